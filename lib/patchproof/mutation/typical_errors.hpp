#pragma once

#include <string>
#include <vector>

#include <patchproof/mutation/vocabulary.hpp>
#include <patchproof/repair/edit.hpp>

namespace patchproof {

/// An error that is often made in writing down a formula, as a change of the text of the file.
struct TypicalError {
  /// Its bytes are those of the file. What it changes is "sign", "summand", "exchanged", "number",
  /// "index", "transposed", "name", "derivative" or "datum".
  Edit edit;
  /// "1/9 -> 1/10", "V[0,1] -> V[1,0]", "1/9*P_uv(0,0) left out".
  std::string words;
};

/// The typical errors of one expression, in the order of the text: signs turned round, summands
/// left out, two arguments or indices exchanged, a net transposed, a number one more or one less, a
/// name or a derivative taken for a similar one.
std::vector<TypicalError> typical_errors(const syntax::ExpressionPointer& expression,
                                         const Vocabulary& vocabulary);

}  // namespace patchproof
