#include <patchproof/language/kind_words.hpp>

#include <array>

namespace patchproof {

using namespace syntax;

// In the order of the enumerations.

std::string_view text_of(Expression::Kind kind) {
  static constexpr std::array<std::string_view, 12> words{
      "number", "name", "hole",  "sum",       "product", "negation",
      "power",  "call", "index", "component", "tuple",   "matrix"};
  return words.at(static_cast<std::size_t>(kind));
}

std::string_view text_of(Statement::Kind kind) {
  static constexpr std::array<std::string_view, 24> words{
      "title", "source", "quote",  "tags",   "limit",   "notation", "param", "scalar", "point",
      "curve", "patch",  "volume", "matrix", "net",    "spline",  "let",   "assume", "family",
      "prove", "refute", "open",   "derive", "erratum", "show"};
  return words.at(static_cast<std::size_t>(kind));
}

std::string_view text_of(FormalType::Kind kind) {
  static constexpr std::array<std::string_view, 10> words{
      "scalar", "scalar function", "point",  "curve", "patch",
      "volume", "net",             "matrix", "list",  "spline"};
  return words.at(static_cast<std::size_t>(kind));
}

}  // namespace patchproof
