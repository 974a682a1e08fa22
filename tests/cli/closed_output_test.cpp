#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "program.hpp"

namespace patchproof {

TEST_CASE("A reader that goes away is an error, and kills nobody", "[reject]") {
  const TemporaryFolder folder;
  folder.write("a.proof", "case a\n  scalar s\n  prove p: s == s\nend\n");
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  ::close(ends[0]);
  const std::string write_end =
      "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(ends[1]);
  const Ended ended = run_program(folder, {"check", "a.proof"}, "", write_end);
  ::close(ends[1]);
  CHECK(ended.code == 4);
  CHECK(ended.errors == "patchproof: cannot write standard output: Broken pipe\n");
}

// More claims than are kept in memory: the file they go to must not be taken for standard output.
TEST_CASE("A closed standard output is an error for any number of claims", "[reject]") {
  const TemporaryFolder folder;
  std::string text;
  for (int k = 0; k < 1000; ++k)
    text += "  prove p" + std::to_string(k) + ": s + " + std::to_string(k) +
            " == " + std::to_string(k) + " + s\n";
  for (int f = 0; f < 11; ++f) {
    const std::string name = "c" + std::to_string(f);
    folder.write("corpus/" + name + ".proof", "case " + name + "\n  scalar s\n" + text + "end\n");
  }
  for (const std::string jobs : {"1", "2"}) {
    const std::string command = "cd '" + folder.path("") +
                                "' && '" PATCHPROOF_PROGRAM "' check corpus --jobs " + jobs +
                                " >&- 2>errors";
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 4);
    CHECK(folder.text("errors") ==
          "patchproof: cannot write standard output: Bad file descriptor\n");
  }
}

}  // namespace patchproof
