#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("splines made of other splines, of Bézier points and with weights have parts that fit", "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..4], n[0..3, 0..4]
  scalar x, y, w[0..4]
  spline T = bspline(d, degree 3, clamped uniform)
  spline S = bspline(n, degree 3, clamped uniform)
  spline X = bspline(d, degree 3, knots [0, 0, 0, 0, x, 1, 1, 1, 1])
  spline A = insert_knot(T, 5)
  spline B = insert_knot(T, 0)
  spline C = insert_knot(insert_knot(insert_knot(insert_knot(T, 1), 1), 1), 1)
  spline D = insert_knot(S, 1/2)
  spline E = insert_knot(S, w, 1/2)
  spline F = insert_knot(T, u, 1/2)
  spline G = insert_knot(X, 1/2)
  spline H = insert_knot(X, x)
  spline I = insert_knot(T)
  spline J = insert_knot(T, d)
  spline K = insert_knot(T, i in 0..1)
  spline L = elevate_degree(x)
  spline V = bezier(d)
  spline W = x
  spline Y = Z
  spline Y2 = insert_knot(A, 1)
)~") ==
        R"~(bad.proof:7:29: error: the knot 5 lies outside the range [0, 2] of this spline
     7 |   spline A = insert_knot(T, 5)
       |                             ^
bad.proof:8:29: error: this knot already has the multiplicity 4, and a knot is inserted up to the degree 3
     8 |   spline B = insert_knot(T, 0)
       |                             ^
bad.proof:9:73: error: this knot already has the multiplicity 3, and a knot is inserted up to the degree 3
     9 |   spline C = insert_knot(insert_knot(insert_knot(insert_knot(T, 1), 1), 1), 1)
       |                                                                         ^
bad.proof:10:14: error: a spline surface has two directions, u and v
    10 |   spline D = insert_knot(S, 1/2)
       |              ^^^^^^^^^^^^^^^^^^^
       = help: insert_knot(T, t) of a curve, insert_knot(T, u, t) of a surface
bad.proof:11:29: error: a direction is u or v
    11 |   spline E = insert_knot(S, w, 1/2)
       |                             ^
       = help: insert_knot(T, t) of a curve, insert_knot(T, u, t) of a surface
bad.proof:12:14: error: a spline curve has one direction, which is not named
    12 |   spline F = insert_knot(T, u, 1/2)
       |              ^^^^^^^^^^^^^^^^^^^^^^
       = help: insert_knot(T, t) of a curve, insert_knot(T, u, t) of a surface
bad.proof:13:29: error: it is not known between which knots this knot lies
    13 |   spline G = insert_knot(X, 1/2)
       |                             ^^^
       = help: inserted_points(d, degree, knots, k, t) takes the number k of the interval
bad.proof:15:14: error: 'insert_knot' cannot take 1 argument
    15 |   spline I = insert_knot(T)
       |              ^^^^^^^^^^^^^^
       = help: insert_knot(T, t) or insert_knot(T, u, t)
bad.proof:16:29: error: a knot has to be a scalar, not a list of 5 points
    16 |   spline J = insert_knot(T, d)
       |                             ^
bad.proof:17:14: error: a knot cannot run
    17 |   spline K = insert_knot(T, i in 0..1)
       |              ^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:18:29: error: a spline is needed here
    18 |   spline L = elevate_degree(x)
       |                             ^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
bad.proof:19:14: error: a spline is needed here
    19 |   spline V = bezier(d)
       |              ^^^^^^^^^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
bad.proof:20:14: error: a spline is needed here
    20 |   spline W = x
       |              ^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
bad.proof:21:14: error: unknown name 'Z'
    21 |   spline Y = Z
       |              ^
)~");
}

