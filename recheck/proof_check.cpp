#include <recheck/proof_check.hpp>

#include <algorithm>

#include <recheck/sign_proof.hpp>

namespace recheck {

namespace {

std::string numbered(const std::string& list, std::size_t k) {
  return list + "[" + std::to_string(k) + "]";
}

class ProofChecker {
 public:
  ProofChecker(const Proof& proof, const Certificate& certificate, Meter& meter)
      : proof_{proof},
        certificate_{certificate},
        field_{certificate.symbols, meter},
        evaluator_{certificate.nodes, field_},
        premises_{proof.sequent, certificate, evaluator_},
        divisors_{field_},
        signs_{premises_, divisors_, evaluator_} {}

  void require() {
    for (std::size_t k = 0; k <= proof_.not_zero.size(); ++k) {
      take_divisors(k);
      if (k < proof_.not_zero.size())
        at_place(numbered("not_zero", k), [&] { take(proof_.not_zero[k]); });
    }
    at_place("sequent", [&] { require_divisors_of_sequent(); });
    std::set<std::pair<std::size_t, std::size_t>> shown;
    for (std::size_t k = 0; k < proof_.components.size(); ++k) {
      const ComponentProof& component = proof_.components[k];
      at_place(numbered("components", k), [&] { require_component(component); });
      shown.emplace(component.conclusion, component.component);
    }
    for (std::size_t k = 0; k < proof_.sequent.conclusions.size(); ++k)
      at_place("sequent." + numbered("conclusions", k), [&] { require_all(k, shown); });
  }

 private:
  // One after the other, so that no scalar is shown not to be zero by dividing by itself.
  void take(const NonZero& claim) {
    const Value& scalar = evaluator_.value(claim.scalar);
    divisors_.require(scalar.divisors);
    const Quotient& value = scalar.components.front();
    if (claim.hypothesis)
      require_difference(*claim.hypothesis, value);
    else
      signs_.require(*claim.sign, field_.multiple(value, claim.negative ? -1 : 1), true);
    // Only contradictory hypotheses show that 0 is not 0: of no use as a divisor.
    if (!value.numerator.empty()) divisors_.add(field_.monic(value.numerator));
  }

  // The hints that need the first scalars alone, and the last of those.
  void take_divisors(std::size_t count) {
    for (std::size_t k = 0; k < proof_.divisors.size(); ++k) {
      const std::vector<std::size_t>& product = proof_.divisors[k].product;
      std::size_t needed = 0;
      for (const std::size_t index : product) needed = std::max(needed, index + 1);
      const bool too_many = needed > proof_.not_zero.size() && count == proof_.not_zero.size();
      if (needed == count || too_many)
        at_place(numbered("divisors", k), [&] { take(proof_.divisors[k]); });
    }
  }

  void take(const Divisor& hint) {
    Quotient whole = number(1);
    for (const std::size_t index : hint.product) {
      if (index >= proof_.not_zero.size())
        throw Rejection{"there is no scalar " + std::to_string(index) + " in not_zero"};
      const Quotient& scalar = evaluator_.value(proof_.not_zero[index].scalar).components.front();
      whole = field_.product(whole, scalar);
    }
    const Value& factor = evaluator_.value(hint.factor);
    divisors_.require(factor.divisors);
    const Quotient& value = factor.components.front();
    if (value.numerator.empty()) throw Rejection{"the factor is zero"};
    // What is below the lines is not zero, so it may be put above: what comes out is not zero, and
    // is a multiple of the divisor.
    Polynomial above = whole.numerator;
    for (const auto& [below, exponent] : value.denominator)
      for (unsigned k = 0; k < exponent; ++k)
        above = recheck::product(above, below, field_.meter());
    const std::optional<Polynomial> divisor =
        exact_quotient(above, value.numerator, field_.meter());
    if (!divisor || divisor->empty())
      throw Rejection{field_.text(value) + " does not divide the product of the scalars"};
    divisors_.add(field_.monic(*divisor));
  }

