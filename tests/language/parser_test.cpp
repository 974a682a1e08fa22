#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {
namespace {

using syntax::Expression;
using syntax::Statement;

/// The only statement of a case.
Statement statement_of(const std::string& text) {
  const Parsed parsed = parse(source_of("case a\n" + text + "\nend\n"));
  INFO(messages_of("case a\n" + text + "\nend\n"));
  REQUIRE(parsed.diagnostics.empty());
  REQUIRE(parsed.file.cases.size() == 1);
  REQUIRE(parsed.file.cases[0].statements.size() == 1);
  return parsed.file.cases[0].statements[0];
}

/// The expression in full parentheses, which shows how it was read.
std::string bracketed(const Expression& expression) {
  const auto at = [&](std::size_t i) { return bracketed(*expression.operands.at(i)); };
  std::string result;
  switch (expression.kind) {
    case Expression::Kind::number:
    case Expression::Kind::name:
      return expression.text;
    case Expression::Kind::hole:
      return "?";
    case Expression::Kind::sum:
    case Expression::Kind::product:
      for (std::size_t i = 0; i < expression.operands.size(); ++i) {
        result += expression.signs.at(i) + at(i);
      }
      return "(" + result + ")";
    case Expression::Kind::negation:
      return "(neg " + at(0) + ")";
    case Expression::Kind::power:
      return "(" + at(0) + "^" + at(1) + ")";
    case Expression::Kind::component:
      return at(0) + "." + expression.text;
    case Expression::Kind::call:
    case Expression::Kind::index:
      for (const syntax::Argument& argument : expression.arguments) {
        if (argument.value) result += bracketed(*argument.value) + ",";
        if (argument.binder) result += argument.binder->name.text + " in span,";
        if (argument.interval) {
          result += bracketed(*argument.interval->first) + ".." +
                    bracketed(*argument.interval->last) + ",";
        }
      }
      return at(0) + (expression.kind == Expression::Kind::call ? "{" : "[") + result + "}";
    case Expression::Kind::tuple:
      for (std::size_t i = 0; i < expression.operands.size(); ++i) result += at(i) + ",";
      return "<" + result + ">";
    case Expression::Kind::matrix:
      for (const auto& row : expression.rows) {
        for (const auto& entry : row) result += bracketed(*entry) + ",";
        result += ";";
      }
      return "|" + result + "|";
  }
  return "";
}

std::string read_as(const std::string& text) {
  return bracketed(*statement_of("show " + text).shown);
}

}  // namespace

TEST_CASE("operators bind as in a textbook", "[language]") {
  CHECK(read_as("a + b*c - d/e") == "(+a+(*b*c)-(*d/e))");
  CHECK(read_as("-a^2") == "(-(a^2))");
  CHECK(read_as("a - -b^-2^3") == "(+a-(neg (b^(neg (2^3)))))");
  CHECK(read_as("(a + b)(u, 0)[1].x") == "(+a+b){u,0,}[1,}.x");
  CHECK(read_as("a^b^c") == "(a^(b^c))");
  CHECK(read_as("(1, ?, -u)") == "<1,?,(-u),>");
  CHECK(read_as("[1, u ; 0.5, C1''(0)]") == "|1,u,;0.5,C1''{0,},;|");
}

TEST_CASE("indices may be ranges and arguments may bind a name", "[language]") {
  CHECK(read_as("M[0..3, i + 1..6, 2]") == "M[0..3,(+i+1)..6,2,}");
  CHECK(read_as("sum(b[i]*x, i in 0..3)") == "sum{(*b[i,}*x),i in span,}");
  CHECK(read_as("f()") == "f{}");
}

TEST_CASE("numbers are exact", "[language]") {
  CHECK(statement_of("show 0.1").shown->number == Rational(1, 10));
  CHECK(statement_of("show 010").shown->number == Rational(10));
  CHECK(statement_of("show 2.50").shown->text == "2.50");
}

TEST_CASE("a word is a keyword only as the first of its line", "[language]") {
  CHECK(statement_of("show point + case*(end - title)").shown->operands.size() == 2);
  CHECK(statement_of("prove prove: source == 1").label->text == "prove");
  CHECK(statement_of("prove for: 1 == 1 using using, in").clauses.using_labels.size() == 2);
}

TEST_CASE("a bracket that begins a line continues only what is in brackets", "[language]") {
  CHECK(read_as("(f\n(u))") == "f{u,}");
  CHECK(messages_of("case a\n  show f\n(u)\nend\n") ==
        "bad.proof:3:1: error: expected a statement, found '('\n"
        "     3 | (u)\n"
        "       | ^\n");
}

TEST_CASE("declarations are read with all their parts", "[language]") {
  const Statement scalars = statement_of("scalar a, b[0..3], f1(u), g(v) = v^2 : C^1");
  REQUIRE(scalars.declarators.size() == 4);
  CHECK(scalars.declarators[1].extents.size() == 1);
  CHECK(scalars.declarators[2].parameters.size() == 1);
  CHECK(scalars.declarators[3].value != nullptr);
  CHECK(scalars.smoothness->order == 1);

  const Statement curves = statement_of("curve C1(u), C2(u) : C^2 in R^3");
  CHECK(curves.dimension == 3);
  CHECK(curves.smoothness->order == 2);
  CHECK(statement_of("curve C1(u) in R^4 : C^2").dimension == 4);
  CHECK(statement_of("point P, V[0..3, 0..3] in R^3").declarators[1].extents.size() == 2);
  CHECK(statement_of("point P").dimension == 0);
  CHECK(statement_of("curve p(t) : degree 3").degrees == std::vector<int>{3});
  CHECK(statement_of("patch p(u,v) : degree (3, 2)").degrees == std::vector<int>{3, 2});
  CHECK(statement_of("param u, v in [0,1], t in [a,b]").parameters.size() == 2);
  CHECK(statement_of("family m in 1..6, n in 1..6").binders.size() == 2);
  CHECK(statement_of("net b[i,j] = i*j for i in 0..3, j in 0..2").binders.size() == 2);
  CHECK(statement_of("spline T = bspline(M, degree 3, 3, clamped uniform)").spline->knots.empty());
  CHECK(statement_of("spline T = bspline(M, degree 2, knots [0, 1])").spline->knots.size() == 1);
}

