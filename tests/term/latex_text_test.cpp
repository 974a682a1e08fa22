#include <patchproof/term/latex_text.hpp>

#include <catch2/catch.hpp>
#include <memory>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/language/reader.hpp>

using namespace patchproof;

namespace {

Case case_of(const std::string& statements) {
  const auto source =
      std::make_shared<const SourceText>(SourceText{"a.proof", "case c\n" + statements + "end\n"});
  const ReadFile file =
      read_cases(source, Limits{}, [](const std::string&) { return std::optional<std::string>{}; });
  std::string messages;
  for (const Diagnostic& diagnostic : file.diagnostics) messages += to_text(diagnostic);
  INFO(messages);
  REQUIRE(messages.empty());
  return file.cases.front();
}

const std::string letters =
    "  param u, v, t in [0, 1]\n  scalar a, b\n  point P, Q, V[0..3, 0..3]\n"
    "  point x, y in R^3\n  curve C1(u), C2(u), D1(v), D2(v) : C^4\n  curve f(t) : C^6\n"
    "  patch w(u, v), W1(u, v) : C^4\n"
    "  patch r(u, v) = coons(C1, C2, D1, D2)\n"
    "  matrix M_R = [P, Q ; Q, P]\n";

// An expression of the case language as it is typeset; `more` are further lines of the case.
std::string latex(const std::string& expression, const std::string& more = "") {
  const Case given =
      case_of(letters + more + "  prove p: " + expression + " == " + expression + "\n");
  const LatexNames names = case_derivation({given, {}, {}}, Detail::result, Engines::kernel).names;
  const auto& claim = std::get<IdentityClaim>(given.claims.front().kind);
  return to_latex(claim.goal.statements.front().left, names);
}

}  // namespace

TEST_CASE("powers stay as written; numbers are small fractions") {
  CHECK(latex("(1-u)^3") == "(1 - u)^{3}");
  CHECK(latex("a^2*b") == "a^{2}\\,b");
  CHECK(latex("1/3*a") == "\\tfrac{1}{3}\\,a");
  CHECK(latex("-1/3") == "-\\tfrac{1}{3}");
  CHECK(latex("2*a") == "2a");
  CHECK(latex("a/b") == "\\frac{a}{b}");
  CHECK(latex("(a/b)^2") == "\\left(\\frac{a}{b}\\right)^{2}");
  CHECK(latex("1/3*P") == "\\tfrac{1}{3}\\,P");
}

TEST_CASE("signs: no two of them meet") {
  CHECK(latex("a - b") == "a - b");
  CHECK(latex("-a - b") == "-a - b");
  CHECK(latex("a + (-b)") == "a - b");
  CHECK(latex("a - (-b)") == "a - (-b)");
  CHECK(latex("a - 2*b") == "a - 2b");
  CHECK(latex("a*(-b)") == "a(-b)");
  CHECK(latex("a - (b + u)") == "a - (b + u)");
  CHECK(latex("a + (b - u)") == "a + b - u");
  CHECK(latex("-(a + b)") == "-(a + b)");
}

TEST_CASE("products stand side by side; digits have a dot between them") {
  CHECK(latex("a*b") == "a\\,b");
  CHECK(latex("a*(b + 1)") == "a(b + 1)");
  CHECK(latex("(1-u)*(1-v)*V[0,0]") == "(1 - u)(1 - v)\\,V_{00}");
  CHECK(latex("2*(3*a)") == "2 \\cdot 3a");
  CHECK(latex("a*2") == "a \\cdot 2");
  CHECK(latex("3*(1/2*a)") == "3 \\cdot \\tfrac{1}{2}\\,a");
}

TEST_CASE("names: curves with indices, arrays, matrices") {
  CHECK(latex("C1(u)") == "C_1(u)");
  CHECK(latex("C2(1)") == "C_2(1)");
  CHECK(latex("V[0,2]") == "V_{02}");
  // The entry of a written-out matrix is what stands there.
  CHECK(latex("M_R[1,1]") == "P");
  CHECK(latex("M_R") == "M_R");
  CHECK(latex("V") == "V");
  CHECK(latex("alpha + rCD", "  scalar alpha, rCD\n") == "\\alpha + \\mathit{rCD}");
  CHECK(latex("h_max + k_2", "  scalar h_max, k_2\n") == "h_{\\mathrm{max}} + k_2");
}

