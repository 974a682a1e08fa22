#include <verify/files.hpp>
#include <verify/latex_run.hpp>
#include <verify/process.hpp>

#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>
#include <thread>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

const char* const packages =
    "texlive-luatex texlive-latex-recommended texlive-pictures latexmk fonts-cmu "
    "texlive-lang-czechslovak texlive-lang-european texlive-lang-cyrillic";

/// The exit code; -1 when the time was up or a signal ended it, nothing when it did not start.
std::optional<int> latexmk_code(const std::string& folder, const std::string& tex,
                                std::chrono::seconds longest) {
  constexpr std::chrono::milliseconds pause{20};
  Process latexmk{{"latexmk", "-norc", "-lualatex", "-interaction=nonstopmode", "-halt-on-error",
                   "-file-line-error", "-no-shell-escape", tex},
                  folder,
                  ""};
  if (!latexmk.started()) return std::nullopt;
  while (!latexmk.ended()) {
    if (latexmk.age() > longest) latexmk.kill();
    std::this_thread::sleep_for(pause);
  }
  return latexmk.code();
}

}  // namespace

LatexError first_error(const std::string& log) {
  static const std::regex pattern{R"(^(.+?\.(?:tex|sty|aux|toc)):([0-9]{1,9}): (.*)$)"};
  std::istringstream lines{log};
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.size() < 1000 && std::regex_match(line, match, pattern)) {
      std::string file = match[1].str();
      if (file.starts_with("./")) file = file.substr(2);
      return {file, std::stoul(match[2].str()), match[3].str()};
    }
    if (line.starts_with("! ")) return {"", 0, line.substr(2)};
  }
  return {};
}

std::string place_in_case(const std::string& tex, std::size_t line) {
  constexpr std::string_view mark = "% case ";
  std::istringstream lines{tex};
  std::string place;
  std::string text;
  for (std::size_t k = 1; k <= line && std::getline(lines, text); ++k)
    if (text.starts_with(mark)) place = text.substr(mark.size());
  return place;
}

LatexRun pdf_of(const std::string& folder, const std::string& tex, std::chrono::seconds longest) {
  for (const char* program : {"latexmk", "lualatex"})
    if (!is_installed(program))
      return {false, "cannot make a PDF: there is no '" + std::string{program} +
                         "'\n  = help: on Debian: apt-get install " + packages};
  const fs::path base = fs::path{folder} / fs::path{tex}.replace_extension();
  const std::string log_path = base.string() + ".log";
  std::error_code ignored;
  // What an earlier run said is not to be taken for what this one says.
  fs::remove(log_path, ignored);
  const std::optional<int> code = latexmk_code(folder, tex, longest);
  if (!code) return {false, "cannot start latexmk"};
  if (*code == 0) return {true, ""};
  std::string problem = "LaTeX failed on '" + (fs::path{folder} / tex).string() + "'";
  if (*code == -1) problem += ": stopped after " + std::to_string(longest.count()) + " seconds";
  const LatexError error = first_error(file_text(log_path).text.value_or(""));
  if (!error.message.empty()) {
    problem += "\n  = error: ";
    if (!error.file.empty()) problem += error.file + ":" + std::to_string(error.line) + ": ";
    problem += error.message;
    const std::string place = place_in_case(
        file_text((fs::path{folder} / error.file).string()).text.value_or(""), error.line);
    if (!place.empty()) problem += "\n  = in the case: " + place;
  }
  return {false, problem + "\n  = log: " + log_path};
}

}  // namespace patchproof
