#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/claims/claim.hpp>

namespace patchproof {

/// A script of Python 3 that checks certificates of a case by SymPy: symbols and definitions by the
/// names of the case, and for each claim the equations that show it. It prints "label: holds" or
/// "label: FAILS" for each, and ends with 1 if one fails. What cannot be written is a comment with
/// the reason.
///
/// The same certificates give the same bytes.
std::string sympy_script(const Case& given, const std::vector<Certificate>& certificates);

}  // namespace patchproof
