#include <recheck/recheck.hpp>

#include <recheck/document_reader.hpp>
#include <recheck/proof_check.hpp>
#include <recheck/refutation_check.hpp>

namespace recheck {

namespace {

Outcome outcome_of(const Certificate& certificate, const Limits& limits) {
  Meter meter{limits};
  const auto ended = [&](Outcome::Kind kind, const std::string& reason) {
    return Outcome{certificate.claim, kind, reason};
  };
  try {
    if (certificate.refutation)
      at_place("refutation",
               [&] { require_refutation(*certificate.refutation, certificate, meter); });
    for (std::size_t k = 0; k < certificate.proofs.size(); ++k)
      at_place("proofs[" + std::to_string(k) + "]",
               [&] { require_proof(certificate.proofs[k], certificate, meter); });
  } catch (const Rejection& error) {
    return ended(Outcome::Kind::rejected, error.what());
  } catch (const Unsupported& error) {
    return ended(Outcome::Kind::unknown, error.what());
  } catch (const LimitReached& error) {
    return ended(Outcome::Kind::unknown, std::string{"limit: "} + error.what());
  }
  return ended(Outcome::Kind::rechecked, "");
}

}  // namespace

std::vector<Outcome> outcomes_of(const std::string& text, const Limits& limits) {
  const Document document = document_of(text, limits);
  std::vector<Outcome> result;
  for (const Certificate& certificate : document.certificates)
    result.push_back(outcome_of(certificate, limits));
  return result;
}

}  // namespace recheck
