#include <algorithm>
#include <catch2/catch.hpp>

#include <patchproof/language/utf8.hpp>
#include <patchproof/latex/words.hpp>

namespace patchproof {

TEST_CASE("every word is there in every language, and is valid UTF-8") {
  for (const std::string& code : language_codes()) {
    const Language language = language_of(code).value();
    for (std::size_t k = 0; k < word_count; ++k) {
      INFO(code << ", word " << k);
      const std::string& text = word(static_cast<Word>(k), language);
      CHECK_FALSE(text.empty());
      CHECK(printable(text) == text);
      // Nothing that TeX would take for a command.
      CHECK(text.find_first_of("\\{}$&#%_^~\"") == std::string::npos);
    }
  }
}

TEST_CASE("the words stand in the order of their names") {
  CHECK(word(Word::book_title, Language::english) == "Surface patches: statements and proofs");
  CHECK(word(Word::given, Language::slovak) == "Dané");
  CHECK(word(Word::by_machine, Language::slovak) ==
        "Každý krok bol rozhodnutý v presnej aritmetike programom");
  CHECK(word(Word::matrices, Language::czech) == "matice");
  CHECK(word(Word::by_definition, Language::slovak) == "Podľa definície");
  CHECK(word(Word::further_instances, Language::english) ==
        "Further instances, decided in the same way");
  CHECK(word(Word::reason_integration, Language::russian) == "интегрирование");
  CHECK(word(Word::refuted, Language::slovak) == "vyvrátené");
  CHECK(word(Word::kernel_only, Language::slovenian) == "samo jedro");
}

TEST_CASE("words of one language are in its letters") {
  const auto has = [](const std::string& text, char first) {
    return std::find(text.begin(), text.end(), first) != text.end();
  };
  // The first bytes of Cyrillic letters in UTF-8.
  for (std::size_t k = 0; k < word_count; ++k) {
    const std::string& text = word(static_cast<Word>(k), Language::russian);
    CHECK((has(text, '\xD0') || has(text, '\xD1')));
  }
}

TEST_CASE("languages have codes, and names for babel") {
  CHECK(language_codes() == std::vector<std::string>{"en", "cs", "sk", "sl", "ru"});
  CHECK_FALSE(language_of("de"));
  CHECK(code_of(Language::slovenian) == "sl");
  CHECK(babel_name(Language::slovenian) == "slovene");
  CHECK(babel_name(Language::russian) == "russian");
}

TEST_CASE("every verdict has a word") {
  CHECK(word(word_of(Verdict::proved_if), Language::english) == "proved if");
  CHECK(word(word_of(Verdict::unknown), Language::english) == "unknown: not decided");
  CHECK(word(word_of(Verdict::internal), Language::english) == "fault of the program");
  CHECK(word(word_of(Expectation::refute), Language::english) == "refuted");
}

}  // namespace patchproof
