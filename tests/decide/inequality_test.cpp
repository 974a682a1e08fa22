#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

const std::string neither =
    "(this inequality is neither shown by the methods of this version nor false at any of the "
    "points tried)";

}  // namespace

TEST_CASE("inequalities follow from ranges, assumptions and squares") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  param w in [-1, 2]
  scalar a, b, c
  assume order: a < b, b <= c
  prove product: u*(1 - u)*v >= 0
  prove sum: u + v >= 0
  prove strict: 1 + u*v > 0
  prove both: 0 <= u <= 1
  prove ordered: a < c
  prove different: a != c
  prove difference: c - a > 0
  prove squares: a^2 + b^2 + 1 > 0
  prove wide: w + 1 >= 0
  prove bernstein: bernstein(5, 2, u) >= 0
  prove inverse: 1/(1 + u) > 0
  refute negative: w >= 0
  refute at_the_end: u > 0
  refute not_strict: b < c
  refute chain: 0 <= u <= 1/2
)~") == R"~(product PROVED
sum PROVED
strict PROVED
both PROVED
ordered PROVED uses order
different PROVED uses order
difference PROVED uses order
squares PROVED
wide PROVED
bernstein PROVED
inverse PROVED
negative REFUTED
at_the_end REFUTED
not_strict REFUTED
chain REFUTED
)~");
}

TEST_CASE("an inequality that is not decided is unknown, and says why") {
  CHECK(verdicts(R"~(
  scalar x, y
  open motzkin: x^4*y^2 + x^2*y^4 + 1 >= 3*x^2*y^2
  open sine: sin(x) <= 1
)~") == "motzkin UNKNOWN " + neither + "\nsine UNKNOWN " + neither + "\n");
}

TEST_CASE("a chain of comparisons is one claim") {
  CHECK(verdicts(R"~(
  scalar a, b, c
  assume order: a <= b, b <= c
  prove chain: a <= b <= c
  refute broken: a <= c <= b
  refute equal: a == b == c
)~") == "chain PROVED uses order\nbroken REFUTED\nequal REFUTED\n");
}

TEST_CASE("an inequality may restrict a parameter") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  assume left: u <= 1/2
  prove half: 1 - 2*u >= 0
  prove inverse: 1/(1 - u) > 0
  refute more: u <= 1/3
)~") == "half PROVED uses left\ninverse PROVED uses left\nmore REFUTED\n");
}

// The witness has to name v, although no statement does.
TEST_CASE("an inequality about a parameter that a claim does not name leaves the claim decidable") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  scalar f(u) : C^0
  assume inside: u > 0, v > 0, v < 1
  prove quotient: u*f(u)/u == f(u)
  refute zero: f(u) == 0
)~") == "quotient PROVED uses inside\nzero REFUTED\n");
}

}  // namespace patchproof
