#include <patchproof/certificate/certificates.hpp>

#include <algorithm>
#include <set>

#include <patchproof/certificate/equation_search.hpp>
#include <patchproof/certificate/sequents.hpp>
#include <patchproof/certificate/sign_search.hpp>
#include <patchproof/decide/guard.hpp>
#include <patchproof/kernel/identity.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// No proof was found, for the reason given.
class NotFound : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class SequentSearch {
 public:
  SequentSearch(Sequent sequent, const std::set<unsigned>& unknowns,
                const std::vector<std::string>& conditions, Workspace& workspace)
      : sequent_{std::move(sequent)},
        conditions_{conditions},
        workspace_{workspace},
        evaluator_{workspace},
        equations_{sequent_, unknowns, evaluator_, workspace},
        signs_{facts(), workspace} {}

  SequentProof proof() {
    SequentProof result;
    for (std::size_t k = 0; k < sequent_.conclusions.size(); ++k)
      prove(k, result);
    divisors_.insert(equations_.conditions().begin(), equations_.conditions().end());
    for (const Condition& divisor : divisors_) add_not_zero(divisor, result);
    result.sequent = sequent_;
    return result;
  }

 private:
  std::vector<SignedPolynomial> facts() {
    std::vector<SignedPolynomial> result;
    for (const Fact& fact : facts_of(sequent_)) {
      const Value& value = evaluator_.value(fact.scalar);
      divisors_.insert(value.conditions.begin(), value.conditions.end());
      const Fraction& fraction = value.components.front();
      result.push_back({fraction.is_polynomial() ? fraction.numerator() : Polynomial{}, fact.strict});
      if (!fraction.is_polynomial()) result.back().strict = false;
    }
    return result;
  }

  void prove(std::size_t index, SequentProof& result) {
    const Statement& statement = sequent_.conclusions[index];
    const Value left = evaluator_.value(statement.left);
    const Value right = evaluator_.value(statement.right);
    divisors_.insert(left.conditions.begin(), left.conditions.end());
    divisors_.insert(right.conditions.begin(), right.conditions.end());
    bool differs = false;
    for (std::size_t c = 0; c < left.components.size(); ++c) {
      const Fraction d = normal_form(
          difference(left.components[c], right.components[c], workspace_.budget), workspace_);
      switch (statement.relation) {
        case Relation::equal: result.components.push_back({index, c, equation(d), false}); break;
        case Relation::not_equal:
          if (!differs) differs = add_difference(index, c, d, result);
          break;
        case Relation::less: add_order(index, negated(d), true, result); break;
        case Relation::less_equal: add_order(index, negated(d), false, result); break;
        case Relation::greater: add_order(index, d, true, result); break;
        case Relation::greater_equal: add_order(index, d, false, result); break;
      }
    }
    if (statement.relation == Relation::not_equal && !differs)
      throw NotFound{"no component was found whose sign shows that the two sides differ"};
  }

  Fraction negated(const Fraction& fraction) {
    return product(fraction, Fraction{Rational{-1}}, workspace_.budget);
  }

  EquationProof equation(const Fraction& d) {
    for (const auto& [factor, exponent] : d.denominator())
      divisors_.insert({Condition::Kind::not_zero, factor});
    if (d.is_zero()) return {};
    const EquationSearch::Reduced reduced = equations_.reduced(d.numerator());
    if (!reduced.rest.is_zero())
      throw NotFound{"the equation was not found to be a sum of multiples of hypotheses"};
    return {equations_.cofactors(reduced.multiples, d)};
  }

  std::optional<SignProof> sign(const Polynomial& polynomial, bool strict) {
    if (std::optional<SignProof> found = signs_.proof({polynomial, strict}, {})) return found;
    const EquationSearch::Reduced reduced = equations_.reduced(polynomial);
    if (reduced.multiples.empty()) return std::nullopt;
    return signs_.proof({reduced.rest, strict},
                        equations_.cofactors(reduced.multiples, Fraction{polynomial}));
  }

  void add_order(std::size_t index, const Fraction& d, bool strict, SequentProof& result) {
    if (!d.is_polynomial()) throw NotFound{"an inequality between quotients"};
    std::optional<SignProof> found = sign(d.numerator(), strict);
    if (!found) throw NotFound{"no proof of the sign was found"};
    result.components.push_back({index, 0, std::move(*found), false});
  }

  bool add_difference(std::size_t index, std::size_t component, const Fraction& d,
                      SequentProof& result) {
    if (!d.is_polynomial()) return false;
    for (const bool negative : {false, true}) {
      const Polynomial p = negative ? scaled(d.numerator(), -1) : d.numerator();
      std::optional<SignProof> found = sign(p, true);
      if (!found) continue;
      result.components.push_back({index, component, std::move(*found), negative});
      return true;
    }
    return false;
  }

