#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string good =
    "case good\n  scalar a, b\n  prove square: (a+b)^2 == a^2 + 2*a*b + b^2\nend\n";
const std::string wrong = "case wrong\n  scalar a, b\n  prove square: (a+b)^2 == a^2 + b^2\nend\n";

Ended check(const std::string& text, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"check", "-"});
  return run_program(TemporaryFolder{}, options, text);
}

}  // namespace

TEST_CASE("A true claim is proved, and the program ends with 0") {
  const Ended ended = check(good);
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output == "  good.square  PROVED\n\n1 claim in 1 case: 1 as expected (1 proved)\n");
}

TEST_CASE("A false claim is refuted by exact values, and the program ends with 1") {
  const Ended ended = check(wrong);
  CHECK(ended.code == 1);
  CHECK(ended.errors == "");
  CHECK(ended.output ==
        "! wrong.square  REFUTED  (expected PROVED)\n"
        "\n"
        "<stdin>:3:17: wrong.square: expected PROVED, found REFUTED\n"
        "     3 |   prove square: (a+b)^2 == a^2 + b^2\n"
        "       |                 ^^^^^^^^^^^^^^^^^^^^\n"
        "       = left - right: 2*a*b\n"
        "       = witness: a = 1, b = 1\n"
        "       = left side: 4\n"
        "       = right side: 2\n"
        "\n"
        "1 claim in 1 case: 1 wrong\n");
}

TEST_CASE(
    "A claim over its budget is unknown, the others are decided, and the program ends with 2") {
  const Ended ended = check(
      "case big\n  scalar a, b\n  prove one: (a+b)^60/a == (b+a)^60/a\n  prove two: a + b == b + "
      "a\nend\n",
      {"--limit-terms", "10"});
  CHECK(ended.code == 2);
  CHECK(ended.output.find("! big.one  UNKNOWN: limit: more than 10 terms\n") == 0);
  CHECK(ended.output.find("  big.two  PROVED\n") != std::string::npos);
}

TEST_CASE("Contradictory assumptions prove nothing, and the program ends with 3") {
  const Ended ended =
      check("case c\n  scalar a\n  assume a == 1, a == 2\n  prove x: a == 3\nend\n");
  CHECK(ended.code == 3);
  CHECK(ended.output.find("! c.x  VACUOUS\n") == 0);
}

TEST_CASE("A conditional proof is enough unless --strict asks for more") {
  const std::string text = "case c\n  scalar a, b\n  prove x: (a^2-b^2)/(a-b) == a + b\nend\n";
  const Ended ended = check(text);
  CHECK(ended.code == 0);
  CHECK(ended.output.find("  c.x  PROVED IF a - b != 0\n") == 0);
  const Ended strict = check(text, {"--strict"});
  CHECK(strict.code == 3);
  CHECK(strict.output.find("assume a - b != 0\n") != std::string::npos);
}

TEST_CASE("A missing operator is shown with the way to write it, and the program ends with 4",
          "[reject]") {
  const Ended ended = check(
      "case bad\n  param u in [0, 1]\n  curve C(u) = (u, 0, 4u(1-u))\n  prove x: u == u\nend\n");
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "<stdin>:3:24: error: expected an operator before 'u'\n"
        "     3 |   curve C(u) = (u, 0, 4u(1-u))\n"
        "       |                        ^\n"
        "       = help: multiplication is written '*': 4*u*(1-u)\n");
}

TEST_CASE("A claim without a value is an error at the place that has none", "[reject]") {
  const Ended ended = check("case c\n  scalar a\n  prove x: a/(a-a) == 1\nend\n");
  CHECK(ended.code == 4);
  CHECK(ended.output.find("<stdin>:3:14: error: division by zero\n") != std::string::npos);
}

