#include <catch2/catch.hpp>

#include "language_test.hpp"
#include "reading.hpp"

namespace patchproof {

TEST_CASE("an assumption may say why it is there") {
  const std::string text = "case a\n  scalar x\n  assume p: x == 1, x != 0 note \"why\"\nend\n";
  CHECK(reading_messages(text) == "");
  CHECK(formatted(SourceText{"a.proof", text}) == text);
  CHECK(meaning_of(text).find("\"note\": \"why\"") != std::string::npos);
  const ReadFile file = read_cases(source_of(text), Limits{},
                                   [](const std::string&) { return std::optional<std::string>{}; });
  const WrittenAssumption& written = file.cases.at(0).assumptions.at(0);
  CHECK(written.label == "p");
  CHECK(written.note == "why");
  CHECK(written.count == 2);
}

TEST_CASE("the note of an assumption is a text, and the last of it", "[reject]") {
  CHECK(type_messages("  scalar x\n  assume x == 1 note why\n") ==
        "bad.proof:3:22: error: expected a text in \"...\", found 'why'\n"
        "     3 |   assume x == 1 note why\n"
        "       |                      ^^^\n");
  CHECK(type_messages("  scalar x\n  assume x == 1 note \"a\" note \"b\"\n") ==
        "bad.proof:3:26: error: expected the end of the statement, found 'note'\n"
        "     3 |   assume x == 1 note \"a\" note \"b\"\n"
        "       |                          ^^^^\n");
}

}  // namespace patchproof
