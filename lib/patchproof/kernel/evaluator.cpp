#include <patchproof/kernel/evaluator.hpp>

#include <patchproof/kernel/basis.hpp>
#include <patchproof/kernel/elementary.hpp>
#include <patchproof/kernel/matrix.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

Evaluator::Evaluator(Workspace& workspace, const std::vector<KnownValue>& known)
    : workspace_{workspace} {
  for (const KnownValue& k : known) known_.emplace(k.symbol->ordinal, k.value);
}

const Value& Evaluator::value(const Term& term) {
  const auto found = values_.find(term.address());
  if (found != values_.end()) return found->second;
  Value result;
  try {
    result = compute(term);
    for (Fraction& component : result.components) component = normal_form(component, workspace_);
  } catch (const NoValue&) {
    throw;
  } catch (const std::domain_error& error) {
    throw NoValue{error.what(), term.span()};
  }
  seen_.push_back(term);
  return values_.emplace(term.address(), std::move(result)).first->second;
}

Value Evaluator::compute(const Term& term) {
  workspace_.budget.spend(1);
  switch (term.operation()) {
    case Operation::number: return {{Fraction{term.number()}}, {}};
    case Operation::pi:
      return {{Polynomial::variable(
                  workspace_.atoms.variable({Atom::Kind::pi, nullptr, 0, {}, {}}))},
              {}};
    case Operation::symbol: return of_symbol(term);
    case Operation::sine:
    case Operation::cosine:
    case Operation::exponential:
    case Operation::square_root: return of_elementary(term);
    case Operation::lambda:
    case Operation::definition: return value(term.child(0));
    case Operation::apply: return of_apply(term);
    case Operation::derivative: return of_derivative(term);
    case Operation::component:
    case Operation::entry:
    case Operation::slice:
    case Operation::transpose:
    case Operation::determinant:
    case Operation::dot:
    case Operation::cross: return of_vector_operation(term);
    case Operation::matrix_product: return of_matrix_product(term);
    case Operation::bernstein:
    case Operation::bspline_basis: return of_basis(term);
    case Operation::integral: return of_integral(term);
    default: return pointwise(term);
  }
}

Value Evaluator::of_symbol(const Term& term) {
  const SymbolPointer& symbol = term.symbol();
  const auto known = known_.find(symbol->ordinal);
  if (known != known_.end()) {
    if (!resolving_.insert(symbol->ordinal).second)
      throw OutsideTheory{"the derivations used define '" + symbol->name + "' by itself"};
    Value result = value(known->second);
    resolving_.erase(symbol->ordinal);
    return result;
  }
  Value result;
  const auto count = static_cast<int>(symbol->type.component_count());
  if (symbol->role != Symbol::Role::function) {
    for (int k = 0; k < count; ++k)
      result.components.push_back(Polynomial::variable(workspace_.atoms.symbol(symbol, k)));
    return result;
  }
  std::vector<Fraction> slots;
  for (const Variable variable : formals(term)) slots.push_back(Polynomial::variable(variable));
  for (int k = 0; k < count; ++k) {
    Atom jet{Atom::Kind::jet, symbol, k, std::vector<int>(slots.size(), 0), slots};
    result.components.push_back(Polynomial::variable(workspace_.atoms.variable(jet)));
  }
  return result;
}

std::vector<Variable> Evaluator::formals(const Term& function) {
  std::vector<Variable> result;
  switch (function.operation()) {
    case Operation::lambda:
      for (const SymbolPointer& formal : function.formals())
        result.push_back(workspace_.atoms.symbol(formal));
      return result;
    case Operation::symbol: {
      const auto known = known_.find(function.symbol()->ordinal);
      if (known != known_.end()) return formals(known->second);
      const auto count = static_cast<int>(function.type().parameters.size());
      for (int k = 0; k < count; ++k)
        result.push_back(workspace_.atoms.slot(function.symbol(), k));
      return result;
    }
    default: return formals(function.child(0));  // derivative, definition
  }
}

Value Evaluator::of_elementary(const Term& term) {
  const Value& inner = value(term.child(0));
  const Fraction& argument = inner.components.front();
  Value result{{}, inner.conditions};
  switch (term.operation()) {
    case Operation::sine: result.components = {sine(argument, workspace_)}; break;
    case Operation::cosine: result.components = {cosine(argument, workspace_)}; break;
    case Operation::exponential: result.components = {exponential(argument, workspace_)}; break;
    default: result.components = {square_root(argument, result.conditions, workspace_)}; break;
  }
  return result;
}

namespace {

// Conditions after a substitution; throws when one of them has become impossible.
void add_conditions(const Conditions& conditions, Substitution& substitution, Workspace& workspace,
                    Conditions& result) {
  for (const Condition& condition : conditions) {
    const Fraction moved = substitution(condition.polynomial);
    for (const auto& [factor, exponent] : moved.denominator())
      result.insert({Condition::Kind::not_zero, factor});
    const Polynomial polynomial = normal_form(moved.numerator(), workspace);
    if (condition.kind == Condition::Kind::not_zero) {
      if (polynomial.is_zero()) throw std::domain_error{"division by zero"};
      if (!polynomial.is_constant()) result.insert({condition.kind, primitive(polynomial).polynomial});
    } else if (moved.is_polynomial()) {
      if (polynomial.is_constant() && polynomial.constant() < 0)
        throw std::domain_error{"the square root of a negative number"};
      if (!polynomial.is_constant()) result.insert({condition.kind, polynomial});
    } else {
      throw OutsideTheory{"the sign of a quotient under a square root"};
    }
  }
}

}  // namespace