  // What is known not to vanish is taken out of the divisor; the rest has to have a sign, or to be one
  // of the conditions of the verdict.
  void add_not_zero(const Condition& divisor, SequentProof& result) {
    if (divisor.kind != Condition::Kind::not_zero)
      throw NotFound{"a root of what is not a number"};
    Divisor hint{number_term(1), {}};
    Polynomial rest = divisor.polynomial;
    for (std::size_t k = 0; k < sequent_.hypotheses.size() && !rest.is_constant(); ++k) {
      const Statement& s = sequent_.hypotheses[k].statement;
      if (s.relation != Relation::not_equal || !s.left.type().is_scalar()) continue;
      const Polynomial d = difference(evaluator_.value(s.left).components.front(),
                                      evaluator_.value(s.right).components.front(),
                                      workspace_.budget)
                               .numerator();
      if (d.is_constant()) continue;
      const Term scalar = difference_term(s.left, s.right);
      while (const std::optional<Polynomial> next = quotient(rest, d, workspace_.budget)) {
        rest = *next;
        hint.product.push_back(place_of({scalar, k, std::nullopt, false}, result));
      }
      const std::optional<Polynomial> more = quotient(d, rest, workspace_.budget);
      if (!rest.is_constant() && more) {
        rest = Polynomial{Rational{1}};
        hint.factor = scalar_term(*more, workspace_.atoms);
        hint.product.push_back(place_of({scalar, k, std::nullopt, false}, result));
      }
    }
    if (!rest.is_constant()) hint.product.push_back(place_of(with_sign(rest), result));
    if (!hint.product.empty()) result.divisors.push_back(std::move(hint));
  }

  static Term difference_term(const Term& a, const Term& b) {
    return make_term(Operation::sum, Type::scalar(),
                     {a, make_term(Operation::negation, Type::scalar(), {b})});
  }

  NonZero with_sign(const Polynomial& rest) {
    for (const bool negative : {false, true}) {
      std::optional<SignProof> found = sign(negative ? scaled(rest, -1) : rest, true);
      if (found)
        return {scalar_term(rest, workspace_.atoms), std::nullopt, std::move(found), negative};
    }
    return as_condition(rest);
  }

  NonZero as_condition(const Polynomial& rest) {
    const Conditions one{{Condition::Kind::not_zero, primitive(rest).polynomial}};
    const std::string words = in_words(one, sequent_.conclusions, workspace_).front();
    if (std::find(conditions_.begin(), conditions_.end(), words) == conditions_.end())
      throw NotFound{"it was not shown that a divisor does not vanish"};
    const Term scalar = scalar_term(primitive(rest).polynomial, workspace_.atoms);
    sequent_.hypotheses.push_back(
        {"condition", {scalar, Relation::not_equal, number_term(0), Span{}}});
    return {difference_term(scalar, number_term(0)), sequent_.hypotheses.size() - 1, std::nullopt,
            false};
  }

  // A hypothesis is named once.
  static std::size_t place_of(NonZero item, SequentProof& result) {
    for (std::size_t k = 0; k < result.not_zero.size(); ++k)
      if (item.hypothesis && result.not_zero[k].hypothesis == item.hypothesis) return k;
    result.not_zero.push_back(std::move(item));
    return result.not_zero.size() - 1;
  }

  Sequent sequent_;
  const std::vector<std::string>& conditions_;
  Workspace& workspace_;
  Evaluator evaluator_;
  Conditions divisors_;
  EquationSearch equations_;
  SignSearch signs_;
};

// The component of that name, such as ".x" or "[1,2]".
std::size_t component_named(const Type& type, const std::string& name) {
  for (std::size_t c = 0; c < type.component_count(); ++c)
    if (component_name(type, c) == name) return c;
  return 0;
}

Refutation refutation(const ClaimResult& claim) {
  Refutation result;
  result.sequent = sequents_of(claim).front();
  result.values = claim.decision.witness.assignment;
  result.conclusion = claim.decision.statement;
  if (result.conclusion >= result.sequent.conclusions.size())
    throw NotFound{"the refutation has no witness"};
  result.component = component_named(result.sequent.conclusions[result.conclusion].left.type(),
                                     claim.decision.witness.component);
  return result;
}

std::vector<SequentProof> proofs(const ClaimResult& claim, Workspace& workspace) {
  std::set<unsigned> unknowns;
  if (const auto* derive = std::get_if<DeriveClaim>(&claim.claim.kind))
    for (const SymbolPointer& unknown : derive->goal.unknowns) unknowns.insert(unknown->ordinal);
  if (const auto* least = std::get_if<MinimumClaim>(&claim.claim.kind))
    for (const SymbolPointer& unknown : least->goal.unknowns) unknowns.insert(unknown->ordinal);
  std::vector<SequentProof> result;
  for (Sequent& sequent : sequents_of(claim)) {
    SequentSearch search{std::move(sequent), unknowns, claim.decision.conditions, workspace};
    result.push_back(search.proof());
  }
  return result;
}

std::variant<std::vector<SequentProof>, Refutation> content(const ClaimResult& claim,
                                                            Workspace& workspace) {
  switch (claim.decision.verdict) {
    case Verdict::proved:
    case Verdict::proved_if: return proofs(claim, workspace);
    case Verdict::refuted:
      if (!std::holds_alternative<DeriveClaim>(claim.claim.kind)) return refutation(claim);
      throw NotFound{"a derivation that gives other values"};
    case Verdict::underdetermined:
    case Verdict::inconsistent: throw NotFound{"a derivation without a unique solution"};
    default: throw NotFound{"there is no verdict to be certified"};
  }
}

}  // namespace

std::variant<Certificate, NotCertified> certificate(const ClaimResult& claim,
                                                    const std::string& case_name,
                                                    const Limits& limits) {
  const Span& span = claim.claim.statement;
  Certificate result{case_name + "." + claim.claim.label + claim.claim.instance,
                     span.source ? span.source->text.substr(span.begin, span.end - span.begin) : "",
                     {}};
  try {
    Budget budget{limits};
    Workspace workspace{budget};
    for (;;) {
      try {
        result.content = content(claim, workspace);
        return result;
      } catch (const FinerAngles&) {
        budget.spend(1000);
      }
    }
  } catch (const NotFound& reason) {
    return NotCertified{reason.what()};
  } catch (const std::exception& error) {
    return NotCertified{error.what()};
  }
}

}  // namespace patchproof
