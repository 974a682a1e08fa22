#pragma once

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/certificate/proposition_table.hpp>
#include <patchproof/certificate/rocq_names.hpp>
#include <patchproof/certificate/scalars.hpp>

namespace patchproof {

/// What a sequent says, made from its terms and from nothing that was written down: for all unknown
/// functions, points and numbers, in the order of their declaration, smooth as they have to be, under
/// the hypotheses, for all parameters in their ranges and where hypotheses restrict them, the
/// conclusions hold.
///
/// `names` tells which symbols are entries of one array; its names are not looked at.
/// @throws NotScalar
std::size_t asked_proposition(const Sequent& sequent, Scalars& scalars, RocqNames& names,
                              PropositionTable& table);

}  // namespace patchproof
