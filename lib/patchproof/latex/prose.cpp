#include <patchproof/latex/prose.hpp>

#include <cctype>

#include <patchproof/language/utf8.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// "C^2" at a place of the text: how many bytes; 0 for none.
std::size_t power_length(const std::string& text, std::size_t at) {
  if (at + 2 >= text.size() || !is_letter(text[at]) || text[at + 1] != '^') return 0;
  std::size_t end = at + 2;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end == at + 2 ? 0 : end - at;
}

}  // namespace

std::string prose(const std::string& author) {
  const std::string text = printable(author);
  std::string result;
  std::string plain;
  const auto mathematics = [&](const std::string& latex) {
    result += latex_escaped(plain) + "$" + latex + "$";
    plain.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t length = power_length(text, at); length > 0) {
      mathematics(text.substr(at, 1) + "^{" + text.substr(at + 2, length - 2) + "}");
      at += length;
      continue;
    }
    const std::string two = text.substr(at, 2);
    if (two == "!=" || two == "<=" || two == ">=") {
      mathematics(two == "!=" ? "\\neq" : two == "<=" ? "\\leq" : "\\geq");
      at += 2;
      continue;
    }
    plain += text[at++];
  }
  return result + latex_escaped(plain);
}

}  // namespace patchproof
