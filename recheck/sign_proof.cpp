#include <recheck/sign_proof.hpp>

namespace recheck {

namespace {

std::string numbered(const std::string& list, std::size_t k) {
  return list + "[" + std::to_string(k) + "]";
}

}  // namespace

Fact multiple_of(const Cofactor& cofactor, const Premises& premises, Evaluator& evaluator) {
  Fact result = premises.instance(cofactor);
  const Value& factor = evaluator.value(cofactor.factor);
  result.divisors.insert(factor.divisors.begin(), factor.divisors.end());
  result.scalar = evaluator.field().product(result.scalar, factor.components.front());
  return result;
}

void SignChecker::follow(const SignProof& proof, const Quotient& goal, bool strict,
                         std::vector<Fact> facts, const std::string& path) const {
  const std::string start = path.empty() ? "" : path + ".";
  field_.meter().spend(1 + facts.size());
  for (std::size_t k = 0; k < proof.steps.size(); ++k) {
    const SignProof::Step& step = proof.steps[k];
    at_place(start + numbered("steps", k), [&] {
      const Value& fact = evaluator_.value(step.fact);
      divisors_.require(fact.divisors);
      require(step.why, fact.components.front(), step.strict, facts);
      facts.push_back({fact.components.front(), step.strict, fact.divisors});
    });
  }
  if (proof.end) {
    at_place(start + "end", [&] { require(*proof.end, goal, strict, facts); });
    return;
  }
  const Value& cut = evaluator_.value(proof.cut);
  at_place(start + "cut", [&] { divisors_.require(cut.divisors); });
  for (std::size_t k = 0; k < proof.cases.size(); ++k) {
    std::vector<Fact> known = facts;
    known.push_back(
        {field_.multiple(cut.components.front(), k == 0 ? 1 : -1), false, cut.divisors});
    follow(proof.cases[k], goal, strict, std::move(known), start + "cut." + numbered("cases", k));
  }
}

void SignChecker::require(const Combination& why, const Quotient& goal, bool strict,
                          const std::vector<Fact>& facts) const {
  Quotient rest = goal;
  bool positive = false;
  for (std::size_t k = 0; k < why.summands.size(); ++k) {
    at_place(numbered("summands", k), [&] {
      const Fact summand = value(why.summands[k], facts);
      divisors_.require(summand.divisors);
      rest = field_.difference(rest, summand.scalar);
      positive = positive || summand.strict;
    });
  }
  for (std::size_t k = 0; k < why.cofactors.size(); ++k) {
    at_place(numbered("cofactors", k), [&] {
      const Fact zero = multiple_of(why.cofactors[k], premises_, evaluator_);
      divisors_.require(zero.divisors);
      rest = field_.difference(rest, zero.scalar);
    });
  }
  if (!rest.numerator.empty())
    throw Rejection{field_.text(goal) + " is not the sum: " + field_.text(rest) + " is left"};
  if (strict && !positive)
    throw Rejection{field_.text(goal) + " is not shown to be positive: no summand is"};
}

Fact SignChecker::value(const Combination::Summand& summand, const std::vector<Fact>& facts) const {
  Fact result{number(summand.coefficient), summand.squares.empty(), {}};
  for (const NodeIndex square : summand.squares) {
    const Value& root = evaluator_.value(square);
    result.divisors.insert(root.divisors.begin(), root.divisors.end());
    result.scalar = field_.product(result.scalar, field_.power(root.components.front(), 2));
  }
  for (const auto& [index, exponent] : summand.facts) {
    if (index >= facts.size())
      throw Rejection{"there is no fact " + std::to_string(index) + ", only " +
                      std::to_string(facts.size())};
    const Fact& fact = facts[index];
    result.strict = result.strict && fact.strict;
    result.divisors.insert(fact.divisors.begin(), fact.divisors.end());
    result.scalar = field_.product(result.scalar, field_.power(fact.scalar, exponent));
  }
  return result;
}

}  // namespace recheck
