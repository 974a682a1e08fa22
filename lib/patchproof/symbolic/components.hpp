#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// The components of a value in a row: coordinates of a point; entries of a matrix, row by row.
using Components = GiNaC::exvector;

/// The extents of a matrix value.
struct Shape {
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// How many components an entry has.
  std::size_t entry = 1;
};

/// The shape of a matrix, or of the matrices that are the values of a function.
/// @throws std::domain_error for any other type.
Shape matrix_shape(const Type& type);

/// Entrywise.
/// @throws std::domain_error when the sizes differ.
Components sum(Ring& ring, const std::vector<Components>& summands);

/// One factor may have several components.
/// @throws std::domain_error when more than one has.
Components product(Ring& ring, const std::vector<Components>& factors);

Components scaled(Ring& ring, const Components& value, const GiNaC::ex& factor);

/// Points of one dimension.
GiNaC::ex dot(Ring& ring, const Components& a, const Components& b);

/// Points in space.
Components cross(Ring& ring, const Components& a, const Components& b);

Components transpose(const Components& matrix, const Shape& shape);

/// Rows i0..i1 and columns j0..j1, all inclusive.
/// @throws std::domain_error when some are outside.
Components slice(const Components& matrix, const Shape& shape, const Indices& bounds);

/// The product of an a.rows x n and an n x b.columns matrix; entries of one may be points.
Components matrix_product(Ring& ring, const Components& a, const Shape& a_shape,
                          const Components& b, const Shape& b_shape);

/// The shape of the product of matrices of these shapes.
Shape product_shape(const Shape& a, const Shape& b);

/// The determinant of a square matrix of scalars.
/// @throws OverBudget for more than a dozen rows that are not all numbers.
GiNaC::ex determinant(Ring& ring, const Components& matrix, const Shape& shape);

}  // namespace patchproof::symbolic
