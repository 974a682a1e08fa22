// patchproof repair: the smallest changes of false statements that make them true.
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>
#include <verify/selection.hpp>

#include <memory>

#include <patchproof/language/parser.hpp>
#include <patchproof/report/repair_report.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

constexpr std::size_t most_changes = 3;

struct RepairArguments {
  CheckArguments check;
  std::string changes;
  std::string candidates;
};

const syntax::Case* written_case(const Parsed& parsed, const Case& given) {
  for (const syntax::Case& written : parsed.file.cases)
    if (written.name.span.begin == given.span.begin) return &written;
  return nullptr;
}

bool any_wanted(const Case& given, const RepairOptions& options) {
  for (const Claim& claim : given.claims)
    if (!options.wanted || options.wanted(given, claim)) return true;
  return false;
}

/// Adds the repairs of one file.
void repair(const CaseFile& file, const CheckOptions& check, const RepairOptions& options,
            RepairReport& report) {
  report.files.push_back({file.path, file.unreadable, file.diagnostics, {}});
  if (file.cases.empty()) return;
  const std::shared_ptr<const SourceText>& source = file.cases.front().span.source;
  std::vector<Diagnostic> reported_before;
  const Library library = read_definitions(source, check.load, reported_before);
  const Parsed parsed = parse(source);
  for (const Case& given : file.cases) {
    const syntax::Case* written = written_case(parsed, given);
    if (written == nullptr || !any_wanted(given, options)) continue;
    for (Repairs& repairs : repairs_of(*written, given, library, options))
      report.statements.push_back(std::move(repairs));
  }
}

RepairOptions repair_options(const RepairArguments& arguments, const Selection& selection) {
  RepairOptions options;
  options.engines = options_of(arguments.check).engines;
  if (!arguments.changes.empty()) options.most_changes = std::stoull(arguments.changes);
  if (options.most_changes < 1 || options.most_changes > most_changes)
    throw UsageError{"--most: from 1 to " + std::to_string(most_changes) + " changes can be tried"};
  if (!arguments.candidates.empty()) options.most_candidates = std::stoull(arguments.candidates);
  if (!selection.everything())
    options.wanted = [&selection](const Case& of, const Claim& claim) {
      return selection.contains(of, claim);
    };
  return options;
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

ExitCode run(const RepairArguments& arguments) {
  const Selection selection{arguments.check.only};
  const CheckOptions check = options_of(arguments.check);
  const RepairOptions options = repair_options(arguments, selection);
  const FoundPaths paths = found_paths(arguments.check.paths);
  const std::vector<CaseFile> files = read_files(inputs(paths), check);
  Output output{arguments.check.output, paths.files};
  if (!output.good()) return ExitCode::unreadable;
  RepairReport report;
  for (const CaseFile& file : files) repair(file, check, options, report);
  print_error(mistakes(Report{report.files, false}));
  say_what_is_empty(paths, selection, files);
  const ExitCode code = exit_code(report);
  return output.write(written(report, arguments.check.format)) ? code
                                                               : graver(code, ExitCode::unreadable);
}

void declare(CLI::App& command, RepairArguments& a) {
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
  option("--most", a.changes, "Changes that are tried together; usual are 2", "N")
      ->check(whole_number());
  option("--candidates", a.candidates, "Changed statements that are looked at; usual are 20000",
         "N")
      ->check(whole_number());
  option("--format", a.check.format, "text (usual) or json", "FORMAT")
      ->check(CLI::IsMember(std::set<std::string>{"text", "json"}));
  option("--output", a.check.output, "Write the report to a file", "FILE");
  a.check.engines = "both";
  option("--engines", a.check.engines,
         "both (usual), usual as in 'check', or kernel: without second opinion", "WHICH")
      ->check(CLI::IsMember(std::set<std::string>{"usual", "both", "kernel"}));
  option("--limit-time", a.check.seconds, "Time for a statement; 0: no limit", "SECONDS")
      ->check(number_of_seconds());
  option("--limit-steps", a.check.steps, "Arithmetic steps for a claim; 0: no limit", "N")
      ->check(whole_number());
  command.footer(
      "Ends with 0 when every false statement has a repair, 1 when one has none, 2 when the\n"
      "search for one was stopped, 4 for mistakes in a text, 5 when no statement is false, 64 for\n"
      "a wrong command line, 70 for a fault of the program.\n\n"
      "Example:\n  patchproof repair cases --only 'ru.P2.*'\n");
}

}  // namespace

void add_repair(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<RepairArguments>();
  CLI::App* command =
      program.add_subcommand("repair", "Find the smallest changes that make false claims true");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (arguments->check.paths.empty())
      throw UsageError{"nothing to repair: name files or folders, or '-' for standard input"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
