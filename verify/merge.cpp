// patchproof merge: joins JSON reports, those of the shards of a run above all.
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/output.hpp>

#include <memory>
#include <set>

#include <patchproof/report/merge.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

// A million claims or so.
constexpr std::size_t most_megabytes = 1024;

struct MergeArguments {
  std::vector<std::string> reports;
  std::string format = "text";
  std::string output;
};

ExitCode run(const MergeArguments& arguments) {
  Output output{arguments.output, arguments.reports};
  if (!output.good()) return ExitCode::unreadable;
  ExitCode code = ExitCode::as_expected;
  const auto complain = [&](const std::string& what) {
    print_error("patchproof: " + what + "\n");
    code = ExitCode::unreadable;
  };
  std::vector<ReadReport> reports;
  for (const std::string& path : arguments.reports) {
    const FileText text = file_text(path, most_megabytes);
    if (!text.text) {
      complain("cannot read '" + path + "': " + text.problem);
      continue;
    }
    try {
      reports.push_back(report_from_json(path, *text.text));
    } catch (const std::invalid_argument& error) {
      complain("'" + path + "' is " + error.what());
    }
  }
  const MergedReport all = merged(reports);
  for (const std::string& what : all.complaints) complain(what);
  print_error(mistakes(all.run));
  code = graver(code, exit_code(all.run));
  write(all.run, arguments.format, {}, [&](std::string_view piece) { output.add(piece); });
  return output.end() ? code : graver(code, ExitCode::unreadable);
}

}  // namespace

void add_merge(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = program.add_subcommand("merge", "Join JSON reports of 'check' into one");
  command->add_option("REPORT", arguments->reports, "JSON reports, of the shards of a run")
      ->required()
      ->option_text("...");
  command->add_option("--format", arguments->format, "text (usual) or json")
      ->option_text("FORMAT")
      ->check(CLI::IsMember(std::set<std::string>{"text", "json"}));
  command->add_option("--output", arguments->output, "Write the report to a file")
      ->option_text("FILE");
  command->footer(
      "Ends as 'patchproof check' would have ended for all claims together, and with 4 when a\n"
      "report cannot be read, a shard is missing, a claim is in two reports, or the reports are\n"
      "of different versions or runs.\n\n"
      "Example:\n  patchproof merge shard1.json shard2.json\n");
  command->callback([arguments, &result] { result = run(*arguments); });
}

}  // namespace patchproof
