#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("names are known", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar width
  point V[0..1]
  prove a: widht == 1
  prove b: bernstien(3, 0, width) == 1
  prove c: xyzzy == 1
  prove d: cons(width) == 1
  prove e: V_u == 0
  prove f: qqqqq(1) == 1
)~") ==
        R"~(bad.proof:4:12: error: unknown name 'widht'
     4 |   prove a: widht == 1
       |            ^^^^^
       = help: did you mean 'width'?
bad.proof:5:12: error: unknown name 'bernstien'
     5 |   prove b: bernstien(3, 0, width) == 1
       |            ^^^^^^^^^
       = help: did you mean 'bernstein'?
bad.proof:6:12: error: unknown name 'xyzzy'
     6 |   prove c: xyzzy == 1
       |            ^^^^^
bad.proof:7:12: error: unknown name 'cons'
     7 |   prove d: cons(width) == 1
       |            ^^^^
       = help: did you mean 'coons'?
bad.proof:8:12: error: unknown name 'V_u'
     8 |   prove e: V_u == 0
       |            ^^^
bad.proof:9:12: error: unknown name 'qqqqq'
     9 |   prove f: qqqqq(1) == 1
       |            ^^^^^
)~");
}

TEST_CASE("what depends on a faulty name is not reported again", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar good
  let bad = good + unknwon
  prove a: bad == 1
  let worse = 2*bad
  prove b: worse == 2
)~") ==
        R"~(bad.proof:3:20: error: unknown name 'unknwon'
     3 |   let bad = good + unknwon
       |                    ^^^^^^^
)~");
}

TEST_CASE("only functions are applied, to as many scalars as they have parameters",
          "[language][reject]") {
  CHECK(type_messages(R"~(  point P
  scalar x
  curve C(u)
  patch r(u, v)
  prove a: x(1) == 1
  prove b: C(1, 2) == P
  prove c: r(1) == P
  prove d: C(P) == P
  prove e: C(i in 0..1) == P
  prove f: (x + 1)(2) == 1
)~") ==
        R"~(bad.proof:6:12: error: x is a scalar, not a function
     6 |   prove a: x(1) == 1
       |            ^^^^
       = help: multiplication is written '*'
bad.proof:7:12: error: a curve(u) takes 1 argument, not 2
     7 |   prove b: C(1, 2) == P
       |            ^^^^^^^
bad.proof:8:12: error: a patch(u, v) takes 2 arguments, not 1
     8 |   prove c: r(1) == P
       |            ^^^^
bad.proof:9:14: error: an argument of a function has to be a scalar, not a point
     9 |   prove d: C(P) == P
       |              ^
bad.proof:10:12: error: a running index is not an argument of a function
    10 |   prove e: C(i in 0..1) == P
       |            ^^^^^^^^^^^^
bad.proof:11:12: error: x + 1 is a scalar, not a function
    11 |   prove f: (x + 1)(2) == 1
       |            ^^^^^^^^^^
       = help: multiplication is written '*'
)~");
}

