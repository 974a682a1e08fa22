#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>

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

}  // namespace patchproof
