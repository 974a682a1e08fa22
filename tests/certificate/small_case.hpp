#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchproof/certificate/certificates.hpp>
#include <patchproof/report/report.hpp>
#include <tests/decide/verdicts.hpp>

namespace patchproof {

/// A case with its certificates.
struct CertifiedCase {
  Case given;
  std::vector<Certificate> certificates;
};

/// Of the only case of a text; every claim has to have a certificate.
inline CertifiedCase certified_case(const std::string& text) {
  const CaseResult result = results_of(text).at(0);
  CertifiedCase all{result.verified, {}};
  for (const ClaimResult& claim : result.claims) {
    const auto found = certificate(claim, result.verified.name, result.verified.limits);
    if (const auto* missing = std::get_if<NotCertified>(&found))
      throw std::invalid_argument{claim_id(result.verified, claim.claim) + ": " + missing->why};
    all.certificates.push_back(std::get<Certificate>(found));
  }
  return all;
}

/// tests/golden/certificate: a small case, and what coqc 8.16.1 prints of its file.
inline std::string golden_certificate(const std::string& name) {
  std::ifstream file{std::string{PATCHPROOF_SOURCE_FOLDER} + "/tests/golden/certificate/" + name};
  if (!file) throw std::runtime_error{"there is no golden file " + name};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// The text with its only such part replaced.
inline std::string with_part(const std::string& text, const std::string& old_part,
                             const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  if (at == std::string::npos || text.find(old_part, at + 1) != std::string::npos)
    throw std::invalid_argument{"not exactly one '" + old_part + "'"};
  return text.substr(0, at) + new_part + text.substr(at + old_part.size());
}

}  // namespace patchproof
