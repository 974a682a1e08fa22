#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {

TEST_CASE("a declaration has the form of its kind", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  point P = (1, 2)
end
)~") ==
        R"~(bad.proof:2:11: error: expected ',' or the end of the statement, found '='
     2 |   point P = (1, 2)
       |           ^
       = help: a value is given by 'let'
)~");
  CHECK(messages_of(R"~(case a
  curve C
end
)~") ==
        R"~(bad.proof:2:10: error: expected a parameter, as in C(u); the statement ends here
     2 |   curve C
       |          ^
)~");
  CHECK(messages_of(R"~(case a
  curve C(u, v)
end
)~") ==
        R"~(bad.proof:2:10: error: a curve has one parameter
     2 |   curve C(u, v)
       |          ^^^^^^
)~");
  CHECK(messages_of(R"~(case a
  patch r(u) : C^2
end
)~") ==
        R"~(bad.proof:2:10: error: a patch has two parameters
     2 |   patch r(u) : C^2
       |          ^^^
)~");
  CHECK(messages_of(R"~(case a
  curve C(u) : smooth
end
)~") ==
        R"~(bad.proof:2:16: error: expected a smoothness like C^2, found 'smooth'
     2 |   curve C(u) : smooth
       |                ^^^^^^
)~");
  CHECK(messages_of(R"~(case a
  patch p(u,v) : degree 3
end
)~") ==
        R"~(bad.proof:2:25: error: expected '(', found '3'
     2 |   patch p(u,v) : degree 3
       |                         ^
)~");
  CHECK(messages_of(R"~(case a
  curve p(t) : degree 3.5
end
)~") ==
        R"~(bad.proof:2:23: error: expected a degree from 0 to 999, found '3.5'
     2 |   curve p(t) : degree 3.5
       |                       ^^^
)~");
  CHECK(messages_of(R"~(case a
  point P in R^12
end
)~") ==
        R"~(bad.proof:2:16: error: expected a dimension from 1 to 9, found '12'
     2 |   point P in R^12
       |                ^^
)~");
  CHECK(messages_of(R"~(case a
  point P in [0,1]
end
)~") ==
        R"~(bad.proof:2:14: error: expected a space like R^3, found '['
     2 |   point P in [0,1]
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  scalar a b
end
)~") ==
        R"~(bad.proof:2:12: error: expected the end of the statement, found 'b'
     2 |   scalar a b
       |            ^
)~");
  CHECK(messages_of(R"~(case a
  param u, for in [0,1]
end
)~") ==
        R"~(bad.proof:2:12: error: expected a name, found 'for'
     2 |   param u, for in [0,1]
       |            ^^^
       = help: 'for' is a word of the language
)~");
}

TEST_CASE("ranges, nets and splines are complete", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  param u in 0..1
end
)~") ==
        R"~(bad.proof:2:14: error: expected a range like [0, 1], found '0'
     2 |   param u in 0..1
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  family m in [1, 6]
end
)~") ==
        R"~(bad.proof:2:15: error: expected a range of whole numbers like 0..3, found '['
     2 |   family m in [1, 6]
       |               ^
)~");
  CHECK(messages_of(R"~(case a
  net b[i,j] = i*j
end
)~") ==
        R"~(bad.proof:2:19: error: expected 'for'; the statement ends here
     2 |   net b[i,j] = i*j
       |                   ^
)~");
  CHECK(messages_of(R"~(case a
  spline T = bspline(M, degree 3, 3, open)
end
)~") ==
        R"~(bad.proof:2:38: error: expected 'clamped uniform' or 'knots', found 'open'
     2 |   spline T = bspline(M, degree 3, 3, open)
       |                                      ^^^^
)~");
  CHECK(messages_of(R"~(case a
  spline T = bspline(M, 3)
end
)~") ==
        R"~(bad.proof:2:25: error: expected 'degree', found '3'
     2 |   spline T = bspline(M, 3)
       |                         ^
)~");
}

