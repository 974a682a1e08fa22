#include <catch2/catch.hpp>

#include <patchproof/latex/plain_latex.hpp>
#include <patchproof/latex/prose.hpp>

namespace patchproof {

TEST_CASE("what an author writes is escaped, and its diacritics stay") {
  CHECK(prose("50 % & #1 $ _ {x} ~ \\ \"q\"") ==
        "50 \\% \\& \\#1 \\$ \\_ \\{x\\} \\textasciitilde{} \\textbackslash{} "
        "\\textquotedbl{}q\\textquotedbl{}");
  CHECK(prose("Plát č. 1, лоскут Кунса") == "Plát č. 1, лоскут Кунса");
  CHECK(prose("a^") == "a\\textasciicircum{}");
}

TEST_CASE("powers and relations in prose are mathematics") {
  CHECK(prose("a C^2 joint") == "a $C^{2}$ joint");
  CHECK(prose("n != 0, m >= 12") == "n $\\neq$ 0, m $\\geq$ 12");
}

TEST_CASE("control characters and invalid bytes become a sign that can be seen") {
  CHECK(prose("a\x01\xFF") == "a\uFFFD\uFFFD");
}

TEST_CASE("mathematics of a report becomes mathematics of LaTeX") {
  const auto latex = [](const std::string& text) { return plain_latex(text, {}); };
  CHECK(latex("-2*V[0,0] + 1/3*P_u(0,0)") == "-2\\,V_{00} + \\tfrac{1}{3}\\,P_u(0,0)");
  CHECK(latex("a - b != 0") == "a - b \\neq 0");
  CHECK(latex("-1*u + 1*(v - 1)") == "-u + (v - 1)");
  CHECK(latex("u^12*v^-2") == "u^{12}\\,v^{-2}");
  CHECK(latex("2*3") == "2 \\cdot 3");
  CHECK(latex("sqrt(2)*sin(pi)") == "\\sqrt{2}\\,\\sin(\\pi)");
  CHECK(latex("a + … %") == "a + \\dots  \\mbox{\\%}");
  CHECK(latex("alpha_max") == "\\alpha_{\\mathrm{max}}");
}

TEST_CASE("names of a report go by the notation of the case") {
  CHECK(plain_latex("r[1,2] - x", {{{"r", "\\mathbf r"}}, {}}) == "\\mathbf r_{12} - x");
}

}  // namespace patchproof
