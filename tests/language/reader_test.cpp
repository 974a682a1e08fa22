#include <catch2/catch.hpp>

#include "language/reading.hpp"

namespace patchproof {

namespace {

// Files that can be included.
std::map<std::string, std::string> files() {
  std::map<std::string, std::string> result{
      {"self.proof", "include \"self.proof\"\n"},
      {"back.proof", "include \"bad.proof\"\n"},
      {"twice.proof", "define twice(t : scalar) : scalar\n  title \"t\"\n  = 2*t\nend\n"},
      {"wrong.proof", "define wrong(t : scalar) : scalar\n  title \"t\"\n  = tt\nend\n"},
  };
  for (int k = 0; k < 30; ++k)
    result["deep" + std::to_string(k) + ".proof"] =
        "include \"deep" + std::to_string(k + 1) + ".proof\"\n";
  return result;
}

}  // namespace

TEST_CASE("a definition has a name of its own", "[language][reject]") {
  CHECK(reading_messages(R"~(define coons(t : scalar) : scalar
  title "t"
  = t
end
define sin(t : scalar) : scalar
  title "t"
  = t
end
define mine(t : scalar) : scalar
  title "t"
  = t
end
define mine(t : scalar) : scalar
  title "t"
  = 2*t
end
)~") ==
        R"~(bad.proof:1:8: error: 'coons' is already defined
     1 | define coons(t : scalar) : scalar
       |        ^^^^^
bad.proof:5:8: error: 'sin' has a meaning of its own and cannot be defined
     5 | define sin(t : scalar) : scalar
       |        ^^^
bad.proof:13:8: error: 'mine' is already defined
    13 | define mine(t : scalar) : scalar
       |        ^^^^
)~");
}

TEST_CASE("a definition uses what is above it, and never itself", "[language][reject]") {
  CHECK(reading_messages(R"~(define loop(t : scalar) : scalar
  title "t"
  = 2*loop(t)
end
define early(t : scalar) : scalar
  title "t"
  = late(t)
end
define late(t : scalar) : scalar
  title "t"
  let n = 2*m
  = n*bernstien(2, 1, t)
end
)~") ==
        R"~(bad.proof:3:7: error: the definition of 'loop' uses itself
     3 |   = 2*loop(t)
       |       ^^^^
       = help: a definition may use only definitions above it
bad.proof:7:5: error: unknown name 'late'
     7 |   = late(t)
       |     ^^^^
bad.proof:11:13: error: unknown name 'm'
    11 |   let n = 2*m
       |             ^
bad.proof:12:7: error: unknown name 'bernstien'
    12 |   = n*bernstien(2, 1, t)
       |       ^^^^^^^^^
       = help: did you mean 'bernstein'?
)~");
}

TEST_CASE("a mistake in a definition is reported where it is used", "[language][reject]") {
  CHECK(reading_messages(R"~(define half(p : point) : point
  title "t"
  = p/2
end
define shifted(p : point) : point
  title "t"
  = half(p) + 1
end
case a
  point P
  prove x: shifted(P) == P
  prove y: half(1/2, P) == P
end
)~") ==
        R"~(bad.proof:11:12: error: in 'shifted': a scalar cannot be added to a point
    11 |   prove x: shifted(P) == P
       |            ^^^^^^^^^^
bad.proof:12:12: error: 'half' takes 1 argument, not 2
    12 |   prove y: half(1/2, P) == P
       |            ^^^^^^^^^^^^
       = help: half(p)
)~");
}

TEST_CASE("a definition in a case that it is not made for", "[language][reject]") {
  CHECK(reading_messages(R"~(define points(s : spline) : list
  title "t"
  = control_points(s)
end
case a
  point P
  prove x: points(P) == P
  prove y: points == P
end
)~") ==
        R"~(bad.proof:7:19: error: a spline is needed here
     7 |   prove x: points(P) == P
       |                   ^
       = help: declare one: 'spline T = bspline(d, degree 3, clamped uniform)'
bad.proof:8:12: error: 'points' needs arguments
     8 |   prove y: points == P
       |            ^^^^^^
)~");
}

TEST_CASE("includes are of files that can be read", "[language][reject]") {
  CHECK(reading_messages(R"~(include ""
include "missing.proof"
include "folder/missing.proof"
)~",
                         files()) ==
        R"~(bad.proof:1:1: error: the path of an include is empty
     1 | include ""
       | ^^^^^^^^^^
bad.proof:2:1: error: cannot read 'missing.proof'
     2 | include "missing.proof"
       | ^^^^^^^^^^^^^^^^^^^^^^^
       = help: the path is taken from the folder of the including file
bad.proof:3:1: error: cannot read 'folder/missing.proof'
     3 | include "folder/missing.proof"
       | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
       = help: the path is taken from the folder of the including file
)~");
}

