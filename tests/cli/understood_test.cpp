#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include <tests/certificate/small_case.hpp>
#include <tests/cli/fake_coqc.hpp>

namespace patchproof {
namespace {

bool is_installed(const std::string& program) {
  std::string command{"command -v "};
  command.append(program).append(" > /dev/null 2>&1");
  return std::system(command.c_str()) == 0;
}

/// How certify ends when coqc accepts everything and prints this.
Ended certified_by(const std::string& printed, const TemporaryFolder& folder,
                   const std::string& axioms = "Closed under the global context\n") {
  const FakeCoqc coqc{printed + axioms};
  folder.write("small.proof", golden_certificate("small.proof"));
  return run_program(folder, {"certify", "small.proof", "-o", "out", "--check"});
}

}  // namespace

TEST_CASE("coqc prints what the golden file says", "[cli]") {
  if (!is_installed("coqc")) {
    WARN("coqc is not installed");
    return;
  }
  const TemporaryFolder folder;
  folder.write("small.proof", golden_certificate("small.proof"));
  const Ended ended = run_program(folder, {"certify", "small.proof", "-o", "out", "--check"});
  CHECK(ended.errors == "");
  CHECK(ended.code == 0);
  CHECK(ended.output.starts_with("small: 8 of 8 claims certified\n"));
  const std::string log = folder.text("out/small.log");
  CHECK(log.substr(0, log.find("Axioms:")) == golden_certificate("small.printed"));
}

TEST_CASE("A claim that Rocq took for another one is not certified", "[cli]") {
  const TemporaryFolder folder;
  CHECK(certified_by(golden_certificate("small.printed"), folder).code == 0);
  CHECK(folder.text("out/certified.json").find("small.points") != std::string::npos);

  const std::string printed =
      with_part(golden_certificate("small.printed"), "q 0%nat = p 0%nat", "q 0%nat = q 0%nat");
  const Ended ended = certified_by(printed, folder);
  CHECK(ended.code == 70);
  CHECK(
      ended.output ==
      "small: 7 of 8 claims certified\n"
      "    small.points: not what was asked: conclusion: Rocq understood q 0%nat where p 0%nat was "
      "asked, in p 0%nat - q 0%nat + q 0%nat = q 0%nat\n"
      "7 of 8 claims in 1 case certified (coqc 8.16.1, axioms: none)\n");
  CHECK(folder.text("out/certified.json").find("small.points") == std::string::npos);
  CHECK(folder.text("out/certified.json").find("small.corner") != std::string::npos);
}

TEST_CASE("Nothing is certified that was not printed", "[cli]") {
  const TemporaryFolder folder;
  const Ended ended = certified_by("", folder);
  CHECK(ended.code == 70);
  CHECK(
      ended.output.starts_with("small: 0 of 8 claims certified\n"
                               "    small.corner: not what was asked: Rocq has not printed "
                               "certified_corner\n"));
}

TEST_CASE("Nothing is certified when coqc has not said which axioms there are", "[cli]") {
  const TemporaryFolder folder;
  const Ended ended = certified_by(golden_certificate("small.printed"), folder, "");
  CHECK(ended.code == 70);
  CHECK(ended.output.starts_with(
      "small: 0 of 8 claims certified\n"
      "    small.corner: coqc has not said which axioms it rests on\n"));
  CHECK(folder.text("out/certified.json").find("small.corner") == std::string::npos);
}

TEST_CASE("Nothing is certified that rests on another axiom", "[cli]") {
  const TemporaryFolder folder;
  const Ended ended = certified_by(golden_certificate("small.printed"), folder,
                                   "Axioms:\nMine.all_is_true : forall P : Prop, P\n");
  CHECK(ended.code == 70);
  CHECK(folder.text("out/certified.json").find("small.corner") == std::string::npos);
}

}  // namespace patchproof
