#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("only scalars are ordered", "[language][reject]") {
  CHECK(type_messages(R"~(  point P, Q in R^2
  prove x: P < Q
  prove y: [1, 2 ; 3, 4] >= 0
)~") ==
        R"~(bad.proof:3:12: error: only scalars are smaller or larger, not a point in R^2
     3 |   prove x: P < Q
       |            ^^^^^
bad.proof:4:12: error: only scalars are smaller or larger, not a 2 x 2 matrix of scalars
     4 |   prove y: [1, 2 ; 3, 4] >= 0
       |            ^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("both sides of a comparison are of one type", "[language][reject]") {
  CHECK(type_messages(R"~(  point P in R^2
  point Q in R^3
  point A
  scalar x
  patch r(u, v)
  curve C(u)
  prove a: P == Q
  prove b: P == x
  prove c: A == Q
  prove d: r == C
  prove e: [1, 2] == [1 ; 2]
  prove f: C == x
  prove g: [1, 2 ; 3, 4] == P
)~") ==
        R"~(bad.proof:8:12: error: a point in R^2 is compared with a point in R^3
     8 |   prove a: P == Q
       |            ^^^^^^
bad.proof:9:12: error: a point in R^2 is compared with a scalar
     9 |   prove b: P == x
       |            ^^^^^^
bad.proof:10:12: error: a point is compared with a point in R^3
    10 |   prove c: A == Q
       |            ^^^^^^
       = help: declare the dimension: 'point P in R^3', 'curve C(u) in R^3'
bad.proof:11:12: error: a patch(u, v) is compared with a curve(u)
    11 |   prove d: r == C
       |            ^^^^^^
bad.proof:12:12: error: a 1 x 2 matrix of scalars is compared with a 2 x 1 matrix of scalars
    12 |   prove e: [1, 2] == [1 ; 2]
       |            ^^^^^^^^^^^^^^^^^
bad.proof:13:12: error: a value is needed here, and this is a curve(u)
    13 |   prove f: C == x
       |            ^
       = help: 'u' is not a parameter of this case; write C(u) with values for the parameters
bad.proof:14:12: error: a 2 x 2 matrix of scalars is compared with a point in R^2
    14 |   prove g: [1, 2 ; 3, 4] == P
       |            ^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("a function without parameters of the case has no value", "[language][reject]") {
  CHECK(type_messages(R"~(  curve C(t)
  point A
  prove a: C + A == A
)~") ==
        R"~(bad.proof:4:12: error: a value is needed here, and this is a curve(t)
     4 |   prove a: C + A == A
       |            ^
       = help: 't' is not a parameter of this case; write C(t) with values for the parameters
)~");
}

TEST_CASE("'on boundary' is said of two patches, and of equality", "[language][reject]") {
  CHECK(type_messages(R"~(  param u, v in [0, 1]
  scalar x
  curve C(u)
  patch r(u, v)
  prove a: x == x on boundary
  prove b: C == C on boundary
  prove c: r != r on boundary
)~") ==
        R"~(bad.proof:6:12: error: 'on boundary' compares two patches
     6 |   prove a: x == x on boundary
       |            ^^^^^^^^^^^^^^^^^^
bad.proof:7:12: error: 'on boundary' compares two patches
     7 |   prove b: C == C on boundary
       |            ^^^^^^^^^^^^^^^^^^
bad.proof:8:12: error: 'on boundary' goes with '=='
     8 |   prove c: r != r on boundary
       |            ^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("a joint is made of curves or patches at the ends of their ranges",
          "[language][reject]") {
  CHECK(type_messages(R"~(  param t in [0, 1]
  param s in [2, 3]
  curve p(t), q(t), w(s)
  curve flat(t) = (t, 0)
  patch r(u, v)
  point P
  prove a: C^21 joint of p at t = 1 and q at t = 0
  prove b: C^1 joint of P at t = 1 and q at t = 0
  prove c: C^1 joint of p at u = 1 and q at t = 0
  prove d: C^1 joint of p at t = P and q at t = 0
  prove e: C^1 joint of p at t = 1/2 and q at t = 0
  prove f: C^1 joint of p at t = 1 and r at u = 0
  prove g: C^1 joint of p at t = 1 and w at s = 0
  prove h: C^1 joint of p at t = 1 and flat at t = 0
  prove i: C^1 joint of pp at t = 1 and q at t = 0
  prove j: C^1 joint of p at tt = 1 and q at t = 0
)~") ==
        R"~(bad.proof:8:12: error: the order of a joint is at most 20
     8 |   prove a: C^21 joint of p at t = 1 and q at t = 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:9:25: error: 'P' is a point, not a curve or patch
     9 |   prove b: C^1 joint of P at t = 1 and q at t = 0
       |                         ^
bad.proof:10:30: error: 'u' is not a parameter of 'p', a curve(t)
    10 |   prove c: C^1 joint of p at u = 1 and q at t = 0
       |                              ^
bad.proof:11:34: error: the place of an edge has to be a scalar, not a point
    11 |   prove d: C^1 joint of p at t = P and q at t = 0
       |                                  ^
bad.proof:12:34: error: an edge of 'p' lies at an end of the range of 't'
    12 |   prove e: C^1 joint of p at t = 1/2 and q at t = 0
       |                                  ^^^
       = help: 't' runs over [0, 1]
bad.proof:13:12: error: a curve(t) cannot be joined to a patch(u, v)
    13 |   prove f: C^1 joint of p at t = 1 and r at u = 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:14:49: error: an edge of 'w' lies at an end of the range of 's'
    14 |   prove g: C^1 joint of p at t = 1 and w at s = 0
       |                                                 ^
       = help: 's' runs over [2, 3]
bad.proof:15:12: error: the two sides of a joint have values of one type, and these are a point and a point in R^2
    15 |   prove h: C^1 joint of p at t = 1 and flat at t = 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:16:25: error: unknown name 'pp'
    16 |   prove i: C^1 joint of pp at t = 1 and q at t = 0
       |                         ^^
       = help: did you mean 'pi'?
bad.proof:17:30: error: 'tt' is not a parameter of 'p', a curve(t)
    17 |   prove j: C^1 joint of p at tt = 1 and q at t = 0
       |                              ^^
)~");
}

TEST_CASE("a G^k joint has the order, the values and the functions it needs",
          "[language][reject]") {
  CHECK(type_messages(R"~(  param t in [0, 1]
  curve p(t), q(t)
  curve flat(t) = (t, 0)
  patch r(u, v)
  scalar k
  prove a: G^3 joint of flat at t = 1 and flat at t = 0
  prove b: G^1 joint of p at t = 1 and q at t = 0
  prove c: G^1 joint of p at t = 1 and q at t = 0 with k, k
  prove d: G^2 joint of r at v = 1 and r at v = 0 with k, k
  prove e: G^1 joint of p at t = 1 and q at t = 0 with p
  prove f: G^0 joint of p at t = 1 and q at t = 0 with k
  prove g: G^1 joint of flat at t = 1 and q at t = 0
  derive k: k from G^1 joint of p at t = 1 and q at t = 0 with k
  volume V(a, b, c)
  prove h: G^1 joint of V at c = 1 and V at c = 0 with k, k
)~") ==
        R"~(bad.proof:7:12: error: the order of a G^k joint is at most 2
     7 |   prove a: G^3 joint of flat at t = 1 and flat at t = 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
       = help: higher orders can be written out as equations
bad.proof:8:12: error: a G^k joint without its connecting functions needs curves or patches in R^2 or R^3, and the values here are a point
     8 |   prove b: G^1 joint of p at t = 1 and q at t = 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
       = help: give the functions: 'with alpha, gamma'; or declare the dimension: 'point V[0..3] in R^3'
bad.proof:9:56: error: a G^1 joint of curves has 1 connecting function, not 2
     9 |   prove c: G^1 joint of p at t = 1 and q at t = 0 with k, k
       |                                                        ^
       = help: alpha of order 1, then beta of order 2
bad.proof:10:56: error: a G^2 joint of patches has 4 connecting functions, not 2
    10 |   prove d: G^2 joint of r at v = 1 and r at v = 0 with k, k
       |                                                        ^
       = help: alpha, gamma of order 1, then beta, delta of order 2
bad.proof:11:56: error: a connecting function has to be a scalar, not a point
    11 |   prove e: G^1 joint of p at t = 1 and q at t = 0 with p
       |                                                        ^
bad.proof:12:56: error: a G^0 joint of curves has 0 connecting functions, not 1
    12 |   prove f: G^0 joint of p at t = 1 and q at t = 0 with k
       |                                                        ^
       = help: leave 'with' out
bad.proof:13:12: error: the two sides of a joint have values of one type, and these are a point in R^2 and a point
    13 |   prove g: G^1 joint of flat at t = 1 and q at t = 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:14:20: error: unknowns are derived from equations, written '=='
    14 |   derive k: k from G^1 joint of p at t = 1 and q at t = 0 with k
       |                    ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:16:12: error: a G^k joint is one of curves or patches, not of volumes
    16 |   prove h: G^1 joint of V at c = 1 and V at c = 0 with k, k
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
       = help: 'C^k joint' goes with volumes too
)~");
}

TEST_CASE("'using' names a derivation above", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  derive found: x from x == 1
  prove a: x == 1 using fuond
  prove b: x == 1 using later
  prove c: x == 1 using a
  derive later: x from x == 1
)~") ==
        R"~(bad.proof:4:25: error: 'using' needs a derivation above, and 'fuond' is none
     4 |   prove a: x == 1 using fuond
       |                         ^^^^^
       = help: did you mean 'found'?
bad.proof:5:25: error: 'using' needs a derivation above, and 'later' is none
     5 |   prove b: x == 1 using later
       |                         ^^^^^
bad.proof:6:25: error: 'using' needs a derivation above, and 'a' is none
     6 |   prove c: x == 1 using a
       |                         ^
)~");
}

TEST_CASE("what is derived are points, scalars and holes, from equations", "[language][reject]") {
  CHECK(
      type_messages(R"~(  param u in [0, 1]
  scalar x, y
  point V[0..1]
  curve C(u)
  derive a: 3 from x == 1
  derive b: C from C(u) == V[0]
  derive c: u from u == 1
  derive d: x from x > 1
  derive e: x, y from x == 1, y == 2 gives 1
  derive f: x from x == 1 gives 1, 2
  derive g: x from x == 1 leaves y
  derive h: x from x == 1 gives V[0]
  derive i: x + y from x == 1
)~") ==
      R"~(bad.proof:6:13: error: nothing here is unknown: derive needs points, scalars, or a matrix with '?'
     6 |   derive a: 3 from x == 1
       |             ^
bad.proof:7:13: error: nothing here is unknown: derive needs points, scalars, or a matrix with '?'
     7 |   derive b: C from C(u) == V[0]
       |             ^
bad.proof:8:13: error: nothing here is unknown: derive needs points, scalars, or a matrix with '?'
     8 |   derive c: u from u == 1
       |             ^
bad.proof:9:20: error: unknowns are derived from equations, written '=='
     9 |   derive d: x from x > 1
       |                    ^^^^^
bad.proof:10:44: error: as many values as unknowns are needed: 2, not 1
    10 |   derive e: x, y from x == 1, y == 2 gives 1
       |                                            ^
bad.proof:11:33: error: as many values as unknowns are needed: 1, not 2
    11 |   derive f: x from x == 1 gives 1, 2
       |                                 ^
bad.proof:12:34: error: 'y' is not one of the unknowns
    12 |   derive g: x from x == 1 leaves y
       |                                  ^
bad.proof:13:33: error: a scalar is compared with a point
    13 |   derive h: x from x == 1 gives V[0]
       |                                 ^^^^
bad.proof:14:13: error: nothing here is unknown: derive needs points, scalars, or a matrix with '?'
    14 |   derive i: x + y from x == 1
       |             ^^^^^
)~");
}

}  // namespace patchproof
