// patchproof mutate: which typical errors the claims of a case would not notice.
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>
#include <verify/progress.hpp>
#include <verify/selection.hpp>

#include <memory>

#include <patchproof/language/parser.hpp>
#include <patchproof/report/mutation_report.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

/// A case is decided hundreds of times: one time may not cost much.
constexpr std::uint64_t usual_steps = 20'000'000;

struct MutateArguments {
  CheckArguments check;
  std::string most;
};

MutationOptions mutation_options(const MutateArguments& arguments, const Selection& selection) {
  const CheckOptions check = options_of(arguments.check);
  MutationOptions options;
  options.limits = check.limits;
  if (arguments.check.steps.empty()) options.limits.steps = usual_steps;
  options.load = check.load;
  if (!arguments.most.empty()) options.most = std::stoull(arguments.most);
  if (options.most < 1) throw UsageError{"--most: at least 1 change has to be tried"};
  if (!selection.everything())
    options.wanted = [&selection](const Case& of, const Claim& claim) {
      return selection.contains(of, claim);
    };
  return options;
}

/// Adds what becomes of the errors in one file.
void mutate(const CaseFile& file, const MutationOptions& options, MutationReport& report) {
  report.files.push_back({file.path, file.unreadable, file.diagnostics, {}});
  if (file.cases.empty()) return;
  const Parsed parsed = parse(file.cases.front().span.source);
  for (CaseMutation& mutation : mutations_of(parsed.file, file.cases, options))
    report.cases.push_back(std::move(mutation));
}

void mutate_with_progress(const std::vector<CaseFile>& files, MutationOptions options,
                          MutationReport& report) {
  std::size_t cases = 0;
  for (const CaseFile& file : files) cases += file.cases.size();
  Progress progress{cases};
  options.progress = [&](const Case& of) { progress.next(of.name); };
  for (const CaseFile& file : files) mutate(file, options, report);
}

void say_what_is_empty(const FoundPaths& paths, const Selection& selection,
                       const std::vector<CaseFile>& files) {
  for (const std::string& folder : paths.empty_folders)
    print_error("patchproof: no .proof file in '" + folder + "'\n");
  std::vector<const Case*> cases;
  for (const CaseFile& file : files)
    for (const Case& read : file.cases) cases.push_back(&read);
  for (const std::string& pattern : selection.unmatched(cases))
    print_error("patchproof: no claim matches --only '" + pattern + "'\n");
}

ExitCode run(const MutateArguments& arguments) {
  const Selection selection{arguments.check.only};
  const MutationOptions options = mutation_options(arguments, selection);
  const FoundPaths paths = found_paths(arguments.check.paths);
  const std::vector<CaseFile> files = read_files(inputs(paths), options_of(arguments.check));
  Output output{arguments.check.output, paths.files};
  if (!output.good()) return ExitCode::unreadable;
  MutationReport report;
  report.verbose = arguments.check.verbose;
  mutate_with_progress(files, options, report);
  print_error(mistakes(Report{report.files, false}));
  say_what_is_empty(paths, selection, files);
  const ExitCode code = exit_code(report);
  return output.write(written(report, arguments.check.format)) ? code
                                                               : graver(code, ExitCode::unreadable);
}

void declare(CLI::App& command, MutateArguments& a) {
  const auto option = [&](const std::string& name, std::string& value, const std::string& what,
                          const std::string& type) {
    return command.add_option(name, value, what)->option_text(type);
  };
  command
      .add_option("PATH", a.check.paths, "Case files, folders of *.proof, or - for standard input")
      ->option_text("...");
  command
      .add_option("--only", a.check.only,
                  "Only these claims: their ids, names of cases, or tag:NAME; * stands for any "
                  "characters; may be given several times")
      ->option_text("GLOB")
      ->allow_extra_args(false);
  option("--most", a.most, "Changes that are tried in one claim or declaration; usual are 40", "N")
      ->check(whole_number());
  option("--format", a.check.format, "text (usual) or json", "FORMAT")
      ->check(CLI::IsMember(std::set<std::string>{"text", "json"}));
  option("--output", a.check.output, "Write the report to a file", "FILE");
  command.add_flag("-v,--verbose", a.check.verbose,
                   "Also the changes that say the same, and all of long lists");
  option("--limit-time", a.check.seconds, "Time for a claim; 0: no limit", "SECONDS")
      ->check(number_of_seconds());
  option("--limit-steps", a.check.steps,
         "Arithmetic steps for a claim, each time; 0: no limit; usual are 20000000", "N")
      ->check(whole_number());
  command.footer(
      "Ends with 0 when every change is noticed, 1 when one is not, or a claim is wrong without\n"
      "any, 2 when something was not decided, 4 for mistakes in a text, 5 when there is nothing\n"
      "to change, 64 for a wrong command line, 70 for a fault of the program.\n\n"
      "Example:\n  patchproof mutate cases/bspline --only 'bspline.*'\n");
}

}  // namespace

void add_mutate(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<MutateArguments>();
  CLI::App* command =
      program.add_subcommand("mutate", "Find the typical errors that no claim would notice");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (arguments->check.paths.empty())
      throw UsageError{"nothing to change: name files or folders, or '-' for standard input"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
