// patchproof latex: derivations as LaTeX, and what of it is stale.
#include <sys/stat.h>
#include <unistd.h>
#include <verify/certified.hpp>
#include <verify/check_options.hpp>
#include <verify/commands.hpp>
#include <verify/files.hpp>
#include <verify/latex_check.hpp>
#include <verify/latex_run.hpp>
#include <verify/output.hpp>
#include <verify/paths.hpp>
#include <verify/progress.hpp>
#include <verify/selection.hpp>

#include <filesystem>
#include <memory>

#include <patchproof/latex/case_figure.hpp>
#include <patchproof/latex/document.hpp>
#include <patchproof/latex/freshness.hpp>
#include <patchproof/latex/style_file.hpp>
#include <patchproof/report/text_report.hpp>
#include <patchproof/report/verdict_words.hpp>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

struct LatexArguments {
  CheckArguments check;
  std::string folder;
  std::string language = "en";
  std::string detail = "2";
  std::string checked_folder;
  std::string pdf_seconds = "600";
  bool fragment = false;
  bool pdf = false;
  bool no_figures = false;
};

DocumentOptions document_options(const LatexArguments& arguments) {
  DocumentOptions options;
  const std::optional<Language> language = language_of(arguments.language);
  if (!language) {
    std::string codes;
    for (const std::string& code : language_codes()) codes += (codes.empty() ? "" : ", ") + code;
    throw UsageError{"--lang: there is no language '" + arguments.language + "'; there are " +
                     codes};
  }
  options.language = *language;
  if (arguments.detail.size() != 1 || arguments.detail < "1" || arguments.detail > "3")
    throw UsageError{"--detail: '" + arguments.detail + "' is none of 1, 2, 3"};
  options.detail = static_cast<Detail>(arguments.detail.front() - '0');
  options.fragment = arguments.fragment;
  options.figures = !arguments.no_figures;
  return options;
}

bool prepared(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  std::string problem;
  if (error)
    problem = error.message();
  else if (!fs::is_directory(folder, error))
    problem = "Not a directory";
  else if (::access(folder.c_str(), W_OK | X_OK) != 0)
    problem = std::generic_category().message(errno);
  if (problem.empty()) return true;
  print_error("patchproof: cannot write into '" + folder + "': " + problem + "\n");
  return false;
}

bool write(const std::string& folder, const std::string& name, const std::string& text,
           const std::vector<std::string>& inputs) {
  Output output{(fs::path{folder} / name).string(), inputs};
  return output.good() && output.write(text);
}

std::vector<const Case*> all_cases(const std::vector<CaseFile>& files) {
  std::vector<const Case*> cases;
  for (const CaseFile& file : files)
    for (const Case& read : file.cases) cases.push_back(&read);
  return cases;
}

void say_what_is_empty(const FoundPaths& paths, const Selection& selection,
                       const std::vector<CaseFile>& files, bool nothing) {
  for (const std::string& folder : paths.empty_folders)
    print_error("patchproof: no .proof file in '" + folder + "'\n");
  const std::vector<std::string> unmatched = selection.unmatched(all_cases(files));
  for (const std::string& pattern : unmatched)
    print_error("patchproof: no claim matches --only '" + pattern + "'\n");
  if (nothing && paths.empty_folders.empty() && unmatched.empty())
    print_error("patchproof: there is no claim to write of\n");
}

std::vector<Page> pages_of(const Report& report, const CheckOptions& check,
                           const DocumentOptions& options) {
  std::vector<Page> pages;
  for (const FileReport& file : report.files)
    for (const CaseResult& result : file.cases) {
      if (result.claims.empty()) continue;
      Page page{result, case_derivation(result, options.detail, check.engines), "", ""};
      if (options.figures)
        page.figure = case_figure(result, {page.derivation.names, options.language});
      page.digest =
          case_digest(result.verified.span.source, result.verified.name, check.load, options)
              .value_or("");
      pages.push_back(std::move(page));
    }
  return pages;
}

// The book would be written over the file of such a case.
bool is_called_as_the_book(const std::vector<Page>& pages) {
  if (pages.size() < 2) return false;
  for (const Page& page : pages)
    if (file_name(page.result.verified) == book_name) {
      print_error(
          "patchproof: the case 'book' has the file name of the book; write it alone, or "
          "give it another name\n");
      return true;
    }
  return false;
}

bool written(const LatexArguments& arguments, const std::vector<Page>& pages,
             const DocumentOptions& options, const std::vector<std::string>& inputs) {
  if (!options.fragment && is_called_as_the_book(pages)) return false;
  if (!write(arguments.folder, std::string{style_file_name}, std::string{style_file()}, inputs))
    return false;
  for (const Page& page : pages)
    if (!write(arguments.folder, file_name(page.result.verified), document(page, options), inputs))
      return false;
  return pages.size() == 1 || options.fragment ||
         write(arguments.folder, book_name, book(pages, options), inputs);
}