TEST_CASE("a patch of the case keeps its name") {
  CHECK(latex("r(u, 0)") == "r(u, 0)");
  CHECK(latex("r_uv(0, 1)") == "r_{uv}(0, 1)");
  CHECK(latex("coons(C1, C2, D1, D2)(0, v)") == "\\operatorname{coons}(C_1, C_2, D_1, D_2)(0, v)");
}

TEST_CASE("matrices, lists and tuples") {
  CHECK(latex("[a, b ; b, a]") == "\\begin{pmatrix} a & b \\\\ b & a \\end{pmatrix}");
  CHECK(latex("[1-u, u]") == "\\begin{pmatrix} 1 - u & u \\end{pmatrix}");
  CHECK(latex("(a, 2*b, 0)") == "(a, 2b, 0)");
  CHECK(latex("transpose(M_R)") == "M_R^{\\mathsf{T}}");
  CHECK(latex("det([a, b ; b, a])") == "\\begin{vmatrix} a & b \\\\ b & a \\end{vmatrix}");
  CHECK(latex("x.y") == "x_y");
}

TEST_CASE("derivatives in the three styles") {
  CHECK(latex("w_uuv(0, v)") == "w_{uuv}(0, v)");
  CHECK(latex("W1_uv(u, v)") == "(W_1)_{uv}(u, v)");
  const std::string above = "  notation derivatives superscript\n";
  CHECK(latex("w_uuv(0, v)", above) == "w^{uuv}(0, v)");
  CHECK(latex("W1_uv(u, v)", above) == "W_1^{uv}(u, v)");
  const std::string fraction = "  notation derivatives fraction\n";
  CHECK(latex("w_uuv(0, v)", fraction) ==
        "\\frac{\\partial^{3} w}{\\partial u^{2}\\,\\partial v}(0, v)");
  CHECK(latex("C1'(0)", fraction) == "\\frac{\\mathrm{d} C_1}{\\mathrm{d} u}(0)");
}

TEST_CASE("derivatives of curves carry marks, then a number in brackets") {
  CHECK(latex("C1'(0)") == "C_1'(0)");
  CHECK(latex("f'''(t)") == "f'''(t)");
  CHECK(latex("diff(f, t, 4)") == "f^{(4)}(t)");
}

TEST_CASE("functions of numbers") {
  CHECK(latex("sin(u)") == "\\sin(u)");
  CHECK(latex("cos(2*u)") == "\\cos(2u)");
  CHECK(latex("sin(pi*u)^2") == "\\sin^{2}(\\pi\\,u)");
  CHECK(latex("exp(-u)") == "e^{-u}");
  CHECK(latex("sqrt(a + 1)") == "\\sqrt{a + 1}");
  CHECK(latex("bernstein(3, 1, u)") == "B_{1}^{3}(u)");
}

TEST_CASE("scalar and vector products are infix") {
  CHECK(latex("dot(x, y)") == "x \\cdot y");
  CHECK(latex("cross(x, y)") == "x \\times y");
  CHECK(latex("dot(x + y, y)") == "(x + y) \\cdot y");
  CHECK(latex("dot(cross(x, y), x)") == "(x \\times y) \\cdot x");
}

TEST_CASE("integrals have their variables at the end, the inner one first") {
  CHECK(latex("integral(u^2, u in [0, 1])") == "\\int_{0}^{1} u^{2}\\,\\mathrm{d}u");
  CHECK(latex("integral(a + u, u in [0, b])") == "\\int_{0}^{b} (a + u)\\,\\mathrm{d}u");
  CHECK(latex("integral(u*v, u in [0, 1], v in [0, a])") ==
        "\\int_{0}^{a}\\!\\int_{0}^{1} u\\,v\\,\\mathrm{d}u\\,\\mathrm{d}v");
}

TEST_CASE("a notation is used for the name, with indices behind it") {
  const std::string bold = "  notation w = \"\\mathbf w\", V = \"v\"\n";
  CHECK(latex("w_u(0, v) + V[1,2]", bold) == "\\mathbf w_{u}(0, v) + v_{12}");
}

TEST_CASE("the summands of a sum come one by one, each with its sign") {
  const Case given = case_of("  scalar a, b\n  prove p: a - 2*b + (b - a) == a*b\n");
  const auto& statement =
      std::get<IdentityClaim>(given.claims.front().kind).goal.statements.front();
  CHECK(latex_summands(statement.left, {}) == std::vector<std::string>{"a", "- 2b", "+ b", "- a"});
  CHECK(latex_summands(statement.right, {}) == std::vector<std::string>{"a\\,b"});
}
