#include <patchproof/derivation/tidied.hpp>

#include <catch2/catch.hpp>

#include <patchproof/term/plain_text.hpp>
#include <tests/derivation/random_terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

std::string tidy(const Term& term) { return to_text(tidied(term)); }

struct Letters {
  Declarations declare;
  Term u = declare.parameter("u");
  Term a = declare.scalar("a");
  Term b = declare.scalar("b");
  Term P = declare.point("P", 2);
  Term Q = declare.point("Q", 2);
};

}  // namespace

TEST_CASE("a tidied term has the same value", "[law]") {
  const Letters l;
  int held = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    TermDrawer draw{seed, {l.u, l.a}, {}, {l.P, l.Q}};
    const Term term = draw.below(3) == 0 ? draw.point_of(3) : draw.scalar(4);
    const std::string said = decided_equation(term, tidied(term));
    INFO(seed << ": " << to_text(term) << " -> " << tidy(term));
    // 0^0 and the like have no value, before and after.
    CHECK((said == "holds" || said == "ERROR none"));
    held += said == "holds" ? 1 : 0;
  }
  CHECK(held >= 290);
}

TEST_CASE("what is tidied stays as it is", "[law]") {
  const Letters l;
  for (unsigned seed = 0; seed < 300; ++seed) {
    TermDrawer draw{seed, {l.u, l.a}, {}, {l.P, l.Q}};
    const Term once = tidied(draw.scalar(4));
    CAPTURE(seed);
    CHECK(tidy(once) == to_text(once));
  }
}

TEST_CASE("numbers are worked out where a person would") {
  const Letters l;
  CHECK(tidy(number(1) - number(0)) == "1");
  CHECK(tidy(number(2, 3) * number(3)) == "2");
  CHECK(tidy(power(number(-1, 2), 3)) == "-1/8");
  CHECK(tidy(number(3) * (number(2) * l.a)) == "6*a");
  CHECK(tidy(l.a / 3) == "1/3*a");
  CHECK(tidy(1 - l.u) == "1 - u");
  CHECK(tidy(l.u - 1) == "u - 1");
  CHECK(tidy(l.a + l.a) == "2*a");
  CHECK(tidy(power(l.a, 1)) == "a");
  CHECK(tidy(power(l.a, 0)) == "1");
}

TEST_CASE("zeros and ones go; sums are not expanded and what cancels stands") {
  const Letters l;
  CHECK(tidy(0 * l.a + l.b) == "b");
  CHECK(tidy(1 * l.P + 0 * l.Q) == "P");
  CHECK(tidy(0 * l.P) == "(0, 0)");
  CHECK(tidy(l.a * (l.b + 1)) == "a*(b + 1)");
  CHECK(tidy(l.a + l.b - l.a) == "a + b - a");
  CHECK(tidy(-(-l.a)) == "a");
  CHECK(tidy((-l.a) * (-l.b)) == "a*b");
  CHECK(tidy(2 * (-l.a)) == "-2*a");
}

TEST_CASE("what has no value is left as it is") {
  const Letters l;
  CHECK(tidy(l.a / number(0)) == "a/0");
  CHECK(tidy(power(number(0), 0)) == "0^0");
  CHECK(tidy(power(number(0), -1)) == "0^-1");
}

TEST_CASE("Bernstein polynomials at the ends are numbers") {
  CHECK(tidy(bernstein(3, 0, number(0))) == "1");
  CHECK(tidy(bernstein(3, 1, number(0))) == "0");
  CHECK(tidy(bernstein(3, 3, number(1))) == "1");
  CHECK(tidy(bernstein(3, 1, number(1, 2))) == "3/8");
  Declarations declare;
  CHECK(tidy(bernstein(0, 0, declare.scalar("a"))) == "1");
  CHECK(tidy(bernstein(3, 1, declare.scalar("a"))) == "bernstein(3, 1, a)");
}

TEST_CASE("written-out matrices are multiplied, scalars before points") {
  const Letters l;
  const Term row = matrix(1, 2, {1 - l.u, l.u});
  const Term column = matrix(2, 1, {l.P, l.Q});
  CHECK(tidy(times(row, column)) == "[(1 - u)*P + u*Q]");
  CHECK(tidy(times(matrix(1, 2, {number(1), number(0)}), column)) == "[P]");
  const Term square = matrix(2, 2, {l.a, l.b, number(0), number(1)});
  CHECK(tidy(make_term(Operation::transpose, square.type(), {square})) == "[a, 0 ; b, 1]");
  CHECK(tidy(make_term(Operation::entry, Type::scalar(), {times(square, square)}, Indices{0, 1})) ==
        "a*b + b");
  CHECK(tidy(component(point({l.a, l.b}), 1)) == "b");
  CHECK(tidy(make_term(Operation::dot, Type::scalar(), {point({l.a, l.b}), point({l.b, l.a})})) ==
        "a*b + b*a");
}
