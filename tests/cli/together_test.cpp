// Small cases go to coqc several at a time. What it says of them together counts only when all is
// well.
#include <catch2/catch.hpp>

#include <tests/certificate/small_case.hpp>
#include <tests/cli/fake_coqc.hpp>

namespace patchproof {
namespace {

const std::string closed = "Closed under the global context\n";

std::string mark(int number) {
  return "before_case_" + std::to_string(number) + " = tt\n     : unit\n";
}

struct Answer {
  Ended ended;
  std::string asked;
};

// Four cases on two processors: two bundles of two.
Answer certified(const std::string& together, const std::string& alone) {
  const TemporaryFolder folder;
  const std::string small = golden_certificate("small.proof");
  std::string proof;
  for (const char* name : {"a", "b", "c", "d"})
    proof += with_part(small, "case small\n", std::string{"case "} + name + "\n");
  folder.write("all.proof", proof);
  const FakeCoqc coqc{alone, together};
  Answer answer;
  answer.ended =
      run_program(folder, {"certify", "all.proof", "-o", "out", "--check", "--jobs", "2"});
  answer.asked = coqc.asked();
  return answer;
}

bool is_asked_alone(const Answer& answer, const std::string& file) {
  return ("\n" + answer.asked).find("\n" + file + "\n") != std::string::npos;
}

}  // namespace

TEST_CASE("cases that coqc accepts together are not asked about again") {
  const std::string printed = golden_certificate("small.printed");
  const Answer answer = certified(mark(0) + printed + mark(1) + printed + closed, "");
  CHECK(answer.ended.code == 0);
  CHECK(answer.ended.output.find("32 of 32 claims in 4 cases certified") != std::string::npos);
  for (const char* file : {"a.v", "b.v", "c.v", "d.v"}) CHECK(!is_asked_alone(answer, file));
}

TEST_CASE("a case that was misunderstood together with others is asked about alone") {
  const std::string printed = golden_certificate("small.printed");
  const std::string other = with_part(printed, "q 0%nat = p 0%nat", "q 0%nat = q 0%nat");
  const Answer answer = certified(mark(0) + printed + mark(1) + other + closed, printed + closed);
  CHECK(answer.ended.code == 0);
  CHECK(!is_asked_alone(answer, "a.v"));
  CHECK(!is_asked_alone(answer, "b.v"));
  CHECK(is_asked_alone(answer, "c.v"));
  CHECK(is_asked_alone(answer, "d.v"));
  const Answer bad = certified(mark(0) + printed + mark(1) + other + closed, other + closed);
  CHECK(bad.ended.code == 70);
  CHECK(bad.ended.output.find("30 of 32 claims in 4 cases certified") != std::string::npos);
}

TEST_CASE("what cases rest on together has to be known, and to be allowed") {
  const std::string printed = golden_certificate("small.printed");
  const std::string both = mark(0) + printed + mark(1) + printed;
  for (const std::string& end : {std::string{}, std::string{"Axioms:\nMine.all : False\n"}}) {
    const Answer good = certified(both + end, printed + closed);
    CHECK(good.ended.code == 0);
    for (const char* file : {"a.v", "b.v", "c.v", "d.v"}) CHECK(is_asked_alone(good, file));
    CHECK(certified(both + end, printed + end).ended.code == 70);
  }
}

TEST_CASE("what coqc said of one case is not taken for a word on another") {
  const std::string printed = golden_certificate("small.printed");
  for (const std::string& together :
       {mark(0) + printed + closed, mark(0) + printed + printed + closed,
        mark(1) + printed + mark(0) + printed + closed, mark(0) + mark(1) + printed + closed}) {
    const Answer answer = certified(together, "" + closed);
    CHECK(answer.ended.code == 70);
    CHECK(answer.ended.output.find("32 of 32") == std::string::npos);
  }
}

}  // namespace patchproof
