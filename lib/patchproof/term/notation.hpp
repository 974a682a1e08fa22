#pragma once

#include <map>
#include <string>

namespace patchproof {

/// How partial derivatives are written in LaTeX.
enum class DerivativeStyle {
  subscript,    ///< r_{uv}
  superscript,  ///< P^{uv}
  fraction,     ///< \frac{\partial^2 r}{\partial u\,\partial v}
};

/// How a case wants its mathematics written in LaTeX.
struct Notation {
  /// Name as in the case -> LaTeX, checked to be mathematics only. Indices are written behind it.
  std::map<std::string, std::string> names;
  DerivativeStyle derivatives = DerivativeStyle::subscript;
};

}  // namespace patchproof
