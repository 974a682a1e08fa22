#include <patchproof/symbolic/evaluation.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <patchproof/symbolic/basis_functions.hpp>
#include <patchproof/symbolic/derivation.hpp>
#include <patchproof/symbolic/elements.hpp>
#include <patchproof/symbolic/exact_number.hpp>
#include <patchproof/symbolic/exponentials.hpp>
#include <patchproof/symbolic/integration.hpp>
#include <patchproof/symbolic/substitution.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;

const ex& scalar(const Components& value) {
  if (value.size() != 1) throw std::domain_error{"a scalar is wanted"};
  return value.front();
}

Components placeholders(Ring& ring, std::size_t count) {
  Components result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(placeholder(ring, static_cast<int>(i)));
  }
  return result;
}

std::vector<unsigned> ids_of(const Ring& ring, const Components& symbols) {
  std::vector<unsigned> result;
  for (const ex& symbol : symbols) result.push_back(ring.atoms().id_of(symbol));
  return result;
}

Value unknown_function(Ring& ring, const SymbolPointer& symbol) {
  const std::size_t arity = symbol->type.parameters.size();
  const Components formals = placeholders(ring, arity);
  Value result{{}, ids_of(ring, formals)};
  for (std::size_t i = 0; i < symbol->type.component_count(); ++i) {
    result.components.push_back(jet(ring, symbol, static_cast<int>(i), Indices(arity, 0), formals));
  }
  return result;
}

Components concatenated(const std::vector<Components>& parts) {
  Components result;
  for (const Components& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

}  // namespace

Components letters(Ring& ring, const SymbolPointer& symbol) {
  Components result;
  for (std::size_t i = 0; i < symbol->type.component_count(); ++i) {
    result.push_back(letter(ring, symbol, static_cast<int>(i)));
  }
  return result;
}

Evaluation::Evaluation(Ring& ring, SymbolValues known) : ring_{ring}, known_{std::move(known)} {}

const Value& Evaluation::operator()(const Term& term) {
  const auto found = values_.find(term.address());
  if (found != values_.end()) return found->second;
  ring_.spend(1);
  Value value = evaluated(term);
  return values_.emplace(term.address(), std::move(value)).first->second;
}

Value Evaluation::evaluated(const Term& term) {
  switch (term.operation()) {
    case Operation::symbol:
      return of_symbol(term);
    case Operation::lambda:
      return of_lambda(term);
    case Operation::apply:
      return of_application(term);
    case Operation::derivative:
      return of_derivative(term);
    case Operation::definition:
      return (*this)(term.child(0));
    case Operation::integral:
      return of_integral(term);
    default:
      return of_operation(term);
  }
}

Value Evaluation::of_symbol(const Term& term) {
  const SymbolPointer& symbol = term.symbol();
  if (symbol->type.is_function()) return unknown_function(ring_, symbol);
  const auto known = known_.find(symbol->ordinal);
  return {known == known_.end() ? letters(ring_, symbol) : known->second, {}};
}

Value Evaluation::of_lambda(const Term& term) {
  const Value& body = (*this)(term.child(0));
  if (!body.formals.empty()) throw std::domain_error{"a function whose values are functions"};
  Value result{body.components, {}};
  for (const SymbolPointer& formal : term.formals()) {
    if (!formal->type.is_scalar()) throw std::domain_error{"a parameter that is not a number"};
    result.formals.push_back(ring_.atoms().id_of(letter(ring_, formal, 0)));
  }
  return result;
}

Components Evaluation::at(const Value& function, const Components& arguments) {
  if (function.formals.size() != arguments.size()) {
    throw std::domain_error{"a function at too few or too many arguments"};
  }
  Replacements replacements;
  bool changed = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    replacements.atoms[function.formals[i]] = arguments[i];
    changed = changed || !arguments[i].is_equal(ring_.atoms().symbol(function.formals[i]));
  }
  if (!changed) return function.components;
  Substitution substitution{ring_, std::move(replacements)};
  Components result;
  for (const ex& component : function.components) result.push_back(substitution(component));
  return result;
}

Value Evaluation::of_application(const Term& term) {
  Components arguments;
  for (std::size_t i = 1; i < term.children().size(); ++i) {
    const Value& argument = (*this)(term.child(i));
    if (!argument.formals.empty()) throw std::domain_error{"a function of functions"};
    arguments.push_back(scalar(argument.components));
  }
  return {at((*this)(term.child(0)), arguments), {}};
}

