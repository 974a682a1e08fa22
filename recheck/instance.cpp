// An equation that holds for all values of its parameters, taken at some of them.
#include <recheck/premises.hpp>

namespace recheck {

namespace {

std::string named(const Symbol& symbol) { return "'" + symbol.name + "'"; }

}  // namespace

Fact Premises::instance(const Cofactor& of) const {
  if (of.hypothesis >= sequent_.hypotheses.size())
    throw Rejection{"there is no hypothesis " + std::to_string(of.hypothesis)};
  const Statement& hypothesis = sequent_.hypotheses[of.hypothesis];
  if (hypothesis.relation != Relation::equal)
    throw Rejection{"hypothesis " + std::to_string(of.hypothesis) + " is no equation"};
  const Value difference = difference_of(hypothesis, evaluator_);
  if (of.component >= difference.components.size())
    throw Rejection{"hypothesis " + std::to_string(of.hypothesis) + " has no component " +
                    std::to_string(of.component)};

  std::set<SymbolIndex> open;
  for (const NodeIndex side : {hypothesis.left, hypothesis.right})
    for (const SymbolIndex symbol : certificate_.free_symbols[side])
      if (field_.symbol(symbol).role == Symbol::Role::parameter) open.insert(symbol);
  Images images;
  Quotient scalar = difference.components[of.component];
  Polynomials divisors;
  for (const Cofactor::At& at : of.at) {
    open.erase(at.parameter);
    const Atom parameter = field_.coordinate(at.parameter, 0);
    const Value& value = evaluator_.value(at.value);
    divisors.insert(value.divisors.begin(), value.divisors.end());
    images.emplace(parameter, value.components.front());
    if (at.order > 0) require_differentiable(at.parameter, of);
    for (std::size_t k = 0; k < at.order; ++k) scalar = derivative(scalar, parameter, field_);
  }
  if (!open.empty())
    throw Rejection{"the parameter " + named(field_.symbol(*open.begin())) + " has no value"};
  for (const Cofactor::At& at : of.at)
    require_in_range(at, images.at(field_.coordinate(at.parameter, 0)), images);
  const Polynomials moved = substituted_divisors(difference.divisors, images, field_);
  divisors.insert(moved.begin(), moved.end());
  return {substituted(scalar, images, field_), false, divisors};
}

// Where an equation holds in a whole neighbourhood, or at least on an interval up to its end, its
// derivatives hold too: both sides are as smooth as their derivatives need.
void Premises::require_differentiable(SymbolIndex parameter, const Cofactor& of) const {
  const std::string name = named(field_.symbol(parameter));
  if (restricted_.contains(parameter))
    throw Rejection{"an equation differentiated in " + name + ", which a hypothesis restricts"};
  const auto own = bounds_.find(parameter);
  if (own != bounds_.end()) {
    const std::optional<int> length =
        sign(field_.difference(own->second.upper, own->second.lower), field_);
    if (!length)
      throw Unsupported{"a derivative in " + name + ", whose range has no numbers as ends"};
    if (*length <= 0) throw Rejection{"a derivative in " + name + ", whose range is a point"};
  }
  // The others must not lose their values when this one moves.
  const Atom atom = field_.coordinate(parameter, 0);
  for (const Cofactor::At& other : of.at) {
    const auto range = bounds_.find(other.parameter);
    if (range == bounds_.end()) continue;
    for (const Quotient& end : {range->second.lower, range->second.upper})
      if (atoms_within(end, field_).contains(atom))
        throw Unsupported{"a derivative in " + name + ", on which another range depends"};
  }
}

void Premises::require_in_range(const Cofactor::At& at, const Quotient& value,
                                const Images& images) const {
  const std::string name = named(field_.symbol(at.parameter));
  const auto zero = [&](const Quotient& a, const Quotient& b) {
    return field_.difference(a, b).numerator.empty();
  };
  const bool itself = zero(value, of_atom(field_.coordinate(at.parameter, 0)));
  if (restricted_.contains(at.parameter) && !itself)
    throw Rejection{"a hypothesis restricts " + name + ", so it has to stay as it is, and not be " +
                    field_.text(value)};
  const auto found = bounds_.find(at.parameter);
  if (found == bounds_.end()) return;
  const Bounds& own = found->second;
  const Bounds here{substituted(own.lower, images, field_), substituted(own.upper, images, field_)};
  const bool same = zero(here.lower, own.lower) && zero(here.upper, own.upper);
  if (itself && same) return;
  const Quotient above = field_.difference(value, here.lower);
  const Quotient below = field_.difference(here.upper, value);
  // There is a value in the range, the parameter itself: so its ends are in it.
  if (same && (above.numerator.empty() || below.numerator.empty())) return;
  if (same && is_other_parameter_of_range(value, here)) return;
  const Quotient mirrored = field_.difference(field_.sum(here.lower, here.upper), value);
  if (same && (zero(mirrored, of_atom(field_.coordinate(at.parameter, 0))) ||
               is_other_parameter_of_range(mirrored, here)))
    return;
  if (is_nonnegative(above, box_, field_) && is_nonnegative(below, box_, field_)) return;
  const std::string what = field_.text(value) + " is not in the range of " + name;
  if (is_negative(above, box_, field_) || is_negative(below, box_, field_)) throw Rejection{what};
  throw Unsupported{"whether " + field_.text(value) + " is in the range of " + name};
}

bool Premises::is_other_parameter_of_range(const Quotient& value, const Bounds& bounds) const {
  for (const auto& [parameter, other] : bounds_) {
    const auto zero = [&](const Quotient& a, const Quotient& b) {
      return field_.difference(a, b).numerator.empty();
    };
    if (zero(value, of_atom(field_.coordinate(parameter, 0))) && zero(other.lower, bounds.lower) &&
        zero(other.upper, bounds.upper))
      return true;
  }
  return false;
}

}  // namespace recheck
