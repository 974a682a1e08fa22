#include <catch2/catch.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

// 2*3 = x, for a number x.
std::string document(const std::string& x) {
  return R"({"format": "patchproof certificate", "version": 1, "program": "by hand", "case": "t",
    "certificates": [{"claim": "t.product", "statement": "2*3 == )" +
         x + R"(", "symbols": [], "nodes": [
      {"operation": "number", "value": "2"}, {"operation": "number", "value": "3"},
      {"operation": "product", "children": [0, 1]}, {"operation": "number", "value": ")" +
         x + R"("}, {"operation": "pi"}],
      "proofs": [{"sequent": {"hypotheses": [], "ranges": [],
          "conclusions": [{"left": 2, "relation": "==", "right": 3}]},
        "components": [{"conclusion": 0, "component": 0, "equation": []}],
        "not_zero": [], "divisors": []}]}]})";
}

Ended recheck(const std::string& text) {
  return run_program(TemporaryFolder{}, {"recheck", "-"}, text);
}

}  // namespace

TEST_CASE("recheck says of every certificate what became of it, and ends with 0") {
  const Ended ended = recheck(document("6"));
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output ==
        "  t.product  RECHECKED\n"
        "\n"
        "1 certificate in 1 file: 1 rechecked, 0 rejected, 0 unknown\n");
}

TEST_CASE("recheck ends with 1 when a certificate is rejected, with 2 when one is unknown") {
  const Ended rejected = recheck(document("7"));
  CHECK(rejected.code == 1);
  CHECK(rejected.output ==
        "! t.product  REJECTED (proofs[0].components[0]: left - right is not the sum: -1 is left)\n"
        "\n"
        "1 certificate in 1 file: 0 rechecked, 1 rejected, 0 unknown\n");
  std::string pi = document("6");
  pi.replace(pi.find("\"right\": 3"), 10, "\"right\": 4");
  const Ended unknown = recheck(pi);
  CHECK(unknown.code == 2);
  CHECK(unknown.output ==
        "? t.product  UNKNOWN (proofs[0].sequent: pi)\n"
        "\n"
        "1 certificate in 1 file: 0 rechecked, 0 rejected, 1 unknown\n");
}

TEST_CASE("recheck reads several files, and ends with 4 when one cannot be read", "[reject]") {
  const TemporaryFolder folder;
  folder.write("good.json", document("6"));
  folder.write("bad.json", "{}");
  const Ended ended = run_program(folder, {"recheck", "good.json", "bad.json", "none.json", "."});
  CHECK(ended.code == 4);
  CHECK(ended.output ==
        "  t.product  RECHECKED\n"
        "\n"
        "1 certificate in 4 files: 1 rechecked, 0 rejected, 0 unknown\n");
  CHECK(ended.errors ==
        "bad.json: the member 'format' is missing\n"
        "none.json: the file cannot be read\n"
        ".: the file cannot be read\n");
}

TEST_CASE("recheck without certificates ends with 5, without files with 64", "[reject]") {
  const Ended nothing = recheck(
      R"({"format": "patchproof certificate", "version": 1, "program": "", "case": "t",
          "certificates": []})");
  CHECK(nothing.code == 5);
  CHECK(nothing.output == "0 certificates in 1 file: 0 rechecked, 0 rejected, 0 unknown\n");
  const Ended usage = run_program(TemporaryFolder{}, {"recheck"});
  CHECK(usage.code == 64);
  CHECK(usage.errors ==
        "patchproof recheck: nothing to recheck: name files, or '-' for standard input\n"
        "  = help: 'patchproof recheck --help' shows what can be said\n");
}

TEST_CASE("Control characters in names do not reach a terminal") {
  std::string text = document("7");
  text.replace(text.find("t.product"), 9, "t.\\u001b[31m");
  CHECK(recheck(text).output.starts_with("! t.?[31m  REJECTED"));
}

}  // namespace patchproof
