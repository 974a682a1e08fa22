#include <patchproof/derivation/checked_derivation.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <optional>

#include <patchproof/decide/decide.hpp>
#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>
#include <tests/derivation/proposals.hpp>
#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;
using patchproof::test::case_named;
using patchproof::test::Proposal;
using patchproof::test::proposal;

namespace {

using Change = std::function<std::optional<Term>(const Term&)>;

// The first node that the change is for, with its image.
std::optional<std::pair<Term, Term>> first_change(const Term& term, const Change& change) {
  if (const auto image = change(term)) return std::pair{term, *image};
  for (const Term& child : term.children())
    if (const auto found = first_change(child, change)) return found;
  return std::nullopt;
}

Term with_node(const Term& term, const Term& node, const Term& image) {
  if (is_one_term(term, node)) return image;
  std::vector<Term> children;
  for (const Term& child : term.children()) children.push_back(with_node(child, node, image));
  const bool same =
      std::equal(children.begin(), children.end(), term.children().begin(),
                 [](const Term& a, const Term& b) { return a.address() == b.address(); });
  if (same) return term;
  return make_term(term.operation(), term.type(), std::move(children), term->payload);
}

// The term with that node changed wherever it is used: in dot(q_uv, q_uv) twice.
std::optional<Term> changed(const Term& term, const Change& change) {
  const auto found = first_change(term, change);
  if (!found) return std::nullopt;
  return with_node(term, found->first, found->second);
}

std::optional<Term> sign_flipped(const Term& node) {
  if (node.operation() == Operation::negation) return node.child(0);
  if (node.operation() != Operation::sum) return std::nullopt;
  std::vector<Term> children = node.children();
  children.back() = -children.back();
  return make_term(Operation::sum, node.type(), children);
}

std::optional<Term> summand_dropped(const Term& node) {
  if (node.operation() != Operation::sum) return std::nullopt;
  std::vector<Term> children = node.children();
  children.pop_back();
  return children.size() == 1 ? children.front() : make_term(Operation::sum, node.type(), children);
}

std::optional<Term> number_changed(const Term& node) {
  if (!node.is_number() || node.number() == 0) return std::nullopt;
  const Integer above = numerator(node.number());
  const Integer below = denominator(node.number());
  return below == 1 ? number_term(node.number() + 1) : number_term(Rational{above, below + 1});
}

std::optional<Term> parameters_exchanged(const Term& term) {
  std::map<std::string, SymbolPointer> parameters;
  for (const auto& [ordinal, symbol] : free_symbols(term))
    if (symbol->role == Symbol::Role::parameter) parameters[symbol->name] = symbol;
  if (!parameters.contains("u") || !parameters.contains("v")) return std::nullopt;
  const SymbolPointer u = parameters["u"];
  const SymbolPointer v = parameters["v"];
  return replaced(term, {{u->ordinal, symbol_term(v)}, {v->ordinal, symbol_term(u)}});
}

std::vector<Term> corruptions(const Term& term) {
  std::vector<Term> result;
  for (const Change& change :
       {Change{sign_flipped}, Change{summand_dropped}, Change{number_changed}})
    if (const auto image = changed(term, change)) result.push_back(*image);
  if (const auto image = parameters_exchanged(term)) result.push_back(*image);
  return result;
}

bool are_equal(const Term& a, const Term& b, const Goal& given) {
  Goal equation_goal = given;
  equation_goal.statements = {equation(a, b)};
  const Verdict verdict = decided(equation_goal, Limits{}, Engines::kernel).verdict;
  return verdict == Verdict::proved || verdict == Verdict::proved_if;
}

std::string refused(const Derivation& derivation) {
  try {
    const CheckedDerivation checked{derivation, Limits{}, Engines::both};
    return "accepted";
  } catch (const FalseStep& fault) {
    return fault.what();
  }
}

std::string message(const Term& before, const Term& after) {
  return "a step of a derivation is REFUTED: " + to_text(before, 300) + " against " +
         to_text(after, 300);
}

// Corrupts each equation of the derivation in each way, and says how many ways there were.
int corrupted_steps(const Derivation& derivation) {
  int count = 0;
  for (std::size_t p = 0; p < derivation.passages.size(); ++p) {
    const Passage& passage = derivation.passages[p];
    for (const Chain& chain : passage.chains) {
      const Term* before = &chain.start;
      for (const Link& link : chain.links) {
        for (const Term& wrong : corruptions(link.term)) {
          if (passage.open || link.relation != Relation::equal) continue;
          // Some changes leave the value as it is.
          if (are_equal(link.term, wrong, passage.given)) continue;
          ++count;
          Passage false_passage = passage;
          false_passage.chains = {{*before, {{link.relation, wrong, link.reason}}}};
          CHECK(refused({{false_passage}}) == message(*before, wrong));
        }
        before = &link.term;
      }
    }
  }
  return count;
}

Passage passage_of(std::vector<Chain> chains) {
  return {Passage::Kind::computation, std::move(chains), {}, {}};
}

Link equal_to(const Term& term) { return {Relation::equal, term, {}}; }

std::string shown(const CheckedDerivation& derivation) {
  std::string result;
  for (const CheckedPassage& passage : derivation.passages())
    for (const CheckedChain& chain : passage.chains) {
      result += to_text(chain.start);
      for (const CheckedLink& link : chain.links)
        result += " | " + to_text(link.link.term) + " " + to_text(link.decision.verdict) + " " +
                  to_text(link.decision.evidence);
      result += "\n";
    }
  return result;
}

std::string checked(const Passage& passage) {
  return shown(CheckedDerivation{{{passage}}, Limits{}, Engines::both});
}

}  // namespace

