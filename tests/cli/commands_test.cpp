#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <patchproof/version.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string untidy = "case a\nscalar s\n\n\n  prove  p:s==s\nend\n";
const std::string tidy = "case a\n  scalar s\n\n  prove p: s == s\nend\n";

Ended run(const std::vector<std::string>& arguments, const std::string& input = "") {
  return run_program(TemporaryFolder{}, arguments, input);
}

}  // namespace

TEST_CASE("fmt rewrites a file where it stands, and only if that changes it") {
  const TemporaryFolder folder;
  folder.write("a.proof", untidy);
  std::filesystem::permissions(folder.path("a.proof"), std::filesystem::perms{0640});
  std::filesystem::create_symlink("a.proof", folder.path("link.proof"));
  Ended ended = run_program(folder, {"fmt", "--check", "a.proof"});
  CHECK(ended.code == 1);
  CHECK(ended.output == "a.proof\n");
  CHECK(folder.text("a.proof") == untidy);
  ended = run_program(folder, {"fmt", "link.proof"});
  CHECK(ended.code == 0);
  CHECK(ended.output + ended.errors == "");
  CHECK(folder.text("a.proof") == tidy);
  CHECK(std::filesystem::is_symlink(folder.path("link.proof")));
  CHECK(std::filesystem::status(folder.path("a.proof")).permissions() ==
        std::filesystem::perms{0640});
  const auto before = std::filesystem::last_write_time(folder.path("a.proof"));
  CHECK(run_program(folder, {"fmt", "."}).code == 0);
  CHECK(std::filesystem::last_write_time(folder.path("a.proof")) == before);
  CHECK(run_program(folder, {"fmt", "--check", "."}).code == 0);
}

TEST_CASE("fmt - filters standard input") {
  const Ended ended = run({"fmt", "-"}, untidy);
  CHECK(ended.code == 0);
  CHECK(ended.output == tidy);
}

TEST_CASE("fmt leaves a file with mistakes as it is", "[reject]") {
  const TemporaryFolder folder;
  folder.write("bad.proof", "case a\n  prvoe p: s == s\nend\n");
  folder.write("good.proof", untidy);
  const Ended ended = run_program(folder, {"fmt", "bad.proof", "good.proof"});
  CHECK(ended.code == 4);
  CHECK(ended.errors ==
        "bad.proof:2:3: error: expected a statement, found 'prvoe'\n"
        "     2 |   prvoe p: s == s\n"
        "       |   ^^^^^\n"
        "       = help: did you mean 'prove'?\n");
  CHECK(folder.text("bad.proof") == "case a\n  prvoe p: s == s\nend\n");
  CHECK(folder.text("good.proof") == tidy);
}

TEST_CASE("definitions lists the textbook constructions and shows them as written") {
  const Ended list = run({"definitions"});
  CHECK(list.code == 0);
  CHECK(list.output.find("ruled(C1, C2)") != std::string::npos);
  const Ended one = run({"definitions", "ruled"});
  CHECK(one.code == 0);
  CHECK(one.output.starts_with("define ruled(C1, C2 : curve(u)) : patch(u, v)\n"));
  CHECK(one.output.ends_with("\nend\n"));
}

TEST_CASE("definitions knows those of a file") {
  const Ended ended = run({"definitions", "--file", "-", "twice"},
                          "define twice(x : scalar) : scalar\n  = 2*x\nend\n");
  CHECK(ended.code == 0);
  CHECK(ended.output == "define twice(x : scalar) : scalar\n  = 2*x\nend\n");
}

TEST_CASE("A definition that does not exist is a wrong command line", "[reject]") {
  const Ended ended = run({"definitions", "rulde"});
  CHECK(ended.code == 64);
  CHECK(ended.errors ==
        "patchproof definitions: there is no definition 'rulde'; did you mean 'ruled'?\n"
        "  = help: 'patchproof definitions --help' shows what can be said\n");
}

TEST_CASE("dump writes the syntax tree as JSON, or what is wrong with the text") {
  const Ended ended = run({"dump", "-"}, tidy);
  CHECK(ended.code == 0);
  CHECK(nlohmann::json::parse(ended.output)["kind"] == "file");
  const Ended bad = run({"dump", "-"}, "case");
  CHECK(bad.code == 4);
  CHECK(bad.output == "");
  CHECK(bad.errors.starts_with("<stdin>:1:1: error: case has no 'end'\n"));
}

TEST_CASE("The program tells its version") {
  const Ended ended = run({"--version"});
  CHECK(ended.code == 0);
  CHECK(ended.output == "patchproof " + std::string{version} + "\n");
}

TEST_CASE("Each command explains itself with an example") {
  for (const std::string command : {"check", "fmt", "definitions", "dump"}) {
    const Ended ended = run({command, "--help"});
    CHECK(ended.code == 0);
    CHECK(ended.output.find("Example:\n  patchproof " + command) != std::string::npos);
    CHECK(ended.errors == "");
  }
  CHECK(run({"--help"}).output.find("Example:\n  patchproof check") != std::string::npos);
}

TEST_CASE("A wrong command line ends with 64 and says what is wrong", "[reject]") {
  const auto message = [](const std::vector<std::string>& arguments) {
    const Ended ended = run(arguments);
    CHECK(ended.code == 64);
    CHECK(ended.output == "");
    return ended.errors.substr(0, ended.errors.find('\n'));
  };
  CHECK(message({"chekc"}) == "patchproof: there is no command 'chekc'; did you mean 'check'?");
  CHECK(message({"check"}) ==
        "patchproof check: nothing to check: name files or folders, or '-' for standard input");
  CHECK(message({"fmt"}) ==
        "patchproof fmt: nothing to format: name files or folders, or '-' for standard input");
  CHECK(message({"check", "-", "--limit-time", "soon"}) ==
        "patchproof check: --limit-time: 'soon' is not a number of seconds, like 10 or 0.5");
  CHECK(message({"check", "-", "--limit-steps", "-1"}) ==
        "patchproof check: --limit-steps: '-1' is not a whole number of at most 12 digits");
  CHECK(message({"check", "-", "--bogus"}) ==
        "patchproof check: The following argument was not expected: --bogus");
  CHECK(message({}).starts_with("Proves or refutes"));
}

}  // namespace patchproof
