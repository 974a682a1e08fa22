#include <patchproof/report/summary.hpp>

#include <algorithm>
#include <cctype>

namespace patchproof {

namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string in_words(const std::map<Verdict, std::size_t>& verdicts) {
  std::string text;
  for (const auto& [verdict, count] : verdicts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + lower_case(to_text(verdict));
  return text;
}

std::string in_words(Outcome outcome, std::size_t count) {
  switch (outcome) {
    case Outcome::as_expected:
      return std::to_string(count) + " as expected";
    case Outcome::wrong:
      return std::to_string(count) + " wrong";
    case Outcome::unknown:
      return std::to_string(count) + " unknown";
    case Outcome::vacuous:
      return std::to_string(count) + " vacuous";
    case Outcome::error:
      return counted(count, "error", "errors");
    default:
      return counted(count, "internal error", "internal errors");
  }
}

}  // namespace

std::string to_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::as_expected:
      return "as_expected";
    case Outcome::wrong:
      return "wrong";
    case Outcome::unknown:
      return "unknown";
    case Outcome::vacuous:
      return "vacuous";
    case Outcome::error:
      return "error";
    default:
      return "internal";
  }
}

void add(const FileRecord& file, Summary& summary) {
  summary.mistakes += file.diagnostics.size();
  if (!file.unreadable.empty()) ++summary.unreadable_files;
  summary.cases += file.cases.size();
  for (const CaseRecord& of : file.cases) {
    for (const ClaimRecord& claim : of.claims) {
      ++summary.claims;
      ++summary.outcomes[claim.outcome];
      if (claim.outcome != Outcome::as_expected) continue;
      ++summary.expected_verdicts[claim.decision.verdict];
      if (claim.decision.verdict == Verdict::proved_if) ++summary.conditional;
    }
    if (of.audit && of.audit->has_flagged) ++summary.flagged;
    if (of.audit && of.audit->is_lost) ++summary.lost;
    summary.lost += static_cast<std::size_t>(std::count_if(
        of.shown.begin(), of.shown.end(), [](const ShownRecord& shown) { return shown.is_lost; }));
  }
}

std::string in_words(const Summary& summary) {
  std::string text =
      counted(summary.claims, "claim", "claims") + " in " + counted(summary.cases, "case", "cases");
  std::string separator = ": ";
  const auto add = [&](const std::string& part) {
    text += separator + part;
    separator = ", ";
  };
  if (summary.claims == 0) add("nothing was decided");
  for (const auto& [outcome, count] : summary.outcomes) {
    add(in_words(outcome, count));
    if (outcome == Outcome::as_expected) text += " (" + in_words(summary.expected_verdicts) + ")";
  }
  if (summary.mistakes > 0) add(counted(summary.mistakes, "mistake", "mistakes") + " in the text");
  if (summary.unreadable_files > 0)
    add(counted(summary.unreadable_files, "path", "paths") + " not read");
  return text;
}

}  // namespace patchproof
