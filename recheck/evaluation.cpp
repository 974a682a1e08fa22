#include <algorithm>

#include <recheck/evaluation.hpp>

#include <recheck/basis.hpp>
#include <recheck/calculus.hpp>
#include <recheck/matrices.hpp>

namespace recheck {

namespace {

// The arguments of a definition say where it comes from; its value is that of its expansion.
std::size_t children_that_count(const Node& node) {
  return node.operation == Operation::definition ? 1 : node.children.size();
}

// How many terms the value has, roughly.
std::size_t size(const Value& value) {
  std::size_t result = 0;
  for (const Quotient& component : value.components) {
    result += 1 + component.numerator.size();
    for (const auto& [factor, exponent] : component.denominator) result += factor.size();
  }
  for (const Polynomial& divisor : value.divisors) result += divisor.size();
  return result;
}

}  // namespace

const Value& Evaluator::value(NodeIndex wanted) {
  if (values_[wanted]) return *values_[wanted];
  field_.meter().spend(1 + wanted / 8);
  // Children come before their parents: backwards it shows what is needed, forwards it is made.
  std::vector<bool> needed(wanted + 1, false);
  needed[wanted] = true;
  for (NodeIndex k = wanted + 1; k-- > 0;) {
    if (!needed[k] || values_[k]) continue;
    for (std::size_t c = 0; c < children_that_count(nodes_[k]); ++c)
      needed[nodes_[k].children[c]] = true;
  }
  for (NodeIndex k = 0; k <= wanted; ++k) {
    if (!needed[k] || values_[k]) continue;
    field_.meter().keep(nodes_[k].type.component_count());
    values_[k] = compute(nodes_[k]);
    field_.meter().keep(size(*values_[k]));
  }
  return *values_[wanted];
}

Value Evaluator::compute(const Node& node) const {
  field_.meter().spend(1 + node.children.size());
  Value result;
  for (std::size_t c = 0; c < children_that_count(node); ++c) {
    const Polynomials& divisors = child(node, c).divisors;
    result.divisors.insert(divisors.begin(), divisors.end());
  }
  switch (node.operation) {
    case Operation::number:
      result.components = {number(node.number)};
      return result;
    case Operation::symbol:
      return of_symbol(node.symbol);
    case Operation::lambda:
      result.components = child(node, 0).components;
      for (const SymbolIndex formal : node.formals)
        result.formals.push_back(field_.coordinate(formal, 0));
      return result;
    case Operation::definition:
      return child(node, 0);
    case Operation::apply:
      return of_apply(node);
    case Operation::derivative:
      return of_derivative(node);
    case Operation::integral:
      return of_integral(node);
    case Operation::quotient:
      return of_quotient(node);
    case Operation::power:
      return of_power(node);
    case Operation::product:
      return of_product(node);
    case Operation::bernstein:
      return of_polynomial(node, bernstein(node.indices[0], node.indices[1]));
    case Operation::bspline_basis:
      return of_polynomial(
          node, bspline_basis(node.indices[0], node.indices[1], node.indices[2], node.knots));
    case Operation::square_root: {
      const std::optional<Rational> radicand = number_in(child(node, 0).components.front());
      if (!radicand) throw Unsupported{"the square root of what is no number"};
      result.components = {field_.square_root(*radicand)};
      return result;
    }
    case Operation::pi:
      throw Unsupported{"pi"};
    case Operation::sine:
      throw Unsupported{"a sine"};
    case Operation::cosine:
      throw Unsupported{"a cosine"};
    case Operation::exponential:
      throw Unsupported{"an exponential"};
    default:
      break;
  }
  result.components = of_vectors(node);
  return result;
}

Value Evaluator::of_symbol(SymbolIndex index) const {
  const auto assigned = assignment_.find(index);
  if (assigned != assignment_.end()) return assigned->second;
  const Symbol& symbol = field_.symbol(index);
  Value result;
  std::vector<Quotient> arguments;
  for (std::size_t k = 0; k < symbol.type.arguments; ++k) {
    result.formals.push_back(field_.slot(index, k));
    arguments.push_back(of_atom(result.formals.back()));
  }
  const std::vector<std::size_t> orders(symbol.type.arguments, 0);
  for (std::size_t k = 0; k < symbol.type.component_count(); ++k)
    result.components.push_back(of_atom(symbol.type.is_function()
                                            ? field_.jet(index, k, orders, arguments)
                                            : field_.coordinate(index, k)));
  return result;
}

Value Evaluator::of_apply(const Node& node) const {
  const Value& function = child(node, 0);
  Value result;
  Images images;
  for (std::size_t k = 0; k < function.formals.size(); ++k) {
    const Value& argument = child(node, k + 1);
    result.divisors.insert(argument.divisors.begin(), argument.divisors.end());
    images.emplace(function.formals[k], argument.components.front());
  }
  for (const Quotient& component : function.components)
    result.components.push_back(substituted(component, images, field_));
  const Polynomials moved = substituted_divisors(function.divisors, images, field_);
  result.divisors.insert(moved.begin(), moved.end());
  return result;
}

Value Evaluator::of_derivative(const Node& node) const {
  Value result = child(node, 0);
  for (std::size_t k = 0; k < result.formals.size(); ++k)
    for (std::size_t order = 0; order < node.indices[k]; ++order)
      for (Quotient& component : result.components)
        component = derivative(component, result.formals[k], field_);
  return result;
}

Value Evaluator::of_integral(const Node& node) const {
  const Value& function = child(node, 0);
  Value result{function.components, {}, {}};
  const auto depends = [&](const Quotient& a) {
    const std::set<Atom> atoms = atoms_within(a, field_);
    return std::any_of(function.formals.begin(), function.formals.end(),
                       [&](Atom formal) { return atoms.contains(formal); });
  };
  for (const Polynomial& divisor : function.divisors)
    if (depends(as_quotient(divisor)))
      throw Unsupported{"an integral with a divisor that depends on its variable"};
  for (std::size_t c = 0; c < node.children.size(); ++c) {
    const Polynomials& divisors = child(node, c).divisors;
    result.divisors.insert(divisors.begin(), divisors.end());
  }
  // One variable after the other, which would catch a variable in the bounds of another one.
  for (std::size_t c = 1; c < node.children.size() && function.formals.size() > 1; ++c)
    if (depends(child(node, c).components.front()))
      throw Unsupported{"an integral whose bounds depend on its variables"};
  for (std::size_t k = 0; k < function.formals.size(); ++k)
    for (Quotient& component : result.components)
      component =
          integral(component, function.formals[k], child(node, 2 * k + 1).components.front(),
                   child(node, 2 * k + 2).components.front(), field_);
  return result;
}

Value Evaluator::of_quotient(const Node& node) const {
  Value result = child(node, 0);
  const Value& below = child(node, 1);
  const Quotient& divisor = below.components.front();
  const Quotient inverse = field_.inverse(divisor);
  result.divisors.insert(below.divisors.begin(), below.divisors.end());
  if (!number_in(divisor.numerator)) result.divisors.insert(field_.monic(divisor.numerator));
  for (Quotient& component : result.components) component = field_.product(component, inverse);
  return result;
}

Value Evaluator::of_power(const Node& node) const {
  Value result = child(node, 0);
  const Quotient base = result.components.front();
  if (node.exponent >= 0) {
    result.components = {field_.power(base, static_cast<std::size_t>(node.exponent))};
    return result;
  }
  const Quotient inverse = field_.inverse(base);
  if (!number_in(base.numerator)) result.divisors.insert(field_.monic(base.numerator));
  result.components = {field_.power(inverse, static_cast<std::size_t>(-node.exponent))};
  return result;
}

Value Evaluator::of_product(const Node& node) const {
  Value result{{number(1)}, {}, {}};
  for (std::size_t c = 0; c < node.children.size(); ++c) {
    const Value& factor = child(node, c);
    result.divisors.insert(factor.divisors.begin(), factor.divisors.end());
    // One factor at most is no scalar; it may have one component all the same.
    const std::vector<Quotient> left = result.components;
    result.components.clear();
    const std::vector<Quotient>& right = factor.components;
    for (std::size_t k = 0; k < std::max(left.size(), right.size()); ++k)
      result.components.push_back(
          field_.product(left[left.size() == 1 ? 0 : k], right[right.size() == 1 ? 0 : k]));
  }
  return result;
}

// By Horner's rule.
Value Evaluator::of_polynomial(const Node& node, const std::vector<Rational>& coefficients) const {
  const Value& argument = child(node, 0);
  Quotient result;
  for (std::size_t k = coefficients.size(); k-- > 0;)
    result =
        field_.sum(field_.product(result, argument.components.front()), number(coefficients[k]));
  return {{result}, argument.divisors, {}};
}

}  // namespace recheck
