#include <tests/architecture/source_tree.hpp>

#include <catch2/catch.hpp>

using namespace patchproof::architecture;

TEST_CASE("Comments and the insides of literals are no code", "[architecture]") {
  CHECK(code_only("a // b\nc") == "a     \nc");
  CHECK(code_only("a /* b\nc */ d") == "a     \n     d");
  CHECK(code_only("f(\"a\\\"b\") + 'c'") == "f(\"    \") + ' '");
  CHECK(code_only("R\"x(a)\" b)x\" c") == "R\"         \" c");
  CHECK(code_only("10'000 + 'a' // 10'000") == "10'000 + ' '          ");
  CHECK(code_only("\"//\" a") == "\"  \" a");
}

TEST_CASE("Unfinished literals and comments end with the text", "[architecture]") {
  CHECK(code_only("a /* b") == "a     ");
  CHECK(code_only("a \"b") == "a \" ");
  CHECK(code_only("a \"b\\") == "a \"  ");
  CHECK(code_only("R\"x(ab") == "R\"    ");
  CHECK(code_only("R\"x") == "   ");
}

TEST_CASE("A text ends with or without the end of its last line", "[architecture]") {
  CHECK(lines_of("a\n\nb") == std::vector<std::string>{"a", "", "b"});
  CHECK(lines_of("a\n\nb\n") == std::vector<std::string>{"a", "", "b"});
  CHECK(lines_of("").empty());
}
