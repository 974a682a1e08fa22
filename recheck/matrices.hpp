#pragma once

#include <recheck/field.hpp>

namespace recheck {

using Components = std::vector<Quotient>;

/// The entries in rows first_row..last_row and columns first_column..last_column.
Components block(const Components& matrix, const Type& type, std::size_t first_row,
                 std::size_t last_row, std::size_t first_column, std::size_t last_column);

Components transposed(const Components& matrix, const Type& type);

/// The product of two matrices, of which one may have points as entries.
Components matrix_product(const Components& a, const Type& a_type, const Components& b,
                          const Type& b_type, Field& field);

/// Of a square matrix of scalars, by expansion along its rows.
/// @throws LimitReached for more than 16 rows
Quotient determinant(const Components& matrix, std::size_t size, Field& field);

Quotient dot(const Components& a, const Components& b, Field& field);
Components cross(const Components& a, const Components& b, Field& field);

}  // namespace recheck
