#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("a name is declared once", "[language][reject]") {
  CHECK(type_messages(R"~(  param u in [0, 1]
  scalar x, y
  point x
  param u in [0, 1]
  let y = 2
  matrix x = [1, 2]
)~") ==
        R"~(bad.proof:4:9: error: 'x' is declared twice (first on line 3)
     4 |   point x
       |         ^
bad.proof:5:9: error: 'u' is declared twice (first on line 2)
     5 |   param u in [0, 1]
       |         ^
bad.proof:6:7: error: 'y' is declared twice (first on line 3)
     6 |   let y = 2
       |       ^
bad.proof:7:10: error: 'x' is declared twice (first on line 3)
     7 |   matrix x = [1, 2]
       |          ^
)~");
}

TEST_CASE("names that have a meaning already are not for use", "[language][reject]") {
  CHECK(type_messages(R"~(  patch r(u, v)
  scalar sin
  scalar pi
  point coons
  let r_uv = 2
  let H03 = 1
  scalar r_w
)~") ==
        R"~(bad.proof:3:10: error: 'sin' has a meaning of its own and cannot be declared
     3 |   scalar sin
       |          ^^^
bad.proof:4:10: error: 'pi' has a meaning of its own and cannot be declared
     4 |   scalar pi
       |          ^^
bad.proof:5:9: error: 'coons' is already a definition
     5 |   point coons
       |         ^^^^^
       = help: see 'patchproof definitions coons'
bad.proof:6:7: error: 'r_uv' already means a derivative of 'r'
     6 |   let r_uv = 2
       |       ^^^^
bad.proof:7:7: error: 'H03' is already a definition
     7 |   let H03 = 1
       |       ^^^
       = help: see 'patchproof definitions H03'
)~");
}

TEST_CASE("the marks of derivatives belong to no name", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x'
  curve C'(u)
)~") ==
        R"~(bad.proof:2:10: error: a name cannot contain ' because that marks derivatives
     2 |   scalar x'
       |          ^^
bad.proof:3:9: error: a name cannot contain ' because that marks derivatives
     3 |   curve C'(u)
       |         ^^
)~");
}

TEST_CASE("a range goes from a smaller to a larger scalar", "[language][reject]") {
  CHECK(type_messages(R"~(  point P
  param u in [1, 0]
  param v in [2, 2]
  param w in [0, P]
  param s in [0, 1/0]
)~") ==
        R"~(bad.proof:3:14: error: the empty range [1, 0]
     3 |   param u in [1, 0]
       |              ^^^^^^
       = help: the lower end comes first, and is smaller than the upper one
bad.proof:4:14: error: the empty range [2, 2]
     4 |   param v in [2, 2]
       |              ^^^^^^
       = help: the lower end comes first, and is smaller than the upper one
bad.proof:5:18: error: the end of a range has to be a scalar, not a point
     5 |   param w in [0, P]
       |                  ^
bad.proof:6:20: error: division by zero
     6 |   param s in [0, 1/0]
       |                    ^
)~");
}

TEST_CASE("arrays have one or two dimensions and start at 0", "[language][reject]") {
  CHECK(type_messages(R"~(  point A[0..1, 0..1, 0..1]
  point B[1..3]
  point C[0..-1]
  scalar D[0..400]
  scalar n
  point E[0..n]
  point F[0..1/2]
  point G[0..9999999]
)~") ==
        R"~(bad.proof:2:9: error: an array has one or two dimensions
     2 |   point A[0..1, 0..1, 0..1]
       |         ^
bad.proof:3:9: error: the indices of an array start at 0, not at 1
     3 |   point B[1..3]
       |         ^
bad.proof:4:9: error: an array needs at least one entry
     4 |   point C[0..-1]
       |         ^
bad.proof:5:10: error: an array has at most 400 entries in one direction
     5 |   scalar D[0..400]
       |          ^
bad.proof:7:14: error: the end of a span has to be a whole number that is known beforehand
     7 |   point E[0..n]
       |              ^
bad.proof:8:14: error: the end of a span has to be a whole number that is known beforehand
     8 |   point F[0..1/2]
       |              ^^^
bad.proof:9:14: error: the end of a span is too large
     9 |   point G[0..9999999]
       |              ^^^^^^^
)~");
}