Value Evaluation::of_derivative(const Term& term) {
  const Value& function = (*this)(term.child(0));
  if (function.formals.size() != term.indices().size()) {
    throw std::domain_error{"a derivative by too few or too many parameters"};
  }
  Value result{{}, function.formals};
  for (ex component : function.components) {
    for (std::size_t i = 0; i < function.formals.size(); ++i) {
      component = derivative(ring_, component, function.formals[i], term.indices()[i]);
    }
    result.components.push_back(component);
  }
  return result;
}

// One variable after the other; the bounds contain none of them.
Value Evaluation::of_integral(const Term& term) {
  const Value function = (*this)(term.child(0));
  Value result{function.components, {}};
  for (std::size_t i = 0; i < function.formals.size(); ++i) {
    const ex lower = scalar((*this)(term.child(2 * i + 1)).components);
    const ex upper = scalar((*this)(term.child(2 * i + 2)).components);
    for (ex& component : result.components) {
      component = integral(ring_, component, function.formals[i], lower, upper);
    }
  }
  return result;
}

// An operation on functions acts on their values: all are taken at the same placeholders.
Value Evaluation::of_operation(const Term& term) {
  std::vector<const Value*> values;
  std::size_t arity = 0;
  for (const Term& child : term.children()) {
    values.push_back(&(*this)(child));
    arity = std::max(arity, values.back()->formals.size());
  }
  const Components common = placeholders(ring_, arity);
  std::vector<Components> children;
  for (const Value* value : values) {
    children.push_back(value->formals.empty() ? value->components : at(*value, common));
  }
  return {combined(term, children), ids_of(ring_, common)};
}

Components Evaluation::combined(const Term& term, const std::vector<Components>& children) {
  switch (term.operation()) {
    case Operation::number:
      return Components(term.type().component_count(), exact(term.number()));
    case Operation::pi:
      return {pi(ring_)};
    case Operation::tuple:
    case Operation::matrix:
      return concatenated(children);
    case Operation::sum:
      return sum(ring_, children);
    case Operation::negation:
      return scaled(ring_, children.at(0), -1);
    case Operation::product:
      return product(ring_, children);
    case Operation::quotient:
      return scaled(ring_, children.at(0), inverse(ring_, scalar(children.at(1))));
    case Operation::power:
      return {whole_power(ring_, scalar(children.at(0)), term.exponent())};
    case Operation::sine:
      return {sine(ring_, scalar(children.at(0)))};
    case Operation::cosine:
      return {cosine(ring_, scalar(children.at(0)))};
    case Operation::exponential:
      return {exponential(ring_, scalar(children.at(0)))};
    case Operation::square_root:
      return {square_root(ring_, scalar(children.at(0)))};
    case Operation::component:
      return {children.at(0).at(static_cast<std::size_t>(term.indices().at(0)))};
    case Operation::entry: {
      const int row = term.indices().at(0);
      const int column = term.indices().at(1);
      return slice(children.at(0), matrix_shape(term.child(0).type()), {row, row, column, column});
    }
    case Operation::slice:
      return slice(children.at(0), matrix_shape(term.child(0).type()), term.indices());
    case Operation::transpose:
      return transpose(children.at(0), matrix_shape(term.child(0).type()));
    case Operation::matrix_product: {
      Components result = children.at(0);
      Shape shape = matrix_shape(term.child(0).type());
      for (std::size_t i = 1; i < children.size(); ++i) {
        const Shape next = matrix_shape(term.child(i).type());
        result = matrix_product(ring_, result, shape, children[i], next);
        shape = product_shape(shape, next);
      }
      return result;
    }
    case Operation::determinant:
      return {determinant(ring_, children.at(0), matrix_shape(term.child(0).type()))};
    case Operation::dot:
      return {dot(ring_, children.at(0), children.at(1))};
    case Operation::cross:
      return cross(ring_, children.at(0), children.at(1));
    case Operation::bernstein:
      return {bernstein(ring_, term.indices().at(0), term.indices().at(1), scalar(children.at(0)))};
    case Operation::bspline_basis:
      return {bspline_piece(ring_, term.basis_function(), scalar(children.at(0)))};
    case Operation::symbol:
    case Operation::lambda:
    case Operation::apply:
    case Operation::derivative:
    case Operation::integral:
    case Operation::definition:
      break;
  }
  throw std::logic_error{"an operation without an evaluation"};
}

}  // namespace patchproof::symbolic
