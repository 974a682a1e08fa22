#pragma once

#include <patchproof/term/term.hpp>

namespace patchproof {

/// The product of two matrices that are written out, of fitting shapes: each entry a sum of
/// products. At most one of them has points as entries.
Term matrix_product_of(const Term& a, const Term& b);

/// The transpose of a matrix that is written out.
Term transposed(const Term& matrix);

}  // namespace patchproof
