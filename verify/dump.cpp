// patchproof dump: the syntax tree of a file as JSON.
#include <verify/commands.hpp>
#include <verify/files.hpp>

#include <memory>

#include <patchproof/language/dump.hpp>
#include <patchproof/language/parser.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

ExitCode run(const std::string& path) {
  const bool standard_input = path == "-";
  const FileText read = standard_input ? standard_input_text() : file_text(path);
  FileReport file{standard_input ? standard_input_name : path, read.problem, {}, {}};
  if (read.text) {
    const Parsed parsed =
        parse(std::make_shared<const SourceText>(SourceText{file.path, *read.text}));
    file.diagnostics = in_order(parsed.diagnostics);
    if (file.diagnostics.empty())
      return print(dump(parsed.file)) ? ExitCode::as_expected : ExitCode::unreadable;
  }
  print_error(mistakes(Report{{file}, false}));
  return ExitCode::unreadable;
}

}  // namespace

void add_dump(CLI::App& program, ExitCode& result) {
  const auto path = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("dump", "Write the syntax tree of a file as JSON");
  command->add_option("FILE", *path, "A case file, or - for standard input")
      ->option_text("")
      ->required();
  command->footer("Example:\n  patchproof dump cases/coons/bilinear.proof\n");
  command->callback([path, &result] { result = run(*path); });
}

}  // namespace patchproof
