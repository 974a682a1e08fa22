#include <verify/case_work.hpp>

#include <algorithm>

#include <patchproof/certificate/misunderstood.hpp>

namespace patchproof {

void write_down(CaseWork& work) {
  work.rocq = rocq_file(work.result->verified, without(work.found.certificates, work.left_out));
}

std::vector<std::string> theorems_of(const CaseWork& work) {
  std::vector<std::string> ids;
  for (const RocqTheorem& theorem : work.rocq.theorems)
    if (!theorem.theorems.empty()) ids.push_back(theorem.claim);
  return ids;
}

std::string claim_at(const CaseWork& work, std::size_t line) {
  std::size_t number = 1;
  std::size_t begin = 0;
  std::string current;
  while (begin < work.rocq.text.size() && number <= line) {
    const std::size_t end = work.rocq.text.find('\n', begin);
    const std::string text = work.rocq.text.substr(begin, end - begin);
    for (const RocqTheorem& theorem : work.rocq.theorems)
      if (text.rfind("(* " + theorem.claim + ":", 0) == 0) current = theorem.claim;
    begin = end + 1;
    ++number;
  }
  return current;
}

namespace {

std::vector<Misunderstanding> misunderstandings(const CaseWork& work, const std::string& output) {
  return misunderstood(work.result->verified, without(work.found.certificates, work.left_out),
                       output);
}

}  // namespace

bool is_understood(const CaseWork& work, const std::string& output) {
  return misunderstandings(work, output).empty();
}

void compare(CaseWork& work, const std::string& output) {
  for (const Misunderstanding& one : misunderstandings(work, output)) {
    work.misunderstood.push_back(one.claim);
    work.missing.emplace_back(one.claim, "not what was asked: " + one.what);
  }
}

std::vector<std::string> certified_in(const CaseWork& work) {
  std::vector<std::string> ids;
  for (const std::string& id : theorems_of(work))
    if (std::find(work.misunderstood.begin(), work.misunderstood.end(), id) ==
        work.misunderstood.end())
      ids.push_back(id);
  return ids;
}

}  // namespace patchproof
