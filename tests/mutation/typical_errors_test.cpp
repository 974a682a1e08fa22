#include <algorithm>
#include <catch2/catch.hpp>

#include <patchproof/language/parser.hpp>
#include <patchproof/mutation/site.hpp>

namespace patchproof {

namespace {

using Texts = std::vector<std::string>;

// What is tried in the left side of the last claim of a case.
std::vector<TypicalError> errors_in(const std::string& statements) {
  const auto source =
      std::make_shared<const SourceText>(SourceText{"", "case a\n" + statements + "\nend\n"});
  const Parsed parsed = parse(source);
  REQUIRE(parsed.diagnostics.empty());
  const syntax::Case& written = parsed.file.cases.front();
  return typical_errors(written.statements.back().proposition.comparisons.front().operands.front(),
                        vocabulary_of(written));
}

Texts words_in(const std::string& statements) {
  Texts result;
  for (const TypicalError& error : errors_in(statements)) result.push_back(error.words);
  return result;
}

// The left side with each of the errors.
Texts texts_in(const std::string& left) {
  const std::string before = "case a\n  prove p: ";
  Texts result;
  for (const TypicalError& error : errors_in("  prove p: " + left + " == 0")) {
    const std::string text = changed(before + left, {error.edit});
    result.push_back(text.substr(before.size()));
  }
  return result;
}

bool contains(const Texts& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

}  // namespace

TEST_CASE("each summand may have the other sign, or be left out") {
  CHECK(texts_in("a - b + c") ==
        Texts{"-a - b + c", "- b + c", "a + c", "a + b + c", "a - b", "a - b - c"});
  CHECK(texts_in("-a") == Texts{"a"});
  CHECK(texts_in("-a + b") == Texts{"a + b", " b", "-a", "-a - b"});
}

TEST_CASE("a denominator is one more or one less, and never 0") {
  CHECK(texts_in("1/9*x") == Texts{"1/10*x", "1/8*x"});
  CHECK(texts_in("1/3*x") == Texts{"1/2*x", "1/4*x"});
  CHECK(texts_in("1/2*x") == Texts{"1/3*x"});
  CHECK(texts_in("x/2") == Texts{"x/3"});
}

TEST_CASE("arguments and indices are exchanged, corners taken for others") {
  CHECK(texts_in("V[0,1]") == Texts{"V[1,1]", "V[1,0]", "V[0,0]", "V[0,2]"});
  CHECK(texts_in("r(0,1)") == Texts{"r(1,1)", "r(1,0)", "r(0,0)"});
  CHECK(words_in("  prove p: r(0,1) == 0") ==
        Texts{"0 -> 1 in r(0,1)", "0 and 1 exchanged in r(0,1)", "1 -> 0 in r(0,1)"});
  CHECK(texts_in("r(0,0)") == Texts{"r(1,0)", "r(0,1)"});
}

TEST_CASE("names of one kind that differ in one character are taken for each other") {
  const std::string curves = "  curve C1(u), C2(u), D1(u)\n  scalar C0\n";
  CHECK(words_in(curves + "  prove p: C1 == 0") == Texts{"C1 -> C2"});
  CHECK(words_in(curves + "  prove p: D1 == 0") == Texts{"D1 -> C1"});
  CHECK(words_in("  point P00, P01, P02, P10\n  prove p: P01 == 0") ==
        Texts{"P01 -> P00", "P01 -> P02"});
}

TEST_CASE("derivatives are taken in another parameter") {
  CHECK(words_in("  param u, v in [0, 1]\n  patch r(u,v) : C^2\n  prove p: r_uv == 0") ==
        Texts{"r_uv -> r_uu", "r_uv -> r_vv"});
}

TEST_CASE("a net that is handed on may be transposed, a list not") {
  const std::string declared = "  point V[0..1, 0..1], L[0..1]\n";
  CHECK(
      contains(words_in(declared + "  prove p: bezier(V) == 0"), "V -> transpose(V) in bezier(V)"));
  CHECK_FALSE(
      contains(words_in(declared + "  prove p: bezier(L) == 0"), "L -> transpose(L) in bezier(L)"));
}

TEST_CASE("the kinds of errors take turns when not all of them are tried") {
  const auto source = std::make_shared<const SourceText>(
      SourceText{"", "case a\n  prove p: 1 + 2 + 3 == V[0,1]\nend\n"});
  const Parsed parsed = parse(source);
  const std::vector<Site> sites = sites_of(parsed.file.cases.front(), "new");
  REQUIRE(sites.size() == 1);
  Texts first;
  const std::vector<SiteError> errors = in_turns(sites.front().errors);
  for (std::size_t k = 0; k < 5; ++k) first.push_back(errors[k].error.edit.what);
  std::sort(first.begin(), first.end());
  CHECK(first == Texts{"exchanged", "index", "number", "sign", "summand"});
}

}  // namespace patchproof
