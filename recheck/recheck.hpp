#pragma once

#include <string>
#include <vector>

#include <recheck/meter.hpp>

/// The second checker: looks at certificates again, with code of its own from the text on. Nothing
/// of patchproof is used, only exact numbers of Boost and a reader of JSON.
namespace recheck {

/// What became of a certificate.
struct Outcome {
  enum class Kind { rechecked, rejected, unknown };
  std::string claim;
  Kind kind = Kind::unknown;
  /// Why it is not rechecked, and where in the certificate.
  std::string reason;
};

/// The outcomes of all certificates in the text of a document, in their order.
/// @throws Unreadable when the text is no such document
std::vector<Outcome> outcomes_of(const std::string& text, const Limits& limits = {});

}  // namespace recheck
