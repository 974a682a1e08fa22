#include <catch2/catch.hpp>

#include "language/reading.hpp"
#include "language_test.hpp"

namespace patchproof {

TEST_CASE("a volume has three parameters", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  volume F(u, v)
end
)~") ==
        R"~(bad.proof:2:11: error: a volume has three parameters
     2 |   volume F(u, v)
       |           ^^^^^^
)~");
  CHECK(messages_of(R"~(case a
  volume F
end
)~") ==
        R"~(bad.proof:2:11: error: expected parameters, as in F(u, v, w); the statement ends here
     2 |   volume F
       |           ^
)~");
  CHECK(messages_of(R"~(define f(F : volume(u, v)) : point
  = F(0, 0, 0)
end
)~") ==
        R"~(bad.proof:1:20: error: a volume has three parameters
     1 | define f(F : volume(u, v)) : point
       |                    ^^^^^^
)~");
}

TEST_CASE("a volume is not a patch", "[language][reject]") {
  CHECK(type_messages(R"~(  param u, v, w in [0, 1]
  volume F(u, v, w) : C^1
  patch r(u, v) : C^1
  volume G(u, v, w) = r
  prove a: F(u,v) == 0
  prove b: F == r
  prove c: adini_corner(F) == 0
)~") ==
        R"~(bad.proof:5:23: error: 'G' has 3 parameters, and this is a patch(u, v)
     5 |   volume G(u, v, w) = r
       |                       ^
bad.proof:6:12: error: a volume(u, v, w) takes 3 arguments, not 2
     6 |   prove a: F(u,v) == 0
       |            ^^^^^^
bad.proof:7:12: error: a volume(u, v, w) is compared with a patch(u, v)
     7 |   prove b: F == r
       |            ^^^^^^
bad.proof:8:25: error: a volume(u, v, w) where a patch is needed
     8 |   prove c: adini_corner(F) == 0
       |                         ^
)~");
}

TEST_CASE("a product runs over an index as a sum does", "[language][reject]") {
  CHECK(type_messages(R"~(  scalar c[0..3]
  point P[0..1]
  prove a: product(c[i], c[0]) == 0
  prove b: product(c[i], i in 3..0) == c[0]
  prove c: product(P[i], i in 0..1) == P[0]
)~") ==
        R"~(bad.proof:4:12: error: a running index is needed here, as in 'i in 0..3'
     4 |   prove a: product(c[i], c[0]) == 0
       |            ^^^^^^^^^^^^^^^^^^^
bad.proof:5:26: error: 'i' runs over the empty span 3..0
     5 |   prove b: product(c[i], i in 3..0) == c[0]
       |                          ^
bad.proof:6:20: error: the factors of a product have to be scalars, and this is a point
     6 |   prove c: product(P[i], i in 0..1) == P[0]
       |                    ^^^^
)~");
}

}  // namespace patchproof