TEST_CASE("limits have a kind, a number and perhaps a unit", "[language]") {
  CHECK(statement_of("limit time 5s").limit_unit->text == "s");
  CHECK(statement_of("limit memory 100 MB").limit_value == Rational(100));
  CHECK(statement_of("limit terms 1000").limit_kind->text == "terms");
  CHECK_FALSE(statement_of("limit steps 1000").limit_unit);
}

TEST_CASE("a derivation is read with all it may say", "[language]") {
  const Statement all = statement_of(
      "derive d: M, x from C^2 joint of P at v = 1 and R at v = 0, x == 1,\n"
      "  C^0 joint of P at u = 1 and Q at u = 0\n"
      "  gives 1, 2\n  leaves x, y\n  using a, b\n  for i in 0..3");
  CHECK(all.unknowns.size() == 2);
  CHECK(all.proposition.joint->order == 2);
  CHECK(all.proposition.comparisons.size() == 1);
  CHECK(all.proposition.further_joints.size() == 1);
  CHECK(all.gives.size() == 2);
  CHECK(all.underdetermined);
  CHECK(all.leaves.size() == 2);
  CHECK(all.clauses.using_labels.size() == 2);
  CHECK(all.clauses.binders.size() == 1);
  CHECK(statement_of("derive d: x from x == 1, x == 2 inconsistent").inconsistent);
}

TEST_CASE("claims and assumptions are read with their comparisons", "[language]") {
  const Statement chain = statement_of("prove c: a == b == c, p != q on boundary");
  REQUIRE(chain.proposition.comparisons.size() == 2);
  CHECK(chain.proposition.comparisons[0].operators.size() == 2);
  CHECK(chain.proposition.comparisons[1].on_boundary);
  CHECK_FALSE(statement_of("assume a != b").label);
  CHECK(statement_of("assume closed: a == b, c == d").proposition.comparisons.size() == 2);
  const Statement erratum =
      statement_of("erratum e\n printed a == b\n corrected a == -b\n note \"sign\"\nend");
  CHECK(erratum.note == "sign");
}

TEST_CASE("the parts of the name of a case may be numbers, but not the first", "[language]") {
  const Parsed parsed = parse(source_of("case cz.twist.00\nend\ncase a.1.2.b\nend\n"));
  REQUIRE(parsed.file.cases.size() == 2);
  CHECK(parsed.file.cases[0].name.text == "cz.twist.00");
  CHECK(parsed.file.cases[1].name.text == "a.1.2.b");
}

TEST_CASE("the source of a case has a language, a section and a page", "[language]") {
  const Statement source = statement_of("source \"Záplaty\" lang sk\n  section \"2\" page 12");
  CHECK(source.text == "Záplaty");
  CHECK(source.language->text == "sk");
  CHECK(source.section == "2");
  CHECK(source.page == "12");
  CHECK(statement_of("source \"a\" page \"3-5\"").page == "3-5");
}

TEST_CASE("definitions group their formals by type", "[language]") {
  const Parsed parsed = parse(
      source_of("include \"x.proof\"\n"
                "define f(C1, C2 : curve(u), g : scalar function, M : matrix, n : net, l : list,\n"
                "    s : spline, p : point, r : patch(u, v), a, b : scalar) : patch(u, v)\n"
                "  title \"t\"\n  let x = a\n  = x*C1(u)\n  + b\nend\n"
                "define one : scalar\n  = 1\nend\n"));
  REQUIRE(parsed.diagnostics.empty());
  CHECK(parsed.file.includes.at(0).path == "x.proof");
  REQUIRE(parsed.file.definitions.size() == 2);
  const syntax::Definition& first = parsed.file.definitions[0];
  CHECK(first.formals.size() == 11);
  CHECK(first.formals[1].type.kind == syntax::FormalType::Kind::curve);
  CHECK(first.formals[2].type.kind == syntax::FormalType::Kind::scalar_function);
  CHECK(first.statements.size() == 2);
  CHECK(first.value->operands.size() == 2);
}

TEST_CASE("spans cover what was written", "[language]") {
  const std::string text = "case a.b\n  show x + (y*2)\nend\n";
  const Parsed parsed = parse(source_of(text));
  const Statement& show = parsed.file.cases.at(0).statements.at(0);
  const auto written = [&](const Span& span) {
    return text.substr(span.begin, span.end - span.begin);
  };
  CHECK(written(parsed.file.cases[0].name.span) == "a.b");
  CHECK(written(show.span) == "show x + (y*2)");
  CHECK(written(show.shown->span) == "x + (y*2)");
  CHECK(written(show.shown->mark) == "+");
  CHECK(written(show.shown->operands.at(1)->span) == "(y*2)");
  CHECK(show.shown->operands.at(1)->parenthesised);
}

TEST_CASE("byte order marks, tabs and carriage returns do not disturb", "[language]") {
  CHECK(messages_of("\xEF\xBB\xBF"
                    "case a\r\n\tprove x: 1 == 1 # Bézier\r\nend\r\n") == "");
}

}  // namespace patchproof
