#include <patchproof/latex/mathematics.hpp>

#include <algorithm>
#include <cctype>

#include <patchproof/latex/line_breaks.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

std::string line(const std::string& relation, const std::string& term, const std::string& reason) {
  return "  \\ppline{" + relation + "}{" + breakable(term) + "}{" + reason + "}\n";
}

std::string chain(const std::string& start, const std::string& lines) {
  return "\\begin{ppchain}{" + breakable(start) + "}\n" + lines + "\\end{ppchain}\n";
}

// Words like `bezier` are upright, as operators are; letters with an index are names.
std::string definition_name(const std::string& name, const Notation& notation) {
  const std::size_t letters = static_cast<std::size_t>(
      std::find_if(name.begin(), name.end(),
                   [](char c) { return std::isalpha(static_cast<unsigned char>(c)) == 0; }) -
      name.begin());
  if (letters <= 1 || notation.names.contains(name))
    return "$" + latex_name(name, notation).text() + "$";
  return latex_escaped(name);
}

std::string reason_text(const Reason& reason, const Wording& wording) {
  using Kind = Reason::Kind;
  const auto named = [&](Word word, bool labels) {
    std::string text;
    for (const std::string& name : reason.names)
      text +=
          (text.empty() ? " " : ", ") + (labels ? "\\pplabel{" + latex_escaped(name) + "}"
                                                : definition_name(name, wording.names.notation));
    return wording(word) + text;
  };
  switch (reason.kind) {
    case Kind::none:
      return "";
    case Kind::definition:
      return named(Word::reason_definition, false);
    case Kind::derivative:
      return wording(Word::reason_derivative);
    case Kind::arithmetic:
      return wording(Word::reason_arithmetic);
    case Kind::assumption:
      return named(Word::reason_assumption, true);
    case Kind::derived:
      return named(Word::reason_derived, true);
    case Kind::collected:
      return wording(Word::reason_collected);
    case Kind::value:
      return wording(Word::reason_value);
    case Kind::integration:
      return wording(Word::reason_integration);
  }
  return "";
}

bool is_zero(const Term& value) {
  switch (value.operation()) {
    case Operation::number:
      return value.number() == 0;
    case Operation::lambda:
      return is_zero(value.child(0));
    case Operation::tuple:
      return std::all_of(value.children().begin(), value.children().end(), is_zero);
    default:
      return false;
  }
}

// Of a function what it is at its parameters.
const Term& body_of(const Term& value) {
  return value.operation() == Operation::lambda ? value.child(0) : value;
}

}  // namespace

std::string relation_text(Relation relation) {
  switch (relation) {
    case Relation::equal:
      return "=";
    case Relation::not_equal:
      return "\\neq";
    case Relation::less:
      return "<";
    case Relation::less_equal:
      return "\\leq";
    case Relation::greater:
      return ">";
    default:
      return "\\geq";
  }
}

std::string statements_text(const std::vector<Statement>& statements, const Wording& wording) {
  std::string text;
  for (std::size_t k = 0; k < statements.size();) {
    const std::string start = to_latex(statements[k].left, wording.names);
    std::string lines;
    do {
      lines += line(relation_text(statements[k].relation),
                    to_latex(statements[k].right, wording.names), "");
      ++k;
    } while (k < statements.size() &&
             statements[k].left.address() == statements[k - 1].right.address());
    text += chain(start, lines);
  }
  return text;
}

std::string relations_text(const std::vector<Statement>& statements, const Wording& wording) {
  constexpr int widest = 1400;
  std::string text;
  for (std::size_t k = 0; k < statements.size(); ++k) {
    const Statement& statement = statements[k];
    const std::string relation = to_latex(statement.left, wording.names) + " " +
                                 relation_text(statement.relation) + " " +
                                 to_latex(statement.right, wording.names);
    if (estimated_width(relation) > widest) return statements_text(statements, wording);
    text += "\\pps{" + relation + (k + 1 < statements.size() ? ",\\quad" : "") + "}";
  }
  return "\\ppalone{" + text + "}\n";
}

std::string equation_text(const std::string& left, const std::string& right) {
  return chain(left, line("=", right, ""));
}

std::string chain_text(const CheckedChain& given, const Wording& wording) {
  std::string lines;
  for (const CheckedLink& checked : given.links)
    lines += line(relation_text(checked.link.relation), to_latex(checked.link.term, wording.names),
                  reason_text(checked.link.reason, wording));
  const std::string start = to_latex(given.start, wording.names);
  return lines.empty() ? "\\ppalone{" + breakable(start) + "}\n" : chain(start, lines);
}

std::string readable_chain_text(const CheckedChain& given, Passage::Kind kind,
                                const Wording& wording) {
  const auto called = [&](Word word) { return "\\text{" + wording(word) + "}"; };
  const bool witness = kind == Passage::Kind::witness;
  std::string start = to_latex(given.start, wording.names);
  bool begun = true;
  if (is_too_wide(start)) {
    begun = witness || kind == Passage::Kind::difference;
    start = called(witness ? Word::left_side : Word::difference);
  }
  std::string lines;
  for (std::size_t k = 0; k < given.links.size(); ++k) {
    const Link& link = given.links[k].link;
    std::string term = to_latex(link.term, wording.names);
    if (is_too_wide(term)) {
      if (!witness || k + 1 < given.links.size()) {
        // Nothing can be said of what stands on the other side of another relation.
        if (link.relation != Relation::equal) return "";
        continue;
      }
      term = called(Word::right_side);
    }
    if (begun)
      lines += line(relation_text(link.relation), term, reason_text(link.reason, wording));
    else if (link.relation != Relation::equal)
      return "";
    else
      start = term;
    begun = true;
  }
  return lines.empty() ? "" : chain(start, lines);
}

std::string values_text(const std::vector<KnownValue>& values, const Wording& wording) {
  std::string text;
  bool zeros = false;
  for (const KnownValue& value : values) {
    if (is_zero(value.value) && value.symbol->role != Symbol::Role::parameter) {
      zeros = true;
      continue;
    }
    text += (text.empty() ? "$" : ", $") + symbol_text(*value.symbol, wording) + " = " +
            to_latex(body_of(value.value), wording.names) + "$";
  }
  if (values.empty()) return wording(Word::any_values);
  if (text.empty()) {
    // All are zero: said of each, as far as that is short.
    constexpr std::size_t few = 6;
    for (std::size_t k = 0; k < values.size() && values.size() <= few; ++k)
      text += (text.empty() ? "$" : ", $") + symbol_text(*values[k].symbol, wording) + " = 0$";
    if (!text.empty()) return text;
  }
  if (zeros) text += (text.empty() ? "" : "; ") + wording(Word::all_others_zero);
  return text;
}

std::string list_text(const std::vector<Term>& terms, const Wording& wording) {
  std::string text;
  for (const Term& term : terms)
    text += (text.empty() ? "$" : ", $") + to_latex(term, wording.names) + "$";
  return text;
}

std::string symbol_text(const Symbol& symbol, const Wording& wording) {
  std::string text = latex_name(symbol.name, wording.names.notation).text();
  if (symbol.role != Symbol::Role::function) return text;
  std::string parameters;
  for (const std::string& parameter : symbol.type.parameters)
    parameters += (parameters.empty() ? "" : ",") +
                  latex_name(parameter, wording.names.notation).text();
  return text + "(" + parameters + ")";
}

}  // namespace patchproof
