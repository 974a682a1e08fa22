#pragma once

#include <vector>

#include <patchproof/algebra/fraction.hpp>
#include <patchproof/term/type.hpp>

namespace patchproof {

/// Matrices as flat lists of components: entries row by row, components of an entry in order.
using Components = std::vector<Fraction>;

/// Rows first_row..last_row and columns first_column..last_column, all inclusive.
Components block(const Components& matrix, const Type& type, int first_row, int last_row,
                 int first_column, int last_column);

Components transposed(const Components& matrix, const Type& type);

/// The product; at most one of the two matrices has points as entries.
Components matrix_product(const Components& a, const Type& a_type, const Components& b,
                          const Type& b_type, Budget& budget);

/// The determinant of a square matrix of scalars, by expansion over the rows with the minors of
/// the columns left remembered: no division, so nothing has to be assumed not to vanish.
Fraction determinant(const Components& matrix, int size, Budget& budget);

Fraction dot(const Components& a, const Components& b, Budget& budget);
Components cross(const Components& a, const Components& b, Budget& budget);

}  // namespace patchproof
