#include <verify/files.hpp>
#include <verify/latex_check.hpp>

#include <algorithm>
#include <filesystem>

#include <patchproof/latex/freshness.hpp>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

/// Why a file is stale; "" when it is fresh.
std::string staleness(const Header& header) {
  const Loader load = [](const std::string& path) { return file_text(path).text; };
  std::vector<std::string> digests;
  for (const auto& [name, path] : header.cases) {
    if (path == standard_input_name) return "its case came from standard input";
    const FileText file = file_text(path);
    if (!file.text) return "cannot read '" + path + "': " + file.problem;
    const auto source = std::make_shared<const SourceText>(SourceText{path, *file.text});
    const std::optional<std::string> digest = case_digest(source, name, load, header.options);
    if (!digest) return "'" + path + "' has no case '" + name + "'";
    digests.push_back(*digest);
  }
  const bool one = digests.size() == 1 && digests.front() == header.digest;
  return one || book_digest(digests) == header.digest
             ? ""
             : "the case, a definition or the program has changed";
}

}  // namespace

ExitCode checked(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  fs::directory_iterator entry{folder, error};
  for (; !error && entry != fs::directory_iterator{}; entry.increment(error))
    if (entry->path().extension() == ".tex") paths.push_back(entry->path());
  if (error) {
    print_error("patchproof: cannot read '" + folder + "': " + error.message() + "\n");
    return ExitCode::unreadable;
  }
  std::sort(paths.begin(), paths.end());
  std::size_t count = 0;
  std::size_t stale = 0;
  std::string text;
  for (const fs::path& path : paths) {
    const FileText file = file_text(path.string());
    if (!file.text) {
      print_error("patchproof: cannot read '" + path.string() + "': " + file.problem + "\n");
      return ExitCode::unreadable;
    }
    const std::optional<Header> header = header_of(*file.text);
    if (!header) continue;
    ++count;
    const std::string why = staleness(*header);
    if (why.empty()) continue;
    ++stale;
    text += path.string() + ": stale: " + why + "\n";
  }
  if (count == 0) {
    print_error("patchproof: no .tex file of patchproof in '" + folder + "'\n");
    return ExitCode::nothing_ran;
  }
  const std::string files = std::to_string(count) + (count == 1 ? " file" : " files");
  text += stale == 0 ? files + (count == 1 ? " is fresh\n" : " are fresh\n")
                     : files + ", " + std::to_string(stale) + " stale\n";
  if (!print(text)) return ExitCode::unreadable;
  return stale == 0 ? ExitCode::as_expected : ExitCode::wrong;
}

}  // namespace patchproof
