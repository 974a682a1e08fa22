#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {

TEST_CASE("statements begin on lines of their own with words the language knows",
          "[language][reject]") {
  CHECK(messages_of(R"~(case a
  scalar x
  prvoe p: x == 2
end
)~") ==
        R"~(bad.proof:3:3: error: expected a statement, found 'prvoe'
     3 |   prvoe p: x == 2
       |   ^^^^^
       = help: did you mean 'prove'?
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1 end
)~") ==
        R"~(bad.proof:2:19: error: expected a new line before 'end'
     2 |   prove x: 1 == 1 end
       |                   ^^^
       = help: every statement begins on a line of its own
)~");
  CHECK(messages_of(R"~(case a  prove x: 1 == 1
end
)~") ==
        R"~(bad.proof:1:9: error: expected a new line before 'prove'
     1 | case a  prove x: 1 == 1
       |         ^^^^^
       = help: every statement begins on a line of its own
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1
  gves 3
end
)~") ==
        R"~(bad.proof:3:3: error: expected a statement, found 'gves'
     3 |   gves 3
       |   ^^^^
       = help: did you mean 'gives'?
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1
  (2)
end
)~") ==
        R"~(bad.proof:3:3: error: expected a statement, found '('
     3 |   (2)
       |   ^
)~");
}

TEST_CASE("cases begin and end", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1
)~") ==
        R"~(bad.proof:1:1: error: case 'a' has no 'end'
     1 | case a
       | ^^^^
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1
case b
end
)~") ==
        R"~(bad.proof:1:1: error: case 'a' has no 'end'
     1 | case a
       | ^^^^
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 == 1
ennd
)~") ==
        R"~(bad.proof:3:1: error: expected a statement, found 'ennd'
     3 | ennd
       | ^^^^
       = help: did you mean 'end'?
)~");
  CHECK(messages_of(R"~(cse a
  prove x: 1 == 1
end
)~") ==
        R"~(bad.proof:1:1: error: expected 'case', 'define' or 'include', found 'cse'
     1 | cse a
       | ^^^
       = help: did you mean 'case'?
)~");
  CHECK(messages_of(R"~(prove x: 1 == 1
)~") ==
        R"~(bad.proof:1:1: error: expected 'case', 'define' or 'include', found 'prove'
     1 | prove x: 1 == 1
       | ^^^^^
       = help: statements stand between 'case NAME' and 'end'
)~");
  CHECK(messages_of(R"~(case
  prove x: 1 == 1
end
)~") ==
        R"~(bad.proof:1:5: error: expected a name for the case; the statement ends here
     1 | case
       |     ^
)~");
  CHECK(messages_of(R"~(case a.?
end
)~") ==
        R"~(bad.proof:1:8: error: expected a name after '.', found '?'
     1 | case a.?
       |        ^
)~");
  CHECK(messages_of(R"~(case a
end
end
)~") ==
        R"~(bad.proof:3:1: error: expected 'case', 'define' or 'include', found 'end'
     3 | end
       | ^^^
       = help: statements stand between 'case NAME' and 'end'
)~");
  CHECK(messages_of(R"~(case a
  include "b.proof"
end
)~") ==
        R"~(bad.proof:2:3: error: 'include' does not belong in a case
     2 |   include "b.proof"
       |   ^^^^^^^
       = help: write it before the first case
)~");
  CHECK(messages_of(R"~(include coons
)~") ==
        R"~(bad.proof:1:9: error: expected a text in "...", found 'coons'
     1 | include coons
       |         ^^^^^
)~");
}

TEST_CASE("one mistake does not hide or cause another", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: ((1) == 1
  prove y: [1 == 1
  refute z: 2 2 == 1
end
)~") ==
        R"~(bad.proof:2:17: error: expected ',' or ')', found '=='
     2 |   prove x: ((1) == 1
       |                 ^^
bad.proof:3:15: error: expected ',', ';' or ']', found '=='
     3 |   prove y: [1 == 1
       |               ^^
bad.proof:4:15: error: expected an operator before '2'
     4 |   refute z: 2 2 == 1
       |               ^
       = help: multiplication is written '*': 2*2
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 $
  prove x: 2 = 2
end
case b
  prove x: 2 2 == 1

)~") ==
        R"~(bad.proof:2:14: error: stray character '$'
     2 |   prove x: 1 $
       |              ^
bad.proof:3:14: error: '=' defines a name; a claim compares with '=='
     3 |   prove x: 2 = 2
       |              ^
bad.proof:5:1: error: case 'b' has no 'end'
     5 | case b
       | ^^^^
bad.proof:6:14: error: expected an operator before '2'
     6 |   prove x: 2 2 == 1
       |              ^
       = help: multiplication is written '*': 2*2
)~");
}

}  // namespace patchproof