TEST_CASE("no corrupted step of a real derivation is accepted", "[reject]") {
  const auto [folder, name, label, least] =
      GENERATE(table<std::string, std::string, std::string, int>(
          {{"coons_to_bezier", "cz.twist.V11", "V11", 10},
           {"coons_to_bezier", "cz.twist.00", "expansion", 5},
           {"bspline", "cz.MR.rule_surface", "rows", 30},
           {"bilinear", "sk.bilinear.closure", "south_defect", 5},
           {"twist_energy", "si.twist.min_bicubic", "least", 1}}));
  CAPTURE(name);
  const Derivation derivation = proposal(case_named(folder, name), label).derivation;
  CHECK_FALSE(derivation.passages.empty());
  CHECK(refused(derivation) == "accepted");
  CHECK(corrupted_steps(derivation) >= least);
}

TEST_CASE("the message of a false step shows both terms", "[reject]") {
  Declarations declare;
  const Term u = declare.parameter("u");
  CHECK(refused({{passage_of({{power(1 - u, 2), {equal_to(1 - 2 * u - power(u, 2))}}})}}) ==
        "a step of a derivation is REFUTED: (1 - u)^2 against 1 - 2*u - u^2");
  const Term a = declare.scalar("a");
  CHECK(refused({{passage_of({{a / 9, {equal_to(number(1, 10) * a)}}})}}) ==
        "a step of a derivation is REFUTED: a/9 against 1/10*a");
}

TEST_CASE("a step inside a chain is decided against what stands right before it", "[reject]") {
  Declarations declare;
  const Term a = declare.scalar("a");
  CHECK(refused({{passage_of({{a + a, {equal_to(2 * a), equal_to(3 * a), equal_to(2 * a)}}})}}) ==
        "a step of a derivation is REFUTED: 2*a against 3*a");
}

TEST_CASE("a false inequality is no step", "[reject]") {
  Declarations declare;
  const Term a = declare.scalar("a");
  const auto chain = [&](Relation relation, const Term& right) {
    return passage_of({{power(a, 2), {{relation, right, {}}}}});
  };
  CHECK(refused({{chain(Relation::greater_equal, number(1))}}) ==
        "a step of a derivation is REFUTED: a^2 against 1");
  CHECK(refused({{chain(Relation::less, number(0))}}) ==
        "a step of a derivation is REFUTED: a^2 against 0");
  CHECK(checked(chain(Relation::greater_equal, number(0))) == "a^2 | 0 PROVED kernel\n");
}

TEST_CASE("a step that the engines leave open is left out, and its neighbours are joined") {
  Declarations declare;
  const Term a = declare.scalar("a");
  const Term t = declare.parameter("t");
  // This integral has no closed form that the engines know.
  const Term open = a * make_term(Operation::integral, Type::scalar(),
                                  {lambda({t}, exp(power(t, 2))), number(0), number(1)});
  CHECK(checked(passage_of({{a + a, {equal_to(open), equal_to(2 * a)}}})) ==
        "a + a | 2*a PROVED both engines\n");
  CHECK(refused({{passage_of({{a + a, {equal_to(open), equal_to(3 * a)}}})}}) ==
        "a step of a derivation is REFUTED: a + a against 3*a");
  CHECK(checked(passage_of({{a + a, {equal_to(2 * a), equal_to(open)}}})) == "");
  CHECK(checked(passage_of({{a + a, {equal_to(open)}}})) == "");
}

TEST_CASE("an open condition is not decided; it is not said to hold") {
  Declarations declare;
  const Term a = declare.scalar("a");
  Passage open = passage_of({{a, {equal_to(2 * a + 1)}}});
  open.open = true;
  CHECK(checked(open) == "a | 2*a + 1 UNKNOWN none\n");
  open.open = false;
  CHECK(refused({{open}}) == "a step of a derivation is REFUTED: a against 2*a + 1");
}

TEST_CASE("that numbers differ is confirmed by both engines; of unknowns it is not") {
  Declarations declare;
  const Term x = declare.scalar("x");
  Passage numbers = passage_of({{power(x, 2), {{Relation::not_equal, number(3), {}}}}});
  numbers.given.known = {{x.symbol(), number(2)}};
  CHECK(checked(numbers) == "x^2 | 3 PROVED both engines\n");
  numbers.given.known = {};
  CHECK(checked(passage_of({{power(x, 2) + 1, {{Relation::not_equal, number(0), {}}}}})) ==
        "x^2 + 1 | 0 PROVED kernel\n");
  Passage equal_numbers = passage_of({{power(x, 2), {{Relation::not_equal, number(4), {}}}}});
  equal_numbers.given.known = {{x.symbol(), number(2)}};
  CHECK(refused({{equal_numbers}}) == "a step of a derivation is REFUTED: x^2 against 4");
}

TEST_CASE("steps are decided under the assumptions of their passage only") {
  Declarations declare;
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  Passage passage = passage_of({{a + b, {equal_to(3 * a)}}});
  passage.given.assumptions = {{"twice", equation(b, 2 * a)}};
  CHECK(checked(passage) == "a + b | 3*a PROVED both engines\n");
  passage.given.assumptions = {};
  CHECK(refused({{passage}}) == "a step of a derivation is REFUTED: a + b against 3*a");
}

TEST_CASE("a derivation without steps has no passages; one with values keeps them") {
  CHECK(CheckedDerivation{{{passage_of({})}}, Limits{}, Engines::both}.passages().empty());
  Declarations declare;
  const Term a = declare.scalar("a");
  Passage witness = passage_of({});
  witness.values = {{a.symbol(), number(1)}};
  const CheckedDerivation kept{{{witness}}, Limits{}, Engines::both};
  REQUIRE(kept.passages().size() == 1);
  CHECK(kept.passages().front().values.size() == 1);
}
