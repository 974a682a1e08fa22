#pragma once

#include <CLI/CLI.hpp>

#include <patchproof/report/report.hpp>

namespace patchproof {

/// Each function adds one subcommand to the program; when the command line names it, it is run
/// while the command line is parsed, and `result` says how it ended.
void add_check(CLI::App& program, ExitCode& result);
void add_repair(CLI::App& program, ExitCode& result);
void add_mutate(CLI::App& program, ExitCode& result);
void add_draw(CLI::App& program, ExitCode& result);
void add_format(CLI::App& program, ExitCode& result);
void add_latex(CLI::App& program, ExitCode& result);
void add_certify(CLI::App& program, ExitCode& result);
void add_definitions(CLI::App& program, ExitCode& result);
void add_dump(CLI::App& program, ExitCode& result);
void add_recheck(CLI::App& program, ExitCode& result);
void add_merge(CLI::App& program, ExitCode& result);
void add_segments(CLI::App& program, ExitCode& result);

/// Thrown by a subcommand whose arguments do not make sense together; ends in exit code 64.
class UsageError : public CLI::ValidationError {
 public:
  explicit UsageError(const std::string& message)
      : CLI::ValidationError{"UsageError", message, CLI::ExitCodes::ValidationError} {}
};

}  // namespace patchproof