TEST_CASE("A path that is not there is named, and the other files still run", "[reject]") {
  const TemporaryFolder folder;
  folder.write("good.proof", good);
  const Ended ended = run_program(folder, {"check", "no.proof", "good.proof"});
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot read 'no.proof': No such file or directory\n");
  CHECK(ended.output.find("  good.square  PROVED\n") == 0);
}

TEST_CASE("A pipe or a device is not waited for", "[reject]") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo(folder.path("pipe.proof").c_str(), 0600) == 0);
  const Ended ended = run_program(folder, {"check", "pipe.proof", "/dev/zero"});
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "patchproof: cannot read 'pipe.proof': not a regular file\n"
        "patchproof: cannot read '/dev/zero': not a regular file\n");
}

TEST_CASE("A file larger than 64 MB is refused", "[reject]") {
  const TemporaryFolder folder;
  folder.write("large.proof", "");
  std::filesystem::resize_file(folder.path("large.proof"), (std::uintmax_t{64} << 20) + 1);
  const Ended ended = run_program(folder, {"check", "large.proof"});
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot read 'large.proof': larger than 64 MB\n");
}

TEST_CASE("A folder without case files is no success", "[reject]") {
  const TemporaryFolder folder;
  folder.write("empty/.hidden.proof", good);
  folder.write("empty/readme.txt", good);
  const Ended ended = run_program(folder, {"check", "empty"});
  CHECK(ended.code == 5);
  CHECK(ended.errors == "patchproof: no .proof file in 'empty'\n");
}

TEST_CASE("A text without claims is no success", "[reject]") {
  const Ended ended = check("");
  CHECK(ended.code == 5);
  CHECK(ended.errors == "patchproof: there is no claim to decide\n");
}

TEST_CASE("The files of a folder are read in the order of their paths, each once") {
  const TemporaryFolder folder;
  for (const char* name : {"b", "a", "a/c", "Z"})
    folder.write("cases/" + std::string{name} + "/x.proof",
                 "case " + std::string(1, std::string{name}.back()) +
                     "\n  scalar s\n  prove p: s == s\nend\n");
  // Two circles: following both again and again would take for ever.
  for (const char* circle : {"cases/a/circle", "cases/b/circle"})
    std::filesystem::create_directory_symlink(folder.path("cases"), folder.path(circle));
  const Ended ended =
      run_program(folder, {"check", "cases", "cases/a/x.proof", "./cases", "--list"});
  CHECK(ended.code == 0);
  CHECK(ended.errors == "");
  CHECK(ended.output == "Z.p  prove\nc.p  prove\na.p  prove\nb.p  prove\n");
}

TEST_CASE("A case name used by two files is an error in the second", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", good);
  folder.write("b.proof", "\n" + good);
  const Ended ended = run_program(folder, {"check", "a.proof", "b.proof"});
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "b.proof:2:6: error: case 'good' occurs twice (first in a.proof, line 1)\n"
        "     2 | case good\n"
        "       |      ^^^^\n");
  CHECK(ended.output.find("1 claim in 1 case: 1 as expected (1 proved), 1 mistake in the text\n") !=
        std::string::npos);
}

TEST_CASE("--only selects by id, instance, case and tag") {
  const std::string text =
      "case k\n  tags fast\n  scalar a\n  prove one: a == a\n"
      "  prove fam: i*a == a*i for i in 0..2\n"
      "  erratum e\n    printed a == 2*a\n    corrected a == a\n  end\nend\n"
      "case l\n  scalar a\n  prove one: a == a\nend\n";
  const auto listed = [&](std::vector<std::string> options) {
    options.emplace_back("--list");
    const Ended ended = check(text, options);
    CHECK(ended.code == 0);
    return ended.output;
  };
  CHECK(listed({"--only", "k.one"}) == "k.one  prove\n");
  CHECK(listed({"--only", "k.fam[i=1]"}) == "k.fam[i=1]  prove\n");
  CHECK(listed({"--only", "k.f?m"}) == "k.fam[i=0]  prove\nk.fam[i=1]  prove\nk.fam[i=2]  prove\n");
  CHECK(listed({"--only", "k.e"}) == "k.e.printed    refute\nk.e.corrected  prove\n");
  CHECK(listed({"--only", "*.one"}) == "k.one  prove\nl.one  prove\n");
  CHECK(listed({"--only", "l", "--only", "k.one"}) == "k.one  prove\nl.one  prove\n");
  CHECK(listed({"--only", "tag:fast", "--only", "l"}).find("l.one") != std::string::npos);
  CHECK(check(text, {"--only", "k.fam[i=1]"}).output ==
        "  k.fam[i=1]  PROVED\n\n1 claim in 1 case: 1 as expected (1 proved)\n");
}

