#pragma once

#include <string>
#include <vector>

#include <patchproof/patchproof.hpp>

namespace patchproof {

/// The files that the arguments of a command stand for.
struct FoundPaths {
  /// Files to be read, in the order of the arguments, those of a folder in the order of the bytes
  /// of their paths; each file once. "-" is standard input.
  std::vector<std::string> files;
  /// Paths that cannot be looked at, and why.
  std::vector<Input> unreadable;
  /// Arguments that are folders without any case file.
  std::vector<std::string> empty_folders;
};

/// Looks for case files: a folder stands for all *.proof below it, except hidden ones, and each
/// folder is entered once, so that symbolic links may form circles. Files may have any ending.
FoundPaths found_paths(const std::vector<std::string>& arguments);

/// The text of a path, or of standard input for "-".
Input input_at(const std::string& path);

/// The texts of all that was found, each to be read anew from the system.
std::vector<Input> inputs(const FoundPaths& paths);

}  // namespace patchproof
