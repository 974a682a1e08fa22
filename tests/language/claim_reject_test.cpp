#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {

TEST_CASE("a claim compares with == and not with =", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  scalar x
  prove p: x = 2
end
)~") ==
        R"~(bad.proof:3:14: error: '=' defines a name; a claim compares with '=='
     3 |   prove p: x = 2
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  scalar x
  assume p: x = 2
end
)~") ==
        R"~(bad.proof:3:15: error: '=' defines a name; an assumption compares with '=='
     3 |   assume p: x = 2
       |               ^
)~");
  CHECK(messages_of(std::string("case a\n\tprove x: 1 = 1\r\nend\r\n", 29)) ==
        R"~(bad.proof:2:13: error: '=' defines a name; a claim compares with '=='
     2 |  prove x: 1 = 1
       |             ^
)~");
  CHECK(
      messages_of(R"~(case a
  prove x: 1 + 2
end
)~") ==
      R"~(bad.proof:2:17: error: expected a comparison ('==', '!=', '<', ...); the statement ends here
     2 |   prove x: 1 + 2
       |                 ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 ==
  prove y: 2 == 2
end
)~") ==
        R"~(bad.proof:2:16: error: expected an expression; the statement ends here
     2 |   prove x: 1 ==
       |                ^
)~");
}

TEST_CASE("a label is needed and may be used once", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove r(u,0) == C1(u)
end
)~") ==
        R"~(bad.proof:2:9: error: expected a label and ':', found 'r'
     2 |   prove r(u,0) == C1(u)
       |         ^
       = help: as in 'prove south: r(u, 0) == C1(u)'
)~");
  CHECK(messages_of(R"~(case a
  scalar x
  prove x = 2
end
)~") ==
        R"~(bad.proof:3:9: error: expected a label and ':', found 'x'
     3 |   prove x = 2
       |         ^
       = help: as in 'prove south: r(u, 0) == C1(u)'
)~");
  CHECK(messages_of(R"~(case a
  scalar t
  prove x: t == t
  prove x: t == 0
end
)~") ==
        R"~(bad.proof:4:3: error: label 'x' used twice (first on line 3)
     4 |   prove x: t == 0
       |   ^^^^^
)~");
  CHECK(messages_of(R"~(case a
  assume x: t == t
  erratum x
    printed t == 1
    corrected t == 0
  end
end
)~") ==
        R"~(bad.proof:3:3: error: label 'x' used twice (first on line 2)
     3 |   erratum x
       |   ^^^^^^^
)~");
}

TEST_CASE("a derivation and an erratum have all their parts once", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  derive x: x gives 3
end
)~") ==
        R"~(bad.proof:2:15: error: expected 'from', found 'gives'
     2 |   derive x: x gives 3
       |               ^^^^^
)~");
  CHECK(messages_of(R"~(case a
  derive x: x from x == 1 gives 1 gives 2
end
)~") ==
        R"~(bad.proof:2:35: error: 'gives' given twice
     2 |   derive x: x from x == 1 gives 1 gives 2
       |                                   ^^^^^
)~");
  CHECK(messages_of(R"~(case a
  derive x: x from x == 1 inconsistent inconsistent
end
)~") ==
        R"~(bad.proof:2:40: error: 'inconsistent' given twice
     2 |   derive x: x from x == 1 inconsistent inconsistent
       |                                        ^^^^^^^^^^^^
)~");
  CHECK(messages_of(R"~(case a
  erratum e printed 1 == 2
  end
  prove x: 1 == 1
end
)~") ==
        R"~(bad.proof:2:27: error: expected 'corrected'; the statement ends here
     2 |   erratum e printed 1 == 2
       |                           ^
)~");
  CHECK(messages_of(R"~(case a
  erratum e
    printed 1 == 2
    corrected 1 == 1
  prove x: 1 == 1
end
)~") ==
        R"~(bad.proof:2:3: error: erratum 'e' has no 'end'
     2 |   erratum e
       |   ^^^^^^^
)~");
  CHECK(messages_of(R"~(case a
  errtum e
    printed 1 == 2
    corrected 1 == 1
  end
  prove x: 1 = 1
end
)~") ==
        R"~(bad.proof:2:3: error: expected a statement, found 'errtum'
     2 |   errtum e
       |   ^^^^^^
       = help: did you mean 'erratum'?
bad.proof:6:14: error: '=' defines a name; a claim compares with '=='
     6 |   prove x: 1 = 1
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  erratum e printed 1 == 2 corrected 1 == 1
    remark "x"
  end
end
)~") ==
        R"~(bad.proof:3:5: error: expected 'note', 'using', 'for' or 'end', found 'remark'
     3 |     remark "x"
       |     ^^^^^^
)~");
}

TEST_CASE("what a later version brings is named where it stands", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: E(d) == 0 for d : patch of degree (3,3)
end
)~") ==
        R"~(bad.proof:2:28: error: 'for ... : patch' is not available in this version
     2 |   prove x: E(d) == 0 for d : patch of degree (3,3)
       |                            ^
)~");
  CHECK(messages_of(R"~(case a
  curve C(u) : G^1
end
)~") ==
        R"~(bad.proof:2:16: error: 'G^k' is not available in this version
     2 |   curve C(u) : G^1
       |                ^
)~");
}

TEST_CASE("a joint names two edges", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: C^1 joint of P at v = 1 and R at v = 0 with k
end
)~") ==
        R"~(bad.proof:2:51: error: only a G^k joint has connecting functions
     2 |   prove x: C^1 joint of P at v = 1 and R at v = 0 with k
       |                                                   ^^^^
)~");
  CHECK(messages_of(R"~(case a
  show joint of P at v = 1
end
)~") ==
        R"~(bad.proof:2:27: error: expected 'and'; the statement ends here
     2 |   show joint of P at v = 1
       |                           ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: C^1 joint of P at v = 1
end
)~") ==
        R"~(bad.proof:2:35: error: expected 'and'; the statement ends here
     2 |   prove x: C^1 joint of P at v = 1
       |                                   ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: C^100 joint of P at v = 1 and R at v = 0
end
)~") ==
        R"~(bad.proof:2:14: error: expected an order from 0 to 99, found '100'
     2 |   prove x: C^100 joint of P at v = 1 and R at v = 0
       |              ^^^
)~");
  CHECK(messages_of(R"~(case a
  prove x: C^1 joint of P at v == 1 and R at v = 0
end
)~") ==
        R"~(bad.proof:2:32: error: expected '=', found '=='
     2 |   prove x: C^1 joint of P at v == 1 and R at v = 0
       |                                ^^
)~");
}

}  // namespace patchproof
