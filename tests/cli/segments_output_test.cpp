// Where segments are written to, and how long that may take.
#include <sys/stat.h>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace patchproof {

namespace {

const std::string net = "0,0\n0,1\n\n1,0\n1,1\n\n0,0\n0,1\n";

/// Ends with the code of the program, run by a shell in the folder.
int shell(const TemporaryFolder& folder, const std::string& arguments) {
  const std::string command =
      "cd '" + folder.path("") + "' && '" PATCHPROOF_PROGRAM "' " + arguments;
  return WEXITSTATUS(std::system(command.c_str()));
}

}  // namespace

TEST_CASE("segments are written through a link, and the link stays") {
  const TemporaryFolder folder;
  folder.write("net.csv", net);
  folder.write("target.csv", "before");
  std::filesystem::create_symlink("target.csv", folder.path("link.csv"));
  CHECK(shell(folder, "segments net.csv --degrees 1 --output link.csv >report") == 0);
  CHECK(std::filesystem::is_symlink(folder.path("link.csv")));
  CHECK(folder.text("target.csv").find("0,0") != std::string::npos);
}

TEST_CASE("a pipe or a device is written into, not replaced") {
  const TemporaryFolder folder;
  folder.write("net.csv", net);
  REQUIRE(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  const std::string reader = "cat '" + folder.path("pipe") + "' >'" + folder.path("read") + "' &";
  REQUIRE(std::system(reader.c_str()) == 0);
  CHECK(shell(folder, "segments net.csv --degrees 1 --output pipe >report") == 0);
  CHECK(std::filesystem::is_fifo(folder.path("pipe")));
  CHECK(shell(folder, "segments net.csv --degrees 1 --output plain.csv >report") == 0);
  for (int k = 0; k < 100 && folder.text("read").empty(); ++k) std::system("sleep 0.05");
  CHECK(folder.text("read") == folder.text("plain.csv"));
}

TEST_CASE("a device that takes nothing is an error, and stays a device", "[reject]") {
  const TemporaryFolder folder;
  folder.write("net.csv", net);
  // A device of its own: the real one is everybody's.
  if (::mknod(folder.path("full").c_str(), S_IFCHR | 0600, 0x107) != 0) {
    WARN("only root can make a device: not tested");
    return;
  }
  CHECK(shell(folder, "segments net.csv --degrees 1 --output full >report 2>errors") == 4);
  CHECK(folder.text("errors") == "patchproof: cannot write 'full': No space left on device\n");
  CHECK(std::filesystem::is_character_file(folder.path("full")));
}

TEST_CASE("segments that take too long are unknown, and leave no file", "[reject]") {
  const TemporaryFolder folder;
  // Knots of 150 digits, for which every weight is a fraction of thousands.
  std::string knots;
  for (int k = 0; k < 40; ++k) {
    std::string digits;
    for (int d = 0; d < 150; ++d)
      digits += static_cast<char>('1' + (k * 7 + d * d * (k + 3) + d) % 9);
    knots += (k == 0 ? "" : ",") + std::to_string(k) + "." + digits;
  }
  std::string points;
  for (int k = 0; k < 30; ++k) points += "0," + std::to_string(k % 7) + "\n1,1\n\n";
  folder.write("net.csv", points);
  const std::string run =
      "segments net.csv --degrees 9,1 --knots-u " + knots + " --output out.csv --limit-time 1 ";
  CHECK(shell(folder, run + ">report") == 2);
  CHECK(folder.text("report") ==
        "net.csv: UNKNOWN: limit: more than 1 s\n       = help: allow more with --limit-time\n");
  CHECK(shell(folder, run + "--format json >report") == 2);
  const auto report = nlohmann::json::parse(folder.text("report"));
  CHECK(report["verdict"] == "UNKNOWN");
  CHECK(report["exit"] == 2);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator{folder.path("")})
    files += entry.is_regular_file() ? 1 : 0;
  CHECK(files == 2);
}

}  // namespace patchproof
