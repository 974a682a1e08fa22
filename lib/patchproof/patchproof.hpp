#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/language/reader.hpp>
#include <patchproof/report/formats.hpp>
#include <patchproof/report/report.hpp>
#include <patchproof/version.hpp>

/// The public face of the library: read case files, decide their claims, write the report.
///
///     #include <iostream>
///     #include <patchproof/patchproof.hpp>
///
///     int main() {
///       const std::string text =
///           "case squares\n"
///           "  scalar a, b\n"
///           "  prove  third: (a + b)*(a - b) == a^2 - b^2\n"
///           "end\n";
///       const patchproof::Report report = patchproof::check({{"squares.proof", text, ""}});
///       std::cout << patchproof::written(report, "text", {});
///       return static_cast<int>(patchproof::exit_code(report));
///     }
namespace patchproof {

/// A file to be checked: its text, or why there is none.
struct Input {
  std::string path;
  std::optional<std::string> text;
  /// "No such file or directory"; only where there is no text.
  std::string unreadable;
};

/// The cases of one file, nothing decided.
struct CaseFile {
  std::string path;
  std::string unreadable;
  std::vector<Diagnostic> diagnostics;
  std::vector<Case> cases;
};

/// How to check; what is not set has its usual value.
struct CheckOptions {
  /// For claims whose case says nothing else.
  Limits limits;
  Engines engines = Engines::both;
  /// Claims that hold only under conditions are not good enough.
  bool strict = false;
  /// Find out what the assumptions of each case are for.
  bool audit = false;
  /// Gives the texts of included files; without it no file can be included.
  Loader load;
  /// Which claims are to be decided; empty: all. Cases without any are left out.
  std::function<bool(const Case&, const Claim&)> wanted;
  /// Called before a claim is decided.
  std::function<void(const Case&, const Claim&)> progress;
};

/// Reads the cases of all inputs, in their order. A case whose name another file has already used
/// is left out, with a diagnostic.
std::vector<CaseFile> read_files(const std::vector<Input>& inputs,
                                 const CheckOptions& options = {});

/// Decides the cases read.
Report decided(const std::vector<CaseFile>& files, const CheckOptions& options = {});

/// Reads and decides. Never throws for any text whatever: what is wrong is in the report.
Report check(const std::vector<Input>& inputs, const CheckOptions& options = {});

}  // namespace patchproof