TEST_CASE("derivatives are of functions, in their parameters", "[language][reject]") {
  CHECK(
      type_messages(R"~(  param u, v in [0, 1]
  scalar x, y
  point P
  curve C(u) : C^2
  patch r(u, v) : C^2
  prove a: x' == 1
  prove b: r'(u, v) == P
  prove c: r_w(u, v) == P
  prove d: r_ux(u, v) == P
  prove e: diff(r, w) == P
  prove f: diff(r, 2) == P
  prove g: diff(r, u, -1) == P
  prove h: diff(r, u, 65) == P
  prove i: diff(x, P) == 0
  prove j: diff(x*u, u + v) == 0
  prove k: diff(r, u, x) == P
)~") ==
      R"~(bad.proof:7:12: error: ' marks the derivative of a function of one parameter, and 'x' is a scalar
     7 |   prove a: x' == 1
       |            ^^
bad.proof:8:12: error: ' marks the derivative of a function of one parameter, and 'r' is a patch(u, v)
     8 |   prove b: r'(u, v) == P
       |            ^^
bad.proof:9:12: error: 'r_w' is not a derivative of 'r', a patch(u, v)
     9 |   prove c: r_w(u, v) == P
       |            ^^^
       = help: parameters mark derivatives, as in r_u and r_uv
bad.proof:10:12: error: 'r_ux' is not a derivative of 'r', a patch(u, v)
    10 |   prove d: r_ux(u, v) == P
       |            ^^^^
       = help: parameters mark derivatives, as in r_u and r_uv
bad.proof:11:20: error: 'w' is not a parameter of this patch(u, v)
    11 |   prove e: diff(r, w) == P
       |                    ^
bad.proof:12:12: error: the name of a parameter is needed after the function
    12 |   prove f: diff(r, 2) == P
       |            ^^^^^^^^^^
       = help: as in diff(r, u, 2, v, 2)
bad.proof:13:12: error: the order of a derivative is not negative
    13 |   prove g: diff(r, u, -1) == P
       |            ^^^^^^^^^^^^^^
bad.proof:14:12: error: the order of a derivative is at most 64
    14 |   prove h: diff(r, u, 65) == P
       |            ^^^^^^^^^^^^^^
bad.proof:15:20: error: 'P' is not a parameter or scalar symbol
    15 |   prove i: diff(x, P) == 0
       |                    ^
bad.proof:16:12: error: the name of a parameter is needed after the function
    16 |   prove j: diff(x*u, u + v) == 0
       |            ^^^^^^^^^^^^^^^^
       = help: as in diff(r, u, 2, v, 2)
bad.proof:17:23: error: 'x' is not a parameter of this patch(u, v)
    17 |   prove k: diff(r, u, x) == P
       |                       ^
)~");
}

TEST_CASE("terms of a sum are of one type", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar x
  point P in R^2
  point Q in R^3
  point A
  patch r(u, v)
  curve C(u)
  prove a: P + x == P
  prove b: P + Q == P
  prove c: A + Q == A
  prove d: r - C == 0
  prove e: [1, 2 ; 3, 4] + [1, 2] == 0
  prove f: 1 + P == P
  prove g: [1, 2] + 1 == 0
)~") ==
        R"~(bad.proof:8:16: error: a scalar cannot be added to a point in R^2
     8 |   prove a: P + x == P
       |                ^
bad.proof:9:16: error: a point in R^3 cannot be added to a point in R^2
     9 |   prove b: P + Q == P
       |                ^
bad.proof:10:16: error: a point in R^3 cannot be added to a point
    10 |   prove c: A + Q == A
       |                ^
       = help: declare the dimension of the points and curves: 'point P in R^3', 'curve C(u) in R^3'
bad.proof:11:16: error: a curve(u) cannot be added to a patch(u, v)
    11 |   prove d: r - C == 0
       |                ^
bad.proof:12:28: error: a 1 x 2 matrix of scalars cannot be added to a 2 x 2 matrix of scalars
    12 |   prove e: [1, 2 ; 3, 4] + [1, 2] == 0
       |                            ^^^^^^
bad.proof:13:16: error: a point in R^2 cannot be added to a scalar
    13 |   prove f: 1 + P == P
       |                ^
bad.proof:14:21: error: a scalar cannot be added to a 1 x 2 matrix of scalars
    14 |   prove g: [1, 2] + 1 == 0
       |                     ^
)~");
}

