#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

// Right and wrong agree at x = 0.
const std::string hidden =
    "case hidden\n  let x = 0\n  let y = x^2 + 1\n  prove value: y == 1\n  prove sum: y - x == 1\n"
    "end\n";

const std::string sharp =
    "case sharp\n  scalar a, b\n  prove square: (a+b)^2 == a^2 + 2*a*b + b^2\n"
    "end\n";

Ended mutate(const std::string& text, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"mutate", "-"});
  return run_program(TemporaryFolder{}, options, text);
}

}  // namespace

TEST_CASE("mutate shows what goes unnoticed, why, and what would show it; it ends with 1") {
  const Ended ended = mutate(hidden, {"--only", "hidden.sum"});
  CHECK(ended.code == 1);
  CHECK(ended.errors == "");
  CHECK(ended.output ==
        "<stdin>:5:14: hidden.sum: 2 of 7 changes not noticed\n"
        "     5 |   prove sum: y - x == 1\n"
        "       |              ^^^^^^^^^^\n"
        "  <stdin>:5:15: x left out: says the same for these data: x\n"
        "  <stdin>:5:16: sign of x: says the same for these data: x\n"
        "\n"
        "hidden: the data hide 2 changes\n"
        "  = try: with x = 1 in place of 0: then 2 of 2 are noticed, but these have to be put right: value\n"
        "\n"
        "7 changes in 1 case: 5 noticed, 2 not noticed\n");
}

TEST_CASE("where every change is noticed mutate ends with 0") {
  const Ended ended = mutate(sharp);
  CHECK(ended.code == 0);
  CHECK(ended.output.find(" noticed, 0 not noticed") != std::string::npos);
  CHECK(ended.output.find('\n') == ended.output.size() - 1);
}

TEST_CASE("of very many changes in one part the first are listed") {
  // A square that is false whatever is changed in it.
  std::string sum = "0";
  for (int k = 0; k < 20; ++k) sum += " + x^" + std::to_string(k);
  const std::string text =
      "case many\n  scalar x\n  let s = " + sum + "\n  refute zero: s == x^100\nend\n";
  const Ended ended = mutate(text);
  CHECK(ended.output.find("  and 23 more, which --verbose lists\n") != std::string::npos);
  CHECK(mutate(text, {"-v"}).output.find("more, which --verbose lists") == std::string::npos);
}

TEST_CASE("what says the same is counted, and listed by --verbose only") {
  const std::string same =
      "case same\n  point P, Q in R^2\n  prove dots: dot(P, Q) == -dot(P, -Q)\nend\n";
  const Ended quiet = mutate(same);
  CHECK(quiet.code == 0);
  CHECK(quiet.output == "8 changes in 1 case: 6 noticed, 0 not noticed, 2 say the same\n");
  const Ended verbose = mutate(same, {"-v"});
  CHECK(verbose.output.find("  <stdin>:3:19: P and Q exchanged in dot(P, Q): says the same\n") !=
        std::string::npos);
}

TEST_CASE("data no claim depends on are listed, with symbols for them") {
  const Ended ended =
      mutate("case free\n  let x = 7\n  prove square: (x + 1)^2 == x^2 + 2*x + 1\nend\n");
  CHECK(ended.code == 1);
  CHECK(ended.output.find("free: no claim notices changes of these data\n"
                          "  <stdin>:2:7: x = 7\n"
                          "  = try: all claims hold for symbols as well: scalar x\n") !=
        std::string::npos);
}

TEST_CASE("claims that are not decided within the limits are no use, and mutate ends with 2") {
  const std::string text =
      "case much\n  scalar a, b, c\n  limit terms 10\n"
      "  prove power: (a + b + c)^9/a == (a + b + c)^8*(a + b + c)/a\n  prove one: a == a\nend\n";
  const Ended ended = mutate(text);
  CHECK(ended.code == 2);
  CHECK(ended.output.find("much: not decided within the limits, so of no use here: power\n") == 0);
}

TEST_CASE("a change that is not decided within the limits is not counted as noticed") {
  const Ended ended = mutate(
      "case near\n  scalar a, b\n  limit terms 20\n"
      "  prove power: (a + b)^9/a == (a + b)^8*(a + b)/a\nend\n");
  CHECK(ended.code == 2);
  CHECK(ended.output.find("  <stdin>:4:24: 9 -> 10: not decided within the limits\n") !=
        std::string::npos);
}

TEST_CASE("claims that are wrong without any change are named, and mutate ends with 1") {
  const Ended ended =
      mutate("case wrong\n  scalar a\n  prove same: a == 2*a\n  prove good: a + a == 2*a\nend\n");
  CHECK(ended.code == 1);
  CHECK(ended.output.find("wrong: not as expected without any change, so of no use here: same\n") ==
        0);
}

TEST_CASE("mutate as JSON") {
  const Ended ended = mutate(hidden, {"--format", "json"});
  const auto document = nlohmann::json::parse(ended.output);
  CHECK(document["exit"] == 1);
  const auto& of = document["cases"][0];
  CHECK(of["case"] == "hidden");
  const auto& sum = of["parts"][3];
  CHECK(sum["name"] == "sum");
  CHECK(sum["kind"] == "claim");
  CHECK(sum["line"] == 5);
  REQUIRE(sum["changes"].size() == 7);
  CHECK(sum["changes"][0]["fate"] == "noticed");
  const auto& left_out = sum["changes"][3];
  CHECK(left_out["change"] == "x left out");
  CHECK(left_out["fate"] == "survives");
  CHECK(left_out["why"] == "data");
  CHECK(left_out["data"] == nlohmann::json::array({"x"}));
  CHECK(of["better"][0]["data"] == "x = 3 in place of 0");
  CHECK(document["summary"]["unnoticed"] == 5);
}

TEST_CASE("two runs of mutate give the same bytes", "[law]") {
  CHECK(mutate(hidden).output == mutate(hidden).output);
  CHECK(mutate(hidden, {"--format", "json"}).output == mutate(hidden, {"--format", "json"}).output);
}

TEST_CASE("mutate refuses what makes no sense", "[reject]") {
  const std::string help = "\n  = help: 'patchproof mutate --help' shows what can be said\n";
  CHECK(mutate(sharp, {"--most", "0"}).errors ==
        "patchproof mutate: --most: at least 1 change has to be tried" + help);
  CHECK(mutate(sharp, {"--most", "0"}).code == 64);
  const Ended nothing = run_program(TemporaryFolder{}, {"mutate"});
  CHECK(nothing.code == 64);
  CHECK(nothing.errors ==
        "patchproof mutate: nothing to change: name files or folders, or '-' for standard input" +
            help);
  const Ended mistake = mutate("case a\n  prove one: x == 1\nend\n");
  CHECK(mistake.code == 4);
  CHECK(mistake.errors.find("<stdin>:2:14: error: unknown name 'x'\n") == 0);
  const Ended unmatched = mutate(sharp, {"--only", "other"});
  CHECK(unmatched.code == 5);
  CHECK(unmatched.errors == "patchproof: no claim matches --only 'other'\n");
  CHECK(unmatched.output == "nothing to change\n");
}

}  // namespace patchproof
