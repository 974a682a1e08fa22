// Certificates in which something was changed are not accepted by coqc: a statement that is not the
// claim, proof data that are not the proof.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "cli/program.hpp"

namespace patchproof {

namespace {

const std::string proof =
    "case c\n  param u, v in [0, 1]\n  scalar a, b, x\n  curve C1(u), C2(u) : C^2\n"
    "  assume closed: C1(0) == C2(0)\n  assume apart: a != b\n"
    "  patch r(u, v) = (1-v)*C1(u) + v*C2(u)\n"
    "  prove identity: r(u,0) == C1(u)\n"
    "  prove hypothesis: r(0,v) == 3*C1(0) - 2*C1(0)\n"
    "  prove derivative: r_uv(u,v) == C2'(u) - C1'(u)\n"
    "  prove quotient: (a^2 - b^2)/(a - b) == a + b\n"
    "  prove bound: u^2 - u + 1 > 0\n"
    "  prove square: a^2 - 2*a*b + b^2 >= 0\n"
    "  prove integral: integral(u*v, u in [0, 1], v in [0, 1]) == 1/4\n"
    "  refute false: r(u,1) == C1(u)\n"
    "  derive half: x from 2*x == a gives a/2\n"
    "end\n";

struct Change {
  const char* what;
  const char* old_text;
  const char* new_text;
};

const Change changes[] = {
    {"a sign in a definition", "(1 - v) * C1 u + v * C2 u", "(1 - v) * C1 u - v * C2 u"},
    {"u and v exchanged in a definition", "(1 - v) * C1 u", "(1 - u) * C1 v"},
    {"an argument in a statement", "r C1 C2 u 0 = C1 u", "r C1 C2 u 1 = C1 u"},
    {"another side in a statement", "r C1 C2 u 0 = C1 u", "r C1 C2 u 0 = C2 u"},
    {"a coefficient in a statement", "3 * C1 0 - 2 * C1 0", "3 * C1 0 - C1 0"},
    {"the smoothness left out", "  smooth 2 C2 ->\n", ""},
    {"a hypothesis left out", "  (a <> b) ->\n", ""},
    {"a number in a statement", "= 1 / 4", "= 1 / 5"},
    {"a strict sign made wrong", "> 0.\nTheorem certified_bound", "> 1.\nTheorem certified_bound"},
    {"not refuted", "~ claim_false", "claim_false"},
    {"another value derived", "x = a / 2", "x = a / 3"},
};

bool accepted(const TemporaryFolder& folder, const std::string& text) {
  folder.write("out/c.v", text);
  const std::string command =
      "cd '" + folder.path("out") +
      "' && coqc -q -w -ambiguous-paths,-notation-overridden -Q PatchProof PatchProof c.v "
      ">c.log 2>&1";
  return std::system(command.c_str()) == 0;
}

}  // namespace

TEST_CASE("coqc accepts no certificate in which a statement or its proof was changed") {
  if (!std::filesystem::exists("/usr/bin/coqc")) return;
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Ended ended = run_program(folder, {"certify", "a.proof", "-o", "out", "--check"});
  INFO(ended.output << ended.errors);
  REQUIRE(ended.code == 0);
  const std::string text = folder.text("out/c.v");
  REQUIRE(accepted(folder, text));
  for (const Change& change : changes) {
    INFO(change.what);
    const std::size_t place = text.find(change.old_text);
    REQUIRE(place != std::string::npos);
    std::string changed = text;
    changed.replace(place, std::string{change.old_text}.size(), change.new_text);
    CHECK_FALSE(accepted(folder, changed));
  }
}

TEST_CASE("coqc accepts no certificate in which a number of the proof data was changed") {
  if (!std::filesystem::exists("/usr/bin/coqc")) return;
  const TemporaryFolder folder;
  folder.write("a.proof",
               "case c\n  param u in [0, 1]\n  scalar a, b\n  assume h: a == 2*b\n"
               "  prove equation: a^2 == 4*b^2\n  prove bound: 3*u^2 - 3*u + 1 > 0\nend\n");
  REQUIRE(run_program(folder, {"certify", "a.proof", "-o", "out", "--check"}).code == 0);
  const std::string text = folder.text("out/c.v");
  int changed_numbers = 0;
  // Every coefficient of a summand, and every whole number of a cofactor.
  for (const std::string mark : {"Summand (", "reasons\n    [(Add (Var 1) (Mul (Int ("}) {
    for (std::size_t at = text.find(mark); at != std::string::npos && changed_numbers < 8;
         at = text.find(mark, at + 1)) {
      const std::size_t digit = at + mark.size();
      std::string changed = text;
      changed[digit] = changed[digit] == '9' ? '8' : static_cast<char>(changed[digit] + 1);
      INFO(changed.substr(at, 60));
      CHECK_FALSE(accepted(folder, changed));
      ++changed_numbers;
    }
  }
  CHECK(changed_numbers >= 3);
}

TEST_CASE("coqc accepts no changed cofactor of equations that are checked together") {
  if (!std::filesystem::exists("/usr/bin/coqc")) return;
  std::string text = "case c\n  scalar x";
  for (int k = 1; k <= 8; ++k) text += ", a" + std::to_string(k);
  for (int k = 1; k <= 8; ++k)
    text += "\n  assume h" + std::to_string(k) + ": a" + std::to_string(k) + " == x";
  text +=
      "\n  prove both: [a1 + a2 + a3 + a4 + a5 + a6 + a7 + a8, 2*a1 + 3*a2 + a3 + a4 + a5 + a6 + "
      "a7 + a8] == [8*x, 11*x]\nend\n";
  const TemporaryFolder folder;
  folder.write("a.proof", text);
  REQUIRE(run_program(folder, {"certify", "a.proof", "-o", "out", "--check"}).code == 0);
  const std::string certificate = folder.text("out/c.v");
  REQUIRE(certificate.find("(equations ") != std::string::npos);
  for (const std::string old_text : {"[([(Int (1))", "([(Int (2))"}) {
    const std::size_t place = certificate.find(old_text);
    REQUIRE(place != std::string::npos);
    std::string changed = certificate;
    changed[place + old_text.size() - 3] = '4';
    CHECK_FALSE(accepted(folder, changed));
  }
}

}  // namespace patchproof
