#pragma once

#include <optional>
#include <string>
#include <vector>

namespace patchproof {

/// A text, or why there is none, in the words of the system.
struct FileText {
  std::optional<std::string> text;
  std::string problem;
};

/// What is read of a file, where nothing else is said.
inline constexpr std::size_t usual_megabytes = 64;

/// The bytes of a regular file. Devices, pipes and larger files are refused, so that reading always
/// ends.
FileText file_text(const std::string& path, std::size_t megabytes = usual_megabytes);

/// All of standard input, up to 64 MB.
FileText standard_input_text();

/// What the program calls standard input in its messages.
inline constexpr const char* standard_input_name = "<stdin>";

/// Writes all of the text to an open file descriptor; "" or what went wrong.
std::string write_all(int descriptor, const std::string& text);

/// Writes to standard output.
/// @returns whether that went well; if not, a message is on standard error.
bool print(const std::string& text);

/// Writes to standard error, as far as that is possible.
void print_error(const std::string& text);

/// Puts a new text in the place of a file at once, so that there is never half a file; what a
/// symbolic link points to is replaced, not the link. Where there is no file one is made. "" or
/// what went wrong.
std::string replace_file(const std::string& path, const std::string& text);

}  // namespace patchproof
