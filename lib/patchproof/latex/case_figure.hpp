#pragma once

#include <string>

#include <patchproof/latex/mathematics.hpp>

namespace patchproof {

/// The picture of a page with its caption, as LaTeX: two patches at their joint where the case has
/// one, else the patch most of its claims speak of. "" for cases that have none, or none that can be drawn.
std::string case_figure(const CaseResult& result, const Wording& wording);

}  // namespace patchproof
