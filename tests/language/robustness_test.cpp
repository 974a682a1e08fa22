#include <catch2/catch.hpp>

#include "language_test.hpp"

namespace patchproof {
namespace {

constexpr std::size_t million = 1'000'000;

std::string repeated(const std::string& piece, std::size_t times) {
  std::string result;
  result.reserve(piece.size() * times);
  for (std::size_t i = 0; i < times; ++i) result += piece;
  return result;
}

std::string claim(const std::string& left) { return "case a\n  prove x: " + left + " == 0\nend\n"; }

/// Messages without places and excerpts, at most one a line.
std::string first_messages_of(const std::string& text) {
  std::string result;
  for (const Diagnostic& diagnostic : parse(source_of(text)).diagnostics) {
    CHECK(to_text(diagnostic).size() < 1000);
    result += diagnostic.message + "\n";
  }
  return result;
}

const std::string too_deep = "nested more deeply than 200 levels\n";

}  // namespace

TEST_CASE("an empty text has no cases and no mistakes", "[language]") {
  CHECK(first_messages_of("") == "");
  CHECK(first_messages_of(std::string(10 * million, ' ')) == "");
}

TEST_CASE("deep nesting is refused, 200 levels are not", "[language][reject]") {
  const auto nested = [](std::size_t n) { return repeated("(", n) + "x" + repeated(")", n); };
  CHECK(first_messages_of(claim(nested(200))) == "");
  CHECK(first_messages_of(claim(nested(201))) == too_deep);
  for (const std::string piece : {"(", "[", "f(", "x^", "x^-", "(-", "a*(b + ", "V[0.."}) {
    CAPTURE(piece);
    const std::size_t times = 3 * million / 5;
    const std::string message = first_messages_of(claim(repeated(piece, times) + "x"));
    CHECK((message == too_deep || message == "more than 3000000 words and signs in one file\n"));
  }
  for (const std::string piece : {".x", "(1)", "[1]"}) {
    CAPTURE(piece);
    CHECK(first_messages_of(claim("f" + repeated(piece, million / 2))) == too_deep);
  }
}

TEST_CASE("a million summands are one sum", "[language]") {
  const Parsed parsed = parse(source_of(claim("x" + repeated(" + x", million - 1))));
  REQUIRE(parsed.diagnostics.empty());
  const auto& comparison = parsed.file.cases.at(0).statements.at(0).proposition.comparisons.at(0);
  CHECK(comparison.operands.at(0)->operands.size() == million);
}

TEST_CASE("a line of ten megabytes is read or refused at once", "[language][reject]") {
  CHECK(first_messages_of(claim(std::string(10 * million, 'x'))) == "");
  CHECK(first_messages_of(claim(std::string(10 * million, '1'))) ==
        "number with more than 10000 characters\n");
  CHECK(first_messages_of(claim("x" + repeated("+x", 5 * million - 1))) ==
        "more than 3000000 words and signs in one file\n");
  CHECK(first_messages_of(std::string(10 * million, 'x')) ==
        "expected 'case', 'define' or 'include', found '" + std::string(40, 'x') + "...'\n");
}

TEST_CASE("long runs of one sign are one mistake", "[language][reject]") {
  CHECK(first_messages_of(repeated("'", million)) == "stray character '''\n");
  CHECK(first_messages_of(claim("x" + repeated("'", million))) == "");
  CHECK(first_messages_of(claim(repeated("- ", million) + "x")) ==
        "expected an expression, found '-'\n");
  CHECK(first_messages_of(claim("2" + repeated(" x", million))) ==
        "expected an operator before 'x'\n");
}

TEST_CASE("of many mistakes twenty are reported", "[language][reject]") {
  const auto count = [](const std::string& text) {
    return parse(source_of(text)).diagnostics.size();
  };
  CHECK(count("case a\n" + repeated("  prove x 1\n", 100'000) + "end\n") == 20);
  CHECK(count("case a\n" + repeated("  prove x: 1 == 1\n", 50'000) + "end\n") == 20);
  CHECK(count(repeated("$ ", million)) == 20);
  CHECK(count(repeated("\"\n", million)) == 20);
  CHECK(count(repeated("\xE9\n", million)) == 20);
  CHECK(count(repeated("\xE9", million)) == 1);
  CHECK(count(repeated("end\n", 100'000)) == 1);
}

TEST_CASE("a file has at most a hundred thousand statements", "[language][reject]") {
  CHECK(first_messages_of("case a\n" + repeated("show 1\n", 100'001) + "end\n") ==
        "more than 100000 statements in one file\n");
}

TEST_CASE("the places of twenty thousand nodes on one line are found quickly", "[language]") {
  const std::string text = claim("x" + repeated("+x", 20'000));
  const std::string tree = dump(parse(source_of(text)).file);
  CHECK(tree.find("\"column\": 40012") != std::string::npos);
}

}  // namespace patchproof