  void require_difference(std::size_t index, const Quotient& scalar) {
    if (index >= proof_.sequent.hypotheses.size())
      throw Rejection{"there is no hypothesis " + std::to_string(index)};
    const Statement& hypothesis = proof_.sequent.hypotheses[index];
    // Points that differ need not differ in every coordinate.
    if (hypothesis.relation != Relation::not_equal ||
        !certificate_.nodes[hypothesis.left].type.is_scalar())
      throw Rejection{"hypothesis " + std::to_string(index) + " does not say that scalars differ"};
    const Value difference = difference_of(hypothesis, evaluator_);
    divisors_.require(difference.divisors);
    if (!field_.difference(difference.components.front(), scalar).numerator.empty())
      throw Rejection{field_.text(scalar) + " is not the difference in hypothesis " +
                      std::to_string(index)};
  }

  void require_divisors_of_sequent() {
    const Sequent& sequent = proof_.sequent;
    for (const auto* statements : {&sequent.hypotheses, &sequent.conclusions})
      for (const Statement& statement : *statements)
        for (const NodeIndex side : {statement.left, statement.right})
          divisors_.require(evaluator_.value(side).divisors);
    for (const Range& range : sequent.ranges)
      for (const NodeIndex end : {range.lower, range.upper})
        divisors_.require(evaluator_.value(end).divisors);
  }

  void require_component(const ComponentProof& component) {
    if (component.conclusion >= proof_.sequent.conclusions.size())
      throw Rejection{"there is no conclusion " + std::to_string(component.conclusion)};
    const Statement& conclusion = proof_.sequent.conclusions[component.conclusion];
    const Value difference = difference_of(conclusion, evaluator_);
    if (component.component >= difference.components.size())
      throw Rejection{"conclusion " + std::to_string(component.conclusion) + " has no component " +
                      std::to_string(component.component)};
    const Quotient& scalar = difference.components[component.component];
    if (component.negative && conclusion.relation != Relation::not_equal)
      throw Rejection{"'negative' belongs to != only"};
    if (component.equation.has_value() != (conclusion.relation == Relation::equal))
      throw Rejection{"an equation is shown by cofactors, anything else by a sign"};
    if (component.equation) return require_equation(*component.equation, scalar);
    if (conclusion.relation == Relation::not_equal)
      return signs_.require(*component.sign, field_.multiple(scalar, component.negative ? -1 : 1),
                            true);
    const Fact order = order_fact(conclusion, evaluator_);
    signs_.require(*component.sign, order.scalar, order.strict);
  }

  void require_equation(const std::vector<Cofactor>& cofactors, const Quotient& scalar) {
    Quotient rest = scalar;
    for (std::size_t k = 0; k < cofactors.size(); ++k) {
      at_place(numbered("equation", k), [&] {
        const Fact zero = multiple_of(cofactors[k], premises_, evaluator_);
        divisors_.require(zero.divisors);
        rest = field_.difference(rest, zero.scalar);
      });
    }
    if (!rest.numerator.empty())
      throw Rejection{"left - right is not the sum: " + field_.text(rest) + " is left"};
  }

  void require_all(std::size_t conclusion,
                   const std::set<std::pair<std::size_t, std::size_t>>& shown) {
    const Statement& statement = proof_.sequent.conclusions[conclusion];
    const std::size_t count = evaluator_.value(statement.left).components.size();
    std::size_t found = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const bool here = shown.contains({conclusion, k});
      if (!here && statement.relation != Relation::not_equal)
        throw Rejection{"component " + std::to_string(k) + " is not shown"};
      if (here) ++found;
    }
    if (found == 0) throw Rejection{"no component is shown"};
  }

  const Proof& proof_;
  const Certificate& certificate_;
  Field field_;
  Evaluator evaluator_;
  Premises premises_;
  Divisors divisors_;
  SignChecker signs_;
};

}  // namespace

void require_proof(const Proof& proof, const Certificate& certificate, Meter& meter) {
  ProofChecker{proof, certificate, meter}.require();
}

}  // namespace recheck
