#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

namespace {

std::string messages_of_case(const std::string& statements) {
  return type_messages(statements);
}

}  // namespace

TEST_CASE("an integral needs variables with ranges that are not empty",
          "[language][reject][integral]") {
  CHECK(messages_of_case("  show integral(u, u in [1, 0])\n") ==
        R"~(bad.proof:2:25: error: the empty range [1, 0]
     2 |   show integral(u, u in [1, 0])
       |                         ^^^^^^
       = help: the lower end comes first, and is smaller than the upper one
)~");
  CHECK(messages_of_case("  show integral(u, u in [2, 2])\n") ==
        R"~(bad.proof:2:25: error: the empty range [2, 2]
     2 |   show integral(u, u in [2, 2])
       |                         ^^^^^^
       = help: the lower end comes first, and is smaller than the upper one
)~");
  CHECK(messages_of_case("  show integral(1, 2)\n") ==
        R"~(bad.proof:2:8: error: a variable with its range is needed here, as in 'u in [0, 1]'
     2 |   show integral(1, 2)
       |        ^^^^^^^^^^^^^^
)~");
  CHECK(messages_of_case("  show integral(i, i in 0..3)\n") ==
        R"~(bad.proof:2:8: error: a variable with its range is needed here, as in 'u in [0, 1]'
     2 |   show integral(i, i in 0..3)
       |        ^^^^^^^^^^^^^^^^^^^^^^
)~");
  CHECK(messages_of_case("  show integral(1)\n") ==
        R"~(bad.proof:2:8: error: 'integral' cannot take 1 argument
     2 |   show integral(1)
       |        ^^^^^^^^^^^
       = help: integral(f(u), u in [0, 1])
)~");
  CHECK(messages_of_case("  show integral(u, u in [0, 1], u in [0, 1])\n") ==
        R"~(bad.proof:2:33: error: the variable 'u' occurs twice
     2 |   show integral(u, u in [0, 1], u in [0, 1])
       |                                 ^
)~");
  CHECK(messages_of_case("  show integral(u, u in 0, 1)\n") ==
        R"~(bad.proof:2:26: error: expected '..', found ','
     2 |   show integral(u, u in 0, 1)
       |                          ^
)~");
}

TEST_CASE("the ends of a range do not depend on the variables", "[language][reject][integral]") {
  CHECK(
      messages_of_case("  param u in [0, 1]\n  show integral(u, u in [0, u])\n") ==
      R"~(bad.proof:3:29: error: the ends of a range cannot contain 'u', which is a variable of this integral
     3 |   show integral(u, u in [0, u])
       |                             ^
       = help: give the variable of the integral another name
)~");
}

TEST_CASE("a value in the parameter of the case is no function to be integrated",
          "[language][reject][integral]") {
  CHECK(
      messages_of_case("  param u in [0, 1]\n  let k = u^2\n  show integral(k, u in [0, 1])\n") ==
      R"~(bad.proof:4:17: error: this integrand contains the parameter 'u' of the case, which is not the variable 'u' of the integral
     4 |   show integral(k, u in [0, 1])
       |                 ^
       = help: make what contains it a function, as in 'let f(u) = ...'
)~");
  CHECK(messages_of_case("  show integral([1, 2 ; 3, 4], u in [0, 1])\n") ==
        R"~(bad.proof:2:17: error: scalars and points are integrated, not a 2 x 2 matrix of scalars
     2 |   show integral([1, 2 ; 3, 4], u in [0, 1])
       |                 ^^^^^^^^^^^^^
)~");
}

TEST_CASE("a functional is given the functions it speaks of", "[language][reject][integral]") {
  const std::string energy =
      "  param u, v in [0, 1]\n  point P in R^3\n  patch p(u, v) in R^3 : C^2\n"
      "  let E(q) = integral(dot(q_uv, q_uv), u in [0, 1], v in [0, 1])\n";
  CHECK(messages_of_case(energy + "  show E\n") ==
        R"~(bad.proof:6:8: error: 'E' needs arguments: E(q)
     6 |   show E
       |        ^
)~");
  CHECK(messages_of_case(energy + "  show E(p, p)\n") ==
        R"~(bad.proof:6:8: error: 'E' takes 1 argument, not 2
     6 |   show E(p, p)
       |        ^^^^^^^
)~");
  CHECK(messages_of_case(energy + "  show E(p(u,0))\n") ==
        R"~(bad.proof:6:10: error: it is not clear which parameters this patch runs over
     6 |   show E(p(u,0))
       |          ^^^^^^
       = help: declare it as a patch: 'patch p(u, v) = ...'
)~");
  CHECK(messages_of_case(energy + "  show E(u*v)\n") ==
        R"~(bad.proof:6:8: error: in 'E': a point is needed here, not a scalar
     6 |   show E(u*v)
       |        ^^^^^^
)~");
}

TEST_CASE("what a minimum is said of has to make sense", "[language][reject][minimum]") {
  const std::string given =
      "  param u, v in [0, 1]\n  scalar b[0..3, 0..3]\n  scalar h(u, v) : C^2\n"
      "  patch r(u, v) = bezier(b)\n  scalar q[0..3, 0..3]\n  patch p(u, v) = bezier(q)\n"
      "  let E(q) = integral(q_uv^2, u in [0, 1], v in [0, 1])\n";
  CHECK(messages_of_case(given + "  prove m: r minimizes E(h) over h\n") ==
        R"~(bad.proof:9:34: error: 'h' is not given by control points
     9 |   prove m: r minimizes E(h) over h
       |                                  ^
       = help: a competitor is polynomial, as in 'patch p(u, v) in R^3 : degree (3, 3)'
)~");
  CHECK(messages_of_case(given + "  prove m: p minimizes E(p) over p\n") ==
        R"~(bad.proof:9:12: error: the candidate contains control points of the competitor 'p'
     9 |   prove m: p minimizes E(p) over p
       |            ^
)~");
  CHECK(messages_of_case(given + "  prove m: r minimizes E(r) over p\n") ==
        R"~(bad.proof:9:24: error: this functional does not depend on the competitor 'p'
     9 |   prove m: r minimizes E(r) over p
       |                        ^^^^
)~");
  CHECK(
      messages_of_case(given + "  prove m: r minimizes p over p\n") ==
      R"~(bad.proof:9:24: error: what is minimized contains the parameter 'u', so that it is no number
     9 |   prove m: r minimizes p over p
       |                        ^
       = help: minimize an integral, or the value at one place
)~");
  CHECK(messages_of_case(given + "  prove m: r minimizes E(p) over p where p(0,0) >= 0\n") ==
        R"~(bad.proof:9:42: error: competitors are restricted by equations, written '=='
     9 |   prove m: r minimizes E(p) over p where p(0,0) >= 0
       |                                          ^^^^^^^^^^^
)~");
  CHECK(messages_of_case(given + "  prove m: r minimizes E(p)\n") ==
        R"~(bad.proof:9:28: error: expected 'over'; the statement ends here
     9 |   prove m: r minimizes E(p)
       |                            ^
)~");
  CHECK(messages_of_case(given + "  assume m: r minimizes E(p) over p\n") ==
        R"~(bad.proof:9:15: error: 'minimizes' makes a claim of its own
     9 |   assume m: r minimizes E(p) over p
       |               ^^^^^^^^^
       = help: as in 'prove least: r minimizes E(p) over p where p == r on boundary'
)~");
}

}  // namespace patchproof
