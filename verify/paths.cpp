#include <verify/files.hpp>
#include <verify/paths.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

class Search {
 public:
  void add(const std::string& argument) {
    if (argument == "-") {
      if (seen_.insert("-").second) found_.files.push_back(argument);
      return;
    }
    std::error_code error;
    const fs::file_status status = fs::status(argument, error);
    if (status.type() == fs::file_type::directory) return add_folder(argument);
    // Anything else is left to reading, which has the better words for what is wrong.
    add_file(argument);
  }

  FoundPaths found() { return std::move(found_); }

 private:
  void add_file(const std::string& path) {
    std::error_code error;
    const fs::path canonical = fs::canonical(path, error);
    if (seen_.insert(error ? path : canonical.string()).second) found_.files.push_back(path);
  }

  void add_folder(const std::string& folder) {
    std::vector<std::string> files;
    std::vector<fs::path> open{folder};
    entered_.clear();
    const std::size_t unreadable_before = found_.unreadable.size();
    while (!open.empty()) {
      const fs::path next = open.back();
      open.pop_back();
      look_into(next, files, open);
    }
    std::sort(files.begin(), files.end());
    if (files.empty() && found_.unreadable.size() == unreadable_before)
      found_.empty_folders.push_back(folder);
    for (const std::string& file : files) add_file(file);
  }

  void look_into(const fs::path& folder, std::vector<std::string>& files,
                 std::vector<fs::path>& open) {
    std::error_code error;
    const fs::path canonical = fs::canonical(folder, error);
    if (!error && !entered_.insert(canonical.string()).second) return;
    std::vector<fs::path> folders;
    fs::directory_iterator entry{folder, error};
    for (; !error && entry != fs::directory_iterator{}; entry.increment(error)) {
      const fs::path path = entry->path();
      const std::string name = path.filename().string();
      if (name.starts_with(".")) continue;
      std::error_code unknown;
      if (entry->is_directory(unknown))
        folders.push_back(path);
      else if (name.ends_with(".proof"))
        files.push_back(path.string());
    }
    if (error) found_.unreadable.push_back({folder.string(), std::nullopt, error.message()});
    // The smallest last, to be entered first: which of two names of a folder counts is no accident.
    std::sort(folders.rbegin(), folders.rend());
    open.insert(open.end(), folders.begin(), folders.end());
  }

  FoundPaths found_;
  std::set<std::string> seen_;
  std::set<std::string> entered_;
};

}  // namespace

FoundPaths found_paths(const std::vector<std::string>& arguments) {
  Search search;
  for (const std::string& argument : arguments) search.add(argument);
  return search.found();
}

Input input_at(const std::string& path) {
  const bool standard_input = path == "-";
  FileText read = standard_input ? standard_input_text() : file_text(path);
  return {standard_input ? standard_input_name : path, std::move(read.text),
          std::move(read.problem)};
}

std::vector<Input> inputs(const FoundPaths& paths) {
  std::vector<Input> result = paths.unreadable;
  for (const std::string& path : paths.files) result.push_back(input_at(path));
  return result;
}

}  // namespace patchproof
