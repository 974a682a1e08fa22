#pragma once

#include <map>
#include <string>

#include <patchproof/claims/verification.hpp>

namespace patchproof::test {

/// For one kind of claims: how many there are, and how many have a certificate and a theorem in Rocq.
struct CertifiedCount {
  std::size_t claims = 0;
  std::size_t certificates = 0;
  std::size_t theorems = 0;
  /// Why there is no theorem -> of how many claims.
  std::map<std::string, std::size_t> missing;
};
/// Kind of claims -> count.
using CertifiedCounts = std::map<std::string, CertifiedCount>;

/// Adds the claims of a case to the counts.
void count_certified(const CaseResult& result, CertifiedCounts& counts);

/// The counts as a table in Markdown, and a list of the reasons.
std::string certified_table(const CertifiedCounts& counts);

}  // namespace patchproof::test
