#include <tests/architecture/source_tree.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace patchproof::architecture {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, std::istreambuf_iterator<char>{}};
}

bool is_identifier_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Walks over C++ text and blanks what is not code.
class Blanker {
 public:
  explicit Blanker(std::string_view text) : text_{text}, code_{text} {}

  std::string result() {
    while (at_ < text_.size()) step();
    return code_;
  }

 private:
  void step() {
    if (starts("//")) {
      blank_to(text_.find('\n', at_));
    } else if (starts("/*")) {
      blank_to(after(text_.find("*/", at_ + 2), 2));
    } else if (starts("R\"") && !follows_identifier()) {
      raw_string();
    } else if (text_[at_] == '"' || (text_[at_] == '\'' && !follows_identifier())) {
      // After an identifier character, ' separates the digits of a number.
      literal(text_[at_]);
    } else {
      ++at_;
    }
  }

  bool starts(std::string_view prefix) const { return text_.substr(at_).starts_with(prefix); }
  bool follows_identifier() const { return at_ > 0 && is_identifier_character(text_[at_ - 1]); }

  static std::size_t after(std::size_t position, std::size_t length) {
    return position == std::string_view::npos ? position : position + length;
  }

  void blank_to(std::size_t end) {
    for (end = std::min(end, text_.size()); at_ < end; ++at_) {
      if (text_[at_] != '\n') code_[at_] = ' ';
    }
  }

  void raw_string() {
    const std::size_t quote = at_ + 1;
    const std::size_t open = text_.find('(', quote);
    if (open == std::string_view::npos) return blank_to(open);
    std::string close = ")";
    close += text_.substr(quote + 1, open - quote - 1);
    close += '"';
    at_ = quote + 1;
    const std::size_t end = text_.find(close, at_);
    blank_to(after(end, close.size() - 1));
    if (at_ < text_.size()) ++at_;
  }

  void literal(char quote) {
    ++at_;
    std::size_t end = at_;
    while (end < text_.size() && text_[end] != quote && text_[end] != '\n') {
      end += text_[end] == '\\' ? 2 : 1;
    }
    blank_to(end);
    if (at_ < text_.size()) ++at_;
  }

  std::string_view text_;
  std::string code_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<SourceFile> project_files(const fs::path& root) {
  std::vector<SourceFile> files;
  for (auto entry = fs::recursive_directory_iterator{root};
       entry != fs::recursive_directory_iterator{}; ++entry) {
    const std::string path = entry->path().lexically_relative(root).generic_string();
    if (path == ".git" || path == "build" || path == ".cache") {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      SourceFile file{path, text_of(entry->path())};
      if (file.text.find('\0') == std::string::npos) files.push_back(std::move(file));
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

bool is_header(const SourceFile& file) { return file.path.ends_with(".hpp"); }

bool is_cpp(const SourceFile& file) { return is_header(file) || file.path.ends_with(".cpp"); }

std::string code_only(std::string_view text) { return Blanker{text}.result(); }

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace patchproof::architecture
