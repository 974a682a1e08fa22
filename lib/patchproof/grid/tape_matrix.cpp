#include <algorithm>

#include <patchproof/grid/tape_builder.hpp>

namespace patchproof {

TapeBuilder::Value TapeBuilder::of_block(const Term& term, const Indices& at, Scope& scope) {
  const Value& matrix = value(term, scope);
  const std::size_t width = term.type().inner->component_count();
  Value result;
  for (int i = at.at(0); i <= at.at(1); ++i)
    for (int j = at.at(2); j <= at.at(3); ++j)
      for (std::size_t k = 0; k < width; ++k)
        result.push_back(
            matrix.at(static_cast<std::size_t>(i * term.type().columns + j) * width + k));
  return result;
}

TapeBuilder::Value TapeBuilder::of_transpose(const Term& term, Scope& scope) {
  Value result;
  for (int j = 0; j < term.type().columns; ++j) {
    const Value column = of_block(term, {0, term.type().rows - 1, j, j}, scope);
    result.insert(result.end(), column.begin(), column.end());
  }
  return result;
}

TapeBuilder::Value TapeBuilder::of_matrix_product(const Term& term, Scope& scope) {
  Value left = value(term.child(0), scope);
  const auto rows = static_cast<std::size_t>(term.child(0).type().rows);
  auto inner = static_cast<std::size_t>(term.child(0).type().columns);
  std::size_t left_width = term.child(0).type().inner->component_count();
  for (std::size_t n = 1; n < term.children().size(); ++n) {
    const Value& right = value(term.child(n), scope);
    const auto columns = static_cast<std::size_t>(term.child(n).type().columns);
    const std::size_t right_width = term.child(n).type().inner->component_count();
    const std::size_t width = std::max(left_width, right_width);
    Value both;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        for (std::size_t k = 0; k < width; ++k) {
          std::vector<Series> products;
          for (std::size_t l = 0; l < inner; ++l)
            products.push_back(product(
                left.at((i * inner + l) * left_width + (left_width > 1 ? k : 0)),
                right.at((l * columns + j) * right_width + (right_width > 1 ? k : 0)), scope));
          std::vector<std::pair<const Series*, bool>> summands;
          for (const Series& one : products) summands.emplace_back(&one, false);
          both.push_back(sum(summands));
        }
    left = std::move(both);
    inner = columns;
    left_width = width;
  }
  return left;
}

TapeBuilder::Value TapeBuilder::of_dot(const Term& term, Scope& scope) {
  const Value& a = value(term.child(0), scope);
  const Value& b = value(term.child(1), scope);
  std::vector<Series> products;
  for (std::size_t k = 0; k < a.size(); ++k) products.push_back(product(a[k], b.at(k), scope));
  std::vector<std::pair<const Series*, bool>> summands;
  for (const Series& one : products) summands.emplace_back(&one, false);
  return {sum(summands)};
}

TapeBuilder::Value TapeBuilder::of_cross(const Term& term, Scope& scope) {
  const Value& a = value(term.child(0), scope);
  const Value& b = value(term.child(1), scope);
  Value result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Series first = product(a.at((k + 1) % 3), b.at((k + 2) % 3), scope);
    const Series second = product(a.at((k + 2) % 3), b.at((k + 1) % 3), scope);
    result.push_back(sum({{&first, false}, {&second, true}}));
  }
  return result;
}

}  // namespace patchproof