TEST_CASE("includes do not go round in circles", "[language][reject]") {
  CHECK(reading_messages(R"~(include "self.proof"
include "back.proof"
)~",
                         files()) ==
        R"~(self.proof:1:1: error: 'self.proof' includes itself
     1 | include "self.proof"
       | ^^^^^^^^^^^^^^^^^^^^
back.proof:1:1: error: 'bad.proof' includes itself
     1 | include "bad.proof"
       | ^^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("includes are not nested too deeply", "[language][reject]") {
  CHECK(reading_messages(R"~(include "deep0.proof"
)~",
                         files()) ==
        R"~(deep18.proof:1:1: error: includes are nested too deeply
     1 | include "deep19.proof"
       | ^^^^^^^^^^^^^^^^^^^^^^
)~");
}

TEST_CASE("what is wrong in an included file is reported there", "[language][reject]") {
  CHECK(reading_messages(R"~(include "wrong.proof"
)~",
                         files()) ==
        R"~(wrong.proof:3:5: error: unknown name 'tt'
     3 |   = tt
       |     ^^
)~");
}

TEST_CASE("a file is included once", "[language][reject]") {
  CHECK(reading_messages(R"~(include "twice.proof"
include "twice.proof"
define twice(t : scalar) : scalar
  title "t"
  = 3*t
end
)~",
                         files()) ==
        R"~(bad.proof:3:8: error: 'twice' is already defined
     3 | define twice(t : scalar) : scalar
       |        ^^^^^
)~");
}

TEST_CASE("a case has a name of its own", "[language][reject]") {
  CHECK(reading_messages(R"~(case a
  prove x: 1 == 1
end
case b
  prove x: 1 == 1
end
case a
  prove x: 1 == 1
end
)~") ==
        R"~(bad.proof:7:6: error: case 'a' occurs twice (first on line 1)
     7 | case a
       |      ^
)~");
}

TEST_CASE("cases without names are mistakes, each by itself", "[language][reject]") {
  CHECK(reading_messages("case +\nend\ncase -\nend\n") ==
        R"~(bad.proof:1:6: error: expected a name for the case, found '+'
     1 | case +
       |      ^
bad.proof:3:6: error: expected a name for the case, found '-'
     3 | case -
       |      ^
)~");
}

TEST_CASE("the instances of a family have one set of mistakes", "[language][reject]") {
  CHECK(reading_messages(R"~(case a
  family i in 0..3, j in 3..2
  prove x: 1 == 1
end
case b
  family i in 0..3
  prove x: y == i
end
case c
  family i in 0..100000
  prove x: y == i
end
)~") ==
        R"~(bad.proof:2:21: error: 'j' runs over the empty span 3..2
     2 |   family i in 0..3, j in 3..2
       |                     ^
bad.proof:7:12: error: unknown name 'y'
     7 |   prove x: y == i
       |            ^
bad.proof:10:10: error: more than 4096 combinations of the running indices
    10 |   family i in 0..100000
       |          ^
)~");
}

TEST_CASE("only the first mistakes are shown, and how many more there are", "[language][reject]") {
  const auto mistakes = [](int count) {
    std::string text = "case a\n";
    for (int k = 0; k < count; ++k) text += "  show x" + std::to_string(k) + "y\n";
    return reading_messages(text + "end\n");
  };
  CHECK(mistakes(20).find("more mistake") == std::string::npos);
  CHECK(mistakes(21).find("bad.proof:21:8: error: and 1 more mistake\n") != std::string::npos);
  CHECK(mistakes(25).find("bad.proof:21:8: error: and 5 more mistakes\n") != std::string::npos);
}

