#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace patchproof {

/// How coqc took a file.
struct CoqRun {
  bool accepted = false;
  /// What went wrong, in its first words; "" when accepted.
  std::string problem;
  /// Line of the file at which it went wrong, from 1; 0 when there is none.
  std::size_t line = 0;
  /// Everything it printed.
  std::string output;
};

/// The version of the coqc that is installed, "8.16.1"; "" when there is none.
std::string coqc_version();

/// Puts the support library into a folder and compiles what is not compiled yet.
/// @returns what went wrong; "" when all is well.
std::string library_made(const std::string& folder);

/// Runs coqc on files of a folder, some at a time, each not longer than the time given.
std::vector<CoqRun> coqc_runs(const std::string& folder, const std::vector<std::string>& files,
                              std::size_t jobs, std::chrono::seconds longest,
                              const std::function<void(std::size_t)>& progress);

/// The axioms that `Print Assumptions` has named, in its order; nothing when it has said nothing.
std::optional<std::vector<std::string>> axioms_in(const std::string& output);

/// Whether it is one of the axioms of the real numbers of the standard library, or of classical
/// logic.
bool is_accepted_axiom(const std::string& axiom);

}  // namespace patchproof
