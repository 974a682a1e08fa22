#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("coordinates are those of points of a known dimension", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  point P in R^2
  point A
  prove a: x.x == 1
  prove b: P.z == 1
  prove c: A.x == 1
  prove d: (P, 1) == P
  prove e: (1, 2, 3, 4, 5, 6, 7, 8, 9, 10) == P
  prove f: (1, 2).z == 1
)~") ==
        R"~(bad.proof:5:12: error: only points have coordinates, this is a scalar
     5 |   prove a: x.x == 1
       |            ^^^
bad.proof:6:12: error: a point in R^2 has no coordinate 'z'
     6 |   prove b: P.z == 1
       |            ^^^
bad.proof:7:12: error: the coordinates of a point of any dimension have no names
     7 |   prove c: A.x == 1
       |            ^^^
       = help: declare the dimension: 'point P in R^3', 'curve C(u) in R^3'
bad.proof:8:13: error: a coordinate has to be a scalar, not a point in R^2
     8 |   prove d: (P, 1) == P
       |             ^
bad.proof:9:12: error: a point has at most 9 coordinates
     9 |   prove e: (1, 2, 3, 4, 5, 6, 7, 8, 9, 10) == P
       |            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
bad.proof:10:12: error: a point in R^2 has no coordinate 'z'
    10 |   prove f: (1, 2).z == 1
       |            ^^^^^^^^
)~");
}

TEST_CASE("entries are of arrays, nets and matrices, within their extents", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  point V[0..3], W[0..3, 0..2]
  matrix M = [1, 2 ; 3, 4]
  prove a: V[4] == V[0]
  prove b: W[4, 0] == W[0, 0]
  prove c: W[0, 3] == W[0, 0]
  prove d: W[0] == W[0, 0]
  prove e: V[0, 1] == V[0]
  prove f: x[0] == 1
  prove g: V[x] == V[0]
  prove h: V[1/2] == V[0]
  prove i: V[0-1] == V[0]
  prove j: V[2..1] == V[0..1]
  prove k: W[0..1] == V[0..1]
  prove l: V[0..4] == V
  prove m: x[0..1] == V
  prove o: M[1, 2] == 4
)~") ==
        R"~(bad.proof:5:12: error: index 4 is outside 0..3
     5 |   prove a: V[4] == V[0]
       |            ^^^^
bad.proof:6:12: error: index 4 is outside 0..3
     6 |   prove b: W[4, 0] == W[0, 0]
       |            ^^^^^^^
bad.proof:7:12: error: index 3 is outside 0..2
     7 |   prove c: W[0, 3] == W[0, 0]
       |            ^^^^^^^
bad.proof:8:12: error: a 4 x 3 matrix of points needs two indices
     8 |   prove d: W[0] == W[0, 0]
       |            ^^^^
bad.proof:9:12: error: a list of 4 points needs one index
     9 |   prove e: V[0, 1] == V[0]
       |            ^^^^^^^
bad.proof:10:12: error: only arrays, nets and matrices have entries, this is a scalar
    10 |   prove f: x[0] == 1
       |            ^^^^
bad.proof:11:14: error: an index has to be a whole number that is known beforehand
    11 |   prove g: V[x] == V[0]
       |              ^
bad.proof:12:14: error: an index has to be a whole number that is known beforehand
    12 |   prove h: V[1/2] == V[0]
       |              ^^^
bad.proof:13:12: error: index -1 is outside 0..3
    13 |   prove i: V[0-1] == V[0]
       |            ^^^^^^
bad.proof:14:12: error: the span 2..1 is empty
    14 |   prove j: V[2..1] == V[0..1]
       |            ^^^^^^^
bad.proof:15:12: error: a part of a 4 x 3 matrix of points cannot be taken like this
    15 |   prove k: W[0..1] == V[0..1]
       |            ^^^^^^^
       = help: as in M[0..1, 0..1]
bad.proof:16:12: error: index 4 is outside 0..3
    16 |   prove l: V[0..4] == V
       |            ^^^^^^^
bad.proof:17:12: error: a part of a scalar cannot be taken like this
    17 |   prove m: x[0..1] == V
       |            ^^^^^^^
bad.proof:18:12: error: index 2 is outside 0..1
    18 |   prove o: M[1, 2] == 4
       |            ^^^^^^^
)~");
}

TEST_CASE("the entries of a matrix are of one type", "[language][reject]") {
  CHECK(
      type_messages(R"~(  scalar x
  point P, Q in R^2
  point A
  prove a: [x, P] == 0
  prove b: [P, A] == 0
  prove c: [[1, 2], [3, 4]] == 0
  prove d: [1, 2 ; P, Q] == 0
  prove e: bezier([P, x]) == 0
)~") ==
      R"~(bad.proof:5:16: error: the entries of a matrix are of one type, and this is a point in R^2 beside a scalar
     5 |   prove a: [x, P] == 0
       |                ^
bad.proof:6:16: error: the entries of a matrix are of one type, and this is a point beside a point in R^2
     6 |   prove b: [P, A] == 0
       |                ^
bad.proof:7:13: error: an entry of a matrix has to be a scalar or a point, not a 1 x 2 matrix of scalars
     7 |   prove c: [[1, 2], [3, 4]] == 0
       |             ^^^^^^
bad.proof:8:20: error: the entries of a matrix are of one type, and this is a point in R^2 beside a scalar
     8 |   prove d: [1, 2 ; P, Q] == 0
       |                    ^
bad.proof:9:23: error: the entries of a matrix are of one type, and this is a scalar beside a point in R^2
     9 |   prove e: bezier([P, x]) == 0
       |                       ^
)~");
}

TEST_CASE("'?' is an entry of a declared matrix and nothing else", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  prove a: x == ?
  let b = 2*?
)~") ==
        R"~(bad.proof:3:17: error: '?' stands for an unknown entry of a matrix and nothing else
     3 |   prove a: x == ?
       |                 ^
       = help: as in: matrix M = [?, (0,1) ; (1,0), (1,1)]
bad.proof:4:13: error: '?' stands for an unknown entry of a matrix and nothing else
     4 |   let b = 2*?
       |             ^
       = help: as in: matrix M = [?, (0,1) ; (1,0), (1,1)]
)~");
}

}  // namespace patchproof
