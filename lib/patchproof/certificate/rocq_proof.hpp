#pragma once

#include <string>

#include <patchproof/certificate/rocq_sequent.hpp>

namespace patchproof {

/// The proof script of a sequent, between `Proof.` and `Qed.`
/// @throws NotScalar
std::string rocq_proof(const SequentProof& proof, RocqSequent& sequent, Scalars& scalars,
                       RocqNames& names, RocqText& text);

/// The proof script that a sequent is false: of `~ claim`.
/// @throws NotScalar
std::string rocq_refutation(const Refutation& refutation, RocqSequent& sequent, Scalars& scalars,
                            RocqNames& names, RocqText& text);

}  // namespace patchproof
