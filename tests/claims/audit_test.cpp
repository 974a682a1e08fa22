#include <catch2/catch.hpp>
#include <memory>

#include <patchproof/claims/audit.hpp>
#include <patchproof/language/reader.hpp>

namespace patchproof {

namespace {

CaseAudit audit_of(const std::string& statements) {
  const auto source =
      std::make_shared<const SourceText>(SourceText{"a.proof", "case a\n" + statements + "end\n"});
  const ReadFile file =
      read_cases(source, Limits{}, [](const std::string&) { return std::optional<std::string>{}; });
  REQUIRE(file.diagnostics.empty());
  const Case& given = file.cases.at(0);
  return audited(given, verified(given, {}));
}

// "south: p necessary, q unneeded"
std::string needs(const CaseAudit& audit, const std::string& label) {
  std::string text;
  for (const ClaimAudit& claim : audit.claims)
    if (claim.label == label)
      for (const AssumptionUse& use : claim.uses)
        text += (text.empty() ? "" : ", ") + use.name + " " + to_text(use.need);
  return text;
}

std::string status(const CaseAudit& audit, const std::string& name) {
  for (const AssumptionAudit& assumption : audit.assumptions)
    if (assumption.name == name) return to_text(assumption.status);
  return "";
}

}  // namespace

TEST_CASE("an assumption is necessary when the claim is false without it") {
  const CaseAudit audit = audit_of(
      "  scalar a, b, c\n  assume p: a == b\n  assume q: b == c\n  prove one: a == b\n"
      "  prove two: a == c\n");
  CHECK(needs(audit, "one") == "p necessary, q unneeded");
  CHECK(needs(audit, "two") == "p necessary, q necessary");
  CHECK(audit.claims[0].uses[0].witness.left != audit.claims[0].uses[0].witness.right);
  CHECK(status(audit, "p") == "needed");
  CHECK(status(audit, "q") == "needed");
}

TEST_CASE("an assumption is needed when the proof does not go through without it") {
  // Without x != 0 the claim holds under a condition, which is less.
  const CaseAudit audit = audit_of("  scalar x\n  assume n: x != 0\n  prove one: x/x == 1\n");
  CHECK(needs(audit, "one") == "n needed");
}

TEST_CASE("what no claim needs is flagged, unless its author says why it is there") {
  const std::string claims = "  prove one: a + b == b + a\n";
  CHECK(status(audit_of("  scalar a, b\n  assume p: a == 1\n" + claims), "p") == "flagged");
  CHECK(status(audit_of("  scalar a, b\n  assume p: a == 1 note \"later\"\n" + claims), "p") ==
        "noted");
  CHECK(status(audit_of("  scalar a, b\n  assume a == 1, b == 2\n" + claims), "assumption 2") ==
        "flagged");
}

TEST_CASE("of assumptions that can stand in for each other one is needed") {
  const CaseAudit audit = audit_of(
      "  scalar x, y\n  assume p: x == 1\n  assume q: y == x\n  assume r: y == 1\n"
      "  prove one: y == 1\n");
  std::size_t needed = 0;
  for (const AssumptionAudit& assumption : audit.assumptions)
    needed += assumption.status == AssumptionAudit::Status::needed ? 1U : 0U;
  CHECK(needed >= 1);
  CHECK(needed < 3);
}

TEST_CASE("a refuted claim is false even under the assumptions that speak of the same") {
  const CaseAudit audit = audit_of(
      "  scalar a, b, c, d\n  assume p: a == b\n  assume q: c == 1\n  refute one: a == d\n");
  CHECK(needs(audit, "one") == "p kept, q unrelated");
  CHECK(status(audit, "p") == "kept");
  CHECK(status(audit, "q") == "flagged");
}

TEST_CASE("assumptions speak of the same through others, in whatever order they stand") {
  const CaseAudit audit = audit_of(
      "  scalar a, b, c, d, e\n  assume r: c == d\n  assume q: b == c\n  assume p: a == b\n"
      "  assume s: e == 1\n  refute one: a == 0\n");
  CHECK(needs(audit, "one") == "r kept, q kept, p kept, s unrelated");
}

TEST_CASE("a parameter in common does not relate equations, but inequalities") {
  const CaseAudit audit = audit_of(
      "  param u in [0, 1]\n  scalar f(t), g(t) : C^0\n  assume p: f(u) == 1\n"
      "  assume h: 2*u <= 1\n  refute one: g(u) == u\n");
  CHECK(needs(audit, "one") == "p unrelated, h kept");
}

TEST_CASE("an assumption needed in one instance of a family is needed") {
  const CaseAudit audit = audit_of(
      "  family n in 1..2\n  scalar a, b\n  assume p: a == b\n  prove one: (n-1)*a == (n-1)*b\n");
  CHECK(needs(audit, "one") == "p necessary");
  CHECK(audit.assumptions.size() == 1);
}

TEST_CASE("a derivation needs the assumptions without which its solution is another one") {
  const CaseAudit audit = audit_of(
      "  scalar x, a, b, c\n  assume p: a == b\n  assume q: c == 2\n"
      "  derive one: x from x == a gives b\n  prove two: x == b using one\n");
  CHECK(needs(audit, "one") == "p necessary, q unneeded");
  CHECK(status(audit, "q") == "flagged");
}

TEST_CASE("a minimum may need assumptions like any other claim") {
  const CaseAudit audit = audit_of(
      "  param t in [0, 1]\n  scalar x, y, q[0..2]\n  curve p(t) = bezier(q)\n"
      "  let L(q) = integral(q_t^2, t in [0, 1])\n  assume spare: x == 1\n  assume end: y == 1\n"
      "  prove one: t minimizes L(p) over p where p(0) == 0, p(1) == y\n");
  CHECK(needs(audit, "one").starts_with("spare unneeded, end "));
  CHECK(status(audit, "spare") == "flagged");
  CHECK(status(audit, "end") == "needed");
}

TEST_CASE("nothing is flagged while a claim is undecided or was not looked at") {
  const std::string text =
      "  scalar x\n  assume p: x == 1\n  open one: sqrt(x^2)*sqrt(x^2+1) == sqrt(x^4+x^2)\n";
  const CaseAudit audit = audit_of(text);
  CHECK(status(audit, "p") != "flagged");
}

}  // namespace patchproof
