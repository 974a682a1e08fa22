#include <catch2/catch.hpp>

#include <patchproof/language/reader.hpp>
#include <patchproof/latex/document.hpp>

// Each of these once stood on a page and read as something else than what was decided.

namespace patchproof {

namespace {

std::string page_of(const std::string& text) {
  const auto source = std::make_shared<const SourceText>(SourceText{"page.proof", text});
  const ReadFile read = read_cases(source, Limits{}, {});
  REQUIRE(read.diagnostics.empty());
  const CaseResult result = verified(read.cases.at(0), {});
  DocumentOptions options;
  options.fragment = true;
  options.figures = false;
  return document(Page{result, case_derivation(result, options.detail, Engines::both), "", ""},
                  options);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("an instance of a family that is refuted is not one more that is proved") {
  const std::string page = page_of("case c\n  family m in 1..3\n  scalar x\n  prove p: x^m == x\nend\n");
  CHECK(contains(page, "\\ppclaim{Claim}{p[m=1]}"));
  CHECK(contains(page, "\\ppclaim{Claim}{p[m=2]}"));
  CHECK(contains(page, "\\ppverdict{ppbad}{refuted}"));
  CHECK(contains(page, "decided in the same way: 1."));
  CHECK(!contains(page, "decided in the same way: 2."));
}

TEST_CASE("a bound variable called as a free one gets another letter") {
  const std::string page = page_of(
      "case c\n  param u, v in [0, 1]\n  scalar f(t) : C^1\n"
      "  let H(u) = integral(f(u*v), v in [0, 1])\n"
      "  prove p: H(v) == integral(f(v*u), u in [0, 1])\nend\n");
  CHECK(contains(page, "\\int_{0}^{1} f(v\\,s)\\,\\mathrm{d}s"));
  CHECK(!contains(page, "f(v\\,v)"));
}

TEST_CASE("summands with bound variables are not taken for repeated ones") {
  CHECK(contains(page_of("case c\n  param u in [0, 1]\n  let F(t) = integral(t*u, u in [0, 1])\n"
                         "  prove p: F(u) + integral(u*u, u in [0, 1]) == u/2 + 1/3\nend\n"),
                 "\\ppverdict{ppgood}{proved}{both engines}"));
}

TEST_CASE("two names that would look alike are told apart") {
  const std::string page =
      page_of("case c\n  scalar C1, C_1, a12, a[0..1,0..2]\n  refute p: C1 == C_1\n"
              "  refute q: a12 == a[1,2]\nend\n");
  CHECK(contains(page, "\\begin{ppchain}{C_1}\n  \\ppline{=}{\\mathtt{C\\_1}}{}"));
  CHECK(contains(page, "\\begin{ppchain}{a_{12}}\n  \\ppline{=}{\\mathtt{a}_{12}}{}"));
}

TEST_CASE("a power belongs to the sine and to the exponential, not to their arguments") {
  const std::string page = page_of(
      "case c\n  param u in [0, 1]\n  prove p: cos(u)^2*2 - 1 == cos(2*u)\n"
      "  prove q: exp(u)^2 == exp(2*u)\nend\n");
  CHECK(contains(page, "{\\cos^{2}(u) \\cdot 2 - 1}"));
  CHECK(contains(page, "{(e^{u})^{2}}"));
}

TEST_CASE("a counterexample says what was derived, too") {
  CHECK(contains(page_of("case c\n  scalar x, y, z\n  derive one: x from x == 2*y gives 2*y\n"
                         "  refute p: x*z + x == y using one\nend\n"),
                 "$y = 1$, $x = 2$; everything else is 0"));
}

TEST_CASE("a claim above an assumption says that it does not have it") {
  CHECK(contains(page_of("case c\n  scalar x\n  refute a: x == 1\n  assume p: x == 1\n"
                         "  prove b: x == 1\nend\n"),
                 "(assumed only after this claim: \\pplabel{p})"));
}

TEST_CASE("a matrix of symbols that is no array of its own is written out") {
  CHECK(contains(page_of("case c\n  scalar a, b\n  matrix M = [b, a ; a, a]\n"
                         "  prove p: det(M) == a*b - a^2\nend\n"),
                 "\\begin{ppchain}{M}\n  \\ppline{=}{\\begin{pmatrix} b & a \\\\ a & a \\end{pmatrix}}{}"));
}

TEST_CASE("a claim of instance 10 uses what was derived for 10, not for 1") {
  const std::string page = page_of(
      "case c\n  scalar x, y\n  derive one: x from x == i*y gives i*y for i in 1..10\n"
      "  prove p: x == i*y using one for i in 1..10\n"
      "  refute r: x == y using one for i in 10..10\nend\n");
  CHECK(contains(page, "$y = 1$, $x = 10$"));
}

}  // namespace patchproof
