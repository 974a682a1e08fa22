#include <catch2/catch.hpp>

#include <patchproof/language/reader.hpp>

#include "language/reading.hpp"

namespace patchproof {

TEST_CASE("a case has a title, and titles in other languages") {
  const auto source = std::make_shared<const SourceText>(SourceText{
      "good.proof", "case a\n  title \"Edge\"\n  title \"Okraj\" lang sk\n  title \"Rob\" lang sl\nend\n"});
  const ReadFile read = read_cases(source, Limits{}, {});
  REQUIRE(read.diagnostics.empty());
  const Case& given = read.cases.at(0);
  CHECK(given.title == "Edge");
  CHECK(given.translated_titles ==
        std::map<std::string, std::string>{{"sk", "Okraj"}, {"sl", "Rob"}});
}

TEST_CASE("a language has one title", "[language][reject]") {
  CHECK(type_messages(R"~(  title "A" lang sk
  title "B" lang sk
  title "C" lang
)~") ==
        R"~(bad.proof:3:3: error: a second title in the language 'sk'
     3 |   title "B" lang sk
       |   ^^^^^^^^^^^^^^^^^
bad.proof:4:17: error: expected a language; the statement ends here
     4 |   title "C" lang
       |                 ^
)~");
}

}  // namespace patchproof
