// --cache: what was decided before is found again as long as nothing it depends on has changed, and
// the report does not tell the difference.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <thread>

#include <patchproof/latex/sha256.hpp>

#include "many_claims.hpp"

namespace patchproof {

namespace {

constexpr std::size_t digits = 64;

/// The files that are kept in the folder "cache".
std::vector<std::filesystem::path> kept_files(const TemporaryFolder& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder.path("cache")})
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Puts another difference of both sides into everything that is kept, of the same length, as only
/// somebody who means it could. It shows in a report that was not found out anew.
void forge(const TemporaryFolder& folder) {
  for (const std::filesystem::path& file : kept_files(folder)) {
    std::string kept = bytes_of(file).substr(digits);
    const std::size_t place = kept.find("a - b");
    if (place == std::string::npos) continue;
    kept.replace(place, 5, "z - z");
    const std::string digest = file.parent_path().filename().string() + file.filename().string();
    std::ofstream{file, std::ios::binary} << sha256(digest + kept) << kept;
  }
}

Ended check(const TemporaryFolder& folder, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"check", "corpus", "--format", "json", "--cache", "cache"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(folder, arguments);
}

bool is_forged(const Ended& ended) { return ended.output.find("z - z") != std::string::npos; }

constexpr const char* one_case =
    "case one\n  scalar a, b\n  refute differ: a == b\n  prove same: a + b == b + a\nend\n";

}  // namespace

TEST_CASE("the report is the same without a cache, with an empty one and with a full one") {
  const TemporaryFolder folder;
  write_corpus(folder);
  for (const std::string format : {"json", "text"}) {
    const Ended without = run_program(folder, {"check", "corpus", "--format", format});
    for (int times = 0; times < 3; ++times) {
      const Ended with =
          run_program(folder, {"check", "corpus", "--format", format, "--cache", "cache"});
      CHECK(with.code == without.code);
      CHECK(with.output == without.output);
      CHECK(with.errors == without.errors);
    }
  }
  CHECK(kept_files(folder).size() > 100);
}

TEST_CASE("what was decided is found again, wherever its case stands") {
  const TemporaryFolder folder;
  folder.write("corpus/a.proof", one_case);
  CHECK(check(folder).code == 0);
  REQUIRE(kept_files(folder).size() == 2);
  forge(folder);
  CHECK(is_forged(check(folder)));
  folder.write("corpus/a.proof",
               std::string{"case before\n  scalar a\n  prove p: a == a\nend\n\n\n"} + one_case +
                   "\ncase after\n  scalar a\n  prove p: a == a\nend\n");
  const Ended moved = check(folder);
  CHECK(is_forged(moved));
  CHECK(moved.output.find("\"line\": 9") != std::string::npos);
  CHECK(kept_files(folder).size() == 4);
}

TEST_CASE("what was decided of another text, with other limits or engines is not believed") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& before, const std::string& text,
                         const std::string& included) {
    folder.write("included/more.proof", included);
    folder.write("corpus/a.proof", "include \"../included/more.proof\"\n" + before + text);
  };
  const std::string definition = "define twice(x : scalar) : scalar\n  = 2*x\nend\n";
  write("", one_case, definition);
  CHECK(check(folder).code == 0);
  forge(folder);
  REQUIRE(is_forged(check(folder)));

  CHECK_FALSE(is_forged(check(folder, {"--engines", "kernel"})));
  CHECK_FALSE(is_forged(check(folder, {"--limit-steps", "1000000"})));
  CHECK_FALSE(is_forged(check(folder, {"--limit-terms", "1000000"})));
  CHECK_FALSE(is_forged(check(folder, {"--limit-time", "7"})));
  CHECK_FALSE(is_forged(check(folder, {"--limit-memory", "900"})));
  CHECK_FALSE(is_forged(check(folder, {"--audit"})));
  CHECK(is_forged(check(folder)));

  write("", one_case, "define twice(x : scalar) : scalar\n  = x + x\nend\n");
  CHECK_FALSE(is_forged(check(folder)));
  write("define thrice(x : scalar) : scalar\n  = 3*x\nend\n", one_case, definition);
  CHECK_FALSE(is_forged(check(folder)));
  std::string other = one_case;
  other.replace(other.find("b + a"), 5, "a + b");
  write("", other, definition);
  CHECK_FALSE(is_forged(check(folder)));
  write("", one_case, definition);
  CHECK(is_forged(check(folder)));
}

