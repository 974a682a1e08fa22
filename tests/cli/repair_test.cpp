#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string wrong =
    "case wrong\n  scalar a, b\n  prove square: (a+b)^2 == a^2 - 2*a*b + b^2\nend\n";

Ended repair(const std::string& text, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"repair", "-"});
  return run_program(TemporaryFolder{}, options, text);
}

Ended audit(const std::string& text, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"check", "--audit", "-"});
  return run_program(TemporaryFolder{}, options, text);
}

}  // namespace

TEST_CASE("repair shows what is written, what would be true, and what changed; it ends with 0") {
  const Ended ended = repair(wrong);
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output ==
        "<stdin>:3:17: wrong.square: 3 repairs of 1 change\n"
        "  - (a+b)^2 == a^2 - 2*a*b + b^2\n"
        "  + (-a+b)^2 == a^2 - 2*a*b + b^2\n"
        "     ^\n"
        "    added - (sign): PROVED, by both engines\n"
        "  + (a-b)^2 == a^2 - 2*a*b + b^2\n"
        "      ^\n"
        "    + -> - (sign): PROVED, by both engines\n"
        "  + (a+b)^2 == a^2 + 2*a*b + b^2\n"
        "                   ^\n"
        "    - -> + (sign): PROVED, by both engines\n"
        "\n"
        "1 false statement: 1 with a repair, 0 without\n");
}

TEST_CASE("a statement without repair makes repair end with 1, a stopped search with 2") {
  const std::string far = "case far\n  scalar a\n  refute one: a == a^3 + 5\nend\n";
  const Ended none = repair(far, {"--most", "1"});
  CHECK(none.code == 1);
  CHECK(none.output ==
        "<stdin>:3:15: far.one: no repair: no change of at most 1 place makes it true\n"
        "  - a == a^3 + 5\n"
        "\n"
        "1 false statement: 0 with a repair, 1 without\n");
  const Ended stopped = repair(far, {"--candidates", "3"});
  CHECK(stopped.code == 2);
  CHECK(stopped.output.find("far.one: no repair: stopped after 3 changed statements\n") !=
        std::string::npos);
}

TEST_CASE("where nothing is false there is nothing to repair, and repair ends with 5") {
  const Ended ended = repair("case a\n  scalar a\n  prove one: a == a\nend\n");
  CHECK(ended.code == 5);
  CHECK(ended.output == "no false statement\n");
}

TEST_CASE("repair does only what --only selects") {
  const std::string two =
      "case two\n  scalar a\n  refute one: a + a == 3*a\n  refute other: a - a == a\nend\n";
  const Ended ended = repair(two, {"--only", "two.one"});
  CHECK(ended.output.find("two.one: ") != std::string::npos);
  CHECK(ended.output.find("two.other") == std::string::npos);
  const Ended nothing = repair(two, {"--only", "three"});
  CHECK(nothing.code == 5);
  CHECK(nothing.errors == "patchproof: no claim matches --only 'three'\n");
}

TEST_CASE("repair as JSON", "[literature]") {
  const Ended ended = repair(wrong, {"--format", "json"});
  const auto document = nlohmann::json::parse(ended.output);
  CHECK(document["exit"] == 0);
  const auto& statement = document["statements"][0];
  CHECK(statement["id"] == "wrong.square");
  CHECK(statement["line"] == 3);
  CHECK(statement["outcome"] == "found");
  CHECK(statement["repairs"][2]["text"] == "(a+b)^2 == a^2 + 2*a*b + b^2");
  CHECK(statement["repairs"][2]["changes"][0] ==
        nlohmann::json({{"what", "sign"}, {"offset", 15}, {"old", "-"}, {"new", "+"}}));
  CHECK(statement["repairs"][2]["evidence"] == "both engines");
}

TEST_CASE("repair refuses what makes no sense", "[reject]") {
  CHECK(repair(wrong, {"--most", "0"}).errors ==
        "patchproof repair: --most: from 1 to 3 changes can be tried\n"
        "  = help: 'patchproof repair --help' shows what can be said\n");
  CHECK(repair(wrong, {"--most", "0"}).code == 64);
  const Ended nothing = run_program(TemporaryFolder{}, {"repair"});
  CHECK(nothing.code == 64);
  CHECK(nothing.errors ==
        "patchproof repair: nothing to repair: name files or folders, or '-' for standard input\n"
        "  = help: 'patchproof repair --help' shows what can be said\n");
  const Ended mistake = repair("case a\n  prove one: x == 1\nend\n");
  CHECK(mistake.code == 4);
  CHECK(mistake.errors.find("<stdin>:2:14: error: unknown name 'x'\n") == 0);
}

TEST_CASE("the audit says what each claim needs") {
  const Ended ended = audit(
      "case a\n  scalar x, y, z\n  assume same: x == y\n  assume far: x == 3*z note \"from the "
      "book\"\n  prove one: 2*x == x + y\nend\n");
  CHECK(ended.code == 0);
  CHECK(ended.output ==
        "  a.one  PROVED\n"
        "\n"
        "assumptions of a\n"
        "  one  same necessary, far unneeded\n"
        "      without same false for y = 1; all others 0: left side 0, right side 1\n"
        "  = same: needed by one\n"
        "  = far: stays: from the book\n"
        "\n"
        "1 claim in 1 case: 1 as expected (1 proved)\n");
}

TEST_CASE("an assumption that nothing needs is shown, and the audit ends with 1") {
  const Ended ended = audit(
      "case a\n  scalar x, y\n  assume spare: x == 1\n  prove one: x + y == y + x\nend\n", {"-q"});
  CHECK(ended.code == 1);
  CHECK(ended.output ==
        "<stdin>:3:3: a: nothing needs 'spare'\n"
        "     3 |   assume spare: x == 1\n"
        "       |   ^^^^^^^^^^^^^^^^^^^^\n"
        "       = help: leave it out, or say why it stays: assume ... note \"why\"\n"
        "\n"
        "1 claim in 1 case: 1 as expected (1 proved)\n");
}

TEST_CASE("the audit as JSON, which is not there unless it was asked for") {
  const std::string text =
      "case a\n  scalar x, y\n  assume same: x == y\n  refute one: x == 2*y\nend\n";
  const auto document = nlohmann::json::parse(audit(text, {"--format", "json"}).output);
  const auto& found = document["audits"][0];
  CHECK(found["case"] == "a");
  CHECK(found["claims"][0]["assumptions"][0]["need"] == "kept");
  CHECK(found["assumptions"][0]["status"] == "kept");
  CHECK(found["assumptions"][0]["kept_by"][0] == "one");
  const Ended plain = run_program(TemporaryFolder{}, {"check", "-", "--format", "json"}, text);
  CHECK_FALSE(nlohmann::json::parse(plain.output).contains("audits"));
}

}  // namespace patchproof
