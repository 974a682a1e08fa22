#pragma once

#include "draft.hpp"

namespace patchproof::differential {

/// An expression that looks almost like this one and has another value: a coefficient off by a
/// little, a sign, an index, a name, a derivative; or a polynomial added that vanishes at many
/// small places, or with a coefficient that many moduli divide.
///
/// That the value is another one is made sure by `meaning`, under the assumptions of the draft.
Node near_miss(Choices& choices, const Draft& draft, const Node& node);

}  // namespace patchproof::differential
