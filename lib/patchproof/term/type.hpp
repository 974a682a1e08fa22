#pragma once

#include <memory>
#include <string>
#include <vector>

namespace patchproof {

/// What kind of mathematical object a term stands for.
///
/// A point of dimension `any_dimension` stands for a point of every dimension: only sums and
/// multiples of it can be formed, so one component stands for all of them.
struct Type {
  enum class Kind { scalar, point, matrix, function };
  static constexpr int any_dimension = 0;

  Kind kind = Kind::scalar;
  /// Points: how many coordinates, or `any_dimension`.
  int dimension = 0;
  /// Matrices: extents. A list of points (a control polygon) has `columns == 1` and `list` set.
  int rows = 0;
  int columns = 0;
  bool list = false;
  /// Functions: the names of the parameters, as in patch(u, v).
  std::vector<std::string> parameters;
  /// Matrices: the type of an entry (scalar or point). Functions: the type of a value.
  std::shared_ptr<const Type> inner;

  static Type scalar();
  static Type point(int dimension);
  static Type matrix(int rows, int columns, const Type& entry, bool list = false);
  static Type function(std::vector<std::string> parameters, const Type& value);

  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_point() const { return kind == Kind::point; }
  bool is_matrix() const { return kind == Kind::matrix; }
  bool is_function() const { return kind == Kind::function; }

  /// How many scalars make up a value of this type; for functions, of one value of the function.
  /// A point of any dimension counts as one.
  std::size_t component_count() const;

  /// Equality of shapes; parameter names of functions do not matter, `list` does not either.
  friend bool operator==(const Type& a, const Type& b);
};

/// The type in words: "scalar", "point in R^3", "4 x 4 matrix of points", "patch(u, v)".
std::string to_text(const Type& type);

}  // namespace patchproof
