#pragma once

#include <string>
#include <vector>

#include <patchproof/claims/audit.hpp>
#include <patchproof/claims/verification.hpp>
#include <patchproof/language/diagnostic.hpp>

namespace patchproof {

/// What became of one file.
struct FileReport {
  std::string path;
  /// Why the file could not be read, as in "No such file or directory"; "" when it could.
  std::string unreadable;
  /// What is wrong with its text.
  std::vector<Diagnostic> diagnostics;
  /// Its cases without mistakes, decided.
  std::vector<CaseResult> cases;
  /// What the assumptions of these cases are for, where that was asked.
  std::vector<CaseAudit> audits{};
};

/// Everything a run found out, in the order of the files and of their texts.
struct Report {
  std::vector<FileReport> files;
  /// A claim that holds only under conditions is not good enough.
  bool strict = false;
};

/// "coons.bilinear.south", or for an instance of a family "coons.bilinear.south[i=0,j=2]".
std::string claim_id(const Case& of, const Claim& claim);

/// Whether a person has to look at this claim: the outcome is not the expected one, or it is
/// conditional in a strict report.
bool needs_attention(const ClaimResult& result, bool strict);

/// What the program ends with.
enum class ExitCode {
  as_expected = 0,  ///< at least one claim was decided, and each as expected
  wrong = 1,        ///< some verdict is not the expected one, or an assumption is flagged
  unknown = 2,      ///< some claim could not be decided
  conditional = 3,  ///< contradictory assumptions, or conditions in a strict report
  unreadable = 4,   ///< some file, case or claim cannot be read, or the report not be written
  nothing_ran = 5,  ///< there was no claim
  usage = 64,       ///< the command line is wrong
  internal = 70,    ///< a fault of this program
};

/// The graver of two: 70 before 64, 4, 1, 3, 2, 5 and 0.
ExitCode graver(ExitCode a, ExitCode b);

/// What a run with this report ends with: the gravest of what happened in it.
ExitCode exit_code(const Report& report);

}  // namespace patchproof
