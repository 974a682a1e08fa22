#include <patchproof/report/verdict_words.hpp>

#include <algorithm>

#include <patchproof/language/utf8.hpp>

namespace patchproof {

namespace {

constexpr std::size_t longest = 100;

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

// The cut never falls inside a character.
std::string cut(const std::string& text) {
  if (text.size() <= longest) return text;
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t length = std::max<std::size_t>(1, utf8_length(text, end));
    if (end + length > longest) break;
    end += length;
  }
  return text.substr(0, end) + "…";
}

// "0", "(0, 0, 0)"
bool is_zero(const std::string& value) {
  return value.find_first_not_of("0(), ") == std::string::npos;
}

}  // namespace

std::string verdict_line(const Decision& decision) {
  const std::string verdict = to_text(decision.verdict);
  switch (decision.verdict) {
    case Verdict::proved_if:
      return cut(verdict + " " + joined(decision.conditions, " and "));
    case Verdict::underdetermined:
      return cut(verdict + ": free " + joined(decision.free, ", "));
    case Verdict::unknown:
    case Verdict::error:
    case Verdict::internal:
      return cut(verdict + ": " + printable(decision.reason));
    default:
      return verdict;
  }
}

std::string expected_verdict(Expectation expectation) {
  switch (expectation) {
    case Expectation::prove:
      return to_text(Verdict::proved);
    case Expectation::refute:
      return to_text(Verdict::refuted);
    case Expectation::open:
      return to_text(Verdict::unknown);
    default:
      return to_text(Verdict::inconsistent);
  }
}

std::string in_words(const WitnessReport& witness) {
  std::string text;
  std::size_t zeros = 0;
  for (const auto& [name, value] : witness.values) {
    if (is_zero(value))
      ++zeros;
    else
      text += (text.empty() ? "" : ", ") + name + " = " + value;
  }
  if (witness.values.empty()) return "any values";
  if (text.empty()) return "all 0";
  return zeros == 0 ? text : text + "; all others 0";
}

std::string in_words(const Subdivision& tree) {
  if (tree.boxes == 0) return "";
  return "Bernstein subdivision: " + std::to_string(tree.boxes) +
         (tree.boxes == 1 ? " box" : " boxes") + ", depth " + std::to_string(tree.depth);
}

}  // namespace patchproof
