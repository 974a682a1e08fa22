#include <catch2/catch.hpp>
#include <random>

#include <patchproof/language/position_table.hpp>
#include <patchproof/language/utf8.hpp>

#include "language_test.hpp"

namespace patchproof {
namespace {

Diagnostic at(const std::string& text, std::size_t begin, std::size_t end) {
  return {{source_of(text), begin, end}, "wrong", ""};
}

}  // namespace

TEST_CASE("columns count characters, and a byte order mark is none", "[language]") {
  const SourceText source{"a",
                          "\xEF\xBB\xBF"
                          "aé\n𝛼b\xFF"
                          "c"};
  const auto place = [&](std::size_t byte) {
    const Position position = position_of(source, byte);
    return std::to_string(position.line) + ":" + std::to_string(position.column);
  };
  CHECK(place(0) == "1:1");
  CHECK(place(3) == "1:1");
  CHECK(place(4) == "1:2");
  CHECK(place(6) == "1:3");
  CHECK(place(7) == "2:1");
  CHECK(place(11) == "2:2");
  CHECK(place(13) == "2:4");
  CHECK(place(1000) == "2:5");
}

TEST_CASE("a table of positions agrees with counting", "[language][law]") {
  std::mt19937 random(7);
  for (int round = 0; round < 30; ++round) {
    SourceText source{"a", ""};
    for (std::size_t i = random() % 3000; i > 0; --i) {
      const std::vector<std::string> pieces{"a", "\n", "é", "€", "𝛼", "\xFF", "\xC3", "xyz"};
      source.text += pieces[random() % pieces.size()];
    }
    const PositionTable table(source);
    for (int i = 0; i < 100; ++i) {
      const std::size_t byte = random() % (source.text.size() + 2);
      CAPTURE(round, byte);
      CHECK(table.at(byte).line == position_of(source, byte).line);
      CHECK(table.at(byte).column == position_of(source, byte).column);
    }
  }
}

TEST_CASE("a message shows place, line, caret and help", "[language]") {
  Diagnostic diagnostic = at("a\n\tb = ccc\r\n", 7, 10);
  diagnostic.help = "write d";
  CHECK(to_text(diagnostic) ==
        "bad.proof:2:6: error: wrong\n"
        "     2 |  b = ccc\n"
        "       |      ^^^\n"
        "       = help: write d\n");
  CHECK(to_text({{}, "wrong", "right"}) == "error: wrong\n       = help: right\n");
  CHECK(to_text(at("ab\ncd\n", 1, 5)) ==
        "bad.proof:1:2: error: wrong\n"
        "     1 | ab\n"
        "       |  ^\n");
  CHECK(to_text(at("", 0, 0)) ==
        "bad.proof:1:1: error: wrong\n"
        "     1 |\n"
        "       | ^\n");
}

TEST_CASE("a long line is cut to a window around the caret", "[language]") {
  std::string line(300, 'a');
  line.append("b").append(300, 'c');
  CHECK(to_text(at(line, 300, 301)) ==
        "bad.proof:1:301: error: wrong\n"
        "     1 | ..." +
            std::string(60, 'a') + "b" + std::string(59, 'c') +
            "...\n"
            "       | " +
            std::string(63, ' ') + "^\n");
  CHECK(to_text(at(line, 0, 1)) ==
        "bad.proof:1:1: error: wrong\n"
        "     1 | " +
            std::string(120, 'a') +
            "...\n"
            "       | ^\n");
  CHECK(to_text(at(line, 600, 601)) ==
        "bad.proof:1:601: error: wrong\n"
        "     1 | ..." +
            std::string(120, 'c') +
            "\n"
            "       | " +
            std::string(122, ' ') + "^\n");
}

TEST_CASE("whatever the bytes, a message is valid UTF-8 with the caret in its line",
          "[language][law]") {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    std::string text;
    for (std::size_t i = random() % 400; i > 0; --i) {
      text += static_cast<char>(random() % 5 == 0 ? random() % 256 : 'a' + random() % 26);
    }
    const std::size_t begin = random() % (text.size() + 1);
    Diagnostic diagnostic = at(text, begin, begin + random() % 200);
    diagnostic.message = diagnostic.help = text;
    const std::string message = to_text(diagnostic);
    CAPTURE(round, message);
    for (std::size_t i = 0; i < message.size(); i += utf8_length(message, i)) {
      REQUIRE(utf8_length(message, i) > 0);
    }
  }
}

TEST_CASE("valid UTF-8 is what RFC 3629 allows", "[language][literature]") {
  for (const std::string valid : {"a", "\xC2\x80", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                                  "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    CHECK(utf8_length(valid, 0) == valid.size());
    if (valid.size() > 1) CHECK(utf8_length(valid.substr(0, valid.size() - 1), 0) == 0);
  }
  for (const std::string invalid :
       {"\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", ""}) {
    CHECK(utf8_length(invalid, 0) == 0);
  }
}

TEST_CASE("diagnostics are put in order, one a place, as many as asked for", "[language]") {
  const auto source = source_of("abcdef");
  const auto other = source_of("abcdef");
  std::vector<Diagnostic> given;
  for (const std::size_t place : {4, 1, 4, 2}) {
    given.push_back({{source, place, place + 1}, std::to_string(given.size()), ""});
  }
  given.push_back({{other, 0, 1}, "other", ""});
  const auto messages = [](const std::vector<Diagnostic>& diagnostics) {
    std::string result;
    for (const Diagnostic& diagnostic : diagnostics) result += diagnostic.message + " ";
    return result;
  };
  CHECK(messages(in_order(given)) == "1 3 0 other ");
  CHECK(messages(in_order(given, 2)) == "1 3 ");
}

}  // namespace patchproof
