// Workers: what they find out does not depend on their number, and a claim somebody is lost over is
// unknown, and the only one.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "many_claims.hpp"

namespace patchproof {

namespace {

using Json = nlohmann::json;

std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator{"/proc"}) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream stat{entry.path() / "stat"};
    std::stringstream text;
    text << stat.rdbuf();
    // "12 (name) S 11 ...": the name may have brackets of its own.
    const std::size_t end = text.str().rfind(')');
    if (end == std::string::npos) continue;
    std::istringstream rest{text.str().substr(end + 1)};
    char state = 0;
    pid_t its_parent = 0;
    rest >> state >> its_parent;
    if (its_parent == parent && state != 'Z') children.push_back(std::stoi(name));
  }
  return children;
}

void write_powers(const TemporaryFolder& folder, int cases, int claims) {
  for (int c = 0; c < cases; ++c) {
    std::string text = "case c" + std::to_string(c) + "\n  scalar a, b, c\n";
    for (int k = 0; k < claims; ++k)
      text += "  prove p" + std::to_string(k) + ": (a + b + " + std::to_string(k) + "*c)^9 == (c*" +
              std::to_string(k) + " + b + a)^9\n";
    folder.write("corpus/" + std::to_string(c) + ".proof", text + "end\n");
  }
}

/// Checks the claims of `corpus`, all of them true, and kills a worker after each pause.
void check_with_workers_killed(const TemporaryFolder& folder, std::size_t claims, const char* jobs,
                               const std::vector<std::chrono::milliseconds>& pauses) {
  const std::string output = folder.path("report.json");
  const std::string corpus = folder.path("corpus");
  const pid_t program = ::fork();
  REQUIRE(program >= 0);
  if (program == 0) {
    ::execl(PATCHPROOF_PROGRAM, PATCHPROOF_PROGRAM, "check", corpus.c_str(), "--format", "json",
            "--output", output.c_str(), "--jobs", jobs, nullptr);
    ::_exit(127);
  }
  // A program with sanitizers takes its time to begin.
  for (int k = 0; k < 1000 && children_of(program).empty(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  std::size_t killed = 0;
  for (std::size_t round = 0; round < pauses.size(); ++round) {
    std::this_thread::sleep_for(pauses[round]);
    const std::vector<pid_t> workers = children_of(program);
    if (workers.empty()) continue;
    if (::kill(workers[round % workers.size()], SIGKILL) == 0) ++killed;
  }
  int status = 0;
  REQUIRE(::waitpid(program, &status, 0) == program);
  REQUIRE(WIFEXITED(status));
  const Json report = Json::parse(folder.text("report.json"));
  CHECK(report["unreadable"].empty());
  REQUIRE(report["claims"].size() == claims);
  std::size_t unknown = 0;
  for (const Json& claim : report["claims"]) {
    if (claim["verdict"] == "PROVED") continue;
    ++unknown;
    CHECK(claim["reason"] == "crash: ended by signal 9 (Killed)");
  }
  CHECK(killed > 0);
  CHECK(unknown <= killed);
  CHECK(WEXITSTATUS(status) == (unknown == 0 ? 0 : 2));
}

}  // namespace

TEST_CASE("the report does not depend on the number of workers") {
  const TemporaryFolder folder;
  write_corpus(folder);
  const auto report = [&](const std::string& jobs, const std::string& format) {
    return run_program(folder, {"check", "corpus", "no_such_file", "--format", format, "--jobs",
                                jobs, "--only", "*", "--only", "nothing.like.it"});
  };
  for (const std::string format : {"json", "text"}) {
    const Ended alone = report("1", format);
    CHECK(alone.code == 4);
    for (const std::string jobs : {"2", "7"}) {
      const Ended together = report(jobs, format);
      CHECK(together.code == alone.code);
      CHECK(together.output == alone.output);
      CHECK(together.errors == alone.errors);
    }
  }
}

TEST_CASE("assumptions are audited by workers as by one") {
  const TemporaryFolder folder;
  folder.write("a.proof",
               "case one\n  scalar a, b\n  assume same: a == b\n  prove p: a == b\nend\n"
               "case two\n  scalar a, b\n  assume same: a == b\n  prove p: a == a\nend\n");
  const Ended alone = run_program(folder, {"check", "a.proof", "--audit", "--jobs", "1"});
  CHECK(alone.code == 1);
  CHECK(alone.output.find("two: nothing needs 'same'") != std::string::npos);
  CHECK(run_program(folder, {"check", "a.proof", "--audit", "--jobs", "3"}).output == alone.output);
}

TEST_CASE("a worker that is ended costs the claim it worked on, and no other") {
  const TemporaryFolder folder;
  folder.write("a.proof",
               "case c\n  scalar a, b, c, d, e, f\n  prove before: a + b == b + a\n"
               "  prove long: (a+b+c+d+e+f)^60*(a-b)^60/c == (a-b)^60*(f+e+d+c+b+a)^60/c + 1\n"
               "  prove after: a*b == b*a\n  show a + a\nend\n");
  // The system ends whoever takes more than a second.
  const std::string command = "ulimit -t 1; cd '" + folder.path("") +
                              "' && '" PATCHPROOF_PROGRAM
                              "' check a.proof --jobs 1 --limit-time 0 --limit-steps 0 "
                              "--limit-terms 0 --format json >report.json";
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 2);
  const Json report = Json::parse(folder.text("report.json"));
  REQUIRE(report["claims"].size() == 3);
  CHECK(report["claims"][0]["verdict"] == "PROVED");
  CHECK(report["claims"][1]["verdict"] == "UNKNOWN");
  CHECK(report["claims"][1]["outcome"] == "unknown");
  CHECK(report["claims"][1]["reason"].get<std::string>().rfind("crash: ended by signal ", 0) == 0);
  CHECK(report["claims"][2]["verdict"] == "PROVED");
  CHECK(report["shown"][0]["value"] == "2*a");
}

