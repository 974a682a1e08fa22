#include <patchproof/certificate/scalars.hpp>

#include <patchproof/certificate/scalar_nodes.hpp>
#include <patchproof/certificate/spline_piece.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;
using Components = std::vector<ScalarPointer>;

}  // namespace

Scalars::Scalars(std::vector<std::pair<std::string, Term>> named) {
  for (const auto& [name, term] : named) names_.add(term, name);
}

const std::string* Scalars::name_of(const Term& term) const {
  if (const std::string* name = names_.name_of(term)) return name;
  return term.operation() == Operation::definition ? &term.name() : nullptr;
}

const Components& Scalars::of(const Term& term) {
  const auto found = values_.find(term.address());
  if (found != values_.end()) return found->second;
  Components result = compute(term);
  for (std::size_t c = 0; c < result.size(); ++c) {
    if (result[c]->size >= largest_scalar) throw NotScalar{"a term that is too large"};
    if (const std::string* name = name_of(term)) {
      Scalar node;
      node.kind = Kind::named;
      node.name = *name;
      node.index = static_cast<unsigned>(c);
      node.children = {result[c]};
      result[c] = scalar(std::move(node));
    }
  }
  seen_.push_back(term);
  return values_.emplace(term.address(), std::move(result)).first->second;
}

const std::vector<ScalarFunctionPointer>& Scalars::functions_of(const Term& term) {
  const auto found = functions_.find(term.address());
  if (found != functions_.end()) return found->second;
  std::vector<ScalarFunctionPointer> result = compute_functions(term);
  if (const std::string* name = name_of(term))
    for (std::size_t c = 0; c < result.size(); ++c) {
      ScalarFunction node;
      node.kind = ScalarFunction::Kind::named;
      node.name = *name;
      node.slot = c;
      node.inner = result[c];
      node.arity = result[c]->arity;
      result[c] = scalar_function(std::move(node));
    }
  seen_.push_back(term);
  return functions_.emplace(term.address(), std::move(result)).first->second;
}

Components Scalars::compute(const Term& term) {
  switch (term.operation()) {
    case Operation::number: return {scalar_number(term.number())};
    case Operation::pi:
    case Operation::sine:
    case Operation::cosine:
    case Operation::exponential: throw NotScalar{"pi, sines, cosines and exponentials"};
    case Operation::symbol: {
      Components result;
      for (std::size_t c = 0; c < term.type().component_count(); ++c)
        result.push_back(scalar_variable({term.symbol(), c}));
      return result;
    }
    case Operation::definition: return of(term.child(0));
    case Operation::apply: return applied(term);
    case Operation::component:
    case Operation::entry:
    case Operation::slice:
    case Operation::transpose:
    case Operation::determinant:
    case Operation::dot:
    case Operation::cross: return vector_operation(term);
    case Operation::matrix_product: return matrix_product(term);
    case Operation::bernstein:
      return {scalar_bernstein(term.indices().at(0), term.indices().at(1),
                               of(term.child(0)).front())};
    case Operation::bspline_basis:
      return {spline_piece(term.basis_function(), of(term.child(0)).front())};
    case Operation::integral: return integrals(term);
    case Operation::square_root: {
      Scalar node;
      node.kind = Kind::root;
      node.children = of(term.child(0));
      return {scalar(std::move(node))};
    }
    case Operation::lambda:
    case Operation::derivative: throw NotScalar{"a function in the place of a value"};
    default: return pointwise(term);
  }
}

Components Scalars::pointwise(const Term& term) {
  Components result;
  if (term.operation() == Operation::tuple || term.operation() == Operation::matrix) {
    for (const Term& child : term.children()) {
      const Components& entries = of(child);
      result.insert(result.end(), entries.begin(), entries.end());
    }
    return result;
  }
  const Components& first = of(term.child(0));
  switch (term.operation()) {
    case Operation::negation:
      for (const ScalarPointer& c : first) result.push_back(scalar_opposite(c));
      return result;
    case Operation::sum:
      for (std::size_t c = 0; c < first.size(); ++c) {
        Components summands;
        for (const Term& child : term.children()) summands.push_back(of(child).at(c));
        result.push_back(scalar_sum(summands));
      }
      return result;
    case Operation::quotient:
      for (const ScalarPointer& c : first)
        result.push_back(scalar_pair(Kind::quotient, c, of(term.child(1)).front()));
      return result;
    case Operation::power: {
      const long exponent = term.exponent();
      const ScalarPointer power =
          scalar_power(first.front(), static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
      return {exponent < 0 ? scalar_pair(Kind::quotient, scalar_number(1), power) : power};
    }
    case Operation::product:
      result = first;
      for (std::size_t k = 1; k < term.children().size(); ++k) {
        const Components& next = of(term.child(k));
        const Components before = std::move(result);
        result.clear();
        for (std::size_t c = 0; c < std::max(before.size(), next.size()); ++c)
          result.push_back(scalar_pair(Kind::product, before[before.size() == 1 ? 0 : c],
                                       next[next.size() == 1 ? 0 : c]));
      }
      return result;
    default: throw NotScalar{"an operation without a word"};
  }
}

Components Scalars::applied(const Term& term) {
  Components arguments;
  for (std::size_t k = 1; k < term.children().size(); ++k)
    arguments.push_back(of(term.child(k)).front());
  Components result;
  for (const ScalarFunctionPointer& function : functions_of(term.child(0))) {
    Scalar node;
    node.kind = Kind::application;
    node.function = function;
    node.children = arguments;
    result.push_back(scalar(std::move(node)));
  }
  return result;
}

// Over several variables: the last one is integrated first.
Components Scalars::integrals(const Term& term) {
  const Term& function = term.child(0);
  if (function.operation() != Operation::lambda) throw NotScalar{"the integral of a function by name"};
  Components result = of(function.child(0));
  const Formals& formals = function.formals();
  for (ScalarPointer& component : result)
    for (std::size_t k = formals.size(); k-- > 0;) {
      Scalar node;
      node.kind = Kind::integral;
      node.formal = formals[k];
      node.children = {of(term.child(1 + 2 * k)).front(), of(term.child(2 + 2 * k)).front(),
                       component};
      component = scalar(std::move(node));
    }
  return result;
}

std::vector<ScalarFunctionPointer> Scalars::compute_functions(const Term& term) {
  std::vector<ScalarFunctionPointer> result;
  const std::size_t arity = term.type().parameters.size();
  switch (term.operation()) {
    case Operation::symbol:
      for (std::size_t c = 0; c < term.type().component_count(); ++c) {
        ScalarFunction node;
        node.coordinate = {term.symbol(), c};
        node.arity = arity;
        result.push_back(scalar_function(std::move(node)));
      }
      return result;
    case Operation::lambda:
      for (const ScalarPointer& body : of(term.child(0))) {
        ScalarFunction node;
        node.kind = ScalarFunction::Kind::lambda;
        node.formals = term.formals();
        node.body = body;
        node.arity = arity;
        result.push_back(scalar_function(std::move(node)));
      }
      return result;
    case Operation::definition: return functions_of(term.child(0));
    case Operation::derivative:
      result = functions_of(term.child(0));
      for (ScalarFunctionPointer& function : result)
        for (std::size_t slot = 0; slot < arity; ++slot)
          for (int order = 0; order < term.indices().at(slot); ++order) {
            ScalarFunction node;
            node.kind = ScalarFunction::Kind::derivative;
            node.inner = function;
            node.slot = slot;
            node.arity = arity;
            function = scalar_function(std::move(node));
          }
      return result;
    default: throw NotScalar{"a function that is no function of the case"};
  }
}

}  // namespace patchproof
