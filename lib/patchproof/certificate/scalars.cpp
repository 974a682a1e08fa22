#include <patchproof/certificate/scalars.hpp>

#include <patchproof/certificate/scalar_nodes.hpp>
#include <patchproof/certificate/spline_piece.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;
using Components = std::vector<ScalarPointer>;

ScalarPointer total(const Components& summands) {
  ScalarPointer result;
  for (const ScalarPointer& s : summands) {
    if (!result)
      result = s;
    else if (s->kind == Kind::opposite)
      result = scalar_pair(Kind::difference, result, s->children.front());
    else
      result = scalar_pair(Kind::sum, result, s);
  }
  return result ? result : scalar_number(0);
}

ScalarPointer signed_scalar(const ScalarPointer& scalar, bool negative) {
  return negative ? scalar_opposite(scalar) : scalar;
}

// Laplace's expansion along the first row; `columns` are those left.
ScalarPointer determinant(const Components& entries, std::size_t size, std::size_t row,
                          const std::vector<std::size_t>& columns) {
  if (row == size) return scalar_number(1);
  Components summands;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<std::size_t> rest = columns;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
    const ScalarPointer& entry = entries[row * size + columns[k]];
    const ScalarPointer product =
        rest.empty() ? entry
                     : scalar_pair(Kind::product, entry, determinant(entries, size, row + 1, rest));
    summands.push_back(signed_scalar(product, k % 2 == 1));
  }
  return total(summands);
}

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
    case Operation::integral: return {integral(term)};
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
        result.push_back(total(summands));
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

Components Scalars::vector_operation(const Term& term) {
  const Components& a = of(term.child(0));
  const Type& type = term.child(0).type();
  const auto columns = static_cast<std::size_t>(type.is_matrix() ? type.columns : 1);
  const auto rows = static_cast<std::size_t>(type.is_matrix() ? type.rows : 1);
  const std::size_t width = type.is_matrix() ? type.inner->component_count() : 1;
  Components result;
  const auto block = [&](std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) {
    for (std::size_t i = i0; i <= i1; ++i)
      for (std::size_t j = j0; j <= j1; ++j)
        for (std::size_t c = 0; c < width; ++c) result.push_back(a.at((i * columns + j) * width + c));
  };
  const auto at = [&](std::size_t k) { return static_cast<std::size_t>(term.indices().at(k)); };
  const auto product = [&](std::size_t i, const Components& b, std::size_t j) {
    return scalar_pair(Kind::product, a.at(i), b.at(j));
  };
  switch (term.operation()) {
    case Operation::component: return {a.at(at(0))};
    case Operation::entry: block(at(0), at(0), at(1), at(1)); return result;
    case Operation::slice: block(at(0), at(1), at(2), at(3)); return result;
    case Operation::transpose:
      for (std::size_t j = 0; j < columns; ++j) block(0, rows - 1, j, j);
      return result;
    case Operation::determinant: {
      if (rows > 5) throw NotScalar{"a determinant of more than five rows"};
      std::vector<std::size_t> all;
      for (std::size_t k = 0; k < rows; ++k) all.push_back(k);
      return {determinant(a, rows, 0, all)};
    }
    case Operation::dot: {
      const Components& b = of(term.child(1));
      for (std::size_t k = 0; k < a.size(); ++k) result.push_back(product(k, b, k));
      return {total(result)};
    }
    default: {  // cross
      const Components& b = of(term.child(1));
      for (std::size_t k = 0; k < 3; ++k)
        result.push_back(scalar_pair(Kind::difference, product((k + 1) % 3, b, (k + 2) % 3),
                                     product((k + 2) % 3, b, (k + 1) % 3)));
      return result;
    }
  }
}

Components Scalars::matrix_product(const Term& term) {
  Components left = of(term.child(0));
  Type type = term.child(0).type();
  for (std::size_t k = 1; k < term.children().size(); ++k) {
    const Components& right = of(term.child(k));
    const Type& next = term.child(k).type();
    const auto inner = static_cast<std::size_t>(type.columns);
    const auto columns = static_cast<std::size_t>(next.columns);
    const std::size_t width_left = type.inner->component_count();
    const std::size_t width_right = next.inner->component_count();
    Components result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(type.rows); ++i)
      for (std::size_t j = 0; j < columns; ++j)
        for (std::size_t c = 0; c < std::max(width_left, width_right); ++c) {
          Components summands;
          for (std::size_t m = 0; m < inner; ++m)
            summands.push_back(scalar_pair(
                Kind::product, left.at((i * inner + m) * width_left + (width_left == 1 ? 0 : c)),
                right.at((m * columns + j) * width_right + (width_right == 1 ? 0 : c))));
          result.push_back(total(summands));
        }
    left = std::move(result);
    const Type& entry = type.inner->is_point() ? *type.inner : *next.inner;
    type = Type::matrix(type.rows, next.columns, entry);
  }
  return left;
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
ScalarPointer Scalars::integral(const Term& term) {
  const Term& function = term.child(0);
  if (function.operation() != Operation::lambda) throw NotScalar{"the integral of a function by name"};
  ScalarPointer result = of(function.child(0)).front();
  const Formals& formals = function.formals();
  for (std::size_t k = formals.size(); k-- > 0;) {
    Scalar node;
    node.kind = Kind::integral;
    node.formal = formals[k];
    node.children = {of(term.child(1 + 2 * k)).front(), of(term.child(2 + 2 * k)).front(), result};
    result = scalar(std::move(node));
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
