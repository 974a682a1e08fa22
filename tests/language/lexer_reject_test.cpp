#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {

TEST_CASE("characters that mean nothing are reported where they stand", "[language][reject]") {
  CHECK(messages_of(R"~(case a
  prove x: 1 $ 2 == 3
end
)~") ==
        R"~(bad.proof:2:14: error: stray character '$'
     2 |   prove x: 1 $ 2 == 3
       |              ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: 1 − 2 == 3
end
)~") ==
        R"~(bad.proof:2:14: error: stray character '−'
     2 |   prove x: 1 − 2 == 3
       |              ^
       = help: write '-'
)~");
  CHECK(messages_of(R"~(case a
  prove x: Bézier == 3
end
)~") ==
        R"~(bad.proof:2:13: error: stray character 'é'
     2 |   prove x: Bézier == 3
       |             ^
       = help: names are made of the letters a-z, A-Z, digits, '_' and trailing quotes
)~");
  CHECK(messages_of(R"~(case a
  prove x: ''' == 3
end
)~") ==
        R"~(bad.proof:2:12: error: stray character '''
     2 |   prove x: ''' == 3
       |            ^
)~");
  CHECK(messages_of(R"~(case a
  prove x: _y == 3
end
)~") ==
        R"~(bad.proof:2:12: error: stray character '_'
     2 |   prove x: _y == 3
       |            ^
       = help: a name begins with a letter
)~");
  CHECK(messages_of(R"~(case a
  title "Coons
end
)~") ==
        R"~(bad.proof:2:9: error: text without a closing '"'
     2 |   title "Coons
       |         ^^^^^^
       = help: a text is written on one line
)~");
  CHECK(messages_of(R"~(case a
  quote „a“
end
)~") ==
        R"~(bad.proof:2:9: error: stray character '„'
     2 |   quote „a“
       |         ^
       = help: a text is written "..."
bad.proof:2:11: error: stray character '“'
     2 |   quote „a“
       |           ^
       = help: a text is written "..."
)~");
}

TEST_CASE("bytes that are no text are reported once", "[language][reject]") {
  CHECK(messages_of(std::string("case a\n  title \"x\000y\"\nend", 24)) ==
        R"~(bad.proof:2:11: error: this is not a text file
     2 |   title "x�y"
       |           ^
)~");
  CHECK(messages_of(std::string("case a\n  title \"B\351zier\" # \351\nend", 31)) ==
        R"~(bad.proof:2:11: error: invalid UTF-8
     2 |   title "B�zier" # �
       |           ^
       = help: save the file in the encoding UTF-8
)~");
  CHECK(messages_of(std::string("\211PNG\r\n\032\n\000\000", 10)) ==
        R"~(bad.proof:2:1: error: this is not a text file
     2 | �
       | ^
)~");
}

}  // namespace patchproof
