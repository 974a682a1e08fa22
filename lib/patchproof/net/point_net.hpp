#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/algebra/rational.hpp>

namespace patchproof {

/// A net of points b[i,j] with exact coordinates. Rows belong to u, columns to v.
struct PointNet {
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// Coordinates of each point, from 1.
  std::size_t dimension = 0;
  /// Row by row, in a row point by point: rows * columns * dimension numbers.
  std::vector<Rational> coordinates;
  /// What a file says besides of the surface in u and in v.
  std::optional<std::array<int, 2>> degrees;
  std::optional<std::array<std::vector<Rational>, 2>> knots;

  const Rational& coordinate(std::size_t i, std::size_t j, std::size_t k) const {
    return coordinates[(i * columns + j) * dimension + k];
  }
};

/// How much a reader takes; what is beyond is a mistake, found before the memory is full.
struct NetLimits {
  std::size_t points = 4'000'000;
  /// What to do with more points.
  std::string help;
  /// Coordinates of a point: x, y, z, w.
  std::size_t dimension = 4;
  /// What numbers beyond machine words may need together.
  std::size_t bytes_of_large_numbers = std::size_t{256} << 20U;
};

}  // namespace patchproof
