#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchproof/certificate/json_certificate.hpp>
#include <patchproof/language/reader.hpp>
#include <recheck/place.hpp>
#include <recheck/recheck.hpp>

/// Certificates made by hand: statements are read from a case, proofs are written down in the
/// tests.
namespace patchproof::test {

/// The claims of one case, by their labels.
class Claims {
 public:
  /// @throws std::invalid_argument with the messages when the text is faulty
  explicit Claims(const std::string& statements) {
    const auto source = std::make_shared<const SourceText>(
        SourceText{"test.proof", "case t\n" + statements + "\nend\n"});
    const ReadFile read = read_cases(
        source, Limits{}, [](const std::string&) { return std::optional<std::string>{}; });
    std::string messages;
    for (const Diagnostic& diagnostic : read.diagnostics) messages += to_text(diagnostic);
    if (!messages.empty()) throw std::invalid_argument{messages};
    for (const Claim& claim : read.cases.at(0).claims)
      if (const auto* identity = std::get_if<IdentityClaim>(&claim.kind))
        goals_.emplace(claim.label, identity->goal);
  }

  /// What is claimed under this label, with all that is assumed.
  Sequent sequent(const std::string& label) const {
    const Goal& goal = goals_.at(label);
    return {goal.assumptions, goal.ranges, goal.statements};
  }
  /// The left side of what is claimed under this label: a term to be used in proofs.
  Term term(const std::string& label) const { return goals_.at(label).statements.at(0).left; }

 private:
  std::map<std::string, Goal> goals_;
};

/// A proof of the first component of the first conclusion, by multiples of equations.
inline SequentProof by_equations(const Sequent& sequent, std::vector<Cofactor> cofactors) {
  return {sequent, {{0, 0, EquationProof{std::move(cofactors)}, false}}, {}, {}};
}

/// The same by a combination of facts.
inline SequentProof by_facts(const Sequent& sequent, Combination combination) {
  return {sequent, {{0, 0, SignProof{{}, std::move(combination)}, false}}, {}, {}};
}

inline std::string document_of(const SequentProof& proof) {
  return json_certificates("t", {{"t.claim", "", std::vector<SequentProof>{proof}}});
}
inline std::string document_of(const Refutation& refutation) {
  return json_certificates("t", {{"t.claim", "", refutation}});
}

/// "RECHECKED", "REJECTED reason", "UNKNOWN reason"; or "unreadable: reason".
inline std::string judged(const std::string& document, const recheck::Limits& limits = {}) {
  try {
    std::string text;
    for (const recheck::Outcome& outcome : recheck::outcomes_of(document, limits)) {
      using Kind = recheck::Outcome::Kind;
      text += (text.empty() ? "" : "; ") +
              std::string{outcome.kind == Kind::rechecked  ? "RECHECKED"
                          : outcome.kind == Kind::rejected ? "REJECTED "
                                                           : "UNKNOWN "} +
              outcome.reason;
    }
    return text;
  } catch (const recheck::Unreadable& error) {
    return std::string{"unreadable: "} + error.what();
  }
}

/// The document with another value at a place, such as "/certificates/0/nodes/3/value".
inline std::string changed(const std::string& document, const std::string& place,
                           const nlohmann::json& value) {
  nlohmann::json json = nlohmann::json::parse(document);
  json.at(nlohmann::json::json_pointer{place}) = value;
  return json.dump();
}

}  // namespace patchproof::test
