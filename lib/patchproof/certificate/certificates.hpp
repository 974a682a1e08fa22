#pragma once

#include <string>
#include <variant>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/claims/verification.hpp>

namespace patchproof {

/// Why there is no certificate.
struct NotCertified {
  std::string why;
};

/// The certificate of a decided claim: found anew from the statement, not taken from the kernel's
/// decision, whose words only say which verdict and which conditions are to be shown.
/// Never throws; work over the limits is a reason.
std::variant<Certificate, NotCertified> certificate(const ClaimResult& claim,
                                                    const std::string& case_name,
                                                    const Limits& limits);

}  // namespace patchproof
