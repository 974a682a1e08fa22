#pragma once

#include <string>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/certificate/python_text.hpp>
#include <patchproof/certificate/scalars.hpp>

namespace patchproof {

/// The body of a function of Python that yields, for each thing a proof rests on, whether it holds.
/// @throws NotScalar for what cannot be written
std::string sympy_proof(const SequentProof& proof, Scalars& scalars, PythonText& text);

/// The same of a refutation: the hypotheses hold at the values, the conclusion does not.
/// @throws NotScalar for what cannot be written, and when a symbol has no value
std::string sympy_refutation(const Refutation& refutation, Scalars& scalars, PythonText& text);

}  // namespace patchproof