TEST_CASE("what was decided of another net, or before other definitions, is not believed") {
  const TemporaryFolder folder;
  const std::string text =
      "case one\n  scalar a, b\n  net d from \"net.csv\"\n  refute differ: a == b\n"
      "  prove height: d[0,0] == 1\nend\n";
  folder.write("corpus/net.csv", "1\n2\n\n3\n4\n");
  folder.write("corpus/a.proof", text);
  REQUIRE(check(folder).code == 0);
  forge(folder);
  REQUIRE(is_forged(check(folder)));
  folder.write("corpus/a.proof", text + "define twice(x : scalar) : scalar\n  = 2*x\nend\n");
  CHECK_FALSE(is_forged(check(folder)));
  folder.write("corpus/a.proof", text);
  CHECK(is_forged(check(folder)));
  folder.write("corpus/net.csv", "5\n2\n\n3\n4\n");
  const Ended other = check(folder);
  CHECK_FALSE(is_forged(other));
  CHECK(other.code == 1);
}

TEST_CASE("what somebody has to look at, and what was cut short, is not kept") {
  const TemporaryFolder folder;
  folder.write("corpus/a.proof",
               "case c\n  scalar a, b, c, d\n  prove wrong: a == b\n  refute wrong_too: a == a\n"
               "  prove long: (a+b+c+d)^40*(a-b)^40/(c+d) == 1/(c-d)\n"
               "  open left: (a+b+c+d)^40*(a-b)^40/(c+d) == 1/(c-d)\n"
               "  assume never: 1 == 0\n  prove vacuous: a == b\nend\n");
  check(folder, {"--limit-steps", "1000"});
  CHECK(kept_files(folder).empty());
}

TEST_CASE("a file of the cache that is damaged counts as not there, and is written anew") {
  const TemporaryFolder folder;
  folder.write("corpus/a.proof", one_case);
  const Ended fresh = check(folder);
  for (const std::filesystem::path& file : kept_files(folder)) {
    const std::string whole = bytes_of(file);
    for (const std::string& damaged :
         {std::string{}, whole.substr(0, digits), whole.substr(0, whole.size() - 1), whole + "x",
          "0" + whole.substr(1), std::string(70, '\xff'), [&] {
            // As it should be, but no claim.
            const std::string digest =
                file.parent_path().filename().string() + file.filename().string();
            return sha256(digest + "\xf6") + "\xf6";
          }()}) {
      std::ofstream{file, std::ios::binary} << damaged;
      CHECK(check(folder).output == fresh.output);
      CHECK(bytes_of(file) == whole);
    }
    // What belongs to another claim.
    for (const std::filesystem::path& other : kept_files(folder))
      if (other != file) std::ofstream{file, std::ios::binary} << bytes_of(other);
    CHECK(check(folder).output == fresh.output);
    CHECK(bytes_of(file) == whole);
  }
}

TEST_CASE("several runs may use a cache at the same time") {
  const TemporaryFolder folder;
  write_corpus(folder);
  const Ended alone = run_program(folder, {"check", "corpus", "--format", "json"});
  std::vector<Ended> ended(4);
  std::vector<std::thread> runs;
  for (Ended& one : ended) runs.emplace_back([&] { one = check(folder, {"--jobs", "2"}); });
  for (std::thread& run : runs) run.join();
  for (const Ended& one : ended) CHECK(one.output == alone.output);
  for (const std::filesystem::path& file : kept_files(folder))
    CHECK(file.filename().string().size() == digits - 2);
}

TEST_CASE("a cache that cannot be made is said, and nothing is decided") {
  const TemporaryFolder folder;
  folder.write("corpus/a.proof", one_case);
  folder.write("cache", "a file");
  const Ended ended = check(folder);
  CHECK(ended.code == 4);
  CHECK(ended.output.empty());
  CHECK(ended.errors == "patchproof: --cache: cannot make the folder 'cache': Not a directory\n");
}

}  // namespace patchproof
