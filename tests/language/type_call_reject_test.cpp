#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("a spline is used by its pieces", "[language][reject]") {
  CHECK(type_messages(R"~(  point d[0..4]
  scalar x
  spline T = bspline(d, degree 3, clamped uniform)
  point n[0..3, 0..4]
  spline S = bspline(n, degree 3, clamped uniform)
  prove a: T == T
  prove b: segment(T, 2) == segment(T, 0)
  prove c: segment(T, 0, 0) == segment(T, 0)
  prove d: segment(S, 0) == segment(T, 0)
  prove e: segment(x, 0) == segment(T, 0)
  prove f: segment(U, 0) == segment(T, 0)
  prove g: segment(T, x) == segment(T, 0)
  prove h: segment(S, 0, 2) == segment(S, 0, 0)
  prove i: segment(T, i in 0..1) == segment(T, 0)
  prove j: control_points(x) == d
  prove k: segment(T, 0-1) == segment(T, 0)
)~") ==
        R"~(bad.proof:7:12: error: 'T' is a spline, which is made of pieces
     7 |   prove a: T == T
       |            ^
       = help: segment(T, 0) is its first piece, for a surface segment(T, 0, 0)
bad.proof:8:12: error: this spline has the segments 0..1 in this direction, not 2
     8 |   prove b: segment(T, 2) == segment(T, 0)
       |            ^^^^^^^^^^^^^
bad.proof:9:12: error: a spline curve has one segment number
     9 |   prove c: segment(T, 0, 0) == segment(T, 0)
       |            ^^^^^^^^^^^^^^^^
       = help: segment(T, i)
bad.proof:10:12: error: a spline surface has two segment numbers
    10 |   prove d: segment(S, 0) == segment(T, 0)
       |            ^^^^^^^^^^^^^
       = help: segment(T, i, j)
bad.proof:11:20: error: a spline is needed here
    11 |   prove e: segment(x, 0) == segment(T, 0)
       |                    ^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
bad.proof:12:20: error: unknown name 'U'
    12 |   prove f: segment(U, 0) == segment(T, 0)
       |                    ^
bad.proof:13:23: error: a segment number has to be a whole number that is known beforehand
    13 |   prove g: segment(T, x) == segment(T, 0)
       |                       ^
bad.proof:14:12: error: this spline has the segments 0..1 in this direction, not 2
    14 |   prove h: segment(S, 0, 2) == segment(S, 0, 0)
       |            ^^^^^^^^^^^^^^^^
bad.proof:15:12: error: a segment number cannot run
    15 |   prove i: segment(T, i in 0..1) == segment(T, 0)
       |            ^^^^^^^^^^^^^^^^^^^^^
bad.proof:16:27: error: a spline is needed here
    16 |   prove j: control_points(x) == d
       |                           ^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
bad.proof:17:12: error: this spline has the segments 0..1 in this direction, not -1
    17 |   prove k: segment(T, 0-1) == segment(T, 0)
       |            ^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("a spline with a gap has no control points of Bézier curves in common",
          "[language][reject]") {
  CHECK(
      type_messages(R"~(  point d[0..3]
  spline T = bspline(d, degree 1, knots [0, 0, 1, 1, 2, 2])
  prove a: bezier_net(T) == d
)~") ==
      R"~(bad.proof:4:12: error: this spline is not continuous: an inner knot has a multiplicity above the degree
     4 |   prove a: bezier_net(T) == d
       |            ^^^^^^^^^^^^^
)~");
}

TEST_CASE("builtins take the arguments they are made for", "[language][reject]") {
  CHECK(type_messages(R"~(  param t in [0, 1]
  scalar x
  point P in R^2
  point Q in R^3
  point A
  matrix M = [1, 2, 3 ; 4, 5, 6]
  prove a: sin(x, x) == 0
  prove b: sin == 0
  prove c: sin(P) == 0
  prove d: det(M) == 0
  prove e: det(P, Q) == 0
  prove f: det(x) == 0
  prove g: dot(P, x) == 0
  prove h: dot(A, A) == 0
  prove i: dot(P, Q) == 0
  prove j: cross(P, P) == P
  prove k: transpose(x) == M
  prove l: rows(P) == 2
  prove m: row(M, 2) == M
  prove n: bernstein(-1, 0, t) == 0
  prove o: bernstein(x, 0, t) == 0
  prove p: bernstein(401, 0, t) == 0
  prove q: binomial(x, 2) == 0
  prove r: binomial(-1, 2) == 0
  prove s: bernstein(3, 0) == 0
  prove u: dot(i in 0..1, P) == 0
)~") ==
        R"~(bad.proof:8:12: error: 'sin' cannot take 2 arguments
     8 |   prove a: sin(x, x) == 0
       |            ^^^^^^^^^
       = help: sin(x)
bad.proof:9:12: error: 'sin' needs arguments: sin(x)
     9 |   prove b: sin == 0
       |            ^^^
bad.proof:10:16: error: this argument has to be a scalar, not a point in R^2
    10 |   prove c: sin(P) == 0
       |                ^
bad.proof:11:12: error: only square matrices of scalars have a determinant, this is a 2 x 3 matrix of scalars
    11 |   prove d: det(M) == 0
       |            ^^^^^^
bad.proof:12:19: error: det of 2 rows needs points in R^2, this is a point in R^3
    12 |   prove e: det(P, Q) == 0
       |                   ^
bad.proof:13:16: error: a matrix, net or list is needed here, not a scalar
    13 |   prove f: det(x) == 0
       |                ^
bad.proof:14:19: error: a point is needed here, not a scalar
    14 |   prove g: dot(P, x) == 0
       |                   ^
bad.proof:15:16: error: products of points need a known dimension
    15 |   prove h: dot(A, A) == 0
       |                ^
       = help: declare the dimension: 'point P in R^3', 'curve C(u) in R^3'
bad.proof:16:12: error: both points need one dimension, and these are a point in R^2 and a point in R^3
    16 |   prove i: dot(P, Q) == 0
       |            ^^^^^^^^^
bad.proof:17:12: error: the vector product exists in R^3 only
    17 |   prove j: cross(P, P) == P
       |            ^^^^^^^^^^^
bad.proof:18:22: error: a matrix, net or list is needed here, not a scalar
    18 |   prove k: transpose(x) == M
       |                      ^
bad.proof:19:17: error: a matrix, net or list is needed here, not a point in R^2
    19 |   prove l: rows(P) == 2
       |                 ^
bad.proof:20:12: error: index 2 is outside 0..1
    20 |   prove m: row(M, 2) == M
       |            ^^^^^^^^^
bad.proof:21:12: error: a degree has to lie between 0 and 400
    21 |   prove n: bernstein(-1, 0, t) == 0
       |            ^^^^^^^^^^^^^^^^^^^
bad.proof:22:22: error: a degree has to be a whole number that is known beforehand
    22 |   prove o: bernstein(x, 0, t) == 0
       |                      ^
bad.proof:23:12: error: a degree has to lie between 0 and 400
    23 |   prove p: bernstein(401, 0, t) == 0
       |            ^^^^^^^^^^^^^^^^^^^^
bad.proof:24:21: error: the upper number has to be a whole number that is known beforehand
    24 |   prove q: binomial(x, 2) == 0
       |                     ^
bad.proof:25:12: error: the upper number of a binomial coefficient has to lie between 0 and 400
    25 |   prove r: binomial(-1, 2) == 0
       |            ^^^^^^^^^^^^^^^
bad.proof:26:12: error: 'bernstein' cannot take 2 arguments
    26 |   prove s: bernstein(3, 0) == 0
       |            ^^^^^^^^^^^^^^^
       = help: bernstein(n, i, t)
bad.proof:27:12: error: a running index comes after the term it runs in
    27 |   prove u: dot(i in 0..1, P) == 0
       |            ^^^^^^^^^^^^^^^^^
       = help: dot(a, b)
)~");
}

TEST_CASE("a running index stands where an index runs", "[language][reject]") {
  CHECK(type_messages(R"~(  param t in [0, 1]
  prove v: bernstein(3, i in 0..1, t) == 0
  prove w: bernstein(3, 1, i in 0..1) == 0
)~") ==
        R"~(bad.proof:3:12: error: a running index is not expected here
     3 |   prove v: bernstein(3, i in 0..1, t) == 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:4:12: error: a running index is not expected here
     4 |   prove w: bernstein(3, 1, i in 0..1) == 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("a determinant has a bound", "[language][reject]") {
  CHECK(type_messages(R"~(  matrix M = net(i*j, i in 0..12, j in 0..12)
  prove a: det(M) == 0
)~") ==
        R"~(bad.proof:3:12: error: a determinant has at most 12 rows
     3 |   prove a: det(M) == 0
       |            ^^^^^^
)~");
}

TEST_CASE("running indices run over spans that are known", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  point c[0..3]
  prove a: sum(x, x) == 0
  prove b: sum(c[i], i in 3..0) == c[0]
  prove c: sum(x, i in 0..x) == 0
  prove d: sum(i in 0..2, x) == 0
  prove e: sum(x, i in 0..400, j in 0..400) == 0
  prove f: net(c[i], i in 1..3) == c
  prove g: net(x, x) == c
  prove h: x == 1 for i in 2..1
  prove i: x == 1 for i in 0..9999
)~") ==
        R"~(bad.proof:4:12: error: a running index is needed here, as in 'i in 0..3'
     4 |   prove a: sum(x, x) == 0
       |            ^^^^^^^^^
bad.proof:5:22: error: 'i' runs over the empty span 3..0
     5 |   prove b: sum(c[i], i in 3..0) == c[0]
       |                      ^
bad.proof:6:27: error: the end of a span has to be a whole number that is known beforehand
     6 |   prove c: sum(x, i in 0..x) == 0
       |                           ^
bad.proof:7:12: error: a running index comes after the term it runs in
     7 |   prove d: sum(i in 0..2, x) == 0
       |            ^^^^^^^^^^^^^^^^^
       = help: sum(b[i]*x^i, i in 0..3)
bad.proof:8:32: error: more than 100000 combinations of the running indices
     8 |   prove e: sum(x, i in 0..400, j in 0..400) == 0
       |                                ^
bad.proof:9:22: error: the indices of a net start at 0, not at 1
     9 |   prove f: net(c[i], i in 1..3) == c
       |                      ^
bad.proof:10:12: error: a running index is needed here, as in 'i in 0..3'
    10 |   prove g: net(x, x) == c
       |            ^^^^^^^^^
bad.proof:11:23: error: 'i' runs over the empty span 2..1
    11 |   prove h: x == 1 for i in 2..1
       |                       ^
bad.proof:12:23: error: more than 4096 combinations of the running indices
    12 |   prove i: x == 1 for i in 0..9999
       |                       ^
)~");
}

TEST_CASE("definitions take the arguments they are made for", "[language][reject]") {
  CHECK(type_messages(R"~(  param u, v in [0, 1]
  scalar x
  point P
  curve C(u), D(v)
  patch r(u, v)
  prove a: ruled(C) == r
  prove b: ruled(r, C) == r
  prove c: ruled == r
  prove d: bilinear(P, P, P, [1, 2]) == r
  prove e: bezier_curve(P) == C
  prove f: bezier_patch(C) == r
  prove g: H03(P) == 1
  prove h: coons(C, i in 0..1, D, D) == r
  prove i: blended_coons(C, C, D, D, C, H33, H03, H33) == r
  prove j: ruled([1, 2 ; 3, 4], C) == r
  prove k: ferguson(P, P, P) == r
  prove l: curve_of_nothing(P) == r
)~") ==
        R"~(bad.proof:7:12: error: 'ruled' takes 2 arguments, not 1
     7 |   prove a: ruled(C) == r
       |            ^^^^^^^^
       = help: ruled(C1, C2)
bad.proof:8:18: error: a patch(u, v) where a curve is needed
     8 |   prove b: ruled(r, C) == r
       |                  ^
bad.proof:9:12: error: 'ruled' needs arguments
     9 |   prove c: ruled == r
       |            ^^^^^
bad.proof:10:30: error: argument 'P11' has to be a point, not a 1 x 2 matrix of scalars
    10 |   prove d: bilinear(P, P, P, [1, 2]) == r
       |                              ^^^^^^
bad.proof:11:25: error: argument 'b' has to be a list of points, not a point
    11 |   prove e: bezier_curve(P) == C
       |                         ^
bad.proof:12:25: error: argument 'b' has to be a net, not a curve(u)
    12 |   prove f: bezier_patch(C) == r
       |                         ^
bad.proof:13:16: error: argument 't' has to be a scalar, not a point
    13 |   prove g: H03(P) == 1
       |                ^
bad.proof:14:12: error: a running index is not an argument of a definition
    14 |   prove h: coons(C, i in 0..1, D, D) == r
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:15:38: error: argument 'f1' has to be a scalar function, not a curve(u)
    15 |   prove i: blended_coons(C, C, D, D, C, H33, H03, H33) == r
       |                                      ^
bad.proof:16:18: error: argument 'C1' has to be a curve, not a 2 x 2 matrix of scalars
    16 |   prove j: ruled([1, 2 ; 3, 4], C) == r
       |                  ^^^^^^^^^^^^^
bad.proof:17:21: error: argument 'P' has to be a matrix, not a point
    17 |   prove k: ferguson(P, P, P) == r
       |                     ^
bad.proof:18:12: error: unknown name 'curve_of_nothing'
    18 |   prove l: curve_of_nothing(P) == r
       |            ^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("a mistake inside a definition is reported at its use", "[language][reject]") {
  CHECK(
      type_messages(R"~(  scalar x
  point P, Q in R^2
  point V[0..1, 0..1]
  prove a: split_clamped_cubic([P, Q]) == [P]
  prove b: bilinear(P, P, x, P) == 0
  prove c: ferguson(V, V, [1, 2]) == 0
)~") ==
      R"~(bad.proof:5:12: error: in 'split_clamped_cubic': a 7 x 5 matrix of scalars cannot be multiplied by a list of 2 points in R^2
     5 |   prove a: split_clamped_cubic([P, Q]) == [P]
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^
       = help: the columns of the first have to be as many as the rows of the second
bad.proof:6:12: error: in 'bilinear': the entries of a matrix are of one type, and this is a scalar beside a point in R^2
     6 |   prove b: bilinear(P, P, x, P) == 0
       |            ^^^^^^^^^^^^^^^^^^^^
bad.proof:7:12: error: in 'ferguson': a 1 x 2 matrix of scalars cannot be multiplied by a 1 x 2 matrix of scalars
     7 |   prove c: ferguson(V, V, [1, 2]) == 0
       |            ^^^^^^^^^^^^^^^^^^^^^^
       = help: the columns of the first have to be as many as the rows of the second
)~");
}

TEST_CASE("a curve given as an expression depends on one parameter", "[language][reject]") {
  CHECK(type_messages(R"~(  param s, t, w in [0, 1]
  curve C(u)
  point P
  prove a: ruled(s*t*P, C) == 0
)~") ==
        R"~(bad.proof:5:18: error: it is not clear which parameter this curve runs over
     5 |   prove a: ruled(s*t*P, C) == 0
       |                  ^^^^^
       = help: it should depend on 'u'; or declare it: 'curve C(u) = ...'
)~");
}

TEST_CASE("a statement does not grow without bound", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  prove p: sum((x + i)*(x + j)*(x + 1)*(x + 2)*(x + 3)*(x + 4), i in 0..299, j in 0..299) == 0
)~") ==
        R"~(bad.proof:3:12: error: this statement expands to more than 400000 terms
     3 |   prove p: sum((x + i)*(x + j)*(x + 1)*(x + 2)*(x + 3)*(x + 4), i in 0..299, j in 0..299) == 0
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("products are not numbers without bound", "[language][reject]") {
  CHECK(type_messages(R"~(  let a = 1234567890^3000*1234567890^3000
  let b = 1234567890^4096
)~") ==
        R"~(bad.proof:2:11: error: this number has more than 100000 binary digits
     2 |   let a = 1234567890^3000*1234567890^3000
       |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:3:11: error: this number has more than 100000 binary digits
     3 |   let b = 1234567890^4096
       |           ^^^^^^^^^^^^^^^
)~");
}

}  // namespace patchproof
