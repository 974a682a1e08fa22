#include <tests/docs/certified_table.hpp>

#include <algorithm>

#include <patchproof/certificate/certificates.hpp>
#include <patchproof/certificate/rocq_file.hpp>

namespace patchproof::test {

namespace {

bool has_order(const std::vector<Statement>& statements) {
  return std::any_of(statements.begin(), statements.end(), [](const Statement& s) {
    return s.relation != Relation::equal && s.relation != Relation::not_equal;
  });
}

bool has_inequality(const std::vector<Statement>& statements) {
  return std::any_of(statements.begin(), statements.end(),
                     [](const Statement& s) { return s.relation == Relation::not_equal; });
}

// The letters in front keep the kinds in this order.
std::string kind_of(const ClaimResult& result) {
  const Decision& decision = result.decision;
  if (decision.verdict == Verdict::refuted) return "6 refutation";
  if (decision.verdict != Verdict::proved && decision.verdict != Verdict::proved_if)
    return "7 no verdict, or a derivation without a unique solution";
  if (std::holds_alternative<DeriveClaim>(result.claim.kind)) return "4 derivation";
  if (std::holds_alternative<MinimumClaim>(result.claim.kind)) return "5 minimum";
  const Goal& goal = std::get<IdentityClaim>(result.claim.kind).goal;
  if (has_order(goal.statements)) return "3 order: <, <=, >, >=";
  if (has_inequality(goal.statements)) return "3 inequality: !=";
  return decision.assumptions_used.empty() ? "1 equation" : "2 equation under assumptions";
}

void count(const std::string& kind, const std::string& why_not, CertifiedCounts& counts) {
  CertifiedCount& total = counts[kind];
  if (why_not.empty())
    ++total.theorems;
  else
    ++total.missing[why_not];
}

}  // namespace

void count_certified(const CaseResult& result, CertifiedCounts& counts) {
  std::vector<Certificate> certificates;
  std::vector<std::string> kinds;
  for (const ClaimResult& claim : result.claims) {
    const std::string kind = kind_of(claim);
    ++counts[kind].claims;
    const auto found = certificate(claim, result.verified.name, result.verified.limits);
    if (const auto* missing = std::get_if<NotCertified>(&found)) {
      count(kind, missing->why, counts);
      continue;
    }
    ++counts[kind].certificates;
    certificates.push_back(std::get<Certificate>(found));
    kinds.push_back(kind);
  }
  const RocqFile file = rocq_file(result.verified, certificates);
  for (std::size_t k = 0; k < kinds.size(); ++k) count(kinds[k], file.theorems[k].why_not, counts);
}

std::string certified_table(const CertifiedCounts& counts) {
  std::string table = "| kind of claim | claims | with a certificate | with a theorem in Rocq |\n"
                      "|---|---|---|---|\n";
  CertifiedCount all;
  std::map<std::string, std::size_t> reasons;
  const auto row = [](const std::string& name, const CertifiedCount& of) {
    return "| " + name + " | " + std::to_string(of.claims) + " | " +
           std::to_string(of.certificates) + " | " + std::to_string(of.theorems) + " |\n";
  };
  for (const auto& [kind, of] : counts) {
    table += row(kind.substr(2), of);
    all.claims += of.claims;
    all.certificates += of.certificates;
    all.theorems += of.theorems;
    for (const auto& [reason, number] : of.missing) reasons[reason] += number;
  }
  table += row("all", all) + "\nWhy the others have none:\n\n";
  for (const auto& [reason, number] : reasons)
    table += "* " + reason + ": " + std::to_string(number) + "\n";
  return table;
}

}  // namespace patchproof::test
