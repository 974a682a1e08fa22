#pragma once

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// p/q as an integer or a quotient of integers.
ScalarPointer scalar_number(const Rational& number);
ScalarPointer scalar_variable(const Coordinate& coordinate);
/// sum, difference, product, quotient
ScalarPointer scalar_pair(Scalar::Kind kind, const ScalarPointer& a, const ScalarPointer& b);
ScalarPointer scalar_opposite(const ScalarPointer& a);
ScalarPointer scalar_power(const ScalarPointer& a, unsigned exponent);
/// B_index^degree(t); zero where there is none.
ScalarPointer scalar_bernstein(int degree, int index, const ScalarPointer& t);
/// a + b - c, from the left; zero for none. What is an opposite is taken away.
ScalarPointer scalar_sum(const std::vector<ScalarPointer>& summands);
/// The node with its size worked out.
ScalarPointer scalar(Scalar node);
ScalarFunctionPointer scalar_function(ScalarFunction node);

}  // namespace patchproof
