#include <recheck/matrices.hpp>

#include <recheck/evaluation.hpp>
#include <recheck/types.hpp>

namespace recheck {

Components block(const Components& matrix, const Type& type, std::size_t first_row,
                 std::size_t last_row, std::size_t first_column, std::size_t last_column) {
  Components result;
  for (std::size_t i = first_row; i <= last_row; ++i)
    for (std::size_t j = first_column; j <= last_column; ++j)
      for (std::size_t k = 0; k < type.width(); ++k)
        result.push_back(matrix.at((i * type.columns + j) * type.width() + k));
  return result;
}

Components transposed(const Components& matrix, const Type& type) {
  Components result;
  for (std::size_t j = 0; j < type.columns; ++j)
    for (const Quotient& entry : block(matrix, type, 0, type.rows - 1, j, j))
      result.push_back(entry);
  return result;
}

Components matrix_product(const Components& a, const Type& a_type, const Components& b,
                          const Type& b_type, Field& field) {
  const std::size_t width = std::max(a_type.width(), b_type.width());
  Components result;
  for (std::size_t i = 0; i < a_type.rows; ++i) {
    for (std::size_t j = 0; j < b_type.columns; ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        Quotient total;
        for (std::size_t l = 0; l < a_type.columns; ++l) {
          const Components left = block(a, a_type, i, i, l, l);
          const Components right = block(b, b_type, l, l, j, j);
          total = field.sum(total, field.product(left[left.size() == 1 ? 0 : k],
                                                 right[right.size() == 1 ? 0 : k]));
        }
        result.push_back(total);
      }
    }
  }
  return result;
}

namespace {

constexpr std::size_t most_rows = 16;

/// The minors of the last rows of a matrix, by the columns they keep.
class Minors {
 public:
  Minors(const Components& matrix, std::size_t size, Field& field)
      : matrix_{matrix}, size_{size}, field_{field} {}

  Quotient of(std::size_t row, const std::vector<std::size_t>& columns) {
    if (columns.empty()) return number(1);
    const auto known = known_.find(columns);
    if (known != known_.end()) return known->second;
    Quotient total;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const Quotient& entry = matrix_.at(row * size_ + columns[k]);
      if (entry.numerator.empty()) continue;
      std::vector<std::size_t> others = columns;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      const Quotient part = field_.product(entry, of(row + 1, others));
      total = k % 2 == 0 ? field_.sum(total, part) : field_.difference(total, part);
    }
    return known_.emplace(columns, total).first->second;
  }

 private:
  const Components& matrix_;
  std::size_t size_;
  Field& field_;
  std::map<std::vector<std::size_t>, Quotient> known_;
};

}  // namespace

Quotient determinant(const Components& matrix, std::size_t size, Field& field) {
  Meter::require(size, most_rows, "rows of a determinant");
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < size; ++k) columns.push_back(k);
  return Minors{matrix, size, field}.of(0, columns);
}

Quotient dot(const Components& a, const Components& b, Field& field) {
  Quotient total;
  for (std::size_t k = 0; k < a.size(); ++k) total = field.sum(total, field.product(a[k], b.at(k)));
  return total;
}

Components cross(const Components& a, const Components& b, Field& field) {
  Components result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    result.push_back(field.difference(field.product(a.at(next), b.at(last)),
                                      field.product(a.at(last), b.at(next))));
  }
  return result;
}

std::vector<Quotient> Evaluator::of_vectors(const Node& node) const {
  const Components& first = child(node, 0).components;
  const Type& type = nodes_[node.children[0]].type;
  switch (node.operation) {
    case Operation::component:
      return {first.at(node.indices[0])};
    case Operation::entry:
      return block(first, type, node.indices[0], node.indices[0], node.indices[1], node.indices[1]);
    case Operation::slice:
      return block(first, type, node.indices[0], node.indices[1], node.indices[2], node.indices[3]);
    case Operation::transpose:
      return transposed(first, type);
    case Operation::determinant:
      return {determinant(first, type.rows, field_)};
    case Operation::dot:
      return {dot(first, child(node, 1).components, field_)};
    case Operation::cross:
      return cross(first, child(node, 1).components, field_);
    case Operation::negation: {
      Components result;
      for (const Quotient& component : first) result.push_back(field_.multiple(component, -1));
      return result;
    }
    default:
      break;
  }
  Components result = first;
  Type left = type;
  for (std::size_t c = 1; c < node.children.size(); ++c) {
    const Components& next = child(node, c).components;
    if (node.operation == Operation::sum) {
      for (std::size_t k = 0; k < result.size(); ++k) result[k] = field_.sum(result[k], next.at(k));
    } else if (node.operation == Operation::matrix_product) {
      const Type& right = nodes_[node.children[c]].type;
      result = matrix_product(result, left, next, right, field_);
      left = product_type(left, right);
    } else {  // a tuple or matrix
      result.insert(result.end(), next.begin(), next.end());
    }
  }
  return result;
}

}  // namespace recheck
