#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/rocq_file.hpp>

namespace patchproof {

/// Files of theorems as modules of one file: loading the library and listing the assumptions take
/// coqc longer than most cases. The assumptions are those of all theorems together.
std::string bundle_text(const std::vector<const RocqFile*>& files);

/// What coqc printed for each of the files of a bundle; fewer when it did not get that far.
std::vector<std::string> bundle_outputs(const std::string& output, std::size_t count);

/// A name for a bundle, which no file of a case has.
std::string bundle_file(std::size_t number);

/// Removes a file of Rocq with all that coqc made of it.
void remove_compiled(const std::string& path);

}  // namespace patchproof