TEST_CASE("'let' gives names to values; points and scalars are free", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x = 3
)~") ==
        R"~(bad.proof:2:10: error: a scalar is a free symbol; 'let' gives a value a name
     2 |   scalar x = 3
       |          ^
       = help: let x = ...
)~");
}

TEST_CASE("a matrix is declared by a matrix", "[language][reject]") {
  CHECK(type_messages(R"~(  point P
  matrix M = P
  matrix N = 3
)~") ==
        R"~(bad.proof:3:14: error: 'M' is declared as a matrix, and this is a point
     3 |   matrix M = P
       |              ^
bad.proof:4:14: error: 'N' is declared as a matrix, and this is a scalar
     4 |   matrix N = 3
       |              ^
)~");
}

TEST_CASE("a net has a span for each of its indices, and for nothing else", "[language][reject]") {
  CHECK(type_messages(R"~(  point c[0..3]
  net a[i, j] = c[i] for i in 0..3
  net b[i] = c[i] for i in 0..3, j in 0..1
  net d[i] = c[i] for i in 1..3
  net e[i] = c[i] for i in 3..0
)~") ==
        R"~(bad.proof:3:12: error: no span is given for the index 'j'
     3 |   net a[i, j] = c[i] for i in 0..3
       |            ^
       = help: for j in 0..3
bad.proof:4:7: error: a span is given for something that is not an index
     4 |   net b[i] = c[i] for i in 0..3, j in 0..1
       |       ^
bad.proof:5:23: error: the indices of a net start at 0, not at 1
     5 |   net d[i] = c[i] for i in 1..3
       |                       ^
bad.proof:6:23: error: the indices of a net start at 0, not at 3
     6 |   net e[i] = c[i] for i in 3..0
       |                       ^
)~");
}

TEST_CASE("parameters of a function have different names", "[language][reject]") {
  CHECK(type_messages(R"~(  let f(t, t) = t
  patch r(u, u) = (u, u)
  patch s(u, u)
  patch p(u, u) : degree (1, 1)
)~") ==
        R"~(bad.proof:2:12: error: the parameter 't' occurs twice
     2 |   let f(t, t) = t
       |            ^
bad.proof:3:14: error: the parameter 'u' occurs twice
     3 |   patch r(u, u) = (u, u)
       |              ^
bad.proof:4:14: error: the parameter 'u' occurs twice
     4 |   patch s(u, u)
       |              ^
bad.proof:5:14: error: the parameter 'u' occurs twice
     5 |   patch p(u, u) : degree (1, 1)
       |              ^
)~");
}

TEST_CASE("a function has values of the declared kind", "[language][reject]") {
  CHECK(
      type_messages(R"~(  curve D(u) = [u, 1]
  patch r(u, v) = D
  let M(t) = [t, 1 ; 1, t]
  curve B(t) = bezier([(0,0), (1,1)])
  patch p(u, v) = B
)~") ==
      R"~(bad.proof:2:16: error: a function has scalars or points as values, not a 1 x 2 matrix of scalars
     2 |   curve D(u) = [u, 1]
       |                ^^^^^^
bad.proof:4:14: error: a function has scalars or points as values, not a 2 x 2 matrix of scalars
     4 |   let M(t) = [t, 1 ; 1, t]
       |              ^^^^^^^^^^^^^
bad.proof:6:19: error: 'p' has 2 parameters, and this is a curve(t)
     6 |   patch p(u, v) = B
       |                   ^
)~");
}

TEST_CASE("degrees of patches lie in bounds", "[language][reject]") {
  CHECK(type_messages(R"~(  patch p(u, v) : degree (61, 1)
)~") ==
        R"~(bad.proof:2:9: error: a degree has to lie between 0 and 60
     2 |   patch p(u, v) : degree (61, 1)
       |         ^
)~");
}

