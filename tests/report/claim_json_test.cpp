#include <catch2/catch.hpp>

#include <patchproof/patchproof.hpp>
#include <patchproof/report/claim_json.hpp>
#include <patchproof/report/merge.hpp>

namespace patchproof {

namespace {

const std::string text =
    "case c\n  param u, v in [0, 1]\n  scalar a, b, x, y\n  point V[0..1]\n"
    "  assume apart: a != b\n  patch r(u, v) = (u, v, u*v)\n"
    "  prove quotient: (a^2 - b^2)/(a - b) == a + b\n  prove wrong: a == b\n"
    "  prove bound: u^2 - u + 1 > 0\n  derive free: x, y from x + y == a gives 0, a\n"
    "  derive none: x from 0*x == 1 inconsistent\n"
    "  erratum e\n    printed a == b\n    corrected a == a\n    note \"a slip\"\n  end\n"
    "  prove conditional: a*x/x == a\n"
    "  show a + a\n  show joint of r at u = 0 and r at u = 1\nend\n"
    "case d\n  scalar a\n  prove missing: a ==\nend\n";

/// The cases of the first of these files.
std::vector<CaseRecord> cases_of(const RunRecord& run) {
  std::vector<CaseRecord> cases;
  run.files.for_each([&](const FileRecord& file) {
    if (cases.empty()) cases = file.cases;
  });
  return cases;
}

}  // namespace

TEST_CASE("claims that were read back are written as they were", "[law]") {
  const RunRecord run = record_of(check({{"a.proof", text, ""}, {"b.proof", std::nullopt, "why"}}));
  std::size_t claims = 0;
  for (const CaseRecord& of : cases_of(run)) {
    for (const ClaimRecord& claim : of.claims) {
      const Json object = to_json(claim, of.name);
      CHECK(to_json(claim_from(object), of.name) == object);
      ++claims;
    }
    for (const ShownRecord& shown : of.shown)
      CHECK(to_json(shown_from(to_json(shown, of.name)), of.name) == to_json(shown, of.name));
  }
  CHECK(claims >= 5);
  const std::string written_run = written(run, "json", {});
  const ReadReport back = report_from_json("r", written_run);
  CHECK(written(back.run, "json", {}) == written_run);
  CHECK(exit_code(back.run) == exit_code(run));
}

TEST_CASE("what no report says is not read") {
  const RunRecord run = record_of(check({{"a.proof", text, ""}}));
  const Json good = to_json(cases_of(run).front().claims.front(), "c");
  for (const auto& [member, value] : {std::pair{"verdict", Json("TRUE")},
                                      {"outcome", Json("well")},
                                      {"evidence", Json("hearsay")},
                                      {"line", Json("one")},
                                      {"conditions", Json("a")},
                                      {"expectation", Json(nullptr)}}) {
    Json bad = good;
    bad[member] = value;
    INFO(member);
    CHECK_THROWS(claim_from(bad));
  }
  Json better = to_json(cases_of(run).front().claims.at(1), "c");
  REQUIRE(better["outcome"] == "wrong");
  better["outcome"] = "as_expected";
  CHECK_THROWS_WITH(claim_from(better), "the outcome of 'c.wrong' does not fit its verdict");
  Json less = good;
  less.erase("verdict");
  CHECK_THROWS(claim_from(less));
}

TEST_CASE("an audit that nobody could make is no success") {
  FileRecord file{"a.proof", "", {}, {}};
  file.cases =
      cases_of(record_of(check({{"a.proof", "case c\n  scalar a\n  prove p: a == a\nend\n", ""}})));
  file.cases.front().audit = lost_audit("c", "crash: ended by signal 9 (Killed)");
  RunRecord run;
  run.files.push_back(file);
  CHECK(exit_code(run) == ExitCode::unknown);
  CHECK(written(run, "text", {}).find("assumptions of c were not looked at: crash") !=
        std::string::npos);
  const ReadReport back = report_from_json("r", written(run, "json", {}));
  CHECK(exit_code(back.run) == ExitCode::unknown);
}

}  // namespace patchproof
