// patchproof recheck: certificates are looked at again by the second checker.
#include <recheck/run.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>

#include <memory>

namespace patchproof {

namespace {

ExitCode run(const std::vector<std::string>& paths) {
  const recheck::Run run = recheck::run_of(paths);
  const bool well = print(run.output);
  print_error(run.errors);
  const auto code = static_cast<ExitCode>(run.code);
  return well ? code : graver(code, ExitCode::unreadable);
}

}  // namespace

void add_recheck(CLI::App& program, ExitCode& result) {
  const auto paths = std::make_shared<std::vector<std::string>>();
  CLI::App* command = program.add_subcommand(
      "recheck", "Look at certificates again, without the engines that found them");
  command->add_option("FILE", *paths, "Documents of certificates (JSON), or - for standard input")
      ->option_text("...");
  command->footer(
      "Ends with 0 when all certificates are rechecked, 1 when one is rejected, 2 when one cannot\n"
      "be judged, 4 when a file cannot be read, 5 when there is no certificate.\n"
      "The program patchproof-recheck does the same; it holds nothing of patchproof.\n\n"
      "Example:\n  patchproof recheck twist.certificates.json\n");
  command->callback([paths, &result] {
    if (paths->empty())
      throw UsageError{"nothing to recheck: name files, or '-' for standard input"};
    result = run(*paths);
  });
}

}  // namespace patchproof
