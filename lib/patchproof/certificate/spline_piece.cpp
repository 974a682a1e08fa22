#include <patchproof/certificate/spline_piece.hpp>

#include <patchproof/certificate/scalar_nodes.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;

// a + b*t
ScalarPointer line(const Rational& a, const Rational& b, const ScalarPointer& t) {
  const ScalarPointer slope =
      b == 1 ? t : scalar_pair(Kind::product, scalar_number(b), t);
  return a == 0 ? slope : scalar_pair(Kind::sum, scalar_number(a), slope);
}

// N_{index,degree}; none where it is zero on the span.
ScalarPointer piece(const BasisFunction& f, int index, int degree, const ScalarPointer& t) {
  const auto knot = [&](int k) -> const Rational& { return f.knots.at(static_cast<std::size_t>(k)); };
  if (f.span < index || f.span > index + degree) return nullptr;
  if (degree == 0) return scalar_number(1);
  const Rational start = knot(f.span);
  const Rational length = knot(f.span + 1) - start;
  const Rational rise = knot(index + degree) - knot(index);
  const Rational fall = knot(index + degree + 1) - knot(index + 1);
  ScalarPointer result;
  const auto add = [&](const ScalarPointer& factor, const ScalarPointer& lower) {
    const ScalarPointer product = lower->kind == Kind::integer && lower->number == 1
                                      ? factor
                                      : scalar_pair(Kind::product, factor, lower);
    result = result ? scalar_pair(Kind::sum, result, product) : product;
  };
  if (rise != 0)
    if (const ScalarPointer lower = piece(f, index, degree - 1, t))
      add(line((start - knot(index)) / rise, length / rise, t), lower);
  if (fall != 0)
    if (const ScalarPointer lower = piece(f, index + 1, degree - 1, t))
      add(line((knot(index + degree + 1) - start) / fall, -length / fall, t), lower);
  return result;
}

}  // namespace

ScalarPointer spline_piece(const BasisFunction& function, const ScalarPointer& t) {
  const ScalarPointer result = piece(function, function.index, function.degree, t);
  return result ? result : scalar_number(0);
}

}  // namespace patchproof
