#include <patchproof/symbolic/components.hpp>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;

constexpr std::size_t most_rows = 12;

void require(bool condition, const char* message) {
  if (!condition) throw std::domain_error{message};
}

// Expands along the last row; minors are shared by their set of columns.
ex determinant_by_minors(Ring& ring, const Components& matrix, std::size_t size) {
  if (size > most_rows) throw OverBudget{"a determinant of more than a dozen rows"};
  std::vector<ex> minors(std::size_t{1} << size, 0);
  minors[0] = 1;
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    const auto rows = static_cast<std::size_t>(std::popcount(columns));
    GiNaC::exvector parts;
    std::size_t position = 0;
    for (std::size_t j = 0; j < size; ++j) {
      const std::size_t bit = std::size_t{1} << j;
      if ((columns & bit) == 0) continue;
      ++position;
      const ex part = ring.product(matrix[(rows - 1) * size + j], minors[columns ^ bit]);
      parts.push_back((rows + position) % 2 == 0 ? part : -part);
    }
    minors[columns] = ring.sum(parts);
  }
  return minors.back();
}

}  // namespace

Shape matrix_shape(const Type& type) {
  if (type.is_function() && type.inner) return matrix_shape(*type.inner);
  require(type.is_matrix(), "a matrix is wanted");
  return {static_cast<std::size_t>(type.rows), static_cast<std::size_t>(type.columns),
          type.inner ? type.inner->component_count() : 1};
}

Components sum(Ring& ring, const std::vector<Components>& summands) {
  Components result;
  for (std::size_t i = 0; i < summands.at(0).size(); ++i) {
    GiNaC::exvector parts;
    for (const Components& part : summands) {
      require(part.size() == summands.front().size(), "a sum of values of different shapes");
      parts.push_back(part[i]);
    }
    result.push_back(ring.sum(parts));
  }
  return result;
}

Components product(Ring& ring, const std::vector<Components>& factors) {
  Components result{1};
  for (const Components& factor : factors) {
    if (factor.size() == 1) {
      result = scaled(ring, result, factor.front());
    } else {
      require(result.size() == 1, "a product of two values with several components");
      result = scaled(ring, factor, result.front());
    }
  }
  return result;
}

Components scaled(Ring& ring, const Components& value, const ex& factor) {
  Components result;
  for (const ex& component : value) result.push_back(ring.product(component, factor));
  return result;
}

ex dot(Ring& ring, const Components& a, const Components& b) {
  require(a.size() == b.size(), "a dot product of points of different dimensions");
  GiNaC::exvector parts;
  for (std::size_t i = 0; i < a.size(); ++i) parts.push_back(ring.product(a[i], b[i]));
  return ring.sum(parts);
}

Components cross(Ring& ring, const Components& a, const Components& b) {
  require(a.size() == 3 && b.size() == 3, "a cross product of points not in space");
  Components result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    result.push_back(ring.sum({ring.product(a[j], b[k]), -ring.product(a[k], b[j])}));
  }
  return result;
}

Components transpose(const Components& matrix, const Shape& shape) {
  Components result;
  for (std::size_t j = 0; j < shape.columns; ++j) {
    for (std::size_t i = 0; i < shape.rows; ++i) {
      for (std::size_t k = 0; k < shape.entry; ++k) {
        result.push_back(matrix.at((i * shape.columns + j) * shape.entry + k));
      }
    }
  }
  return result;
}

Components slice(const Components& matrix, const Shape& shape, const Indices& bounds) {
  require(bounds.size() == 4 && bounds[0] >= 0 && bounds[2] >= 0, "a slice outside the matrix");
  require(bounds[1] < static_cast<long>(shape.rows) && bounds[3] < static_cast<long>(shape.columns),
          "a slice outside the matrix");
  Components result;
  for (int i = bounds[0]; i <= bounds[1]; ++i) {
    for (int j = bounds[2]; j <= bounds[3]; ++j) {
      const std::size_t entry =
          static_cast<std::size_t>(i) * shape.columns + static_cast<std::size_t>(j);
      for (std::size_t k = 0; k < shape.entry; ++k) {
        result.push_back(matrix.at(entry * shape.entry + k));
      }
    }
  }
  return result;
}

Shape product_shape(const Shape& a, const Shape& b) {
  return {a.rows, b.columns, std::max(a.entry, b.entry)};
}

Components matrix_product(Ring& ring, const Components& a, const Shape& a_shape,
                          const Components& b, const Shape& b_shape) {
  require(a_shape.columns == b_shape.rows, "a product of matrices that do not fit");
  require(a_shape.entry == 1 || b_shape.entry == 1, "a product of two matrices of points");
  const std::size_t entry = product_shape(a_shape, b_shape).entry;
  Components result;
  for (std::size_t i = 0; i < a_shape.rows; ++i) {
    for (std::size_t j = 0; j < b_shape.columns; ++j) {
      for (std::size_t k = 0; k < entry; ++k) {
        GiNaC::exvector parts;
        for (std::size_t m = 0; m < a_shape.columns; ++m) {
          const std::size_t left = (i * a_shape.columns + m) * a_shape.entry;
          const std::size_t right = (m * b_shape.columns + j) * b_shape.entry;
          parts.push_back(ring.product(a.at(left + (a_shape.entry == 1 ? 0 : k)),
                                       b.at(right + (b_shape.entry == 1 ? 0 : k))));
        }
        result.push_back(ring.sum(parts));
      }
    }
  }
  return result;
}

ex determinant(Ring& ring, const Components& matrix, const Shape& shape) {
  require(shape.rows == shape.columns && shape.entry == 1, "a determinant of no square matrix");
  const bool numbers = std::all_of(matrix.begin(), matrix.end(), [](const ex& entry) {
    return GiNaC::is_a<GiNaC::numeric>(entry);
  });
  if (!numbers) return determinant_by_minors(ring, matrix, shape.rows);
  ring.spend(shape.rows * shape.rows * shape.rows);
  const auto size = static_cast<unsigned>(shape.rows);
  return GiNaC::matrix{size, size, GiNaC::lst(matrix.begin(), matrix.end())}.determinant();
}

}  // namespace patchproof::symbolic
