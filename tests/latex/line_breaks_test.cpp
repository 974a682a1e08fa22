#include <catch2/catch.hpp>

#include <patchproof/latex/line_breaks.hpp>

namespace patchproof {

using Pieces = std::vector<std::string>;

TEST_CASE("a sum is broken before its signs, not before those of factors") {
  CHECK(pieces("a - (b + c)\\,d + \\tfrac{1-x}{2}") ==
        Pieces{"a", "- (b + c)\\,d", "+ \\tfrac{1-x}{2}"});
  CHECK(pieces("-a + b") == Pieces{"-a", "+ b"});
  CHECK(pieces("x^{a+b}") == Pieces{"x^{a+b}"});
  CHECK(pieces("\\left(a + b\\right)") == Pieces{"\\left(a + b\\right)"});
}

TEST_CASE("a sign behind an operator is not a place for a break") {
  CHECK(pieces("2 \\cdot (-a) = -b") == Pieces{"2 \\cdot (-a) = -b"});
}

TEST_CASE("what stands in one bracket of a long summand is broken too, and the bracket is fixed") {
  const std::string part = "\\frac{a+b}{c} + \\alpha\\,\\beta\\,\\gamma\\,\\delta\\,abcdefghij";
  const Pieces found = pieces("2\\left(" + part + " - " + part + "\\right)");
  REQUIRE(found.size() == 4);
  CHECK(found.front() == "2\\bigl(\\frac{a+b}{c}");
  CHECK(found.back() == "+ \\alpha\\,\\beta\\,\\gamma\\,\\delta\\,abcdefghij\\bigr)");
}

TEST_CASE("a long list is broken behind its commas, which keep their space") {
  const std::string entry = "abcdefghijklmnopqrstu";
  CHECK(pieces("(" + entry + "," + entry + "," + entry + ")") ==
        Pieces{"(" + entry + ",\\,", entry + ",\\,", entry + ")"});
}

TEST_CASE("mathematics that surely fits stays as it is") {
  CHECK(breakable("a + b") == "a + b");
  const std::string summand = "\\alpha\\,\\beta\\,\\gamma\\,\\delta\\,xyz";
  CHECK(breakable(summand + " + " + summand + " + " + summand) ==
        "\\pps{" + summand + "}\\pps{+ " + summand + "}\\pps{+ " + summand + "}");
}

TEST_CASE("a minus at the beginning is no difference") {
  const std::string summand = "\\alpha\\,\\beta\\,\\gamma\\,\\delta\\,xyz";
  CHECK(breakable("-" + summand + " - " + summand + " - " + summand) ==
        "\\pps{{-}" + summand + "}\\pps{- " + summand + "}\\pps{- " + summand + "}");
}

TEST_CASE("widths grow with the text, and a matrix is as wide as its widest row") {
  CHECK(estimated_width("") == 0);
  CHECK(estimated_width("a + b") > estimated_width("ab"));
  CHECK(estimated_width("\\frac{a}{b}") < estimated_width("ab"));
  CHECK(estimated_width("\\begin{pmatrix} a \\\\ b \\end{pmatrix}") <
        estimated_width("\\begin{pmatrix} a & b \\end{pmatrix}"));
  // Braces that are not closed are no trouble.
  CHECK(estimated_width("\\frac{a") > 0);
  CHECK(estimated_width("\\") > 0);
}

}  // namespace patchproof
