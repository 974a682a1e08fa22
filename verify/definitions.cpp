// patchproof definitions: the textbook constructions, as they are written.
#include <verify/commands.hpp>
#include <verify/files.hpp>

#include <algorithm>
#include <memory>

#include <patchproof/language/nearest_name.hpp>
#include <patchproof/language/reader.hpp>
#include <patchproof/language/utf8.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

namespace {

struct DefinitionsArguments {
  std::vector<std::string> names;
  std::string file;
};

std::string title_of(const syntax::Definition& definition) {
  for (const syntax::Statement& statement : definition.statements)
    if (statement.kind == syntax::Statement::Kind::title) return printable(statement.text);
  return "";
}

std::string call_of(const syntax::Definition& definition) {
  std::string text = definition.name.text + "(";
  for (const syntax::Formal& formal : definition.formals)
    text += (text.back() == '(' ? "" : ", ") + formal.name.text;
  return text + ")";
}

std::string list_of(const Library& library) {
  constexpr std::size_t widest = 48;
  std::size_t width = 0;
  for (const std::string& name : library.names())
    width = std::max(width, std::min(call_of(*library.find(name)).size(), widest));
  std::string text;
  for (const std::string& name : library.names()) {
    const syntax::Definition& definition = *library.find(name);
    const std::string call = call_of(definition);
    const std::string title = title_of(definition);
    text += call;
    if (!title.empty())
      text += std::string(call.size() < width ? width - call.size() : 0, ' ') + "  " + title;
    text += "\n";
  }
  return text;
}

std::string source_of(const syntax::Definition& definition) {
  const Span& span = definition.span;
  return span.source->text.substr(span.begin, span.end - span.begin) + "\n";
}

ExitCode show(const Library& library, const std::vector<std::string>& names) {
  if (names.empty()) return print(list_of(library)) ? ExitCode::as_expected : ExitCode::unreadable;
  std::string text;
  for (const std::string& name : names) {
    const syntax::Definition* definition = library.find(name);
    if (definition == nullptr) {
      const std::string help = did_you_mean(name, library.names());
      throw UsageError{"there is no definition '" + name + "'" + (help.empty() ? "" : "; " + help)};
    }
    text += (text.empty() ? "" : "\n") + source_of(*definition);
  }
  return print(text) ? ExitCode::as_expected : ExitCode::unreadable;
}

ExitCode run(const DefinitionsArguments& arguments) {
  if (arguments.file.empty()) return show(Library::prelude(), arguments.names);
  const bool standard_input = arguments.file == "-";
  const FileText read = standard_input ? standard_input_text() : file_text(arguments.file);
  FileReport file{standard_input ? standard_input_name : arguments.file, read.problem, {}, {}};
  if (read.text) {
    const auto source = std::make_shared<const SourceText>(SourceText{file.path, *read.text});
    const Loader load = [](const std::string& path) { return file_text(path).text; };
    const Library library = read_definitions(source, load, file.diagnostics);
    file.diagnostics = in_order(std::move(file.diagnostics));
    if (file.diagnostics.empty()) return show(library, arguments.names);
  }
  print_error(mistakes(Report{{file}, false}));
  return ExitCode::unreadable;
}

}  // namespace

void add_definitions(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<DefinitionsArguments>();
  CLI::App* command =
      program.add_subcommand("definitions", "List the textbook constructions, or show some");
  command->add_option("NAME", arguments->names, "Show how these are defined")->option_text("...");
  command
      ->add_option("--file", arguments->file,
                   "Also those of a file and of what it includes; - for standard input")
      ->option_text("FILE");
  command->footer("Example:\n  patchproof definitions ruled\n");
  command->callback([arguments, &result] { result = run(*arguments); });
}

}  // namespace patchproof
