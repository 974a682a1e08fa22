#include <patchproof/report/run_record.hpp>

namespace patchproof {

namespace {

/// So many claims are kept in memory before files are stored.
constexpr std::size_t most_claims_in_memory = 10'000;

ExitCode code_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::as_expected:
      return ExitCode::as_expected;
    case Outcome::wrong:
      return ExitCode::wrong;
    case Outcome::unknown:
      return ExitCode::unknown;
    case Outcome::vacuous:
      return ExitCode::conditional;
    case Outcome::error:
      return ExitCode::unreadable;
    default:
      return ExitCode::internal;
  }
}

}  // namespace

void FileRecords::push_back(FileRecord file) {
  add(file, summary_);
  stores_ = stores_ || (store_ && summary_.claims > most_claims_in_memory);
  if (stores_)
    store_->add(file);
  else
    first_.push_back(std::move(file));
}

void FileRecords::for_each(const std::function<void(const FileRecord&)>& see) const {
  for (const FileRecord& file : first_) see(file);
  if (stores_) store_->for_each(see);
}

RunRecord record_of(const Report& report) {
  RunRecord run;
  run.strict = report.strict;
  for (const FileReport& file : report.files) run.files.push_back(record_of(file));
  return run;
}

ExitCode exit_code(const RunRecord& run) {
  const Summary& summary = run.files.summary();
  ExitCode worst = ExitCode::as_expected;
  for (const auto& [outcome, count] : summary.outcomes) worst = graver(worst, code_of(outcome));
  if (summary.unreadable_files > 0 || summary.mistakes > 0)
    worst = graver(worst, ExitCode::unreadable);
  if (run.strict && summary.conditional > 0) worst = graver(worst, ExitCode::conditional);
  if (summary.flagged > 0) worst = graver(worst, ExitCode::wrong);
  if (summary.lost > 0) worst = graver(worst, ExitCode::unknown);
  return summary.claims > 0 ? worst : graver(worst, ExitCode::nothing_ran);
}

}  // namespace patchproof
