#include <recheck/premises.hpp>

namespace recheck {

Value difference_of(const Statement& statement, Evaluator& evaluator) {
  Field& field = evaluator.field();
  Value result = evaluator.value(statement.left);
  const Value& right = evaluator.value(statement.right);
  result.divisors.insert(right.divisors.begin(), right.divisors.end());
  for (std::size_t k = 0; k < result.components.size(); ++k)
    result.components[k] = field.difference(result.components[k], right.components.at(k));
  return result;
}

Fact order_fact(const Statement& statement, Evaluator& evaluator) {
  const Value difference = difference_of(statement, evaluator);
  const bool left_is_smaller =
      statement.relation == Relation::less || statement.relation == Relation::less_equal;
  const bool strict =
      statement.relation == Relation::less || statement.relation == Relation::greater;
  const Quotient scalar =
      evaluator.field().multiple(difference.components.front(), left_is_smaller ? -1 : 1);
  return {scalar, strict, difference.divisors};
}

Box box_of(const std::vector<Range>& ranges, Evaluator& evaluator) {
  constexpr unsigned digits = 64;
  Field& field = evaluator.field();
  Box box;
  // The ends of a range may contain parameters whose ranges come later.
  for (std::size_t pass = 0; pass < ranges.size(); ++pass) {
    const std::size_t known = box.size();
    for (const Range& range : ranges) {
      const Atom parameter = field.coordinate(range.parameter, 0);
      if (box.contains(parameter)) continue;
      const auto lower =
          enclosure(evaluator.value(range.lower).components.front(), box, digits, field);
      const auto upper =
          enclosure(evaluator.value(range.upper).components.front(), box, digits, field);
      if (lower && upper && lower->lower <= upper->upper)
        box.emplace(parameter, Interval{lower->lower, upper->upper});
    }
    if (box.size() == known) break;
  }
  return box;
}

Premises::Premises(const Sequent& sequent, const Certificate& certificate, Evaluator& evaluator)
    : sequent_{sequent},
      certificate_{certificate},
      evaluator_{evaluator},
      field_{evaluator.field()},
      box_{box_of(sequent.ranges, evaluator)} {
  for (const Range& range : sequent.ranges) {
    const Quotient parameter = of_atom(field_.coordinate(range.parameter, 0));
    const Value& lower = evaluator.value(range.lower);
    const Value& upper = evaluator.value(range.upper);
    const Bounds bounds{lower.components.front(), upper.components.front()};
    facts_.push_back({field_.difference(parameter, bounds.lower), false, lower.divisors});
    facts_.push_back({field_.difference(bounds.upper, parameter), false, upper.divisors});
    bounds_.emplace(range.parameter, bounds);
  }
  for (const Statement& hypothesis : sequent.hypotheses) {
    if (hypothesis.relation == Relation::equal) continue;
    if (hypothesis.relation != Relation::not_equal)
      facts_.push_back(order_fact(hypothesis, evaluator));
    for (const NodeIndex side : {hypothesis.left, hypothesis.right})
      for (const SymbolIndex symbol : certificate.free_symbols[side])
        if (certificate.symbols[symbol].role == Symbol::Role::parameter) restricted_.insert(symbol);
  }
}

}  // namespace recheck
