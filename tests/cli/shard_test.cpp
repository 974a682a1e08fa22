// Shards of a run on several machines, and their reports joined again.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "many_claims.hpp"

namespace patchproof {

namespace {

using Json = nlohmann::ordered_json;

Ended check(const TemporaryFolder& folder, const std::string& shard, const std::string& output) {
  std::vector<std::string> words{"check", "corpus", "none", "--format", "json", "--output", output};
  if (!shard.empty()) words.insert(words.end(), {"--shard", shard});
  return run_program(folder, words);
}

void write_shards(const TemporaryFolder& folder, int count) {
  for (int k = 1; k <= count; ++k) {
    const std::string number = std::to_string(k);
    check(folder, number + "/" + std::to_string(count), number + ".json");
  }
}

Ended merge(const TemporaryFolder& folder, std::vector<std::string> reports) {
  reports.insert(reports.begin(), "merge");
  return run_program(folder, reports);
}

void change(const TemporaryFolder& folder, const std::string& name,
            const std::function<void(Json&)>& how) {
  Json document = Json::parse(folder.text(name));
  how(document);
  folder.write(name, document.dump(2) + "\n");
}

}  // namespace

TEST_CASE("the reports of all shards give the report of the run") {
  const TemporaryFolder folder;
  write_corpus(folder);
  const Ended whole = check(folder, "", "whole.json");
  write_shards(folder, 3);
  const Ended joined =
      merge(folder, {"2.json", "3.json", "1.json", "--format", "json", "--output", "joined.json"});
  CHECK(joined.code == whole.code);
  CHECK(folder.text("joined.json") == folder.text("whole.json"));
  std::size_t claims = 0;
  for (const std::string name : {"1.json", "2.json", "3.json"}) {
    const Json shard = Json::parse(folder.text(name));
    CHECK(!shard["claims"].empty());
    claims += shard["claims"].size();
  }
  CHECK(claims == Json::parse(folder.text("whole.json"))["claims"].size());
  const Ended text = merge(folder, {"1.json", "2.json", "3.json"});
  CHECK(text.output.find("many.wrong: expected PROVED, found REFUTED\n") != std::string::npos);
  CHECK(text.errors.find("corpus/c.proof:3:") != std::string::npos);
}

TEST_CASE("GNU parallel does the shards, as docs/many-claims.md says") {
  if (!std::filesystem::exists("/usr/bin/parallel")) return;
  const TemporaryFolder folder;
  write_corpus(folder);
  run_program(folder, {"check", "corpus", "--format", "json", "--output", "whole.json"});
  const std::string command =
      "cd '" + folder.path("") +
      "' && HOME=. parallel --will-cite --jobs 3 '" PATCHPROOF_PROGRAM
      "' check corpus --shard {}/4 --jobs 1 --format json --output shard{}.json ::: 1 2 3 4 "
      "2>parallel.log";
  // That is how many shards did not end with 0: each reports the mistakes of the corpus.
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 4);
  const Ended joined = merge(folder, {"shard1.json", "shard2.json", "shard3.json", "shard4.json",
                                      "--format", "json", "--output", "joined.json"});
  CHECK(joined.code == 4);
  CHECK(folder.text("joined.json") == folder.text("whole.json"));
}

TEST_CASE("a shard of part of the claims is a shard of these") {
  const TemporaryFolder folder;
  write_corpus(folder);
  for (const std::string shard : {"1/2", "2/2"})
    run_program(folder, {"check", "corpus/a.proof", "--only", "family.*", "--shard", shard,
                         "--format", "json", "--output", shard.substr(0, 1) + ".json"});
  const Ended joined = merge(folder, {"1.json", "2.json"});
  CHECK(joined.code == 0);
  CHECK(joined.output.find("13 claims in 1 case: 13 as expected (13 proved)") != std::string::npos);
}

TEST_CASE("what is missing, twice or of another run is complained of") {
  const TemporaryFolder folder;
  folder.write("corpus/a.proof",
               "case c\n  scalar a\n  prove p: a == a\n  prove q: a*1 == a\n  prove r: a + 0 == "
               "a\n  prove s: 2*a == a + a\nend\n");
  folder.write("none", "case d\n  scalar a\n  prove p: a == a\nend\n");
  write_shards(folder, 3);
  CHECK(merge(folder, {"1.json", "2.json", "3.json"}).code == 0);

  const Ended gap = merge(folder, {"1.json", "3.json"});
  CHECK(gap.code == 4);
  CHECK(gap.errors == "patchproof: shard 2 of 3 is missing\n");

  const Ended twice = merge(folder, {"1.json", "2.json", "3.json", "2.json"});
  CHECK(twice.code == 4);
  CHECK(twice.errors.find("is in '2.json' and in '2.json'") != std::string::npos);

  change(folder, "2.json", [](Json& report) { report["version"] = "0.0.7"; });
  const Ended other = merge(folder, {"1.json", "2.json", "3.json"});
  CHECK(other.code == 4);
  CHECK(other.errors.rfind("patchproof: '2.json' was written by version 0.0.7, not ", 0) == 0);

  change(folder, "3.json", [](Json& report) { report["claims"] = Json::array(); });
  const Ended less = merge(folder, {"1.json", "2.json", "3.json"});
  CHECK(less.code == 4);
  CHECK(less.errors.find("claims where the run had 5\n") != std::string::npos);

  check(folder, "2/4", "4.json");
  const Ended run = merge(folder, {"1.json", "4.json"});
  CHECK(run.code == 4);
  CHECK(run.errors.find("'1.json' and '4.json' are about shards of different runs\n") !=
        std::string::npos);
}