TEST_CASE("the parts of a declared spline fit", "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..4], n[0..3, 0..4]
  scalar x, y
  spline J = bspline(d, degree 3, knots [0, 0, 0, 0, x, 0, 1, 1, 1])
  spline K = bspline(d, degree 3, knots [0, 0, 0, x, y, x, 1, 1, 1])
  spline K2 = bspline(d, degree 3, knots [0, 0, 0, x, x, x, x, x, 1])
  spline K3 = bspline(d, degree 3, knots [x, x, x, x, 2, y, y, 1, y])
  spline K4 = bspline(d, degree 3, knots d)
  spline L = bspline(d, degree 3, weights [1, 2], clamped uniform)
  spline M = bspline(d, degree 3, weights d, clamped uniform)
  spline M2 = bspline(d, degree 3, weights x, clamped uniform)
  spline N = merged(d, degree 3, clamped uniform)
  spline O = merged(d, degree 2, knots [0, 0, 0, 1, 1, 1])
  spline P = merged(d, degree 2, knots [0, 0, 0, 1, 2, 3, 3, 3])
  spline Q = merged(d, degree 2, knots [0, 0, 0, 1, 1, 1, 2, 2, 2])
  spline R = merged(d, degree 2, knots [0, 1])
  spline R2 = merged(x, degree 2, knots [0, 1])
  spline U = bspline(d, degree 3, knots [0, 0, 0, 0, 1, 2, 2, 2, 2], [0, 1])
)~") ==
        R"~(bad.proof:4:57: error: equal knots stand together
     4 |   spline J = bspline(d, degree 3, knots [0, 0, 0, 0, x, 0, 1, 1, 1])
       |                                                         ^
bad.proof:5:57: error: equal knots stand together
     5 |   spline K = bspline(d, degree 3, knots [0, 0, 0, x, y, x, 1, 1, 1])
       |                                                         ^
bad.proof:6:64: error: a knot occurs at most degree + 1 = 4 times
     6 |   spline K2 = bspline(d, degree 3, knots [0, 0, 0, x, x, x, x, x, 1])
       |                                                                ^
bad.proof:7:64: error: knots must not decrease
     7 |   spline K3 = bspline(d, degree 3, knots [x, x, x, x, 2, y, y, 1, y])
       |                                                                ^
bad.proof:8:42: error: knots are a list of numbers
     8 |   spline K4 = bspline(d, degree 3, knots d)
       |                                          ^
       = help: as in: knots [0, 0, 0, 1, 1, 1]
bad.proof:9:43: error: each point has one weight: a list of 2 scalars does not fit a list of 5 points
     9 |   spline L = bspline(d, degree 3, weights [1, 2], clamped uniform)
       |                                           ^^^^^^
bad.proof:10:43: error: weights are numbers, this is a list of 5 points
    10 |   spline M = bspline(d, degree 3, weights d, clamped uniform)
       |                                           ^
bad.proof:11:44: error: the weights of a spline are a list or a net, not a scalar
    11 |   spline M2 = bspline(d, degree 3, weights x, clamped uniform)
       |                                            ^
bad.proof:12:21: error: k pieces of degree 3 have 3*k + 1 Bézier points, not 5
    12 |   spline N = merged(d, degree 3, clamped uniform)
       |                     ^
bad.proof:13:40: error: these knots have 1 interval, and there are Bézier points of 2 pieces
    13 |   spline O = merged(d, degree 2, knots [0, 0, 0, 1, 1, 1])
       |                                        ^^^^^^^^^^^^^^^^^^
bad.proof:14:40: error: these knots have 3 intervals, and there are Bézier points of 2 pieces
    14 |   spline P = merged(d, degree 2, knots [0, 0, 0, 1, 2, 3, 3, 3])
       |                                        ^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:15:21: error: this spline is not continuous: an inner knot has a multiplicity above the degree
    15 |   spline Q = merged(d, degree 2, knots [0, 0, 0, 1, 1, 1, 2, 2, 2])
       |                     ^
bad.proof:16:40: error: a spline of degree 2 has at least 6 knots, not 2
    16 |   spline R = merged(d, degree 2, knots [0, 1])
       |                                        ^^^^^^
