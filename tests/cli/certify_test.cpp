#include <catch2/catch.hpp>
#include <filesystem>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string proof =
    "case c.all\n  param u, v in [0, 1]\n  scalar a, b, x\n  curve C1(u), C2(u) : C^2\n"
    "  assume closed: C1(0) == C2(0)\n  assume apart: a != b\n"
    "  patch r(u, v) = (1-v)*C1(u) + v*C2(u)\n"
    "  prove identity: r(u,0) == C1(u)\n"
    "  prove hypothesis: r(0,v) == C1(0)\n"
    "  prove derivative: r_uv(u,v) == C2'(u) - C1'(u)\n"
    "  prove quotient: (a^2 - b^2)/(a - b) == a + b\n"
    "  prove bound: u^2 - u + 1 > 0\n"
    "  refute false: r(u,1) == C1(u)\n"
    "  derive half: x from 2*x == a gives a/2\n"
    "end\n";

bool has_coqc() { return std::filesystem::exists("/usr/bin/coqc"); }

Ended certify(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "certify");
  return run_program(folder, arguments);
}

}  // namespace

TEST_CASE("certify writes statements and proofs, and says that nothing was checked") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Ended ended = certify(folder, {"a.proof", "-o", "out"});
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output ==
        "c.all: 7 of 7 claims with a certificate, not checked\n"
        "7 of 7 claims in 1 case with a certificate, not checked\n");
  const std::string text = folder.text("out/c_all.v");
  CHECK(text.find("Definition claim_identity : Prop :=\n"
                  "  forall (a : R) (b : R) (C1 : R -> R) (C2 : R -> R),\n"
                  "  (C1 0 = C2 0) ->\n  (a <> b) ->\n  forall u : R,\n  0 <= u <= 1 ->\n"
                  "  r C1 C2 u 0 = C1 u.\n") != std::string::npos);
  CHECK(text.find("Definition r (C1 : R -> R) (C2 : R -> R) (u v : R) : R :=\n"
                  "  (1 - v) * C1 u + v * C2 u.\n") != std::string::npos);
  CHECK(text.find("Theorem certified_false : ~ claim_false.\n") != std::string::npos);
  CHECK(text.find("Print Assumptions certified_together.\n") != std::string::npos);
}

TEST_CASE("what is not certified is named with its reason, and with --strict is not enough") {
  const TemporaryFolder folder;
  folder.write("a.proof", "case c\n  scalar x\n  prove p: sin(x)^2 + cos(x)^2 == 1\nend\n");
  const Ended ended = certify(folder, {"a.proof", "-o", "out"});
  CHECK(ended.code == 0);
  CHECK(ended.output ==
        "c: 0 of 1 claim with a certificate, not checked\n"
        "    c.p: pi, sines, cosines and exponentials\n"
        "0 of 1 claim in 1 case with a certificate, not checked\n");
  CHECK(certify(folder, {"a.proof", "-o", "out", "--strict"}).code == 2);
}

TEST_CASE("certify says what is missing on the command line") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const auto message = [](const std::string& text) {
    return "patchproof certify: " + text +
           "\n  = help: 'patchproof certify --help' shows what can be said\n";
  };
  const Ended no_folder = certify(folder, {"a.proof"});
  CHECK(no_folder.code == 64);
  CHECK(no_folder.errors == message("-o is missing: name a folder for the certificates"));
  const Ended no_path = certify(folder, {"-o", "out"});
  CHECK(no_path.code == 64);
  CHECK(no_path.errors ==
        message("nothing to certify: name files or folders, or '-' for standard input"));
  const Ended no_file = certify(folder, {"b.proof", "-o", "out"});
  CHECK(no_file.code == 4);
  CHECK(no_file.errors ==
        "patchproof: cannot read 'b.proof': No such file or directory\n"
        "patchproof: there is no claim to certify\n");
}

TEST_CASE("certificates as JSON go through recheck, and as a script for SymPy") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  CHECK(certify(folder, {"a.proof", "-o", "out", "--format", "json"}).code == 0);
  const Ended rechecked = run_program(folder, {"recheck", "out/c_all.json"});
  CHECK(rechecked.code == 0);
  CHECK(certify(folder, {"a.proof", "-o", "out", "--format", "sympy"}).code == 0);
  CHECK(folder.text("out/c_all.py").find("sympy") != std::string::npos);
  CHECK(certify(folder, {"a.proof", "-o", "out", "--format", "json", "--check"}).code == 64);
}

TEST_CASE("a folder without record certifies nothing") {
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Ended ended = run_program(folder, {"check", "a.proof", "--certificates", "out"});
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot read 'out/certified.json': No such file or directory\n");
}

TEST_CASE("coqc certifies claims of all kinds, and the evidence is lost with a change of the case") {
  if (!has_coqc()) return;
  const TemporaryFolder folder;
  folder.write("a.proof", proof);
  const Ended ended = certify(folder, {"a.proof", "-o", "out", "--check"});
  CHECK(ended.errors == "");
  CHECK(ended.code == 0);
  CHECK(ended.output.rfind("c.all: 7 of 7 claims certified\n7 of 7 claims in 1 case certified (coqc ",
                           0) == 0);
  const Ended evidence =
      run_program(folder, {"check", "a.proof", "-v", "--certificates", "out"});
  CHECK(evidence.output.find("certified (coqc ") != std::string::npos);
  CHECK(evidence.output.find("both engines") == std::string::npos);
  std::string changed = proof;
  changed.replace(changed.find("v*C2(u)"), 7, "(0 + v)*C2(u)");
  folder.write("a.proof", changed);
  const std::string record = folder.text("out/certified.json");
  std::string other = record;
  other[other.find("\"library\": \"") + 12] ^= 1;
  folder.write("out/certified.json", other);
  CHECK(run_program(folder, {"check", "a.proof", "--certificates", "out"}).code == 4);
  folder.write("out/certified.json", record);
  const Ended stale = run_program(folder, {"check", "a.proof", "-v", "--certificates", "out"});
  CHECK(stale.output.find("certified") == std::string::npos);
}

}  // namespace patchproof