TEST_CASE("what is no report is not joined") {
  const TemporaryFolder folder;
  folder.write("text", "no report");
  folder.write("list", "[1, 2]");
  folder.write("huge",
               "{\"version\": \"0\", \"strict\": false, \"claims\": [], \"shown\": [], "
               "\"diagnostics\": [], \"unreadable\": [], \"shard\": {\"number\": 1, "
               "\"of\": 1000000000000, \"claims\": 0, \"cases\": []}}");
  for (const std::string name : {"text", "list", "huge"}) {
    const Ended ended = merge(folder, {name});
    CHECK(ended.code == 4);
    CHECK(ended.errors.rfind(
              "patchproof: '" + name + "' is no report of 'patchproof check --format json'", 0) ==
          0);
  }
  const Ended missing = merge(folder, {"missing"});
  CHECK(missing.code == 4);
  CHECK(missing.errors == "patchproof: cannot read 'missing': No such file or directory\n");
  CHECK(merge(folder, {}).code == 64);
}

TEST_CASE("a shard is i/n, and about single claims") {
  const TemporaryFolder folder;
  for (const std::string shard :
       {"0/4", "5/4", "1", "a/b", "1/0", "-1/2", "1/100001", "/", "1/2/3"})
    CHECK(run_program(folder, {"check", "-", "--shard", shard}).code == 64);
  const Ended ended = run_program(folder, {"check", "-", "--shard", "5/4"});
  CHECK(ended.errors.find("'5/4' is not the number of a shard, like 2/4") != std::string::npos);
  for (const std::string option : {"--audit", "--list"})
    CHECK(run_program(folder, {"check", "-", "--shard", "1/2", option}).code == 64);
}

TEST_CASE("a shard without claims does not look like a success") {
  const TemporaryFolder folder;
  folder.write("a.proof", "case c\n  scalar a\n  prove p: a == a\nend\n");
  const int first = run_program(folder, {"check", "a.proof", "--shard", "1/2"}).code;
  const int second = run_program(folder, {"check", "a.proof", "--shard", "2/2"}).code;
  CHECK(first + second == 5);
  CHECK(first * second == 0);
}

// More than are kept in memory: the others are stored, and read again for the report.
TEST_CASE("the report of very many claims is that of its shards") {
  const TemporaryFolder folder;
  constexpr int files = 13;
  for (int f = 0; f < files; ++f) {
    const std::string name = "c" + std::to_string(100 + f);
    std::string text = "case " + name + "\n  title \"Case " + name + "\"\n  scalar a, b\n";
    for (int k = 0; k < 900; ++k) {
      const std::string n = std::to_string(k);
      text += k % 10 == 0 ? "  refute r" + n + ": a + " + n + " == b\n"
                          : "  prove p" + n + ": a + " + n + " == " + n + " + a\n";
    }
    text += "  prove wrong: a == b\n  show a + a + " + std::to_string(f) + "*b\nend\n";
    // A name that was used long before, and a mistake.
    if (f == files - 1)
      text += "case c100\n  scalar a\n  prove p: a == a\nend\ncase broken\n  sca\n";
    folder.write("corpus/" + name + ".proof", text);
  }
  const auto check = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"check", "corpus", "--jobs", "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder, arguments);
  };
  check({"--shard", "1/2", "--format", "json", "--output", "one.json"});
  check({"--shard", "2/2", "--format", "json", "--output", "two.json"});
  const Ended merged = run_program(folder, {"merge", "one.json", "two.json", "--format", "json"});
  const Ended whole = check({"--format", "json"});
  CHECK(whole.code == merged.code);
  CHECK(whole.output == merged.output);
  const Ended text = check({"--quiet"});
  CHECK(text.code == 4);
  CHECK(
      text.output.find("11713 claims in 13 cases: 11700 as expected (10530 proved, 1170 refuted), "
                       "13 wrong, 3 mistakes in the text") != std::string::npos);
  CHECK(text.errors.find("case 'c100' occurs twice (first in corpus/c100.proof, line 1)") !=
        std::string::npos);
  // With titles and times, which are in no JSON report.
  const Ended verbose = check({"--verbose"});
  CHECK(verbose.output.find("\nc111: Case c111\n") != std::string::npos);
}

}  // namespace patchproof
