#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace patchproof::architecture {

/// A file of the project: its path from the root, with '/', and its text.
struct SourceFile {
  std::string path;
  std::string text;
};

/// All files below a folder that are part of the project, in the order of their paths: not what
/// was built, not what git keeps, no binary files.
/// @throws std::filesystem::filesystem_error when the folder cannot be read.
std::vector<SourceFile> project_files(const std::filesystem::path& root);

/// Whether the text is C++ by the name of its file.
bool is_cpp(const SourceFile& file);
bool is_header(const SourceFile& file);

/// C++ text with blanks in place of comments and of what stands in string and character literals;
/// every other byte, each quote and each line break stay where they were.
std::string code_only(std::string_view text);

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace patchproof::architecture
