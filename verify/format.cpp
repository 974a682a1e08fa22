// patchproof fmt: case files in their standard form.
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/paths.hpp>

#include <memory>

#include <patchproof/language/formatter.hpp>
#include <patchproof/language/parser.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

struct FormatArguments {
  std::vector<std::string> paths;
  bool check = false;
};

ExitCode changed(const Input& input, const std::string& fresh, const FormatArguments& arguments) {
  const bool standard_input = input.path == standard_input_name;
  if (arguments.check) {
    if (fresh == *input.text) return ExitCode::as_expected;
    return print(input.path + "\n") ? ExitCode::wrong : ExitCode::unreadable;
  }
  if (standard_input) return print(fresh) ? ExitCode::as_expected : ExitCode::unreadable;
  if (fresh == *input.text) return ExitCode::as_expected;
  const std::string problem = replace_file(input.path, fresh);
  if (problem.empty()) return ExitCode::as_expected;
  print_error("patchproof: cannot write '" + input.path + "': " + problem + "\n");
  return ExitCode::unreadable;
}

ExitCode format_one(const Input& input, const FormatArguments& arguments) {
  FileReport file{input.path, input.unreadable, {}, {}};
  if (input.text) {
    const auto source = std::make_shared<const SourceText>(SourceText{input.path, *input.text});
    file.diagnostics = in_order(parse(source).diagnostics);
    if (file.diagnostics.empty()) return changed(input, formatted(*source), arguments);
  }
  print_error(mistakes(Report{{file}, false}));
  return ExitCode::unreadable;
}

ExitCode run(const FormatArguments& arguments) {
  const FoundPaths paths = found_paths(arguments.paths);
  ExitCode result = ExitCode::as_expected;
  const std::vector<Input> files = inputs(paths);
  for (const Input& input : files) result = graver(result, format_one(input, arguments));
  for (const std::string& folder : paths.empty_folders)
    print_error("patchproof: no .proof file in '" + folder + "'\n");
  return files.empty() ? ExitCode::nothing_ran : result;
}

}  // namespace

void add_format(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<FormatArguments>();
  CLI::App* command = program.add_subcommand("fmt", "Put case files into their standard form");
  command
      ->add_option("PATH", arguments->paths,
                   "Files, folders of *.proof, or - to filter standard input")
      ->option_text("...");
  command->add_flag("--check", arguments->check,
                    "Change nothing; list the files that would change, and end with 1 if any");
  command->footer("Files with mistakes stay as they are.\n\nExample:\n  patchproof fmt cases\n");
  command->callback([arguments, &result] {
    if (arguments->paths.empty())
      throw UsageError{"nothing to format: name files or folders, or '-' for standard input"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
