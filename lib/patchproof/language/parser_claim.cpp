// Claims:
//
//   ( prove | refute | open ) LABEL : proposition { clause }
//   derive LABEL : expressions from proposition {, proposition}
//       [ gives expressions ] [ leaves expressions ] [ inconsistent ] { clause }
//   erratum LABEL printed proposition corrected proposition [ note STRING ] end
//   assume [ LABEL : ] comparison {, comparison} [ note STRING ]
//   proposition = "C^k" joint of edge and edge | comparison {, comparison}
//               | "G^k" joint of edge and edge [ with expressions ]
//   clause      = using LABEL {, LABEL} | for binder {, binder}

#include <array>

#include <patchproof/language/grammar.hpp>
#include <patchproof/language/keywords.hpp>

namespace patchproof::grammar {
namespace {

using syntax::Comparison;
using syntax::Proposition;
using syntax::Statement;
using Kind = Statement::Kind;

constexpr int highest_order = 99;

syntax::Name label(TokenStream& stream) {
  // Any word may be a label: a word is a keyword only as the first of its line.
  const bool is_label = stream.is(Token::Kind::name) && stream.is(":", 1);
  if (!is_label || stream.at_statement()) {
    stream.fail_expected("a label and ':'", "as in 'prove south: r(u, 0) == C1(u)'");
  }
  syntax::Name result = stream.any_word("a label");
  stream.expect(":");
  return result;
}

bool at_comparison_sign(const TokenStream& stream) {
  static constexpr std::array<std::string_view, 6> signs{"==", "!=", "<", "<=", ">", ">="};
  for (const std::string_view sign : signs) {
    if (stream.is(sign)) return true;
  }
  return false;
}

Comparison comparison(TokenStream& stream, std::string_view subject) {
  const std::size_t begin = stream.token().begin;
  Comparison result;
  result.operands.push_back(expression(stream));
  while (at_comparison_sign(stream)) {
    result.operators.emplace_back(stream.text());
    result.operator_spans.push_back(stream.span(stream.token()));
    stream.advance();
    result.operands.push_back(expression(stream));
  }
  if (stream.is("=")) {
    stream.fail(stream.span(stream.token()),
                "'=' defines a name; " + std::string(subject) + " compares with '=='");
  }
  if (stream.is("minimizes")) {
    stream.fail(stream.span(stream.token()), "'minimizes' makes a claim of its own",
                "as in 'prove least: r minimizes E(p) over p where p == r on boundary'");
  }
  if (result.operators.empty()) stream.fail_expected("a comparison ('==', '!=', '<', ...)");
  if (stream.accept("on")) {
    stream.expect("boundary");
    result.on_boundary = true;
  }
  result.span = stream.span_from(begin);
  return result;
}

syntax::Edge edge(TokenStream& stream) {
  syntax::Edge result;
  result.patch = stream.name("a patch");
  stream.expect("at");
  result.parameter = stream.name("a parameter");
  stream.expect("=");
  result.value = expression(stream);
  return result;
}

bool at_joint(const TokenStream& stream) {
  return (stream.is("C") || stream.is("G")) && stream.is("^", 1) && stream.is("joint", 3);
}

void edges(TokenStream& stream, syntax::Joint& joint) {
  stream.expect("joint");
  stream.expect("of");
  joint.first = edge(stream);
  stream.expect("and");
  joint.second = edge(stream);
}

syntax::Joint joint(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  syntax::Joint result;
  result.geometric = stream.is("G");
  stream.advance();
  stream.expect("^");
  result.order = stream.whole_number("an order", 0, highest_order);
  edges(stream, result);
  if (stream.is("with") && !result.geometric) {
    stream.fail(stream.span(stream.token()), "only a G^k joint has connecting functions");
  }
  if (stream.accept("with")) result.functions = expressions(stream);
  result.span = stream.span_from(begin);
  return result;
}

Proposition comparisons(TokenStream& stream, std::string_view subject) {
  const std::size_t begin = stream.token().begin;
  Proposition result;
  do {
    result.comparisons.push_back(comparison(stream, subject));
  } while (stream.accept(","));
  result.span = stream.span_from(begin);
  return result;
}

/// Whether `minimizes` stands in this statement, so that it claims a minimum.
bool at_minimum(const TokenStream& stream) {
  for (std::size_t k = stream.index(); k < stream.tokens().size(); ++k) {
    const Token& token = stream.tokens()[k];
    if (token.kind == Token::Kind::name && stream.text(token) == "minimizes") return true;
    const bool next_statement = k > stream.index() && token.first_on_line &&
                                token.kind == Token::Kind::name &&
                                begins_statement(stream.text(token));
    if (next_statement || stream.text(token) == "==") return false;
  }
  return false;
}

syntax::Minimum minimum(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  syntax::Minimum result;
  result.candidate = expression(stream);
  stream.expect("minimizes");
  result.functional = expression(stream);
  stream.expect("over");
  result.competitor = stream.name("the competitor");
  if (stream.accept("where")) {
    do {
      result.constraints.push_back(comparison(stream, "a constraint"));
    } while (stream.accept(","));
  }
  result.span = stream.span_from(begin);
  return result;
}

Proposition proposition(TokenStream& stream) {
  if (at_minimum(stream)) {
    Proposition result;
    result.minimum = minimum(stream);
    result.span = result.minimum->span;
    return result;
  }
  if (!at_joint(stream)) return comparisons(stream, "a claim");
  Proposition result;
  result.joint = joint(stream);
  result.span = result.joint->span;
  return result;
}

/// What something is derived from: comparisons and joints in any order.
Proposition premises(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  Proposition result;
  do {
    if (!at_joint(stream)) {
      result.comparisons.push_back(comparison(stream, "a claim"));
    } else if (!result.joint) {
      result.joint = joint(stream);
    } else {
      result.further_joints.push_back(joint(stream));
    }
  } while (stream.accept(","));
  result.span = stream.span_from(begin);
  return result;
}

/// Takes `using` or `for` with what follows, if one of them comes next.
bool clause(TokenStream& stream, syntax::Clauses& clauses) {
  if (stream.accept("using")) {
    do {
      clauses.using_labels.push_back(stream.any_word("a label"));
    } while (stream.accept(","));
    return true;
  }
  if (stream.accept("for")) {
    for (syntax::Binder& binder : binders(stream)) clauses.binders.push_back(std::move(binder));
    return true;
  }
  return false;
}

void refuse_second(TokenStream& stream, std::string_view word, bool is_given) {
  if (is_given && stream.is(word)) {
    stream.fail(stream.span(stream.token()), "'" + std::string(word) + "' given twice");
  }
}

void derivation(TokenStream& stream, Statement& statement) {
  statement.unknowns = expressions(stream);
  stream.expect("from");
  statement.proposition = premises(stream);
  while (true) {
    refuse_second(stream, "gives", !statement.gives.empty());
    refuse_second(stream, "leaves", statement.underdetermined);
    refuse_second(stream, "inconsistent", statement.inconsistent);
    if (stream.accept("gives")) {
      statement.gives = expressions(stream);
    } else if (stream.accept("leaves")) {
      statement.underdetermined = true;
      statement.leaves = expressions(stream);
    } else if (stream.accept("inconsistent")) {
      statement.inconsistent = true;
    } else if (!clause(stream, statement.clauses)) {
      return;
    }
  }
}

void erratum(TokenStream& stream, Statement& statement) {
  statement.label = stream.any_word("a label");
  stream.expect("printed");
  statement.printed = proposition(stream);
  stream.expect("corrected");
  statement.corrected = proposition(stream);
  while (true) {
    refuse_second(stream, "note", statement.note.has_value());
    if (stream.accept("note")) {
      statement.note = stream.quoted_text();
    } else if (!clause(stream, statement.clauses)) {
      break;
    }
  }
  if (stream.at_statement() && !stream.is("end")) {
    stream.fail(statement.keyword, "erratum '" + statement.label->text + "' has no 'end'");
  }
  stream.expect_end_of_statement();
  if (!stream.is("end")) stream.fail_expected("'note', 'using', 'for' or 'end'");
  stream.advance();
}

}  // namespace

void show(TokenStream& stream, Statement& statement) {
  if (!stream.is("joint") || !stream.is("of", 1)) {
    statement.shown = expression(stream);
    return;
  }
  const std::size_t begin = stream.token().begin;
  statement.shown_joint.emplace();
  edges(stream, *statement.shown_joint);
  statement.shown_joint->span = stream.span_from(begin);
}

void assumption(TokenStream& stream, Statement& statement) {
  if (stream.is(Token::Kind::name) && stream.is(":", 1)) statement.label = label(stream);
  statement.proposition = comparisons(stream, "an assumption");
  if (stream.accept("for")) statement.clauses.binders = binders(stream);
  if (stream.accept("note")) statement.note = stream.quoted_text();
}

void claim(TokenStream& stream, Statement& statement) {
  if (statement.kind == Kind::erratum) return erratum(stream, statement);
  statement.label = label(stream);
  if (statement.kind == Kind::derive) return derivation(stream, statement);
  statement.proposition = proposition(stream);
  while (clause(stream, statement.clauses)) {
  }
}

}  // namespace patchproof::grammar
