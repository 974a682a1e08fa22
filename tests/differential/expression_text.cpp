#include <algorithm>

#include "expression.hpp"

namespace patchproof::differential {
namespace {

enum class Language { cases, python };

/// Writes expressions; both languages agree in all but a few places.
class Writer {
 public:
  explicit Writer(Language language) : python_{language == Language::python} {}

  std::string text(const Node& node) const {
    const std::vector<Node>& parts = node->operands;
    switch (node->kind) {
      case Kind::number:
        return python_ ? "Rational('" + node->text + "')" : node->text;
      case Kind::name:
        return node->text;
      case Kind::element:
        return node->text + "[" + list(parts, 0) + "]";
      case Kind::sum:
        return sum_text(parts);
      case Kind::negative:
        return "-" + factor(parts[0]);
      case Kind::product:
        return joined(parts, "*");
      case Kind::quotient:
        return factor(parts[0]) + "/" + factor(parts[1]);
      case Kind::power:
        return factor(parts[0]) + (python_ ? "**" : "^") + node->text;
      case Kind::apply:
        return function_text(node) + "(" + list(parts, 1) + ")";
      case Kind::call:
        return node->text + "(" + list(parts, 0) + ")";
      case Kind::running_sum:
        if (python_)
          return "sum(" + text(parts[0]) + " for " + node->text + " in range(" + text(parts[1]) +
                 ", 1 + " + text(parts[2]) + "))";
        return "sum(" + text(parts[0]) + ", " + node->text + " in " + factor(parts[1]) + ".." +
               factor(parts[2]) + ")";
      case Kind::integral:
        if (python_)
          return "integral(" + text(parts[0]) + ", " + node->text + ", " + list(parts, 1) + ")";
        return "integral(" + text(parts[0]) + ", " + node->text + " in [" + list(parts, 1) + "])";
      case Kind::matrix:
        return matrix_text(node);
    }
    return "";
  }

 private:
  /// A factor, in parentheses where it needs them.
  std::string factor(const Node& node) const {
    const bool fraction = node->kind == Kind::number && node->text.find('/') != std::string::npos;
    const bool loose = node->kind == Kind::sum || node->kind == Kind::negative ||
                       node->kind == Kind::product || node->kind == Kind::quotient ||
                       node->kind == Kind::power || (fraction && !python_);
    return loose ? "(" + text(node) + ")" : text(node);
  }

  std::string sum_text(const std::vector<Node>& parts) const {
    std::string result;
    for (const Node& part : parts) {
      const bool minus = part->kind == Kind::negative;
      const Node& shown = minus ? part->operands[0] : part;
      const bool inner = shown->kind == Kind::sum || shown->kind == Kind::negative;
      const std::string term = inner ? "(" + text(shown) + ")" : text(shown);
      if (result.empty())
        result = (minus ? "-" : "") + (minus ? factor(shown) : term);
      else
        result += (minus ? " - " : " + ") + term;
    }
    return result;
  }

  std::string function_text(const Node& node) const {
    const std::string function = text(node->operands[0]);
    if (node->derivative.empty()) return function;
    if (python_) return "partial(" + function + ", '" + node->derivative + "')";
    // Curves have one argument.
    const bool curve = node->operands.size() == 2;
    return function + (curve ? std::string(node->derivative.size(), '\'') : "_" + node->derivative);
  }

  std::string matrix_text(const Node& node) const {
    const std::size_t columns = std::stoul(node->text);
    std::string result = python_ ? "M([[" : "[";
    for (std::size_t i = 0; i < node->operands.size(); ++i) {
      if (i > 0) result += i % columns != 0 ? ", " : python_ ? "], [" : " ; ";
      result += text(node->operands[i]);
    }
    return result + (python_ ? "]])" : "]");
  }

  std::string list(const std::vector<Node>& parts, std::size_t first) const {
    std::string result;
    for (std::size_t i = first; i < parts.size(); ++i)
      result += (i > first ? ", " : "") + text(parts[i]);
    return result;
  }

  std::string joined(const std::vector<Node>& parts, const std::string& sign) const {
    std::string result;
    for (const Node& part : parts) result += (result.empty() ? "" : sign) + factor(part);
    return result;
  }

  bool python_;
};

}  // namespace

std::string case_text(const Node& node) { return Writer{Language::cases}.text(node); }
std::string python_text(const Node& node) { return Writer{Language::python}.text(node); }

}  // namespace patchproof::differential
