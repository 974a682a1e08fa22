// patchproof check: reads case files, decides their claims, writes the report.
#include <unistd.h>
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/crew.hpp>
#include <verify/files.hpp>
#include <verify/list.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>
#include <verify/progress.hpp>
#include <verify/selection.hpp>

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <system_error>

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

/// Says what of the command line came to nothing: such a run is not to look like a success.
void say_what_is_empty(const FoundPaths& paths, const std::vector<std::string>& unmatched,
                       ExitCode code) {
  for (const std::string& folder : paths.empty_folders)
    print_error("patchproof: no .proof file in '" + folder + "'\n");
  for (const std::string& pattern : unmatched)
    print_error("patchproof: no claim matches --only '" + pattern + "'\n");
  const bool said = !paths.empty_folders.empty() || !unmatched.empty();
  if (code == ExitCode::nothing_ran && !said)
    print_error("patchproof: there is no claim to decide\n");
}

Work work_of(const CheckArguments& arguments, const FoundPaths& paths) {
  Work work;
  work.options = options_of(arguments);
  work.selection = Selection{arguments.only};
  if (!arguments.shard.empty()) work.shard = *shard_from_text(arguments.shard);
  for (const Input& unreadable : paths.unreadable) {
    work.known.emplace(work.paths.size(), unreadable);
    work.paths.push_back(unreadable.path);
  }
  for (const std::string& path : paths.files) {
    const bool standard_input = path == "-";
    if (standard_input) work.known.emplace(work.paths.size(), input_at(path));
    work.paths.push_back(standard_input ? standard_input_name : path);
  }
  return work;
}

// Nothing is decided, so that there is nothing to share out.
ExitCode list(const CheckArguments& arguments, const FoundPaths& paths, Output& output) {
  CheckOptions options = options_of(arguments);
  const std::vector<CaseFile> files = read_files(inputs(paths), options);
  const Selection selection{arguments.only};
  std::vector<const Case*> cases;
  bool any = false;
  for (const CaseFile& file : files)
    for (const Case& read : file.cases) {
      cases.push_back(&read);
      for (const Claim& claim : read.claims) any = any || selection.contains(read, claim);
    }
  options.wanted = [](const Case&, const Claim&) { return false; };
  const Report report = decided(files, options);
  print_error(mistakes(report));
  ExitCode code = exit_code(report);
  if (code == ExitCode::nothing_ran && any) code = ExitCode::as_expected;
  say_what_is_empty(paths, selection.unmatched(cases), code);
  const bool well = output.write(list_of(cases, selection, arguments.format));
  return well ? code : graver(code, ExitCode::unreadable);
}

ExitCode run(const CheckArguments& arguments) {
  const FoundPaths paths = found_paths(arguments.paths);
  // Opened before the work is done, which would be in vain if it could not be written down.
  Output output{arguments.output, paths.files};
  if (!output.good()) return ExitCode::unreadable;
  if (arguments.list) return list(arguments, paths, output);

  Work work = work_of(arguments, paths);
  try {
    if (!arguments.cache.empty()) work.cache.emplace(arguments.cache);
  } catch (const std::runtime_error& error) {
    print_error("patchproof: --cache: " + std::string{error.what()} + "\n");
    return ExitCode::unreadable;
  }
  std::string problem;
  if (!arguments.certificates.empty()) {
    work.checked.emplace();
    problem = read_checked(arguments.certificates, *work.checked);
    if (!problem.empty()) work.checked.reset();
  }
  WorkDone done;
  try {
    Progress progress;
    done = done_by_crew(work, jobs_of(arguments), [&](const std::string& id, std::size_t claims) {
      progress.next(id, claims);
    });
  } catch (const std::system_error& error) {
    print_error(
        "patchproof: no process can be started to decide claims: " + error.code().message() + "\n");
    return ExitCode::unreadable;
  } catch (const std::runtime_error& error) {
    print_error("patchproof: " + std::string{error.what()} + "\n");
    return ExitCode::unreadable;
  }
  print_error(mistakes(done.run));
  ExitCode code = exit_code(done.run);
  if (!problem.empty()) {
    print_error("patchproof: " + problem + "\n");
    code = graver(code, ExitCode::unreadable);
  }
  say_what_is_empty(paths, done.unmatched, code);
  write(done.run, arguments.format, style_of(arguments),
        [&](std::string_view piece) { output.add(piece); });
  return output.end() ? code : graver(code, ExitCode::unreadable);
}

}  // namespace

void add_check(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = program.add_subcommand("check", "Decide the claims of case files");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (arguments->paths.empty())
      throw UsageError{"nothing to check: name files or folders, or '-' for standard input"};
    for (const auto& [given, option] :
         {std::pair{arguments->audit, "--audit"},
          std::pair{!arguments->certificates.empty(), "--certificates"},
          std::pair{arguments->list, "--list"}})
      if (given && !arguments->shard.empty())
        throw UsageError{std::string{option} + " is about whole cases: leave out --shard"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