TEST_CASE("products are of scalars, and of matrices that fit", "[language][reject]") {
  CHECK(type_messages(R"~(  param u in [0, 1]
  scalar x
  point P, Q in R^3
  point V[0..1, 0..1] in R^3
  curve C(u)
  patch r(u, v)
  matrix M = [1, 2 ; 3, 4]
  prove a: P*Q == 1
  prove b: M*[1, 2] == 0
  prove c: V*V == 0
  prove d: M*P == 0
  prove e: C*r == 0
  prove f: x/P == 1
  prove g: x/M == 1
  prove h: x/0 == 1
  prove i: x/(1 - 1) == 1
  prove j: C*C == 0
  prove k: P*[1, 2] == 0
)~") ==
        R"~(bad.proof:9:14: error: two points cannot be multiplied
     9 |   prove a: P*Q == 1
       |              ^
       = help: the scalar product is dot(a, b), the vector product cross(a, b)
bad.proof:10:14: error: a 2 x 2 matrix of scalars cannot be multiplied by a 1 x 2 matrix of scalars
    10 |   prove b: M*[1, 2] == 0
       |              ^^^^^^
       = help: the columns of the first have to be as many as the rows of the second
bad.proof:11:14: error: two matrices of points cannot be multiplied
    11 |   prove c: V*V == 0
       |              ^
bad.proof:12:14: error: a point and a matrix cannot be multiplied
    12 |   prove d: M*P == 0
       |              ^
bad.proof:13:14: error: functions of different numbers of parameters cannot be multiplied
    13 |   prove e: C*r == 0
       |              ^
bad.proof:14:14: error: a divisor has to be a scalar, not a point in R^3
    14 |   prove f: x/P == 1
       |              ^
bad.proof:15:14: error: a divisor has to be a scalar, not a 2 x 2 matrix of scalars
    15 |   prove g: x/M == 1
       |              ^
bad.proof:16:14: error: division by zero
    16 |   prove h: x/0 == 1
       |              ^
bad.proof:17:14: error: division by zero
    17 |   prove i: x/(1 - 1) == 1
       |              ^^^^^^^
bad.proof:18:12: error: two points cannot be multiplied
    18 |   prove j: C*C == 0
       |            ^^^
       = help: the scalar product is dot(a, b), the vector product cross(a, b)
bad.proof:19:12: error: a point and a matrix cannot be multiplied
    19 |   prove k: P*[1, 2] == 0
       |            ^
)~");
}

TEST_CASE("powers are of scalars, with whole exponents that are known", "[language][reject]") {
  CHECK(type_messages(R"~(  param u in [0, 1]
  scalar x, n
  point P in R^2
  matrix M = [1, 2 ; 3, 4]
  prove a: x^n == 1
  prove b: x^(1/2) == 1
  prove c: x^4097 == 1
  prove d: P^2 == 1
  prove e: M^2 == M
  prove f: 0^-1 == 1
  prove g: 1234567890^4096 + 2 == 1
  prove h: x^10^9 == 1
  prove i: x^-5000 == 1
)~") ==
        R"~(bad.proof:6:14: error: an exponent has to be a whole number that is known beforehand
     6 |   prove a: x^n == 1
       |              ^
bad.proof:7:14: error: an exponent has to be a whole number that is known beforehand
     7 |   prove b: x^(1/2) == 1
       |              ^^^^^
bad.proof:8:14: error: an exponent lies between -4096 and 4096
     8 |   prove c: x^4097 == 1
       |              ^^^^
bad.proof:9:12: error: only scalars have powers, this is a point in R^2
     9 |   prove d: P^2 == 1
       |            ^^^
       = help: the square of a vector is dot(p, p)
bad.proof:10:12: error: only scalars have powers, this is a 2 x 2 matrix of scalars
    10 |   prove e: M^2 == M
       |            ^^^
bad.proof:11:12: error: division by zero
    11 |   prove f: 0^-1 == 1
       |            ^^^^
bad.proof:12:12: error: this number has more than 100000 binary digits
    12 |   prove g: 1234567890^4096 + 2 == 1
       |            ^^^^^^^^^^^^^^^
bad.proof:13:14: error: an exponent is too large
    13 |   prove h: x^10^9 == 1
       |              ^^^^
bad.proof:14:14: error: an exponent lies between -4096 and 4096
    14 |   prove i: x^-5000 == 1
       |              ^^^^^
)~");
}

}  // namespace patchproof