bad.proof:17:22: error: the Bézier points of a spline are a list or a net, not a scalar
    17 |   spline R2 = merged(x, degree 2, knots [0, 1])
       |                      ^
bad.proof:18:70: error: a spline curve has one list of knots
    18 |   spline U = bspline(d, degree 3, knots [0, 0, 0, 0, 1, 2, 2, 2, 2], [0, 1])
       |                                                                      ^^^^^^
)~");
}

TEST_CASE("what is asked of a spline is there", "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..4], n[0..3, 0..4]
  param s in [0, 1]
  spline T = bspline(d, degree 3, clamped uniform)
  spline S = bspline(n, degree 3, clamped uniform)
  spline Z = bspline(d, degree 3, weights [1, 0, 0, 0, 1], clamped uniform)
  prove a: insert_knot(T, 1/2) == d
  prove b: knots(S) == knots(T)
  prove c: knots(T, u) == knots(T)
  prove e: greville(S, s) == knots(T)
  prove f: weights(T) == d
  prove g: bezier_weights(T) == d
  prove h: bezier_net(Z) == d
  prove i: segment(insert_knot(T, 1/2), 3)(s) == d[0]
  prove j: elevate_degree(T) == d
  prove k: greville == d
  prove l: knots(d) == d
)~") ==
        R"~(bad.proof:7:12: error: 'insert_knot' gives a spline, which is made of pieces
     7 |   prove a: insert_knot(T, 1/2) == d
       |            ^^^^^^^^^^^^^^^^^^^
       = help: segment(insert_knot(…), 0) is its first piece; spline T = insert_knot(…) gives it a name
bad.proof:8:12: error: a spline surface has two directions, u and v
     8 |   prove b: knots(S) == knots(T)
       |            ^^^^^^^^
       = help: knots(T) of a curve, knots(T, u) of a surface
bad.proof:9:12: error: a spline curve has one direction, which is not named
     9 |   prove c: knots(T, u) == knots(T)
       |            ^^^^^^^^^^^
       = help: knots(T) of a curve, knots(T, u) of a surface
bad.proof:10:24: error: a direction is u or v
    10 |   prove e: greville(S, s) == knots(T)
       |                        ^
       = help: greville(T) of a curve, greville(T, u) of a surface
bad.proof:11:12: error: this spline has no weights
    11 |   prove f: weights(T) == d
       |            ^^^^^^^^^^
       = help: spline T = bspline(d, degree 2, weights w, clamped uniform)
bad.proof:12:12: error: this spline has no weights
    12 |   prove g: bezier_weights(T) == d
       |            ^^^^^^^^^^^^^^^^^
bad.proof:13:12: error: one of these points has the weight 0: it is a direction, not a point
    13 |   prove h: bezier_net(Z) == d
       |            ^^^^^^^^^^^^^
bad.proof:14:12: error: this spline has the segments 0..2 in this direction, not 3
    14 |   prove i: segment(insert_knot(T, 1/2), 3)(s) == d[0]
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:15:12: error: 'elevate_degree' gives a spline, which is made of pieces
    15 |   prove j: elevate_degree(T) == d
       |            ^^^^^^^^^^^^^^^^^
       = help: segment(elevate_degree(…), 0) is its first piece; spline T = elevate_degree(…) gives it a name
bad.proof:16:12: error: 'greville' needs arguments: greville(T) or greville(T, u)
    16 |   prove k: greville == d
       |            ^^^^^^^^
bad.proof:17:18: error: a spline is needed here
    17 |   prove l: knots(d) == d
       |                  ^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
)~");
}

