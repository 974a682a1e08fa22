#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/certificate.hpp>

namespace patchproof {

/// The certificates of one case as a JSON document, format version 1: docs/certificates.md. The
/// same certificates give the same bytes.
/// @throws std::logic_error when two symbols of one certificate have the same ordinal and different
/// types or roles, or a term is missing
std::string json_certificates(const std::string& case_name,
                              const std::vector<Certificate>& certificates);

}  // namespace patchproof
