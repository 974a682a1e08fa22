#include <catch2/catch.hpp>

#include <patchproof/latex/freshness.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

const std::string two_cases =
    "define twice(a: scalar) : scalar = 2*a\nend\n"
    "case one\n  scalar a\n  prove x: a == a\nend\n"
    "case two\n  scalar b\n  prove y: twice(b) == b + b\nend\n";

std::string digest_of(const std::string& text, const std::string& name,
                      const DocumentOptions& options = {}, const std::string& included = "") {
  const Loader load = [&](const std::string&) -> std::optional<std::string> { return included; };
  return case_digest(std::make_shared<const SourceText>(SourceText{"a.proof", text}), name, load,
                     options)
      .value();
}

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

}  // namespace

TEST_CASE("a digest depends on the text of the case and on no other case") {
  const std::string digest = digest_of(two_cases, "one");
  CHECK(digest.size() == 64);
  CHECK(digest_of(two_cases, "one") == digest);
  CHECK(digest_of(replaced(two_cases, "a == a", "a == 1*a"), "one") != digest);
  CHECK(digest_of(replaced(two_cases, "b + b", "2*b"), "one") == digest);
}

TEST_CASE("a digest depends on definitions, also on included ones") {
  const std::string digest = digest_of(two_cases, "two");
  CHECK(digest_of(replaced(two_cases, "= 2*a", "= a + a"), "two") != digest);
  const std::string including = "include \"d.proof\"\n" + two_cases;
  const std::string definition = "define d(a: scalar) : scalar = a\nend\n";
  CHECK(digest_of(including, "two", {}, definition) != digest);
  CHECK(digest_of(including, "two", {}, definition) !=
        digest_of(including, "two", {}, replaced(definition, "= a", "= 3*a")));
}

TEST_CASE("a digest depends on language, detail and sort of the document") {
  const std::string digest = digest_of(two_cases, "one");
  CHECK(digest_of(two_cases, "one", {Language::czech, Detail::steps, false}) != digest);
  CHECK(digest_of(two_cases, "one", {Language::english, Detail::all, false}) != digest);
  CHECK(digest_of(two_cases, "one", {Language::english, Detail::steps, true}) != digest);
}

TEST_CASE("a case that is not there has no digest") {
  const auto source = std::make_shared<const SourceText>(SourceText{"a.proof", two_cases});
  CHECK_FALSE(case_digest(source, "three", [](const auto&) { return std::nullopt; }, {}));
}

TEST_CASE("the header says what is needed to write the file again") {
  const DocumentOptions options{Language::slovak, Detail::all, true};
  const std::string text = header_text({{"a.b", "x, y.proof"}, {"c", "z\n.proof"}}, "abc", options);
  CHECK(text == "% patchproof " + std::string{version} +
                    "\n% case: a.b, source: x, y.proof\n% case: c, source: z .proof\n"
                    "% digest: abc\n% options: --lang sk --detail 3 --fragment\n");
  const Header header = header_of(text + "\\section{x}\n% digest: other\n").value();
  CHECK(header.cases == std::vector<Origin>{{"a.b", "x, y.proof"}, {"c", "z .proof"}});
  CHECK(header.digest == "abc");
  CHECK(header.options.language == Language::slovak);
  CHECK(header.options.detail == Detail::all);
  CHECK(header.options.fragment);
  CHECK_FALSE(header_of("\\documentclass{article}\n"));
}

}  // namespace patchproof
