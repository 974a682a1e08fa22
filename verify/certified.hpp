#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/certificate/rocq_file.hpp>
#include <patchproof/report/report.hpp>

namespace patchproof {

/// The certificates of the claims of a case, and the claims without one.
struct CaseCertificates {
  std::vector<Certificate> certificates;
  /// Id of the claim, and why it has none.
  std::vector<std::pair<std::string, std::string>> missing;
};
CaseCertificates certificates_of(const CaseResult& result);

/// A file of theorems without those that coqc did not accept.
struct CheckedFile {
  std::string case_name;
  /// Name of the file in the folder.
  std::string file;
  /// SHA-256 of its text.
  std::string digest;
  /// Ids of the claims whose theorems were accepted.
  std::vector<std::string> claims;
  /// Ids of those left out.
  std::vector<std::string> left_out;
  std::vector<std::string> axioms;
};

/// What was checked by coqc: kept in `certified.json` beside the files.
struct CheckedFolder {
  std::string coqc;
  std::vector<CheckedFile> files;
};

/// @returns what went wrong; "" when all is well.
std::string write_checked(const std::string& folder, const CheckedFolder& checked);

/// Reads what was checked in the folder.
/// @returns what is wrong with the folder; "" when all is well.
std::string read_checked(const std::string& folder, CheckedFolder& checked);

/// The ids of the claims for which there is a checked certificate of what the case says now: the
/// file is written anew and has to be the one that was checked, so that all claims of the case have
/// to be decided.
struct CertifiedClaims {
  std::vector<std::string> ids;
  /// As in `Decision::certificate`.
  std::string by;
};
CertifiedClaims certified_claims(const CheckedFolder& checked, const CaseResult& result);

/// Raises the evidence of these claims in a report.
void raise_evidence(const CheckedFolder& checked, Report& report);

/// "coqc 8.16.1, axioms: a, b"
std::string check_in_words(const std::string& coqc, const std::vector<std::string>& axioms);

/// The certificates without those of the claims named.
std::vector<Certificate> without(const std::vector<Certificate>& certificates,
                                 const std::vector<std::string>& claims);

}  // namespace patchproof
