#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {

TEST_CASE("multiplication is written out", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  param u in [0,1]
  curve C(u) = (u, 0, 4u(1-u))
end
)~") ==
        R"~(bad.proof:3:24: error: expected an operator before 'u'
     3 |   curve C(u) = (u, 0, 4u(1-u))
       |                        ^
       = help: multiplication is written '*': 4*u*(1-u)
)~");
  CHECK(messages_of(R"~(case a
  prove x: 3x == 1
  prove y: f(1)g(2) == 1
end
)~") ==
        R"~(bad.proof:2:13: error: expected an operator before 'x'
     2 |   prove x: 3x == 1
       |             ^
       = help: multiplication is written '*': 3*x
bad.proof:3:16: error: expected an operator before 'g'
     3 |   prove y: f(1)g(2) == 1
       |                ^
       = help: multiplication is written '*': f(1)*g(2)
)~");
  CHECK(messages_of(R"~(case a
  prove x: 2(1-3) == 1
end
)~") ==
        R"~(bad.proof:2:13: error: expected an operator before '('
     2 |   prove x: 2(1-3) == 1
       |             ^
       = help: multiplication is written '*': 2*(1-3)
)~");
  CHECK(messages_of(R"~(case a
  prove x: V[1,2]u == 1
end
)~") ==
        R"~(bad.proof:2:18: error: expected an operator before 'u'
     2 |   prove x: V[1,2]u == 1
       |                  ^
       = help: multiplication is written '*'
)~");
  CHECK(messages_of(R"~(case a
  scalar a, b
  prove x: 2a b^2/3 == (a + b)c
end
)~") ==
        R"~(bad.proof:3:13: error: expected an operator before 'a'
     3 |   prove x: 2a b^2/3 == (a + b)c
       |             ^
       = help: multiplication is written '*': 2*a*b^2/3
)~");
  CHECK(messages_of(R"~(case a
  prove x: 2f(3g) == 1
end
)~") ==
        R"~(bad.proof:2:13: error: expected an operator before 'f'
     2 |   prove x: 2f(3g) == 1
       |             ^
       = help: multiplication is written '*'
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1 usng c
end
)~") ==
        R"~(bad.proof:2:19: error: expected an operator before 'usng'
     2 |   prove x: 1 == 1 usng c
       |                   ^^^^
       = help: did you mean 'using'?
)~");
}

TEST_CASE("brackets are closed and rows equally long", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: (1 + 2 == 3
end
)~") ==
        R"~(bad.proof:2:19: error: expected ',' or ')', found '=='
     2 |   prove x: (1 + 2 == 3
       |                   ^^
)~");
  CHECK(messages_of(R"~(case a
  prove x: f(1, 2 == 3
end
)~") ==
        R"~(bad.proof:2:19: error: expected ',' or ')', found '=='
     2 |   prove x: f(1, 2 == 3
       |                   ^^
)~");
  CHECK(messages_of(R"~(case a
  prove x: V[1, 2 == 3
end
)~") ==
        R"~(bad.proof:2:19: error: expected ',' or ']', found '=='
     2 |   prove x: V[1, 2 == 3
       |                   ^^
)~");
  CHECK(messages_of(R"~(case a
  prove x: [1, 2 == 3
end
)~") ==
        R"~(bad.proof:2:18: error: expected ',', ';' or ']', found '=='
     2 |   prove x: [1, 2 == 3
       |                  ^^
)~");
  CHECK(messages_of(R"~(case a
  matrix M = [1, 2 ; 3]
end
)~") ==
        R"~(bad.proof:2:14: error: rows of unequal length: row 1 has 2 entries, row 2 has 1
     2 |   matrix M = [1, 2 ; 3]
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  matrix M = [1 ; 2, 3]
end
)~") ==
        R"~(bad.proof:2:14: error: rows of unequal length: row 1 has 1 entry, row 2 has 2
     2 |   matrix M = [1 ; 2, 3]
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: (1 +
  prove y: () == 1
end
)~") ==
        R"~(bad.proof:2:16: error: expected an expression; the statement ends here
     2 |   prove x: (1 +
       |                ^
bad.proof:3:13: error: expected an expression, found ')'
     3 |   prove y: () == 1
       |             ^
)~");
}

TEST_CASE("operands are written as the language has them", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: 2 * -3 == 6
end
)~") ==
        R"~(bad.proof:2:16: error: expected an expression, found '-'
     2 |   prove x: 2 * -3 == 6
       |                ^
       = help: write a second sign in parentheses: (-x)
)~");
  CHECK(messages_of(R"~(case a
  prove x: - - 3 == 3
end
)~") ==
        R"~(bad.proof:2:14: error: expected an expression, found '-'
     2 |   prove x: - - 3 == 3
       |              ^
       = help: write a second sign in parentheses: (-x)
)~");
  CHECK(messages_of(R"~(case a
  prove x: 2**3 == 8
end
)~") ==
        R"~(bad.proof:2:14: error: expected an expression, found '*'
     2 |   prove x: 2**3 == 8
       |              ^
       = help: a power is written '^'
)~");
  CHECK(messages_of(R"~(case a
  prove x: .5 == 1/2
end
)~") ==
        R"~(bad.proof:2:12: error: expected an expression, found '.'
     2 |   prove x: .5 == 1/2
       |            ^
       = help: write 0.5
)~");
  CHECK(messages_of(R"~(case a
  prove x: r.w == 1
end
)~") ==
        R"~(bad.proof:2:14: error: expected 'x', 'y' or 'z' after '.', found 'w'
     2 |   prove x: r.w == 1
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  let E = sum(u, u in [0,1])
end
)~") ==
        R"~(bad.proof:2:23: error: expected a range of whole numbers like 0..3, found '['
     2 |   let E = sum(u, u in [0,1])
       |                       ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: from == 1
end
)~") ==
        R"~(bad.proof:2:12: error: expected an expression, found 'from'
     2 |   prove x: from == 1
       |            ^^^^
       = help: 'from' is a word of the language
)~");
}

}  // namespace patchproof
