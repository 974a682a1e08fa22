#pragma once

#include <string>
#include <vector>

#include <patchproof/language/elaborator.hpp>

namespace patchproof {

/// What cannot be a definition of the prelude: arithmetic on whole arrays, basis functions,
/// derivatives, finite sums, splines.
bool is_builtin(const std::string& name);
std::vector<std::string> builtin_names();

/// How it is called: "bernstein(n, i, t)".
std::string builtin_usage(const std::string& name);

/// Fault when the call has too few or too many arguments.
void require_arguments(const std::string& name, const syntax::Expression& call);

/// The value of `name(arguments)`.
/// @throws Fault
Term builtin_call(const std::string& name, const syntax::Expression& call, const Scope& scope,
                  Elaborator& elaborator);

}  // namespace patchproof