Value Evaluator::of_apply(const Term& term) {
  const Term& function = term.child(0);
  const Value generic = value(function);
  const std::vector<Variable> parameters = formals(function);
  Value result;
  std::map<Variable, Fraction> images;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Value& argument = value(term.child(k + 1));
    result.conditions.insert(argument.conditions.begin(), argument.conditions.end());
    images.emplace(parameters[k], argument.components.front());
  }
  Substitution substitution{std::move(images), workspace_};
  for (const Fraction& component : generic.components)
    result.components.push_back(substitution(component));
  add_conditions(generic.conditions, substitution, workspace_, result.conditions);
  result.conditions.insert(substitution.conditions().begin(), substitution.conditions().end());
  return result;
}

Value Evaluator::of_derivative(const Term& term) {
  Value result = value(term.child(0));
  const std::vector<Variable> parameters = formals(term.child(0));
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (int order = 0; order < term.indices().at(k); ++order)
      for (Fraction& component : result.components)
        component = derivative(component, parameters[k], result.conditions, workspace_);
  return result;
}

Value Evaluator::of_vector_operation(const Term& term) {
  Value result;
  std::vector<const std::vector<Fraction>*> operands;
  for (const Term& child : term.children()) {
    const Value& inner = value(child);
    result.conditions.insert(inner.conditions.begin(), inner.conditions.end());
    operands.push_back(&inner.components);
  }
  const Type& type = term.child(0).type();
  Budget& budget = workspace_.budget;
  switch (term.operation()) {
    case Operation::component:
      result.components = {operands[0]->at(static_cast<std::size_t>(term.indices().at(0)))};
      break;
    case Operation::entry: {
      const Indices& at = term.indices();
      result.components = block(*operands[0], type, at.at(0), at.at(0), at.at(1), at.at(1));
      break;
    }
    case Operation::slice: {
      const Indices& at = term.indices();
      result.components = block(*operands[0], type, at.at(0), at.at(1), at.at(2), at.at(3));
      break;
    }
    case Operation::transpose: result.components = transposed(*operands[0], type); break;
    case Operation::determinant:
      result.components = {determinant(*operands[0], type.rows, budget)};
      break;
    case Operation::dot: result.components = {dot(*operands[0], *operands[1], budget)}; break;
    default: result.components = cross(*operands[0], *operands[1], budget); break;
  }
  return result;
}

Value Evaluator::of_matrix_product(const Term& term) {
  Value result = value(term.child(0));
  Type type = term.child(0).type();
  for (std::size_t k = 1; k < term.children().size(); ++k) {
    const Value& next = value(term.child(k));
    const Type& next_type = term.child(k).type();
    result.components =
        matrix_product(result.components, type, next.components, next_type, workspace_.budget);
    const Type& entry = type.inner->is_point() ? *type.inner : *next_type.inner;
    type = Type::matrix(type.rows, next_type.columns, entry);
    result.conditions.insert(next.conditions.begin(), next.conditions.end());
  }
  return result;
}

Value Evaluator::of_basis(const Term& term) {
  const Value& inner = value(term.child(0));
  const std::vector<Rational> coefficients =
      term.operation() == Operation::bernstein
          ? bernstein_coefficients(term.indices().at(0), term.indices().at(1))
          : basis_coefficients(term.basis_function());
  Fraction result;
  for (std::size_t k = coefficients.size(); k-- > 0;)
    result = sum(product(result, inner.components.front(), workspace_.budget),
                 Fraction{coefficients[k]}, workspace_.budget);
  return {{result}, inner.conditions};
}

Value Evaluator::pointwise(const Term& term) {
  Budget& budget = workspace_.budget;
  Value result;
  bool first = true;
  for (const Term& child : term.children()) {
    const Value& next = value(child);
    result.conditions.insert(next.conditions.begin(), next.conditions.end());
    const std::vector<Fraction>& values = next.components;
    if (term.operation() == Operation::tuple || term.operation() == Operation::matrix) {
      result.components.insert(result.components.end(), values.begin(), values.end());
    } else if (first) {
      result.components = values;
    } else if (term.operation() == Operation::sum) {
      for (std::size_t k = 0; k < values.size(); ++k)
        result.components[k] = sum(result.components[k], values[k], budget);
    } else if (term.operation() == Operation::quotient) {
      const Fraction& divisor = values.front();
      if (divisor.is_zero()) throw NoValue{"division by zero", child.span()};
      if (!divisor.numerator().is_constant())
        result.conditions.insert(
            {Condition::Kind::not_zero, primitive(divisor.numerator()).polynomial});
      for (Fraction& component : result.components)
        component = quotient(component, divisor, budget);
    } else {  // product: scalars, and at most one factor that is not
      const std::vector<Fraction> left = std::move(result.components);
      const bool scalar_left = left.size() == 1;
      result.components.clear();
      for (std::size_t k = 0; k < std::max(left.size(), values.size()); ++k)
        result.components.push_back(normal_form(
            product(left[scalar_left ? 0 : k], values[values.size() == 1 ? 0 : k], budget),
            workspace_));
    }
    first = false;
  }
  if (term.operation() == Operation::negation)
    for (Fraction& component : result.components)
      component = product(component, Rational{-1}, budget);
  if (term.operation() == Operation::power) {
    const Fraction base = result.components.front();
    const long exponent = term.exponent();
    if (exponent < 0 && !base.numerator().is_constant())
      result.conditions.insert({Condition::Kind::not_zero, primitive(base.numerator()).polynomial});
    result.components = {power(base, exponent, budget)};
  }
  return result;
}

}  // namespace patchproof