TEST_CASE("a rational curve or patch has one weight for each point", "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..4], n[0..3, 0..4]
  scalar w[0..4]
  prove j: rational_bezier(d, [1, 2]) == 0
  prove k: rational_bezier(d, d) == 0
  prove l: rational_bezier(d, [0, 0, 0, 0, 0]) == 0
  prove m: rational_bezier(d) == 0
  prove n: rational_bezier(n, w) == 0
  prove o: rational_bezier(n[0..3, 0..3], n) == 0
  prove p: rational_bezier_curve(d, [1, 1, 1, 1]) == 0
  prove q: rational_bezier_curve(d, [1, 1, 1, 1, 1, 1]) == 0
  prove r: weighted(d, [1, 1, 1, 1, 1, 1]) == d
  assume z: w[0] == w[k] for k in 3..2
  assume y: w[0] == w[k] for k in 3..5
)~") ==
        R"~(bad.proof:4:31: error: each point has one weight: a 1 x 2 matrix of scalars does not fit a list of 5 points
     4 |   prove j: rational_bezier(d, [1, 2]) == 0
       |                               ^^^^^^
bad.proof:5:31: error: weights are numbers, this is a list of 5 points
     5 |   prove k: rational_bezier(d, d) == 0
       |                               ^
bad.proof:6:31: error: all weights are 0: there is no curve or patch
     6 |   prove l: rational_bezier(d, [0, 0, 0, 0, 0]) == 0
       |                               ^^^^^^^^^^^^^^^
bad.proof:7:12: error: 'rational_bezier' cannot take 1 argument
     7 |   prove m: rational_bezier(d) == 0
       |            ^^^^^^^^^^^^^^^^^^
       = help: rational_bezier(b, w)
bad.proof:8:31: error: each point has one weight: a list of 5 scalars does not fit a 4 x 5 matrix of points
     8 |   prove n: rational_bezier(n, w) == 0
       |                               ^
bad.proof:9:43: error: weights are numbers, this is a 4 x 5 matrix of points
     9 |   prove o: rational_bezier(n[0..3, 0..3], n) == 0
       |                                           ^
bad.proof:10:12: error: in 'rational_bezier_curve': index 4 is outside 0..3
    10 |   prove p: rational_bezier_curve(d, [1, 1, 1, 1]) == 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:11:12: error: in 'rational_bezier_curve': index 5 is outside 0..4
    11 |   prove q: rational_bezier_curve(d, [1, 1, 1, 1, 1, 1]) == 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:12:12: error: in 'weighted': index 5 is outside 0..4
    12 |   prove r: weighted(d, [1, 1, 1, 1, 1, 1]) == d
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:13:30: error: 'k' runs over the empty span 3..2
    13 |   assume z: w[0] == w[k] for k in 3..2
       |                              ^
bad.proof:14:21: error: index 5 is outside 0..4
    14 |   assume y: w[0] == w[k] for k in 3..5
       |                     ^^^^
)~");
}

TEST_CASE("knots of which it can be told that they do not increase are rejected",
          "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..3]
  scalar a
  spline A = bspline(d, degree 1, knots [0, 0, sqrt(4), 2, 5, 5])
  spline B = bspline(d, degree 1, knots [0, 0, sqrt(2), 1, 5, 5])
  spline C = bspline(d, degree 1, knots [a, a, a + 2, a + 1, 5, 5])
  spline D = bspline(d, degree 1, knots [0, 0, 1, sqrt(2), a, a])
)~") ==
        R"~(bad.proof:4:57: error: this knot is equal to one before it
     4 |   spline A = bspline(d, degree 1, knots [0, 0, sqrt(4), 2, 5, 5])
       |                                                         ^
       = help: equal knots are written alike
bad.proof:5:57: error: knots must not decrease
     5 |   spline B = bspline(d, degree 1, knots [0, 0, sqrt(2), 1, 5, 5])
       |                                                         ^
bad.proof:6:55: error: knots must not decrease
     6 |   spline C = bspline(d, degree 1, knots [a, a, a + 2, a + 1, 5, 5])
       |                                                       ^^^^^
)~");
}

}  // namespace patchproof
