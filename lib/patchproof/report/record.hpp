#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/report/report.hpp>

namespace patchproof {

/// Where something stands in a file; line and column from 1, and 0 where there is no text.
struct FilePlace {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;

  friend auto operator<=>(const FilePlace&, const FilePlace&) = default;
};
FilePlace place_at(const Span& span);

/// A claim with its verdict as a report tells it: words and numbers, no terms. It can be written to
/// a file and read back, or come from another process.
struct ClaimRecord {
  std::string id;
  std::string label;
  std::string instance;
  FilePlace place;
  std::string verb;
  std::string statement;
  Expectation expectation = Expectation::prove;
  /// Its terms and spans are left out.
  Decision decision;
  Outcome outcome = Outcome::unknown;
  std::string note;
  /// What a person reads who has to look at the claim, see `finding`; "" where nobody has to.
  std::string finding;
  std::chrono::microseconds time{0};
  /// Among all claims of the run, those of other shards too; only in the report of a shard.
  std::size_t position = 0;
};

/// What `show` has found out, in words.
struct ShownRecord {
  FilePlace place;
  std::string instance;
  /// The term, or the words after `show` that describe a joint.
  std::string term;
  std::string value;
  /// Its span is left out.
  std::optional<JointReport> joint;
  /// Nothing was found out, for the reason that stands as its value.
  bool is_lost = false;
};

/// What the assumptions of a case are for, written out.
struct AuditRecord {
  /// All of it, and only what is flagged; see `audit_text`.
  std::string text;
  std::string flagged;
  /// The same as a JSON value.
  std::string json;
  bool has_flagged = false;
  /// Nothing was found out, for the reason in the texts.
  bool is_lost = false;
};

/// What stands for the audit of a case that somebody was lost over.
AuditRecord lost_audit(const std::string& case_name, const std::string& why);

struct CaseRecord {
  std::string name;
  std::string title;
  FilePlace place;
  /// The lines a message about its name shows.
  std::string excerpt;
  std::vector<ClaimRecord> claims;
  std::vector<ShownRecord> shown;
  std::optional<AuditRecord> audit;
};

/// A mistake in a text.
struct DiagnosticRecord {
  FilePlace place;
  std::string message;
  std::string help;
  /// As a person reads it.
  std::string text;
};

struct FileRecord {
  std::string path;
  /// Why it could not be read; "" when it could.
  std::string unreadable;
  std::vector<DiagnosticRecord> diagnostics;
  std::vector<CaseRecord> cases;
};

/// Which part of a run a report is about, where it is not all of it.
struct ShardRecord {
  /// From 1.
  std::size_t number = 1;
  std::size_t of = 1;
  /// How many claims all shards have together.
  std::size_t claims = 0;
  /// The names of all cases, in order.
  std::vector<std::string> cases;
};

ClaimRecord record_of(const Case& of, const ClaimResult& result);
ShownRecord record_of(const ShownResult& shown);
AuditRecord record_of(const CaseAudit& audit);
DiagnosticRecord record_of(const Diagnostic& diagnostic);
/// Without claims, shown terms and audit.
CaseRecord record_of(const Case& given);
FileRecord record_of(const FileReport& file);

bool needs_attention(const ClaimRecord& claim, bool strict);

}  // namespace patchproof
