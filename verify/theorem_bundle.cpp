#include <verify/theorem_bundle.hpp>

#include <filesystem>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

std::string mark(std::size_t number) { return "before_case_" + std::to_string(number); }
std::string module(std::size_t number) { return "Case" + std::to_string(number); }

}  // namespace

std::string bundle_text(const std::vector<const RocqFile*>& files) {
  std::string text{rocq_head};
  std::string all;
  for (std::size_t k = 0; k < files.size(); ++k) {
    text += "Definition " + mark(k) + " := tt.\nPrint " + mark(k) + ".\nModule " + module(k) +
            ".\n" + files[k]->body + "End " + module(k) + ".\n";
    all += (k == 0 ? "" : ",\n  ") + module(k) + "." + rocq_theorems_together;
  }
  return text + "Definition all_together :=\n  (" + all + ").\nPrint Assumptions all_together.\n";
}

std::vector<std::string> bundle_outputs(const std::string& output, std::size_t count) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string line = mark(k) + " = tt\n";
    const std::size_t at = output.find(line, begin);
    if (at == std::string::npos || (at > 0 && output[at - 1] != '\n')) return {};
    if (k > 0) result.push_back(output.substr(begin, at - begin));
    begin = at + line.size();
  }
  if (count > 0) result.push_back(output.substr(begin));
  return result;
}

std::string bundle_file(std::size_t number) {
  return "PatchProof/together_" + std::to_string(number) + ".v";
}

void remove_compiled(const std::string& path) {
  std::error_code ignored;
  for (const char* ending : {".v", ".vo", ".vok", ".vos", ".glob", ".log"})
    fs::remove(fs::path{path}.replace_extension(ending), ignored);
  const fs::path file{path};
  fs::remove(file.parent_path() / ("." + file.stem().string() + ".aux"), ignored);
}

}  // namespace patchproof
