#include <patchproof/kernel/matrix.hpp>

#include <cstdint>
#include <map>

namespace patchproof {

Components block(const Components& matrix, const Type& type, int first_row, int last_row,
                 int first_column, int last_column) {
  const std::size_t width = type.inner->component_count();
  Components result;
  for (int i = first_row; i <= last_row; ++i)
    for (int j = first_column; j <= last_column; ++j)
      for (std::size_t k = 0; k < width; ++k)
        result.push_back(matrix.at(static_cast<std::size_t>(i * type.columns + j) * width + k));
  return result;
}

Components transposed(const Components& matrix, const Type& type) {
  Components result;
  for (int j = 0; j < type.columns; ++j) {
    const Components column = block(matrix, type, 0, type.rows - 1, j, j);
    result.insert(result.end(), column.begin(), column.end());
  }
  return result;
}

Components matrix_product(const Components& a, const Type& a_type, const Components& b,
                          const Type& b_type, Budget& budget) {
  const std::size_t a_width = a_type.inner->component_count();
  const std::size_t b_width = b_type.inner->component_count();
  const std::size_t width = std::max(a_width, b_width);
  Components result;
  for (int i = 0; i < a_type.rows; ++i) {
    for (int j = 0; j < b_type.columns; ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        Fraction total;
        for (int l = 0; l < a_type.columns; ++l) {
          const auto left = static_cast<std::size_t>(i * a_type.columns + l) * a_width;
          const auto right = static_cast<std::size_t>(l * b_type.columns + j) * b_width;
          total = sum(total,
                      product(a.at(left + (a_width > 1 ? k : 0)),
                              b.at(right + (b_width > 1 ? k : 0)), budget),
                      budget);
        }
        result.push_back(std::move(total));
      }
    }
  }
  return result;
}

namespace {

class Minors {
 public:
  Minors(const Components& matrix, int size, Budget& budget)
      : matrix_{matrix}, size_{size}, budget_{budget} {}

  // The determinant of rows row.. and the columns in the set.
  Fraction of(int row, std::uint32_t columns) {
    if (row == size_) return Rational{1};
    const auto known = known_.find(columns);
    if (known != known_.end()) return known->second;
    Fraction total;
    int sign = 1;
    for (int column = 0; column < size_; ++column) {
      if ((columns >> column & 1U) == 0) continue;
      const Fraction& entry = matrix_.at(static_cast<std::size_t>(row * size_ + column));
      if (!entry.is_zero()) {
        const Fraction part = product(entry, of(row + 1, columns & ~(1U << column)), budget_);
        total = sum(total, product(part, Rational{sign}, budget_), budget_);
      }
      sign = -sign;
    }
    budget_.require_terms(known_.size());
    return known_.emplace(columns, std::move(total)).first->second;
  }

 private:
  const Components& matrix_;
  int size_;
  Budget& budget_;
  std::map<std::uint32_t, Fraction> known_;
};

}  // namespace

Fraction determinant(const Components& matrix, int size, Budget& budget) {
  if (size > 30) throw OverBudget{"a determinant of more than 30 rows"};
  return Minors{matrix, size, budget}.of(0, (std::uint32_t{1} << size) - 1);
}

Fraction dot(const Components& a, const Components& b, Budget& budget) {
  Fraction total;
  for (std::size_t k = 0; k < a.size(); ++k)
    total = sum(total, product(a[k], b.at(k), budget), budget);
  return total;
}

Components cross(const Components& a, const Components& b, Budget& budget) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return difference(product(a.at(i), b.at(j), budget), product(a.at(j), b.at(i), budget), budget);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

}  // namespace patchproof
