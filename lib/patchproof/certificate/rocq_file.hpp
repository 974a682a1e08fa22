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
  /// Names of their statements.
  std::vector<std::string> statements;
  /// Why it could not be written.
  std::string why_not;
};

/// What a file begins with, below the remarks.
inline constexpr const char* rocq_head = "Require Import PatchProof.Certificates.\n\n";
/// The name of the tuple of all theorems of a file.
inline constexpr const char* rocq_theorems_together = "certified_together";

struct RocqFile {
  std::string text;
  /// What stands in it between the head and the question for the assumptions.
  std::string body;
  /// Names of what is defined, but for the statements; each stands after those it needs.
  std::vector<std::string> definitions;
  /// One for each certificate, in the same order.
  std::vector<RocqTheorem> theorems;
};

/// A file for coqc with a definition for everything the case has a name for, and for each certificate
/// a statement `claim_…` and a theorem `certified_…`; then it prints what Rocq has understood of the
/// definitions, statements and theorems, in this order, and the assumptions.
RocqFile rocq_file(const Case& given, const std::vector<Certificate>& certificates);

}  // namespace patchproof