TEST_CASE("expressions nest to a depth that is named", "[language][reject]") {
  std::string text = "case a\n  scalar x0\n";
  for (int k = 1; k <= 1100; ++k)
    text += "  let x" + std::to_string(k) + " = x" + std::to_string(k - 1) + "^2\n";
  const std::string messages = reading_messages(text + "end\n");
  CHECK(
      messages ==
      R"~(bad.proof:1002:15: error: this expression nests more than 1000 operations inside each other
  1002 |   let x1000 = x999^2
       |               ^^^^^^
)~");
}

TEST_CASE("definitions nest to a depth that is named", "[language][reject]") {
  std::string text;
  for (int k = 0; k <= 61; ++k)
    text += "define d" + std::to_string(k) + "(t : scalar) : scalar\n  title \"t\"\n  = " +
            (k == 0 ? "t" : "d" + std::to_string(k - 1) + "(t)") + "\nend\n";
  CHECK(reading_messages(text + "case a\n  show d59(1)\nend\n").empty());
  const std::string messages = reading_messages(text + "case a\n  show d60(1)\nend\n");
  CHECK(messages == R"~(bad.proof:250:8: error: in 'd1': definitions are nested more than 60 deep
   250 |   show d60(1)
       |        ^^^^^^
)~");
}

TEST_CASE("what is read without mistakes is complete") {
  const auto source = std::make_shared<const SourceText>(SourceText{
      "good.proof",
      "include \"twice.proof\"\ncase a\n  title \"A\"\n  source \"B\" lang sk section \"C\" page "
      "\"7\"\n"
      "  tags one, two\n  limit time 3 s\n  limit memory 2 MB\n  limit terms 5\n  limit steps 6\n"
      "  prove x: twice(2) == 4\nend\n"});
  const ReadFile read = read_cases(source, Limits{}, [](const std::string& path) {
    return std::optional<std::string>{files().at(path)};
  });
  CHECK(read.diagnostics.empty());
  REQUIRE(read.cases.size() == 1);
  const Case& given = read.cases.front();
  CHECK(given.name == "a");
  CHECK(given.title == "A");
  REQUIRE(given.sources.size() == 1);
  CHECK(given.sources[0].work == "B");
  CHECK(given.sources[0].language == "sk");
  CHECK(given.sources[0].section == "C");
  CHECK(given.sources[0].page == "7");
  CHECK(given.tags == std::vector<std::string>{"one", "two"});
  CHECK(given.limits.time == std::chrono::milliseconds{3000});
  CHECK(given.limits.memory == 2u << 20);
  CHECK(given.limits.terms == 5);
  CHECK(given.limits.steps == 6);
  REQUIRE(given.claims.size() == 1);
  CHECK(given.claims[0].label == "x");
}

TEST_CASE("a case with mistakes is left out, and the others are read") {
  const auto source = std::make_shared<const SourceText>(SourceText{
      "mixed.proof", "case a\n  prove x: y == 1\nend\ncase b\n  prove x: 1 == 1\nend\n"});
  const ReadFile read =
      read_cases(source, Limits{}, [](const std::string&) { return std::optional<std::string>{}; });
  CHECK(read.diagnostics.size() == 1);
  REQUIRE(read.cases.size() == 1);
  CHECK(read.cases.front().name == "b");
}

TEST_CASE("the library of a text holds the prelude and its own definitions") {
  const auto source = std::make_shared<const SourceText>(
      SourceText{"own.proof",
                 "include \"twice.proof\"\ndefine own(t : scalar) : scalar\n  title \"t\"\n  = "
                 "twice(t)\nend\n"});
  std::vector<Diagnostic> diagnostics;
  const Library library = read_definitions(
      source, [](const std::string& path) { return std::optional<std::string>{files().at(path)}; },
      diagnostics);
  CHECK(diagnostics.empty());
  CHECK(library.find("coons") != nullptr);
  CHECK(library.find("twice") != nullptr);
  CHECK(library.find("own") != nullptr);
  CHECK(library.find("none") == nullptr);
  CHECK(library.names().back() == "own");
}

}  // namespace patchproof
