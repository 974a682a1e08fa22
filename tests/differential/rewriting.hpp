#pragma once

#include "draft.hpp"

namespace patchproof::differential {

/// The derivative by the rules of calculus, written out; null where a rule is missing. That of a
/// function is written by its name, `r_u`.
Node derivative_written_out(const Node& node, const std::string& variable, const Draft& draft);

/// Another expression of the same value: `steps` times, one of the rules is used somewhere in it.
/// The rules are identities of rings and modules, of calculus, those that the functions of the
/// draft come with, and the equations it assumes.
Node rewritten(Choices& choices, const Draft& draft, Node node, unsigned steps);

/// With one function, if there is one that has another way to write it, written in that way.
Node unfolded_somewhere(Choices& choices, const Draft& draft, const Node& node);

}  // namespace patchproof::differential
