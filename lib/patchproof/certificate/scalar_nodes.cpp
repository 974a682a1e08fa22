#include <patchproof/certificate/scalar_nodes.hpp>

#include <algorithm>

namespace patchproof {

ScalarPointer scalar(Scalar node) {
  node.size = 1 + (node.function ? node.function->size : 0);
  for (const ScalarPointer& child : node.children)
    node.size = std::min(largest_scalar, node.size + child->size);
  return std::make_shared<const Scalar>(std::move(node));
}

ScalarFunctionPointer scalar_function(ScalarFunction node) {
  node.size = std::min(largest_scalar, 1 + (node.body ? node.body->size : 0) +
                                           (node.inner ? node.inner->size : 0));
  return std::make_shared<const ScalarFunction>(std::move(node));
}

ScalarPointer scalar_number(const Rational& number) {
  const auto whole = [](const Integer& n) {
    Scalar node;
    node.number = n;
    return scalar(std::move(node));
  };
  const ScalarPointer above = whole(numerator(number));
  const Integer below = denominator(number);
  return below == 1 ? above : scalar_pair(Scalar::Kind::quotient, above, whole(below));
}

ScalarPointer scalar_variable(const Coordinate& coordinate) {
  Scalar node;
  node.kind = Scalar::Kind::variable;
  node.coordinate = coordinate;
  return scalar(std::move(node));
}

ScalarPointer scalar_pair(Scalar::Kind kind, const ScalarPointer& a, const ScalarPointer& b) {
  Scalar node;
  node.kind = kind;
  node.children = {a, b};
  return scalar(std::move(node));
}

ScalarPointer scalar_opposite(const ScalarPointer& a) {
  Scalar node;
  node.kind = Scalar::Kind::opposite;
  node.children = {a};
  return scalar(std::move(node));
}

ScalarPointer scalar_power(const ScalarPointer& a, unsigned exponent) {
  Scalar node;
  node.kind = Scalar::Kind::power;
  node.children = {a};
  node.order = exponent;
  return scalar(std::move(node));
}

ScalarPointer scalar_bernstein(int degree, int index, const ScalarPointer& t) {
  if (index < 0 || index > degree) return scalar_number(0);
  Scalar node;
  node.kind = Scalar::Kind::bernstein;
  node.children = {t};
  node.order = static_cast<unsigned>(degree);
  node.index = static_cast<unsigned>(index);
  return scalar(std::move(node));
}

ScalarPointer scalar_sum(const std::vector<ScalarPointer>& summands) {
  ScalarPointer result;
  for (const ScalarPointer& s : summands) {
    if (!result)
      result = s;
    else if (s->kind == Scalar::Kind::opposite)
      result = scalar_pair(Scalar::Kind::difference, result, s->children.front());
    else
      result = scalar_pair(Scalar::Kind::sum, result, s);
  }
  return result ? result : scalar_number(0);
}

}  // namespace patchproof