/// Names the claims that a reader of the documents will find marked.
void say_what_needs_attention(const Report& report) {
  for (const FileReport& file : report.files)
    for (const CaseResult& result : file.cases)
      for (const ClaimResult& claim : result.claims)
        if (needs_attention(claim, report.strict))
          print_error("patchproof: " + claim_id(result.verified, claim.claim) + ": expected " +
                      expected_verdict(claim.claim.expectation) + ", found " +
                      verdict_line(claim.decision) + "\n");
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

ExitCode make_pdf(const LatexArguments& arguments, const std::vector<Page>& pages) {
  const std::string tex = pages.size() == 1 ? file_name(pages.front().result.verified) : book_name;
  const LatexRun ran =
      pdf_of(arguments.folder, tex, std::chrono::seconds{std::stoll(arguments.pdf_seconds)});
  if (!ran.good) {
    print_error("patchproof: " + ran.problem + "\n");
    return ExitCode::unreadable;
  }
  const fs::path pdf = fs::path{arguments.folder} / fs::path{tex}.replace_extension(".pdf");
  return print(pdf.string() + "\n") ? ExitCode::as_expected : ExitCode::unreadable;
}

ExitCode run(const LatexArguments& arguments) {
  const DocumentOptions options = document_options(arguments);
  const Selection selection{arguments.check.only};
  CheckOptions check = options_of(arguments.check);
  if (!selection.everything())
    check.wanted = [&](const Case& of, const Claim& claim) {
      return selection.contains(of, claim);
    };
  // No file that was read is written over, included ones neither.
  std::vector<std::string> read;
  check.load = [&read, load = check.load](const std::string& path) {
    read.push_back(path);
    return load(path);
  };
  const FoundPaths paths = found_paths(arguments.check.paths);
  const std::vector<CaseFile> files = read_files(inputs(paths), check);
  if (!prepared(arguments.folder)) return ExitCode::unreadable;

  std::size_t claims = 0;
  for (const Case* of : all_cases(files))
    for (const Claim& claim : of->claims) claims += selection.contains(*of, claim) ? 1U : 0U;
  Report report;
  std::vector<Page> pages;
  {
    Progress progress{claims};
    check.progress = [&](const Case& of, const Claim& claim) {
      progress.next(claim_id(of, claim));
    };
    report = decided(files, check);
    if (const std::string& folder = arguments.check.certificates; !folder.empty()) {
      CheckedFolder checked;
      if (const std::string problem = read_checked(folder, checked); !problem.empty()) {
        print_error("patchproof: " + problem + "\n");
        return ExitCode::unreadable;
      }
      raise_evidence(checked, report);
    }
    pages = pages_of(report, check, options);
  }
  print_error(mistakes(report));
  say_what_needs_attention(report);
  ExitCode code = exit_code(report);
  say_what_is_empty(paths, selection, files, pages.empty());
  if (pages.empty()) return code;
  read.insert(read.end(), paths.files.begin(), paths.files.end());
  if (!written(arguments, pages, options, read)) return graver(code, ExitCode::unreadable);
  const std::string said =
      counted(pages.size(), "case") + " written to '" + arguments.folder + "'\n";
  if (!print(said)) return graver(code, ExitCode::unreadable);
  return arguments.pdf ? graver(code, make_pdf(arguments, pages)) : code;
}

void declare(CLI::App& command, LatexArguments& a) {
  const auto option = [&](const std::string& name, auto& value, const std::string& what,
                          const std::string& type) {
    return command.add_option(name, value, what)->option_text(type);
  };
  option("PATH", a.check.paths, "Case files, folders of *.proof, or - for standard input", "...");
  option("-o,--output", a.folder, "Folder for the .tex files; it is made if need be", "DIR");
  option("--only", a.check.only,
         "Only these claims: their ids, names of cases, or tag:NAME; * stands for any characters; "
         "may be given several times",
         "GLOB")
      ->allow_extra_args(false);
  option(
      "--certificates", a.check.certificates,
      "Folder of 'patchproof certify --check': what is still as it was checked there is certified",
      "DIR");
  option("--lang", a.language, "Language of the words: en (usual), cs, sk, sl or ru", "CODE");
  option("--detail", a.detail,
         "1: statements and results, 2 (usual): the steps a book prints, 3: all definitions and "
         "instances",
         "N");
  command.add_flag("--fragment", a.fragment, "Bodies only, for \\input into a document of yours");
  command.add_flag("--no-figures", a.no_figures, "Without pictures of patches");
  CLI::Option* pdf = command.add_flag("--pdf", a.pdf, "Make the PDF too, by latexmk and LuaLaTeX");
  pdf->excludes("--fragment");
  option("--pdf-time", a.pdf_seconds, "Time for LaTeX, in seconds; usual are 600", "N")
      ->check(whole_number());
  option("--check", a.checked_folder, "Only list the .tex files in a folder that are stale", "DIR");
  a.check.engines = "both";
  option("--engines", a.check.engines,
         "both (usual), usual as in 'check', or kernel: without second opinion", "WHICH")
      ->check(CLI::IsMember(std::set<std::string>{"usual", "both", "kernel"}));
  option("--limit-time", a.check.seconds, "Time for a claim; 0: no limit", "SECONDS")
      ->check(number_of_seconds());
  option("--limit-steps", a.check.steps, "Arithmetic steps for a claim; 0: no limit", "N")
      ->check(whole_number());
  command.footer(
      "Ends like 'patchproof check'; with 4 also when a file cannot be written or LaTeX fails.\n"
      "With --check: 0 when all files are fresh, 1 when one is stale, 5 when there is none.\n\n"
      "Example:\n  patchproof latex cases/coons -o out --pdf\n");
}

}  // namespace

void add_latex(CLI::App& program, ExitCode& result) {
  const auto arguments = std::make_shared<LatexArguments>();
  CLI::App* command = program.add_subcommand("latex", "Write statements and derivations as LaTeX");
  declare(*command, *arguments);
  command->callback([arguments, &result] {
    if (!arguments->checked_folder.empty()) {
      if (!arguments->check.paths.empty())
        throw UsageError{"--check looks at a folder of .tex files and takes no PATH"};
      result = checked(arguments->checked_folder);
      return;
    }
    if (arguments->check.paths.empty())
      throw UsageError{"nothing to write of: name files or folders, or '-' for standard input"};
    if (arguments->folder.empty())
      throw UsageError{"-o is missing: name a folder for the .tex files"};
    result = run(*arguments);
  });
}

}  // namespace patchproof
