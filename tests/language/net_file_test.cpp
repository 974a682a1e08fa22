#include <catch2/catch.hpp>

#include <patchproof/language/net_file.hpp>

#include "language_test.hpp"
#include "reading.hpp"

namespace patchproof {

namespace {

const std::string case_of_net =
    "case a\n  net d from \"d.csv\"\n  prove p: d[0,0] == d[0,0]\nend\n";

std::string message_with(const std::string& net) {
  return reading_messages(case_of_net, {{"d.csv", net}});
}

}  // namespace

TEST_CASE("A net of a file has the points of the file", "[language]") {
  const auto source = source_of(
      "case a\n  net d from \"d.csv\"\n  net w from \"w.json\"\n  net c from \"row.csv\"\n"
      "  prove p: d[1,0] == (1/2, 3)\n  prove q: w[0,1] == 1/10\n  prove r: c[1] == (2, 2)\n"
      "end\n");
  const ReadFile read =
      read_cases(source, Limits{}, [](const std::string& path) -> std::optional<std::string> {
        if (path == "d.csv") return "0 0\n\n0.5 3\n";
        if (path == "w.json") return "[[[1], [0.1]], [[2], [3]]]";
        return "1 1\n2 2\n";
      });
  CHECK(read.diagnostics.empty());
  REQUIRE(read.cases.size() == 1);
  CHECK(read.cases[0].claims.size() == 3);
  REQUIRE(read.cases[0].declarations.size() == 3);
  CHECK_FALSE(read.cases[0].declarations[0].given);
  CHECK(read.cases[0].declarations[1].term.type().inner->is_scalar());
  CHECK(read.cases[0].declarations[2].term.type().list);
}

TEST_CASE("The path of a net is taken from the folder of the case", "[language]") {
  CHECK(path_beside("a.proof", "d.csv") == "d.csv");
  CHECK(path_beside("cases/a.proof", "d.csv") == "cases/d.csv");
  CHECK(path_beside("cases/a.proof", "../d.csv") == "cases/../d.csv");
  CHECK(path_beside("cases/a.proof", "/tmp/d.csv") == "/tmp/d.csv");
}

TEST_CASE("A declaration of a net from a file stays as it is formatted", "[language]") {
  const std::string text = "case a\n  net d from \"a b/d.csv\"  # points\nend\n";
  CHECK(formatted(SourceText{"a.proof", "case a\nnet  d   from \"a b/d.csv\" # points\nend"}) ==
        text);
  CHECK(formatted(SourceText{"a.proof", text}) == text);
}

TEST_CASE("The syntax tree has the name of the file", "[language]") {
  const Parsed parsed = parse(source_of(case_of_net));
  CHECK(dump(parsed.file).find("\"file\": \"d.csv\"") != std::string::npos);
}

TEST_CASE("Nets of files that cannot be taken are refused", "[language][reject]") {
  CHECK(reading_messages(case_of_net) ==
        R"~(bad.proof:2:14: error: cannot read 'd.csv'
     2 |   net d from "d.csv"
       |              ^^^^^^^
       = help: the path is taken from the folder of the file of the case
)~");
  CHECK(reading_messages("case a\n  net d from \"\"\nend\n") ==
        R"~(bad.proof:2:14: error: the path of a net is empty
     2 |   net d from ""
       |              ^^
)~");
  CHECK(message_with("1, 2\n1, x\n") == R"~(d.csv:2:4: error: expected a number, found 'x'
     2 | 1, x
       |    ^
       = help: a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like 0x1.8p-3
)~");
  CHECK(message_with("net 1000 x 1000\n1\n") == R"~(d.csv:1:1: error: more than 10000 points
     1 | net 1000 x 1000
       | ^^^^^^^^^^^^^^^
       = help: 'patchproof segments' is for larger nets
)~");
  CHECK(messages_of("case a\n  net d from d.csv\nend\n") ==
        R"~(bad.proof:2:14: error: expected a text in "...", found 'd'
     2 |   net d from d.csv
       |              ^
)~");
  CHECK(messages_of("case a\n  net d = 3\nend\n") ==
        R"~(bad.proof:2:9: error: expected '[' or 'from', found '='
     2 |   net d = 3
       |         ^
)~");
  CHECK(messages_of("case a\n  net d from \"d.csv\" for i in 0..3\nend\n") ==
        R"~(bad.proof:2:22: error: expected the end of the statement, found 'for'
     2 |   net d from "d.csv" for i in 0..3
       |                      ^^^
)~");
  CHECK(reading_messages("case a\n  scalar d\n  net d from \"d.csv\"\nend\n", {{"d.csv", "1\n"}}) ==
        R"~(bad.proof:3:7: error: 'd' is declared twice (first on line 2)
     3 |   net d from "d.csv"
       |       ^
)~");
}

TEST_CASE("One mistake in a file of a net is told once, for all cases", "[language][reject]") {
  const std::string two =
      case_of_net + "\ncase b\n  net d from \"d.csv\"\n  prove p: d == d\nend\n";
  CHECK(reading_messages(two, {{"d.csv", "x"}}) == message_with("x"));
}

}  // namespace patchproof
