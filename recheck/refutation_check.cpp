#include <recheck/refutation_check.hpp>

#include <recheck/premises.hpp>

namespace recheck {

namespace {

bool holds(Relation relation, int sign) {
  switch (relation) {
    case Relation::equal:
      return sign == 0;
    case Relation::not_equal:
      return sign != 0;
    case Relation::less:
      return sign < 0;
    case Relation::less_equal:
      return sign <= 0;
    case Relation::greater:
      return sign > 0;
    default:
      return sign >= 0;
  }
}

std::string numbered(const std::string& list, std::size_t k) {
  return list + "[" + std::to_string(k) + "]";
}

/// Functions are put into the terms, numbers and points into what the terms are worth: so formal
/// parameters stay what they are.
class RefutationChecker {
 public:
  RefutationChecker(const Refutation& refutation, const Certificate& certificate, Meter& meter)
      : refutation_{refutation},
        certificate_{certificate},
        field_{certificate.symbols, meter},
        evaluator_{certificate.nodes, field_, functions()} {
    for (const auto& [index, node] : refutation.values) {
      const Symbol& symbol = field_.symbol(index);
      if (symbol.type.is_function()) continue;
      const Value value = number_value(index, node);
      for (std::size_t k = 0; k < value.components.size(); ++k) {
        const Atom atom = field_.coordinate(index, k);
        everything_.emplace(atom, value.components[k]);
        if (symbol.role != Symbol::Role::parameter)
          not_parameters_.emplace(atom, value.components[k]);
      }
    }
  }

  void require() {
    const Sequent& sequent = refutation_.sequent;
    for (const auto* statements : {&sequent.hypotheses, &sequent.conclusions})
      for (const Statement& statement : *statements)
        for (const NodeIndex side : {statement.left, statement.right})
          require_values(
              side, statements == &sequent.hypotheses && statement.relation == Relation::equal);
    for (const Range& range : sequent.ranges)
      for (const NodeIndex end : {range.lower, range.upper}) require_values(end, false);
    for (std::size_t k = 0; k < sequent.ranges.size(); ++k)
      at_place("sequent." + numbered("ranges", k), [&] { require_range(sequent.ranges[k]); });
    find_box();
    for (std::size_t k = 0; k < sequent.hypotheses.size(); ++k)
      at_place("sequent." + numbered("hypotheses", k),
               [&] { require_hypothesis(sequent.hypotheses[k]); });
    require_false();
  }

 private:
  Assignment functions() const {
    Assignment result;
    Evaluator closed{certificate_.nodes, field_};
    for (const auto& [index, node] : refutation_.values) {
      if (!field_.symbol(index).type.is_function()) continue;
      const Value& value = closed.value(node);
      // Polynomials have all derivatives, everywhere.
      if (!value.divisors.empty())
        throw Rejection{"the value of '" + field_.symbol(index).name + "' is no polynomial"};
      result.emplace(index, value);
    }
    return result;
  }

  Value number_value(SymbolIndex index, NodeIndex node) const {
    Evaluator closed{certificate_.nodes, field_};
    const Value value = closed.value(node);
    for (const Quotient& component : value.components)
      if (!component.denominator.empty() || !sign(component, field_))
        throw Rejection{"the value of '" + field_.symbol(index).name + "' is no number"};
    return value;
  }

  void require_value(SymbolIndex symbol) const {
    if (!refutation_.values.contains(symbol))
      throw Rejection{"there is no value for '" + field_.symbol(symbol).name + "'"};
  }
  // An equation that is assumed holds for all values of its parameters: they need none.
  void require_values(NodeIndex node, bool of_assumed_equation) const {
    for (const SymbolIndex symbol : certificate_.free_symbols[node])
      if (!of_assumed_equation || field_.symbol(symbol).role != Symbol::Role::parameter)
        require_value(symbol);
  }

  /// The value after a replacement; divisors that are numbers are not zero.
  Value moved(const Value& value, const Images& images) {
    Value result;
    for (const Quotient& component : value.components)
      result.components.push_back(substituted(component, images, field_));
    for (const Polynomial& divisor : substituted_divisors(value.divisors, images, field_))
      if (!sign(as_quotient(divisor), field_)) result.divisors.insert(divisor);
    return result;
  }
  Quotient number_at(NodeIndex node) {
    return moved(evaluator_.value(node), everything_).components.front();
  }

  int sign_of(const Quotient& number) {
    const std::optional<int> found = sign(number, field_);
    if (!found) throw Rejection{field_.text(number) + " is no number"};
    return *found;
  }

  void require_range(const Range& range) {
    const auto found = everything_.find(field_.coordinate(range.parameter, 0));
    if (found == everything_.end()) {
      if (sign_of(field_.difference(number_at(range.upper), number_at(range.lower))) < 0)
        throw Rejection{"the range of '" + field_.symbol(range.parameter).name + "' is empty"};
      return;
    }
    const Quotient& value = found->second;
    if (sign_of(field_.difference(value, number_at(range.lower))) < 0 ||
        sign_of(field_.difference(number_at(range.upper), value)) < 0)
      throw Rejection{"'" + field_.symbol(range.parameter).name + "' = " + field_.text(value) +
                      " is not in its range"};
  }

