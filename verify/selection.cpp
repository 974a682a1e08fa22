#include <verify/selection.hpp>

#include <algorithm>

#include <patchproof/report/report.hpp>

namespace patchproof {

namespace {

constexpr std::string_view tag_prefix = "tag:";

// An erratum is two claims with one label.
std::string erratum_label(const Claim& claim) {
  if (claim.verb != "printed" && claim.verb != "corrected") return claim.label;
  return claim.label.substr(0, claim.label.rfind('.'));
}

bool selects(std::string_view pattern, const Case& of, const Claim& claim) {
  if (pattern.starts_with(tag_prefix)) {
    const std::string_view wanted = pattern.substr(tag_prefix.size());
    return std::any_of(of.tags.begin(), of.tags.end(),
                       [&](const std::string& tag) { return matches(wanted, tag); });
  }
  return matches(pattern, claim_id(of, claim)) || matches(pattern, of.name) ||
         matches(pattern, of.name + "." + claim.label) ||
         matches(pattern, of.name + "." + erratum_label(claim));
}

}  // namespace

bool matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0;
  std::size_t t = 0;
  // Where to go on when what follows the last '*' does not fit: one character further.
  std::size_t after_star = std::string_view::npos;
  std::size_t retry = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      after_star = ++p;
      retry = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (after_star != std::string_view::npos) {
      p = after_star;
      t = ++retry;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool Selection::contains(const Case& of, const Claim& claim) const {
  return everything() ||
         std::any_of(patterns_.begin(), patterns_.end(),
                     [&](const std::string& pattern) { return selects(pattern, of, claim); });
}

std::vector<std::string> Selection::unmatched(const std::vector<const Case*>& cases) const {
  std::vector<std::string> result;
  for (const std::string& pattern : patterns_) {
    const bool matched = std::any_of(cases.begin(), cases.end(), [&](const Case* of) {
      return std::any_of(of->claims.begin(), of->claims.end(),
                         [&](const Claim& claim) { return selects(pattern, *of, claim); });
    });
    if (!matched) result.push_back(pattern);
  }
  return result;
}

}  // namespace patchproof
