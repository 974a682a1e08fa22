#include <patchproof/certificate/scalar_nodes.hpp>
#include <patchproof/certificate/scalars.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;
using Components = std::vector<ScalarPointer>;

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
  return scalar_sum(summands);
}

}  // namespace

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
      return {scalar_sum(result)};
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
          result.push_back(scalar_sum(summands));
        }
    left = std::move(result);
    const Type& entry = type.inner->is_point() ? *type.inner : *next.inner;
    type = Type::matrix(type.rows, next.columns, entry);
  }
  return left;
}

}  // namespace patchproof
