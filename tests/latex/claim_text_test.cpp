#include <catch2/catch.hpp>

#include <patchproof/latex/claim_text.hpp>
#include <patchproof/latex/given_text.hpp>
#include <patchproof/patchproof.hpp>

namespace patchproof {

namespace {

/// The claim of a case that proves `a + a == 2*a == b`, with b = 2a assumed.
Case small_case() {
  const std::vector<CaseFile> files = read_files(
      {{"a.proof",
        "case c\n  scalar a, b\n  assume twice: b == 2*a\n  prove x: a + a == 2*a == b\nend\n",
        ""}});
  REQUIRE(files.front().diagnostics.empty());
  return files.front().cases.front();
}

CheckedDerivation derivation_of(Passage::Kind kind, const Case& given,
                                std::vector<KnownValue> values = {}) {
  Goal goal = goal_of(given.claims.front());
  const std::vector<Statement> statements = std::move(goal.statements);
  goal.statements.clear();
  const Chain chain{
      statements.front().left,
      {{Relation::equal, statements.front().right, {Reason::Kind::arithmetic, {}}},
       {Relation::equal, statements.back().right, {Reason::Kind::assumption, {"twice"}}}}};
  return {{{{kind, {chain}, std::move(values), goal}}}, given.limits, Engines::kernel};
}

std::string with(Passage::Kind kind, Language language) {
  Wording wording;
  wording.language = language;
  return passages_text(derivation_of(kind, small_case()), wording);
}

const std::string chain_in_english =
    "\\begin{ppchain}{a + a}\n"
    "  \\ppline{=}{2a}{arithmetic}\n"
    "  \\ppline{=}{b}{assumption \\pplabel{twice}}\n"
    "\\end{ppchain}\n";

}  // namespace

TEST_CASE("a chain has a line for each step, with its reason") {
  CHECK(with(Passage::Kind::computation, Language::english) ==
        "\\ppderivation{Derivation}{We compute}\n" + chain_in_english);
}

TEST_CASE("the words of a passage are those of the language") {
  CHECK(with(Passage::Kind::computation, Language::slovak) ==
        "\\ppderivation{Odvodenie}{Počítame}\n\\begin{ppchain}{a + a}\n  \\ppline{=}{2a}{úprava}\n"
        "  \\ppline{=}{b}{predpoklad \\pplabel{twice}}\n\\end{ppchain}\n");
}

TEST_CASE("a result stands in a box") {
  CHECK(with(Passage::Kind::result, Language::english) ==
        "\\ppderivation{Derivation}{Hence}\n\\begin{ppresult}\n" + chain_in_english + "\\end{ppresult}\n");
}

TEST_CASE("a counterexample begins with its values, zeros said together") {
  const Case given = small_case();
  const SymbolPointer a = given.declarations.at(0).term.symbol();
  const SymbolPointer b = given.declarations.at(1).term.symbol();
  const std::string text = passages_text(
      derivation_of(Passage::Kind::witness, given,
                    {{a, number_term(Rational{0})}, {b, number_term(Rational{1, 2})}}),
      Wording{});
  CHECK(text == "\\ppderivation{Derivation}{\\textbf{Counterexample:} $b = \\tfrac{1}{2}$; "
                "everything else is 0}\n" +
                    chain_in_english);
}

TEST_CASE("statements that share a side are one chain") {
  const Case given = small_case();
  CHECK(statement_text(given.claims.front(), Wording{}) ==
        "\\begin{ppchain}{a + a}\n  \\ppline{=}{2a}{}\n  \\ppline{=}{b}{}\n\\end{ppchain}\n");
}

TEST_CASE("a claim whose derivation shows the result does not show it again") {
  const Case given = small_case();
  ClaimResult result;
  result.claim = given.claims.front();
  result.decision.verdict = Verdict::proved;
  result.decision.evidence = Evidence::kernel;
  result.outcome = Outcome::as_expected;
  result.decision.solution = {{given.declarations.at(0).term.symbol(), number_term(Rational{1})}};
  const std::string boxed =
      claim_text(result, {0, 0, derivation_of(Passage::Kind::result, given)}, false, Wording{});
  CHECK(boxed.find("\\ppline{=}{1}{}") == std::string::npos);
  CHECK(boxed.ends_with("\\ppverdict{ppgood}{proved}{kernel only}\n"));
  const std::string bare = claim_text(result, {0, 0, {}}, false, Wording{});
  CHECK(bare.find("\\begin{ppresult}\n\\begin{ppchain}{a}\n  \\ppline{=}{1}{}") !=
        std::string::npos);
}

}  // namespace patchproof
