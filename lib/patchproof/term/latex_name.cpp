#include <patchproof/term/latex_name.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <vector>

namespace patchproof {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

const std::set<std::string, std::less<>>& greek_letters() {
  static const std::set<std::string, std::less<>> names{
      "alpha", "beta",  "gamma", "delta", "epsilon", "zeta",  "eta",     "theta", "iota",
      "kappa", "lambda", "mu",   "nu",    "xi",      "pi",    "rho",     "sigma", "tau",
      "upsilon", "phi", "chi",   "psi",   "omega",   "Gamma", "Delta",   "Theta", "Lambda",
      "Xi",    "Pi",    "Sigma", "Upsilon", "Phi",   "Psi",   "Omega"};
  return names;
}

std::string letters_of(const std::string& word) {
  if (greek_letters().contains(word)) return "\\" + word;
  if (word.size() == 1) return word;
  return "\\mathit{" + latex_escaped(word) + "}";
}

// What follows an underscore: one letter or digits as they are, words upright.
std::string index_of(const std::string& word) {
  const bool digits = std::all_of(word.begin(), word.end(), is_digit);
  if (word.size() == 1 || digits) return word;
  return "\\mathrm{" + latex_escaped(word) + "}";
}

LatexName spelled(const std::string& name) {
  const std::size_t underscore = name.find('_');
  if (underscore != std::string::npos && underscore > 0 && underscore + 1 < name.size()) {
    LatexName base = spelled(name.substr(0, underscore));
    const std::string index = index_of(name.substr(underscore + 1));
    base.index += (base.index.empty() ? "" : ",") + index;
    return base;
  }
  std::size_t digits = name.size();
  while (digits > 0 && is_digit(name[digits - 1])) --digits;
  if (digits == 0 || digits == name.size()) return {letters_of(name), ""};
  return {letters_of(name.substr(0, digits)), name.substr(digits)};
}

// The indices between brackets: "0,2" -> "02"; a comma stays where a number has two digits.
std::string array_index(const std::string& inside) {
  std::vector<std::string> numbers{""};
  for (const char c : inside)
    if (c == ',')
      numbers.emplace_back();
    else
      numbers.back() += c;
  const bool single = std::all_of(numbers.begin(), numbers.end(),
                                  [](const std::string& n) { return n.size() == 1; });
  std::string result;
  for (const std::string& number : numbers)
    result += (result.empty() || single ? "" : ",") + number;
  return result;
}

// A notation like "C_1" or "\mathbf r_{01}": the last index at its end apart from the letters.
LatexName parted(const std::string& notation) {
  const std::size_t underscore = notation.rfind('_');
  const bool escaped = underscore != std::string::npos && underscore > 0 &&
                       notation[underscore - 1] == '\\';
  if (underscore == std::string::npos || underscore == 0 || escaped) return {notation, ""};
  const std::string index = notation.substr(underscore + 1);
  if (index.size() == 1) return {notation.substr(0, underscore), index};
  const bool braced = index.size() > 2 && index.front() == '{' && index.find('}') == index.size() - 1;
  if (!braced) return {notation, ""};
  return {notation.substr(0, underscore), index.substr(1, index.size() - 2)};
}

}  // namespace

std::string LatexName::text() const {
  if (index.empty()) return letters;
  // TeX takes one subscript: behind that of a notation an empty sign carries the index. Braces do not
  // help, as TeX takes them away from an accent.
  const std::string base = letters.find('_') == std::string::npos ? letters : "{" + letters + "}{}";
  return base + "_" + (index.size() == 1 ? index : "{" + index + "}");
}

namespace {

// "segment(T, 0)": a name that is a call, with names and numbers as arguments.
std::string call_text(const std::string& name, const Notation& notation) {
  const std::size_t open = name.find('(');
  std::string text = "\\operatorname{" + latex_escaped(name.substr(0, open)) + "}(";
  const std::string inside = name.substr(open + 1, name.size() - open - 2);
  for (std::size_t begin = 0; begin <= inside.size();) {
    std::size_t end = inside.find(", ", begin);
    if (end == std::string::npos) end = inside.size();
    const std::string part = inside.substr(begin, end - begin);
    const bool plain = std::all_of(part.begin(), part.end(), [](char c) {
      return is_digit(c) || std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
    });
    const bool number = !part.empty() && is_digit(part.front());
    text += (begin > 0 ? ", " : "") +
            (number && plain ? part
             : plain && !part.empty() ? latex_name(part, notation).text()
                                      : "\\mathtt{" + latex_escaped(part) + "}");
    begin = end + 2;
  }
  return text + ")";
}

}  // namespace

LatexName latex_name(const std::string& name, const Notation& notation) {
  if (name.find('(') != std::string::npos) return {call_text(name, notation), ""};
  const std::size_t bracket = name.find('[');
  const std::string base = name.substr(0, bracket);
  const auto own = notation.names.find(base);
  LatexName result = own == notation.names.end() ? spelled(base) : parted(own->second);
  if (bracket == std::string::npos) return result;
  const std::string index = array_index(name.substr(bracket + 1, name.size() - bracket - 2));
  result.index += (result.index.empty() ? "" : ",") + index;
  return result;
}

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\textbackslash{}"; break;
      case '^': result += "\\textasciicircum{}"; break;
      case '~': result += "\\textasciitilde{}"; break;
      case '"': result += "\\textquotedbl{}"; break;
      case '{':
      case '}':
      case '#':
      case '$':
      case '%':
      case '&':
      case '_': result += std::string{"\\"} + c; break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace patchproof
