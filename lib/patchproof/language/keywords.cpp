#include <algorithm>

#include <patchproof/language/keywords.hpp>

namespace patchproof {
namespace {

bool holds(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

const std::vector<std::string>& statement_keywords() {
  static const std::vector<std::string> words{
      "title", "source", "quote",  "tags", "limit", "notation", "param",   "scalar", "point",
      "curve", "patch",  "volume", "matrix", "net",  "spline", "let",     "assume", "family",
      "prove", "refute", "open",   "show",   "derive", "erratum", "end"};
  return words;
}

const std::vector<std::string>& file_keywords() {
  static const std::vector<std::string> words{"case", "define", "include"};
  return words;
}

const std::vector<std::string>& inner_keywords() {
  static const std::vector<std::string> words{
      "using", "for", "from", "gives", "leaves",    "inconsistent", "where",     "over", "on",
      "at",    "in",  "of",   "joint", "minimizes", "printed",      "corrected", "note", "and", "with"};
  return words;
}

bool begins_statement(std::string_view word) {
  return holds(statement_keywords(), word) || begins_file_item(word);
}

bool begins_file_item(std::string_view word) { return holds(file_keywords(), word); }

bool is_inner_keyword(std::string_view word) { return holds(inner_keywords(), word); }

}  // namespace patchproof
