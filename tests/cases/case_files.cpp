#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <tests/cases/case_files.hpp>

namespace patchproof::test {

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

std::vector<SourceText> case_files(const std::string& part) {
  const std::filesystem::path root = std::filesystem::path{PATCHPROOF_SOURCE_FOLDER} / "cases";
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{root})
    if (entry.path().extension() == ".proof" &&
        entry.path().string().find(part, root.parent_path().string().size()) != std::string::npos)
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  std::vector<SourceText> result;
  for (const std::string& path : paths) result.push_back({path, text_of(path)});
  return result;
}

Loader case_loader() {
  return [](const std::string& path) -> std::optional<std::string> {
    if (!std::filesystem::is_regular_file(path)) return std::nullopt;
    return text_of(path);
  };
}

std::vector<SourceText> sampled_case_files() {
  constexpr std::size_t step = sanitized ? 6 : 1;
  const std::vector<SourceText> all = case_files();
  std::vector<SourceText> result;
  for (std::size_t k = 0; k < all.size(); k += step) result.push_back(all[k]);
  return result;
}

}  // namespace patchproof::test
