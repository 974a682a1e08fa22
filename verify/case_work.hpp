#pragma once

#include <verify/certified.hpp>

#include <string>
#include <utility>
#include <vector>

namespace patchproof {

/// A case on its way: what is certified of it, and what is not and why.
struct CaseWork {
  const CaseResult* result = nullptr;
  std::string file;
  CaseCertificates found;
  RocqFile rocq;
  /// The text for another format than that of Rocq.
  std::string other;
  std::vector<std::string> left_out;
  /// Ids of claims, each with the reason why it has no certificate.
  std::vector<std::pair<std::string, std::string>> missing;
  bool accepted = false;
  std::vector<std::string> axioms;
  /// coqc has not said which axioms the theorems rest on, or has named one that is not accepted.
  bool unfounded = false;
  /// Claims that Rocq took for something else.
  std::vector<std::string> misunderstood;
};

/// Makes the file of its certificates, without those left out.
void write_down(CaseWork& work);

/// Ids of the claims with a theorem in the file.
std::vector<std::string> theorems_of(const CaseWork& work);

/// The claim whose theorem begins last before the line; "" for none.
std::string claim_at(const CaseWork& work, std::size_t line);

/// Whether what coqc says it has checked is what was asked.
bool is_understood(const CaseWork& work, const std::string& output);

/// Compares what coqc says it has checked with what was asked.
void compare(CaseWork& work, const std::string& output);

/// Of the claims with a theorem those that were not taken for others.
std::vector<std::string> certified_in(const CaseWork& work);

}  // namespace patchproof
