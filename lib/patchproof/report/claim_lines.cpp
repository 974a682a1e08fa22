#include <patchproof/report/claim_lines.hpp>

#include <map>
#include <utility>

#include <patchproof/report/verdict_words.hpp>

namespace patchproof {

namespace {

using Family = std::vector<const ClaimRecord*>;
using Key = std::pair<FilePlace, std::string>;

bool same_answer(const ClaimRecord& a, const ClaimRecord& b) {
  return a.outcome == b.outcome && verdict_line(a.decision) == verdict_line(b.decision);
}

std::vector<ClaimLine> lines_of(const CaseRecord& of, const Family& family, bool strict) {
  std::vector<std::pair<const ClaimRecord*, std::size_t>> answers;
  for (const ClaimRecord* claim : family) {
    bool shared = false;
    for (auto& [first, count] : answers) {
      if (!same_answer(*first, *claim)) continue;
      ++count;
      shared = true;
      break;
    }
    if (!shared) answers.emplace_back(claim, 1);
  }
  std::vector<ClaimLine> lines;
  const bool differ = answers.size() > 1;
  for (const auto& [first, count] : answers) {
    if (differ && needs_attention(*first, strict)) {
      for (const ClaimRecord* claim : family)
        if (same_answer(*first, *claim)) lines.push_back({claim->id, claim, 1});
    } else {
      lines.push_back({count == 1 ? first->id : of.name + "." + first->label, first, count});
    }
  }
  return lines;
}

}  // namespace

std::vector<ClaimLine> claim_lines(const CaseRecord& given, bool strict) {
  std::map<Key, Family> families;
  std::vector<Key> order;
  for (const ClaimRecord& claim : given.claims) {
    const Key key{claim.place, claim.label};
    if (!families.contains(key)) order.push_back(key);
    families[key].push_back(&claim);
  }
  std::vector<ClaimLine> lines;
  for (const Key& key : order)
    for (ClaimLine& line : lines_of(given, families.at(key), strict))
      lines.push_back(std::move(line));
  return lines;
}

}  // namespace patchproof
