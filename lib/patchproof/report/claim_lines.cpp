#include <patchproof/report/claim_lines.hpp>

#include <map>
#include <utility>

#include <patchproof/report/verdict_words.hpp>

namespace patchproof {

namespace {

using Family = std::vector<const ClaimResult*>;
using Key = std::pair<std::size_t, std::string>;

Key family_of(const ClaimResult& result) { return {result.claim.span.begin, result.claim.label}; }

bool same_answer(const ClaimResult& a, const ClaimResult& b) {
  return a.outcome == b.outcome && verdict_line(a.decision) == verdict_line(b.decision);
}

std::vector<ClaimLine> lines_of(const Case& of, const Family& family, bool strict) {
  std::vector<std::pair<const ClaimResult*, std::size_t>> answers;
  for (const ClaimResult* result : family) {
    bool shared = false;
    for (auto& [first, count] : answers) {
      if (!same_answer(*first, *result)) continue;
      ++count;
      shared = true;
      break;
    }
    if (!shared) answers.emplace_back(result, 1);
  }
  std::vector<ClaimLine> lines;
  const bool differ = answers.size() > 1;
  for (const auto& [first, count] : answers) {
    if (differ && needs_attention(*first, strict)) {
      for (const ClaimResult* result : family)
        if (same_answer(*first, *result)) lines.push_back({claim_id(of, result->claim), result, 1});
    } else {
      const std::string id =
          count == 1 ? claim_id(of, first->claim) : of.name + "." + first->claim.label;
      lines.push_back({id, first, count});
    }
  }
  return lines;
}

}  // namespace

std::vector<ClaimLine> claim_lines(const CaseResult& given, bool strict) {
  std::map<Key, Family> families;
  std::vector<Key> order;
  for (const ClaimResult& result : given.claims) {
    const Key key = family_of(result);
    if (!families.contains(key)) order.push_back(key);
    families[key].push_back(&result);
  }
  std::vector<ClaimLine> lines;
  for (const Key& key : order)
    for (ClaimLine& line : lines_of(given.verified, families.at(key), strict))
      lines.push_back(std::move(line));
  return lines;
}

}  // namespace patchproof
