#include <patchproof/term/latex_name.hpp>

#include <catch2/catch.hpp>

using patchproof::latex_escaped;
using patchproof::latex_name;
using patchproof::Notation;

namespace {

std::string spelled(const std::string& name) { return latex_name(name, Notation{}).text(); }

}  // namespace

TEST_CASE("digits at the end of a name are its index") {
  CHECK(spelled("C") == "C");
  CHECK(spelled("C1") == "C_1");
  CHECK(spelled("C12") == "C_{12}");
  CHECK(latex_name("C1", Notation{}).letters == "C");
  CHECK(latex_name("C1", Notation{}).index == "1");
}

TEST_CASE("several letters are one name; names of Greek letters are those letters") {
  CHECK(spelled("rCD") == "\\mathit{rCD}");
  CHECK(spelled("rC2") == "\\mathit{rC}_2");
  CHECK(spelled("alpha") == "\\alpha");
  CHECK(spelled("alpha1") == "\\alpha_1");
  CHECK(spelled("Omega") == "\\Omega");
  CHECK(spelled("alphabet") == "\\mathit{alphabet}");
}

TEST_CASE("what follows an underscore is an index") {
  CHECK(spelled("M_R") == "M_R");
  CHECK(spelled("M_12") == "M_{12}");
  CHECK(spelled("M_left") == "M_{\\mathrm{left}}");
  CHECK(spelled("x1_a") == "x_{1,a}");
  CHECK(spelled("a_b_c") == "a_{\\mathrm{b\\_c}}");
  CHECK(spelled("a_") == "\\mathit{a\\_}");
  CHECK(spelled("_a") == "\\mathit{\\_a}");
}

TEST_CASE("entries of arrays have their indices, apart where a number has two digits") {
  CHECK(spelled("V[2]") == "V_2");
  CHECK(spelled("V[0,2]") == "V_{02}");
  CHECK(spelled("V[0,12]") == "V_{0,12}");
  CHECK(spelled("V[12]") == "V_{12}");
  CHECK(spelled("M_R[1,1]") == "M_{R,11}");
  CHECK(spelled("p1[0,3]") == "p_{1,03}");
}

TEST_CASE("the notation of the case goes before the spelling") {
  Notation notation;
  notation.names = {{"r", "\\mathbf r"}, {"C1", "C_1"}, {"w", "\\mathbf w_{01}"}, {"x", "x^*"}};
  CHECK(latex_name("r", notation).text() == "\\mathbf r");
  CHECK(latex_name("C1", notation).index == "1");
  CHECK(latex_name("w", notation).letters == "\\mathbf w");
  CHECK(latex_name("w[2]", notation).text() == "\\mathbf w_{01,2}");
  CHECK(latex_name("x[1,2]", notation).text() == "x^*_{12}");
  CHECK(latex_name("r1", notation).text() == "r_1");
}

TEST_CASE("TeX's special characters are escaped in texts") {
  CHECK(latex_escaped("50 % of A_B & #1 {x} $") == "50 \\% of A\\_B \\& \\#1 \\{x\\} \\$");
  CHECK(latex_escaped("a\\b^~\"") ==
        "a\\textbackslash{}b\\textasciicircum{}\\textasciitilde{}\\textquotedbl{}");
  CHECK(latex_escaped("záplata") == "záplata");
}
