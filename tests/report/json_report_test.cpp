#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <patchproof/report/formats.hpp>
#include <patchproof/version.hpp>

#include "report_test.hpp"

namespace patchproof {

using Json = nlohmann::ordered_json;

namespace {

Json document_of(const Report& report) { return Json::parse(written(report, "json", {})); }

}  // namespace

TEST_CASE("The JSON report has the members the documentation names, in this order") {
  ClaimResult refuted = result_of("one", Expectation::refute, Verdict::refuted, "[i=0]");
  refuted.decision.witness = {{{"u", "1/2"}, {"v", "0"}}, {}, "1/4", "0", ".x"};
  refuted.decision.residual = "u^2";
  const Json document = document_of(report_of({refuted}));
  std::vector<std::string> members;
  for (const auto& [name, value] : document.items()) members.push_back(name);
  CHECK(members == std::vector<std::string>{"version", "strict", "claims", "shown", "diagnostics",
                                            "unreadable", "summary", "exit"});
  CHECK(document["version"] == std::string{version});
  CHECK(document["exit"] == 0);
  const Json& claim = document["claims"][0];
  CHECK(claim["id"] == "a.one[i=0]");
  CHECK(claim["file"] == "a.proof");
  CHECK(claim["line"] == 3);
  CHECK(claim["column"] == 3);
  CHECK(claim["statement"] == "x == y");
  CHECK(claim["expectation"] == "refute");
  CHECK(claim["verdict"] == "REFUTED");
  CHECK(claim["as_expected"] == true);
  CHECK(claim["evidence"] == "none");
  CHECK(claim["conditions"] == Json::array());
  CHECK(claim["witness"].dump() ==
        R"({"values":[{"name":"u","value":"1/2"},{"name":"v","value":"0"}],)"
        R"("left":"1/4","right":"0","component":".x"})");
  CHECK(claim["residual"] == "u^2");
  CHECK(claim["assumptions_used"] == Json::array());
  CHECK(claim["derived"] == Json::array());
}

TEST_CASE("What does not apply is null in the JSON report") {
  const Json claim =
      document_of(report_of({result_of("one", Expectation::prove, Verdict::proved)}))["claims"][0];
  for (const char* member : {"instance", "reason", "witness", "subdivision", "residual", "note"}) {
    INFO(member);
    CHECK(claim[member].is_null());
  }
}

TEST_CASE("The JSON report says how many boxes an inequality needed, and what a joint is") {
  ClaimResult proved = result_of("one", Expectation::prove, Verdict::proved);
  proved.decision.subdivision = {7, 4};
  Report report = report_of({proved});
  JointReport joint;
  joint.parametric = 1;
  joint.geometric = 2;
  joint.next_parametric = "not C^2: left - right = u";
  report.files.front().cases.front().shown.push_back({{}, "", "", in_words(joint), joint});
  const Json document = document_of(report);
  CHECK(document["claims"][0]["subdivision"].dump() == R"({"boxes":7,"depth":4})");
  CHECK(document["shown"][0]["value"] == "C^1, G^2; not C^2: left - right = u");
  CHECK(document["shown"][0]["joint"].dump() ==
        R"({"parametric":1,"one_polynomial":false,"geometric":2,)"
        R"("next_parametric":"not C^2: left - right = u","next_geometric":null,"conditions":[]})");
}

TEST_CASE("Mistakes and unreadable paths are in the JSON report") {
  Report report;
  report.files.push_back({"a.proof", "", {{span_of("scalar"), "wrong", "do this"}}, {}});
  report.files.push_back({"b.proof", "No such file or directory", {}, {}});
  const Json document = document_of(report);
  CHECK(document["diagnostics"].dump() ==
        R"([{"file":"a.proof","line":2,"column":3,"message":"wrong","help":"do this"}])");
  CHECK(document["unreadable"].dump() ==
        R"([{"path":"b.proof","message":"No such file or directory"}])");
  CHECK(document["summary"]["mistakes"] == 1);
  CHECK(document["exit"] == 4);
}

TEST_CASE("Invalid bytes in a name do not make the JSON report invalid") {
  Report report;
  report.files.push_back({"\xff.proof", "no", {}, {}});
  CHECK(document_of(report)["unreadable"][0]["path"] == "\xEF\xBF\xBD.proof");
}

TEST_CASE("A format that does not exist is refused", "[reject]") {
  CHECK_THROWS_WITH(written(Report{}, "xml", {}), "there is no format 'xml'");
}

}  // namespace patchproof
