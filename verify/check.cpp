// patchproof check: reads case files, decides their claims, writes the report.
#include <unistd.h>
#include <verify/certified.hpp>
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/list.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>
#include <verify/progress.hpp>
#include <verify/selection.hpp>

#include <cstdlib>
#include <memory>

#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

bool wants_colour(const CheckArguments& arguments) {
  if (arguments.colour != "auto") return arguments.colour == "always";
  // https://no-color.org: set and not empty.
  const char* no_colour = std::getenv("NO_COLOR");
  if (no_colour != nullptr && *no_colour != '\0') return false;
  const char* terminal = std::getenv("TERM");
  if (terminal != nullptr && std::string{terminal} == "dumb") return false;
  return arguments.output.empty() && ::isatty(STDOUT_FILENO) == 1;
}

ReportStyle style_of(const CheckArguments& arguments) {
  ReportStyle style;
  if (arguments.quiet) style.verbosity = Verbosity::quiet;
  if (arguments.verbose) style.verbosity = Verbosity::verbose;
  style.colour = wants_colour(arguments);
  return style;
}

std::vector<const Case*> all_cases(const std::vector<CaseFile>& files) {
  std::vector<const Case*> cases;
  for (const CaseFile& file : files)
    for (const Case& read : file.cases) cases.push_back(&read);
  return cases;
}

std::size_t count_of(const Selection& selection, const std::vector<const Case*>& cases) {
  std::size_t count = 0;
  for (const Case* of : cases)
    for (const Claim& claim : of->claims)
      if (selection.contains(*of, claim)) ++count;
  return count;
}

/// Says what of the command line came to nothing: such a run is not to look like a success.
void say_what_is_empty(const FoundPaths& paths, const Selection& selection,
                       const std::vector<CaseFile>& files, ExitCode code) {
  for (const std::string& folder : paths.empty_folders)
    print_error("patchproof: no .proof file in '" + folder + "'\n");
  const std::vector<std::string> unmatched = selection.unmatched(all_cases(files));
  for (const std::string& pattern : unmatched)
    print_error("patchproof: no claim matches --only '" + pattern + "'\n");
  const bool said = !paths.empty_folders.empty() || !unmatched.empty();
  if (code == ExitCode::nothing_ran && !said)
    print_error("patchproof: there is no claim to decide\n");
}

Report decided_with_progress(const std::vector<CaseFile>& files, CheckOptions options,
                             std::size_t claims) {
  Progress progress{claims};
  options.progress = [&](const Case& of, const Claim& claim) {
    progress.next(claim_id(of, claim));
  };
  return decided(files, options);
}

ExitCode run(const CheckArguments& arguments) {
  const Selection selection{arguments.only};
  CheckOptions options = options_of(arguments);
  if (!selection.everything())
    options.wanted = [&](const Case& of, const Claim& claim) {
      return selection.contains(of, claim);
    };

  const FoundPaths paths = found_paths(arguments.paths);
  const std::vector<CaseFile> files = read_files(inputs(paths), options);
  // Opened before the work is done, which would be in vain if it could not be written down.
  Output output{arguments.output, paths.files};
  if (!output.good()) return ExitCode::unreadable;

  const std::size_t claims = count_of(selection, all_cases(files));
  // A list is what is left when nothing is decided.
  if (arguments.list) options.wanted = [](const Case&, const Claim&) { return false; };
  Report report = decided_with_progress(files, options, claims);
  print_error(mistakes(report));
  ExitCode code = exit_code(report);
  if (const std::string problem = evidence_raised(arguments.certificates, report);
      !problem.empty()) {
    print_error("patchproof: " + problem + "\n");
    code = graver(code, ExitCode::unreadable);
  }
  if (arguments.list && code == ExitCode::nothing_ran && claims > 0) code = ExitCode::as_expected;
  say_what_is_empty(paths, selection, files, code);
  const bool well =
      output.write(arguments.list ? list_of(all_cases(files), selection, arguments.format)
                                  : written(report, arguments.format, style_of(arguments)));
  return well ? code : graver(code, ExitCode::unreadable);
}

}  // namespace

void add_check(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = program.add_subcommand("check", "Decide the claims of case files");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (arguments->paths.empty())
      throw UsageError{"nothing to check: name files or folders, or '-' for standard input"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