TEST_CASE("a claim that is said to be open is not as expected when a worker is lost over it") {
  const TemporaryFolder folder;
  folder.write(
      "a.proof",
      "case c\n  scalar a, b, c, d, e, f\n"
      "  open long: (a+b+c+d+e+f)^60*(a-b)^60/c == (a-b)^60*(f+e+d+c+b+a)^60/c + 1\nend\n");
  const std::string command =
      "ulimit -t 1; cd '" + folder.path("") +
      "' && '" PATCHPROOF_PROGRAM
      "' check a.proof --limit-time 0 --limit-steps 0 --limit-terms 0 >report";
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 2);
  CHECK(folder.text("report").find("UNKNOWN: crash: ended by signal") != std::string::npos);
}

TEST_CASE("workers that are killed at random lose nothing but what they worked on") {
  const TemporaryFolder folder;
  write_powers(folder, 20, 60);
  std::vector<std::chrono::milliseconds> pauses(12, std::chrono::milliseconds{40});
  check_with_workers_killed(folder, 1200, "3", pauses);
}

TEST_CASE("workers that are killed while they open a file lose nothing") {
  const TemporaryFolder folder;
  write_powers(folder, 1, 600);
  std::vector<std::chrono::milliseconds> pauses(10, std::chrono::milliseconds{1});
  check_with_workers_killed(folder, 600, "1", pauses);
}

TEST_CASE("what is shown has to be found out for a run to end with 0") {
  const TemporaryFolder folder;
  folder.write("a.proof",
               "case c\n  scalar a, b, c, d, e, f\n  prove p: a + b == b + a\n"
               "  show (a+b+c+d+e+f)^60*(a-b)^60/c\n  show a + a\nend\n");
  const std::string command = "ulimit -t 1; cd '" + folder.path("") +
                              "' && '" PATCHPROOF_PROGRAM
                              "' check a.proof --limit-time 0 --limit-steps 0 --limit-terms 0 "
                              "--format json >report.json";
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 2);
  const Json report = Json::parse(folder.text("report.json"));
  CHECK(report["exit"] == 2);
  CHECK(report["shown"][0]["lost"] == true);
  CHECK(report["shown"][0]["value"].get<std::string>().rfind("crash: ended by signal ", 0) == 0);
  CHECK(report["shown"][1]["value"] == "2*a");
  const Ended merged = run_program(folder, {"merge", "report.json"});
  CHECK(merged.code == 2);
  CHECK(merged.output.find("a.proof:4:3: c: nothing to show: crash: ended by signal ") !=
        std::string::npos);
}

TEST_CASE("a number of workers is a whole number from 1 on") {
  const TemporaryFolder folder;
  for (const std::string jobs : {"0", "-1", "x", "1.5", "1025", ""}) {
    const Ended ended = run_program(folder, {"check", "-", "--jobs", jobs});
    CHECK(ended.code == 64);
    CHECK(ended.errors.find("is not a whole number from 1 to 1024") != std::string::npos);
  }
}

}  // namespace patchproof
