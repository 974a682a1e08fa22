// Declarations:
//
//   param  NAME {, NAME} in range {, ...}          family binder {, binder}
//   scalar | point | curve | patch | volume  declarator {, declarator} { ":" property | "in" R^n }
//   matrix NAME = expression                       let NAME [(NAMES)] = expression
//   net NAME[i, j] = expression for binders        net NAME from "file.csv"
//   spline NAME = bspline(...) | merged(...) | expression

#include <patchproof/language/grammar.hpp>

namespace patchproof::grammar {
namespace {

using syntax::Declarator;
using syntax::Statement;
using Kind = Statement::Kind;

constexpr int highest_degree = 999;
constexpr int highest_order = 99;
constexpr int highest_dimension = 9;

void parameters(TokenStream& stream, Statement& statement) {
  do {
    syntax::ParameterGroup group;
    group.names = stream.names();
    for (const syntax::Name& name : group.names) stream.variables.insert(name.text);
    stream.expect("in");
    group.range = range(stream);
    statement.parameters.push_back(std::move(group));
  } while (stream.accept(","));
}

/// `[0..3, 0..3]`
std::vector<syntax::Interval> extents(TokenStream& stream) {
  const Nested nested(stream, Nested::Kind::bracket);
  stream.expect("[");
  std::vector<syntax::Interval> result;
  do {
    result.push_back(interval(stream));
  } while (stream.accept(","));
  if (!stream.accept("]")) stream.fail_expected("',' or ']'");
  return result;
}

/// Parameters of a function: one of a curve or a scalar function, two of a patch, three of a volume.
void function_parameters(TokenStream& stream, const Statement& statement, Declarator& declared) {
  const std::size_t begin = stream.token().begin;
  declared.parameters = formal_parameters(stream);
  const std::size_t count = declared.parameters.size();
  if (statement.kind == Kind::curve && count != 1) {
    stream.fail(stream.span_from(begin), "a curve has one parameter");
  }
  if (statement.kind == Kind::patch && count != 2) {
    stream.fail(stream.span_from(begin), "a patch has two parameters");
  }
  if (statement.kind == Kind::volume && count != 3) {
    stream.fail(stream.span_from(begin), "a volume has three parameters");
  }
}

Declarator declarator(TokenStream& stream, const Statement& statement) {
  const bool may_be_array = statement.kind == Kind::scalar || statement.kind == Kind::point;
  const bool must_be_function = statement.kind == Kind::curve || statement.kind == Kind::patch ||
                                statement.kind == Kind::volume;
  Declarator result;
  result.name = stream.name();
  if (may_be_array && stream.is("[")) {
    result.extents = extents(stream);
  } else if (must_be_function && !stream.is("(")) {
    stream.fail_expected(statement.kind == Kind::curve   ? "a parameter, as in C(u)"
                         : statement.kind == Kind::patch ? "parameters, as in r(u, v)"
                                                         : "parameters, as in F(u, v, w)");
  } else if (statement.kind != Kind::point && stream.is("(")) {
    function_parameters(stream, statement, result);
  } else if (statement.kind == Kind::scalar) {
    stream.variables.insert(result.name.text);
  }
  if (stream.is("=") && (statement.kind == Kind::point || !result.extents.empty())) {
    stream.fail_expected("',' or the end of the statement", "a value is given by 'let'");
  }
  if (stream.accept("=")) result.value = expression(stream);
  return result;
}

syntax::Smoothness smoothness(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  if (stream.is("G") && stream.is("^", 1)) {
    stream.fail(stream.span(stream.token()), "'G^k' is not available in this version");
  }
  if (!stream.accept("C")) stream.fail_expected("a smoothness like C^2");
  stream.expect("^");
  syntax::Smoothness result;
  result.order = stream.whole_number("an order", 0, highest_order);
  result.span = stream.span_from(begin);
  return result;
}

/// `degree 3` of a curve, `degree (3, 3)` of a patch.
void degrees(TokenStream& stream, Statement& statement) {
  const auto degree = [&] {
    statement.degrees.push_back(stream.whole_number("a degree", 0, highest_degree));
  };
  if (statement.kind == Kind::curve) {
    degree();
    return;
  }
  stream.expect("(");
  degree();
  stream.expect(",");
  degree();
  stream.expect(")");
}

/// `: C^2`, `: degree 3` and `in R^3`, in either order.
void properties(TokenStream& stream, Statement& statement) {
  const bool is_function = statement.kind != Kind::point;
  const bool has_space = statement.kind != Kind::scalar;
  const bool may_have_degree = statement.kind == Kind::curve || statement.kind == Kind::patch;
  bool has_property = false;
  while (true) {
    if (is_function && !has_property && stream.accept(":")) {
      has_property = true;
      if (may_have_degree && stream.accept("degree")) {
        degrees(stream, statement);
      } else {
        statement.smoothness = smoothness(stream);
      }
    } else if (has_space && !statement.space && stream.accept("in")) {
      if (!stream.is("R")) stream.fail_expected("a space like R^3");
      statement.space = stream.name();
      stream.expect("^");
      statement.dimension = stream.whole_number("a dimension", 1, highest_dimension);
    } else {
      return;
    }
  }
}

void functions(TokenStream& stream, Statement& statement) {
  do {
    statement.declarators.push_back(declarator(stream, statement));
  } while (stream.accept(","));
  properties(stream, statement);
}

/// `NAME = expression`, of a let perhaps `NAME(u, v) = expression`.
void definition_of_name(TokenStream& stream, Statement& statement) {
  Declarator result;
  result.name = stream.name();
  if (statement.kind == Kind::let && stream.is("(")) result.parameters = formal_parameters(stream);
  stream.expect("=");
  result.value = expression(stream);
  statement.declarators.push_back(std::move(result));
}

void net(TokenStream& stream, Statement& statement) {
  Declarator result;
  result.name = stream.name();
  if (stream.accept("from")) {
    const Span span = stream.span(stream.token());
    result.file = syntax::FileName{stream.quoted_text(), span};
    statement.declarators.push_back(std::move(result));
    return;
  }
  if (!stream.is("[")) stream.fail_expected("'[' or 'from'");
  stream.expect("[");
  result.parameters = stream.names();
  stream.expect("]");
  stream.expect("=");
  result.value = expression(stream);
  stream.expect("for");
  statement.binders = binders(stream);
  statement.declarators.push_back(std::move(result));
}

/// `bspline(M, degree 3, 3, clamped uniform)` or `merged(B, degree 2, weights w, knots [...])`, or
/// a spline made of another: `insert_knot(T, 1/2)`.
void spline(TokenStream& stream, Statement& statement) {
  Declarator declared;
  declared.name = stream.name();
  stream.expect("=");
  const bool merged = stream.is("merged") && stream.is("(", 1);
  if (!merged && !stream.is("bspline")) {
    declared.value = expression(stream);
    statement.declarators.push_back(std::move(declared));
    return;
  }
  stream.advance();
  const Nested nested(stream, Nested::Kind::bracket);
  stream.expect("(");
  syntax::SplineData data;
  data.merged = merged;
  data.control_points = expression(stream);
  stream.expect(",");
  stream.expect("degree");
  do {
    data.degrees.push_back(stream.whole_number("a degree", 0, highest_degree));
    stream.expect(",");
  } while (stream.is(Token::Kind::number));
  if (stream.accept("weights")) {
    data.weights = expression(stream);
    stream.expect(",");
  }
  if (stream.accept("clamped")) {
    stream.expect("uniform");
  } else if (stream.accept("knots")) {
    data.knots = expressions(stream);
  } else {
    stream.fail_expected("'clamped uniform' or 'knots'");
  }
  stream.expect(")");
  statement.spline = std::move(data);
  statement.declarators.push_back(std::move(declared));
}

}  // namespace

void declaration(TokenStream& stream, Statement& statement) {
  switch (statement.kind) {
    case Kind::parameter:
      return parameters(stream, statement);
    case Kind::family:
      statement.binders = binders(stream);
      return;
    case Kind::net:
      return net(stream, statement);
    case Kind::spline:
      return spline(stream, statement);
    case Kind::matrix:
    case Kind::let:
      return definition_of_name(stream, statement);
    default:
      return functions(stream, statement);
  }
}

}  // namespace patchproof::grammar
