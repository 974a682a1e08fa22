#pragma once

#include <patchproof/language/scope.hpp>

namespace patchproof {

/// Which of the formals are no scalars in the expression but functions or nets: called,
/// differentiated, indexed, or handed on to something that does so.
std::vector<bool> functions_among(const std::vector<syntax::Name>& formals,
                                  const syntax::Expression& expression, const Scope& scope);

/// The variables of the first integral in the expression; empty when there is none.
std::vector<syntax::Name> integration_variables(const syntax::Expression& expression);

}  // namespace patchproof