  // Ranges between numbers, with values for everything but parameters.
  void find_box() {
    constexpr unsigned digits = 64;
    for (const Range& range : refutation_.sequent.ranges) {
      const auto end = [&](NodeIndex node) {
        const Value value = moved(evaluator_.value(node), not_parameters_);
        return enclosure(value.components.front(), {}, digits, field_);
      };
      const auto lower = end(range.lower);
      const auto upper = end(range.upper);
      if (lower && upper)
        box_.emplace(field_.coordinate(range.parameter, 0), Interval{lower->lower, upper->upper});
    }
  }

  void require_hypothesis(const Statement& hypothesis) {
    const Value difference = difference_of(hypothesis, evaluator_);
    if (hypothesis.relation != Relation::equal) {
      require_true(hypothesis, moved(difference, everything_));
      if (is_about_functions_of_parameters(hypothesis))
        require_everywhere(hypothesis, moved(difference, not_parameters_));
      return;
    }
    // For all values of the parameters, even outside of their ranges: enough for polynomials.
    const Value everywhere = moved(difference, not_parameters_);
    for (const Quotient& component : everywhere.components)
      if (!component.numerator.empty())
        throw Rejection{"the equation does not hold: left - right is " + field_.text(component)};
    for (const Polynomial& divisor : everywhere.divisors)
      if (!is_nonzero(as_quotient(divisor), box_, field_))
        throw Unsupported{"whether the divisor " + field_.text(divisor) + " has a zero"};
  }

  void require_true(const Statement& statement, const Value& difference) {
    if (!is_true(statement.relation, difference))
      throw Rejection{"the hypothesis does not hold: left - right is " +
                      field_.text(difference.components.front())};
  }

  // All components together; only != is true when one of them is.
  bool is_true(Relation relation, const Value& difference) {
    bool all = true;
    bool any = false;
    for (const Quotient& component : difference.components) {
      const bool good = holds(relation, sign_of(component));
      all = all && good;
      any = any || good;
    }
    return relation == Relation::not_equal ? any : all;
  }

  bool is_about_functions_of_parameters(const Statement& statement) const {
    bool functions = false;
    bool parameters = false;
    for (const NodeIndex side : {statement.left, statement.right}) {
      for (const SymbolIndex symbol : certificate_.free_symbols[side]) {
        functions = functions || field_.symbol(symbol).role == Symbol::Role::function;
        parameters = parameters || field_.symbol(symbol).role == Symbol::Role::parameter;
      }
    }
    return functions && parameters;
  }

  // Whether `0 < f(u)` is about one u or about the function may be read in two ways: the values
  // have to do for both.
  void require_everywhere(const Statement& statement, const Value& difference) {
    for (const Polynomial& divisor : difference.divisors)
      if (!is_nonzero(as_quotient(divisor), box_, field_))
        throw Unsupported{"whether the divisor " + field_.text(divisor) + " has a zero"};
    for (const Quotient& component : difference.components) {
      const bool nonzero = is_nonzero(component, box_, field_);
      const bool good = statement.relation == Relation::not_equal
                            ? nonzero
                            : has_sign(statement.relation, component, nonzero);
      if (!good) throw Unsupported{"whether the hypothesis holds for all parameters"};
    }
  }

  bool has_sign(Relation relation, const Quotient& component, bool nonzero) {
    const bool less = relation == Relation::less || relation == Relation::less_equal;
    const bool strict = relation == Relation::less || relation == Relation::greater;
    return is_nonnegative(field_.multiple(component, less ? -1 : 1), box_, field_) &&
           (nonzero || !strict);
  }

  void require_false() {
    const Sequent& sequent = refutation_.sequent;
    if (refutation_.conclusion >= sequent.conclusions.size())
      throw Rejection{"there is no conclusion " + std::to_string(refutation_.conclusion)};
    const Statement& conclusion = sequent.conclusions[refutation_.conclusion];
    at_place("sequent." + numbered("conclusions", refutation_.conclusion), [&] {
      const Value difference = moved(difference_of(conclusion, evaluator_), everything_);
      if (refutation_.component >= difference.components.size())
        throw Rejection{"there is no component " + std::to_string(refutation_.component)};
      const Quotient& chosen = difference.components[refutation_.component];
      const bool good = conclusion.relation == Relation::not_equal
                            ? is_true(conclusion.relation, difference)
                            : holds(conclusion.relation, sign_of(chosen));
      if (good)
        throw Rejection{"the statement is true at the values: left - right is " +
                        field_.text(chosen)};
    });
  }

  const Refutation& refutation_;
  const Certificate& certificate_;
  mutable Field field_;
  Evaluator evaluator_;
  Images everything_;
  Images not_parameters_;
  Box box_;
};

}  // namespace

void require_refutation(const Refutation& refutation, const Certificate& certificate,
                        Meter& meter) {
  RefutationChecker{refutation, certificate, meter}.require();
}

}  // namespace recheck