TEST_CASE("splines have points, degrees and knots that fit", "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..4]
  point n[0..3, 0..3]
  scalar x
  spline A = bspline(x, degree 3, clamped uniform)
  spline B = bspline(d, degree 5, clamped uniform)
  spline C = bspline(d, degree 3, 3, clamped uniform)
  spline D = bspline(d, degree 0, clamped uniform)
  spline E = bspline(d, degree 41, clamped uniform)
  spline F = bspline(d, degree 3, knots x)
  spline G = bspline(d, degree 3, knots [0, 0, 0, 0, x, 1, 1, 1, 1])
  spline H = bspline(d, degree 3, knots [0, 0, 0, 0, 1, 1, 1, 1])
  spline I = bspline(d, degree 3, knots [0, 0, 0, 0, 2, 1, 1, 1, 1])
  spline J = bspline(d, degree 3, knots [0, 0, 0, 0, 0, 1, 1, 1, 1])
  spline K = bspline(d, degree 1, knots [0, 0, 1, 1, 1, 2, 2])
  spline L = bspline(d, degree 3, knots [0, 1, 2, 3, 3, 3, 4, 5, 6])
  spline M = bspline(n, degree 3, knots [0, 0, 0, 0, 1, 1, 1, 1], [0, 1])
  spline N = bspline(d, degree 4, knots [0, 0, 0, 0, 0, 0, 1, 1, 1, 1])
)~") ==
        R"~(bad.proof:5:22: error: the control points of a spline are a list or a net, not a scalar
     5 |   spline A = bspline(x, degree 3, clamped uniform)
       |                      ^
bad.proof:6:22: error: a spline of degree 5 needs at least 6 control points in each direction, not 5
     6 |   spline B = bspline(d, degree 5, clamped uniform)
       |                      ^
bad.proof:7:22: error: a spline curve has one degree
     7 |   spline C = bspline(d, degree 3, 3, clamped uniform)
       |                      ^
bad.proof:8:22: error: the degree of a spline has to lie between 1 and 40
     8 |   spline D = bspline(d, degree 0, clamped uniform)
       |                      ^
bad.proof:9:22: error: the degree of a spline has to lie between 1 and 40
     9 |   spline E = bspline(d, degree 41, clamped uniform)
       |                      ^
bad.proof:10:41: error: knots are a list of numbers
    10 |   spline F = bspline(d, degree 3, knots x)
       |                                         ^
       = help: as in: knots [0, 0, 0, 1, 1, 1]
bad.proof:12:41: error: 5 control points of degree 3 need 9 knots, not 8
    12 |   spline H = bspline(d, degree 3, knots [0, 0, 0, 0, 1, 1, 1, 1])
       |                                         ^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:13:57: error: knots must not decrease
    13 |   spline I = bspline(d, degree 3, knots [0, 0, 0, 0, 2, 1, 1, 1, 1])
       |                                                         ^
bad.proof:14:54: error: a knot occurs at most degree + 1 = 4 times
    14 |   spline J = bspline(d, degree 3, knots [0, 0, 0, 0, 0, 1, 1, 1, 1])
       |                                                      ^
bad.proof:15:54: error: a knot occurs at most degree + 1 = 2 times
    15 |   spline K = bspline(d, degree 1, knots [0, 0, 1, 1, 1, 2, 2])
       |                                                      ^
bad.proof:16:41: error: these knots leave no interval for the spline to be defined on
    16 |   spline L = bspline(d, degree 3, knots [0, 1, 2, 3, 3, 3, 4, 5, 6])
       |                                         ^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:17:67: error: 4 control points of degree 3 need 8 knots, not 2
    17 |   spline M = bspline(n, degree 3, knots [0, 0, 0, 0, 1, 1, 1, 1], [0, 1])
       |                                                                   ^^^^^^
bad.proof:18:57: error: a knot occurs at most degree + 1 = 5 times
    18 |   spline N = bspline(d, degree 4, knots [0, 0, 0, 0, 0, 0, 1, 1, 1, 1])
       |                                                         ^
)~");
}

}  // namespace patchproof