TEST_CASE("what is said about a case is complete", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  title Coons
end
)~") ==
        R"~(bad.proof:2:9: error: expected a text in "...", found 'Coons'
     2 |   title Coons
       |         ^^^^^
)~");
  CHECK(messages_of(R"~(case a
  source "x" lang sk lang en
end
)~") ==
        R"~(bad.proof:2:22: error: 'lang' given twice
     2 |   source "x" lang sk lang en
       |                      ^^^^
)~");
  CHECK(messages_of(R"~(case a
  limit tme 5 s
end
)~") ==
        R"~(bad.proof:2:9: error: expected 'time', 'memory', 'terms' or 'steps', found 'tme'
     2 |   limit tme 5 s
       |         ^^^
       = help: did you mean 'time'?
)~");
  CHECK(messages_of(R"~(case a
  limit time 5 MB
end
)~") ==
        R"~(bad.proof:2:16: error: expected 's' or 'ms', found 'MB'
     2 |   limit time 5 MB
       |                ^^
)~");
  CHECK(messages_of(R"~(case a
  limit memory lots
end
)~") ==
        R"~(bad.proof:2:16: error: expected a number, found 'lots'
     2 |   limit memory lots
       |                ^^^^
)~");
}

TEST_CASE("definitions have a type, a value and an end", "[language][reject]") {
  CHECK(messages_of(R"~(define f(u : scalar)
  = u
end
)~") ==
        R"~(bad.proof:2:3: error: expected ':' and the type of the result, found '='
     2 |   = u
       |   ^
)~");
  CHECK(messages_of(R"~(define f(u : scaler) : scalar
  = u
end
)~") ==
        R"~(bad.proof:1:14: error: expected a type, found 'scaler'
     1 | define f(u : scaler) : scalar
       |              ^^^^^^
       = help: did you mean 'scalar'?
)~");
  CHECK(messages_of(R"~(define f(u) : scalar
  = u
end
)~") ==
        R"~(bad.proof:1:11: error: expected ':', found ')'
     1 | define f(u) : scalar
       |           ^
)~");
  CHECK(messages_of(R"~(define f(u : mapping) : scalar
  = u
end
)~") ==
        R"~(bad.proof:1:14: error: expected a type, found 'mapping'
     1 | define f(u : mapping) : scalar
       |              ^^^^^^^
       = help: types are scalar, scalar function, point, curve(u), patch(u, v), volume(u, v, w), net, matrix, list and spline
)~");
  CHECK(messages_of(R"~(define f(u : scalar) : scalar
end
)~") ==
        R"~(bad.proof:1:30: error: expected '=' and the value; the statement ends here
     1 | define f(u : scalar) : scalar
       |                              ^
)~");
  CHECK(messages_of(R"~(define f(u : scalar) : scalar
  = u
)~") ==
        R"~(bad.proof:1:1: error: definition 'f' has no 'end'
     1 | define f(u : scalar) : scalar
       | ^^^^^^
)~");
  CHECK(messages_of(R"~(define f(u : scalar) : scalar
  prove x: u == 1
  = u
end
)~") ==
        R"~(bad.proof:2:3: error: 'prove' does not belong in a definition
     2 |   prove x: u == 1
       |   ^^^^^
)~");
  CHECK(messages_of(R"~(define f(u : scalar) : scalar
  titel "x"
  = u
end
)~") ==
        R"~(bad.proof:2:3: error: expected a statement or '=', found 'titel'
     2 |   titel "x"
       |   ^^^^^
       = help: did you mean 'title'?
)~");
  CHECK(messages_of(R"~(define f(u : scalar) : scalar
  = u
  let x = 2
end
)~") ==
        R"~(bad.proof:3:3: error: 'let' does not belong behind the value
     3 |   let x = 2
       |   ^^^
)~");
}

}  // namespace patchproof
