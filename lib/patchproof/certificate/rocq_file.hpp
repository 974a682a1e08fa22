#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/claims/claim.hpp>

namespace patchproof {

/// The statements and proofs of one certificate in Rocq.
struct RocqTheorem {
  /// Of the certificate.
  std::string claim;
  /// Names of the theorems; empty when it could not be written.
  std::vector<std::string> theorems;
  /// Why it could not be written.
  std::string why_not;
};

struct RocqFile {
  std::string text;
  /// One for each certificate, in the same order.
  std::vector<RocqTheorem> theorems;
};

/// A file for coqc with a definition for everything the case has a name for, and for each certificate
/// a statement `claim_…`, a theorem `certified_…`, and `Print Assumptions`.
RocqFile rocq_file(const Case& given, const std::vector<Certificate>& certificates);

}  // namespace patchproof
