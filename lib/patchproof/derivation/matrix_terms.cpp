#include <patchproof/derivation/matrix_terms.hpp>

#include <patchproof/derivation/shapes.hpp>

namespace patchproof {

Term matrix_product_of(const Term& a, const Term& b) {
  const auto size = [](int n) { return static_cast<std::size_t>(n); };
  const std::size_t rows = size(a.type().rows);
  const std::size_t middle = size(a.type().columns);
  const std::size_t columns = size(b.type().columns);
  const Type entry = a.type().inner->is_point() ? *a.type().inner : *b.type().inner;
  std::vector<Term> entries;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      std::vector<Term> parts;
      for (std::size_t k = 0; k < middle; ++k) {
        const Term& x = a.child(i * middle + k);
        const Term& y = b.child(k * columns + j);
        // Scalars stand before points.
        std::vector<Term> factors =
            x.type().is_point() ? std::vector<Term>{y, x} : std::vector<Term>{x, y};
        parts.push_back(make_term(Operation::product, entry, std::move(factors)));
      }
      entries.push_back(sum_of(std::move(parts), entry));
    }
  }
  return make_term(Operation::matrix,
                   Type::matrix(a.type().rows, b.type().columns, entry), std::move(entries));
}

Term transposed(const Term& matrix) {
  const auto rows = static_cast<std::size_t>(matrix.type().rows);
  const auto columns = static_cast<std::size_t>(matrix.type().columns);
  std::vector<Term> entries;
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = 0; i < rows; ++i) entries.push_back(matrix.child(i * columns + j));
  return make_term(Operation::matrix,
                   Type::matrix(matrix.type().columns, matrix.type().rows, *matrix.type().inner),
                   std::move(entries));
}

}  // namespace patchproof