TEST_CASE("A filter that matches nothing is no success", "[reject]") {
  const Ended ended = check(good, {"--only", "goood.*"});
  CHECK(ended.code == 5);
  CHECK(ended.errors == "patchproof: no claim matches --only 'goood.*'\n");
}

TEST_CASE("Two runs give the same bytes") {
  for (const char* format : {"text", "json"}) {
    const Ended first = check(wrong + good, {"--format", format});
    const Ended second = check(wrong + good, {"--format", format});
    CHECK(first.output == second.output);
    CHECK(first.output.size() > 100);
  }
}

TEST_CASE("The JSON report says what the program ends with") {
  const Ended ended = check(wrong, {"--format", "json"});
  CHECK(ended.code == 1);
  const auto document = nlohmann::json::parse(ended.output);
  CHECK(document["exit"] == 1);
  CHECK(document["claims"][0]["id"] == "wrong.square");
}

TEST_CASE("--output writes the same report into a file") {
  const TemporaryFolder folder;
  folder.write("good.proof", good);
  folder.write("old.txt", std::string(10'000, 'x'));
  const Ended ended = run_program(folder, {"check", "good.proof", "--output", "old.txt"});
  CHECK(ended.code == 0);
  CHECK(ended.output == "");
  CHECK(folder.text("old.txt") == run_program(folder, {"check", "good.proof"}).output);
}

TEST_CASE("An output that cannot be written is no success", "[reject]") {
  const TemporaryFolder folder;
  folder.write("good.proof", good);
  Ended ended = run_program(folder, {"check", "good.proof", "--output", "no/where.txt"});
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot write 'no/where.txt': No such file or directory\n");
  ended = run_program(folder, {"check", "good.proof", "--output", "good.proof"});
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot write 'good.proof': it is one of the case files\n");
  CHECK(folder.text("good.proof") == good);
  ended = run_program(folder, {"check", "good.proof"}, "", "/dev/full");
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot write standard output: No space left on device\n");
}

// Under the address sanitizer memory is kept by its own allocator, and the claim meets the time
// limit first.
#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("A memory limit ends one claim and not the run") {
  const Ended ended = check(
      "case m\n  scalar a, b, c, d\n  prove big: (a+b+c+d)^200 == (d+c+b+a)^200\n"
      "  prove small: a == a\nend\n",
      {"--limit-memory", "5"});
  CHECK(ended.code == 2);
  CHECK(ended.output.find("! m.big    UNKNOWN: limit: more than 5000000 bytes of memory\n") == 0);
  CHECK(ended.output.find("  m.small  PROVED\n") != std::string::npos);
}
#endif

TEST_CASE("An included file is found beside the file that includes it") {
  const TemporaryFolder folder;
  folder.write("d/double.proof", "define twice(x : scalar) : scalar\n  = 2*x\nend\n");
  folder.write("d/a.proof",
               "include \"double.proof\"\ncase a\n  scalar s\n  prove p: twice(s) == s + s\nend\n");
  const Ended ended = run_program(folder, {"check", "d/a.proof"});
  CHECK(ended.errors == "");
  CHECK(ended.code == 0);
}

}  // namespace patchproof
