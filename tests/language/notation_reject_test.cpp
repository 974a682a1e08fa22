#include <catch2/catch.hpp>

#include <patchproof/language/reader.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("a notation writes a symbol and does nothing else", "[language][reject]") {
  CHECK(type_messages(R"~(  notation r = "\mathbf r", Q = "\input{x}", r = "r"
  notation a = "x#1", b = "\write18{ls}", c = "\\def", d = "$x$"
  notation e = "{a", f = "a}", g = "x_", h = "", i = "x^_2"
  notation j = "x_1_2", k = "\bar", l = "x'^2", m = "{\hat}x"
  notation derivatives dots
  notation a
  patch r(u, v)
  scalar a, b, c, d, e, f, g, h, i, j, k, l, m
)~") ==
        R"~(bad.proof:2:29: error: a notation for 'Q', which is not declared
     2 |   notation r = "\mathbf r", Q = "\input{x}", r = "r"
       |                             ^
bad.proof:2:34: error: '\input' is not a command a notation may use
     2 |   notation r = "\mathbf r", Q = "\input{x}", r = "r"
       |                                  ^^^^^^
       = help: alphabets, accents and Greek letters, such as \mathbf, \tilde, \alpha
bad.proof:2:46: error: 'r' already has a notation
     2 |   notation r = "\mathbf r", Q = "\input{x}", r = "r"
       |                                              ^
bad.proof:3:18: error: a notation is mathematics in LaTeX, and this sign is not
     3 |   notation a = "x#1", b = "\write18{ls}", c = "\\def", d = "$x$"
       |                  ^
       = help: letters, digits, _ ^ { } and commands such as \mathbf or \alpha
bad.proof:3:28: error: '\write' is not a command a notation may use
     3 |   notation a = "x#1", b = "\write18{ls}", c = "\\def", d = "$x$"
       |                            ^^^^^^
       = help: alphabets, accents and Greek letters, such as \mathbf, \tilde, \alpha
bad.proof:3:48: error: '\' is not a command a notation may use
     3 |   notation a = "x#1", b = "\write18{ls}", c = "\\def", d = "$x$"
       |                                                ^
       = help: alphabets, accents and Greek letters, such as \mathbf, \tilde, \alpha
bad.proof:3:61: error: a notation is mathematics in LaTeX, and this sign is not
     3 |   notation a = "x#1", b = "\write18{ls}", c = "\\def", d = "$x$"
       |                                                             ^
       = help: letters, digits, _ ^ { } and commands such as \mathbf or \alpha
bad.proof:4:17: error: '{' is not closed
     4 |   notation e = "{a", f = "a}", g = "x_", h = "", i = "x^_2"
       |                 ^
bad.proof:4:28: error: '}' closes nothing
     4 |   notation e = "{a", f = "a}", g = "x_", h = "", i = "x^_2"
       |                            ^
bad.proof:4:38: error: nothing stands behind this '_'
     4 |   notation e = "{a", f = "a}", g = "x_", h = "", i = "x^_2"
       |                                      ^
bad.proof:4:47: error: an empty notation
     4 |   notation e = "{a", f = "a}", g = "x_", h = "", i = "x^_2"
       |                                               ^
bad.proof:4:56: error: nothing stands behind this '^'
     4 |   notation e = "{a", f = "a}", g = "x_", h = "", i = "x^_2"
       |                                                        ^
bad.proof:5:20: error: a second subscript
     5 |   notation j = "x_1_2", k = "\bar", l = "x'^2", m = "{\hat}x"
       |                    ^
       = help: braces make one of them: x_{12}, {x_1}_2
bad.proof:5:30: error: nothing stands behind this '\bar'
     5 |   notation j = "x_1_2", k = "\bar", l = "x'^2", m = "{\hat}x"
       |                              ^^^^
bad.proof:5:44: error: a second superscript
     5 |   notation j = "x_1_2", k = "\bar", l = "x'^2", m = "{\hat}x"
       |                                            ^
       = help: braces make one of them: x_{12}, {x_1}_2
bad.proof:5:55: error: nothing stands behind this '\hat'
     5 |   notation j = "x_1_2", k = "\bar", l = "x'^2", m = "{\hat}x"
       |                                                       ^^^^
bad.proof:6:24: error: expected 'subscript', 'superscript' or 'fraction', found 'dots'
     6 |   notation derivatives dots
       |                        ^^^^
bad.proof:7:13: error: expected '='; the statement ends here
     7 |   notation a
       |             ^
)~");
}

TEST_CASE("a notation is taken over into the case") {
  const auto source = std::make_shared<const SourceText>(SourceText{
      "good.proof",
      "case a\n  notation r = \"\\mathbf r_{0}''\", coons = \"K\"\n  notation derivatives fraction\n"
      "  patch r(u, v)\nend\n"});
  const ReadFile read = read_cases(source, Limits{}, {});
  REQUIRE(read.diagnostics.empty());
  const Notation& notation = read.cases.at(0).notation;
  CHECK(notation.names.at("r") == "\\mathbf r_{0}''");
  CHECK(notation.names.at("coons") == "K");
  CHECK(notation.derivatives == DerivativeStyle::fraction);
  CHECK(read.cases.at(0).declarations.at(0).name == "r");
  CHECK(read.cases.at(0).declarations.at(0).keyword == "patch");
  CHECK(read.cases.at(0).declarations.at(0).given);
}

}  // namespace patchproof
