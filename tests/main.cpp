#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <string>
#include <string_view>

namespace {

/// "#algebra/number" for a test case in tests/algebra/number_test.cpp.
std::string file_tag(std::string_view path) {
  constexpr std::string_view folder = "/tests/";
  constexpr std::string_view ending = "_test.cpp";
  const std::size_t start = path.rfind(folder);
  if (start != std::string_view::npos) path.remove_prefix(start + folder.size());
  if (path.ends_with(ending)) path.remove_suffix(ending.size());
  return "#" + std::string{path};
}

/// Gives every test case the file it is in as a tag. Catch's own `--filenames-as-tags` forgets the
/// folder; it changes the registered test cases in the same way.
void tag_with_files(const Catch::IConfig& config) {
  for (const Catch::TestCase& test : Catch::getAllTestCasesSorted(config)) {
    auto& changed = const_cast<Catch::TestCase&>(test);
    std::vector<std::string> tags = test.tags;
    tags.push_back(file_tag(test.lineInfo.file));
    Catch::setTags(changed, tags);
  }
}

}  // namespace

/// Runs the tests named on the command line, or all. A run without a test fails, and so does a
/// test case without an assertion: Catch would let both pass.
int main(int argument_count, char* arguments[]) {
  Catch::Session session;
  const int usage_error = session.applyCommandLine(argument_count, arguments);
  if (usage_error != 0) return usage_error;
  using Warnings = Catch::WarnAbout;
  session.configData().warnings =
      static_cast<Warnings::What>(Warnings::NoTests | Warnings::NoAssertions);
  tag_with_files(session.config());
  return session.run();
}
