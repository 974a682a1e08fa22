#include <patchproof/report/text_report.hpp>

#include <algorithm>
#include <map>

#include <patchproof/language/utf8.hpp>
#include <patchproof/report/claim_lines.hpp>
#include <patchproof/report/colour.hpp>
#include <patchproof/report/summary.hpp>
#include <patchproof/report/verdict_words.hpp>

namespace patchproof {

namespace {

constexpr std::size_t widest_id = 60;
/// Of a family, so many members are explained; the others are much like them.
constexpr std::size_t most_findings_of_a_family = 3;

// The words after `show`, in one line.
std::string joint_as_written(const ShownRecord& shown) {
  std::string text;
  for (const char c : shown.term) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank || (!text.empty() && text.back() != ' ')) text += blank ? ' ' : c;
  }
  return printable(text);
}

class TextReport {
 public:
  TextReport(const RunRecord& run, const ReportStyle& style, const ReportSink& sink)
      : run_{run}, style_{style}, sink_{sink} {}

  void write() {
    if (style_.verbosity != Verbosity::quiet)
      for_each_case([&](const CaseRecord& of) {
        for (const ClaimLine& line : lines_of(of))
          width_ = std::max(width_, std::min(line.id.size(), widest_id));
      });
    for_each_case([&](const CaseRecord& of) {
      if (style_.verbosity != Verbosity::quiet) tell(case_lines(of));
      findings(of);
      if (of.audit) audit_lines(*of.audit);
    });
    for (const std::string& paragraph : paragraphs_) tell((told_ ? "\n" : "") + paragraph);
    for (const std::string& paragraph : audits_) tell((told_ ? "\n" : "") + paragraph);
    if (told_) tell("\n");
    const std::string summary = in_words(run_.files.summary());
    tell((style_.colour ? bold(summary) : summary) + "\n");
  }

 private:
  void tell(const std::string& text) {
    if (text.empty()) return;
    told_ = true;
    sink_(text);
  }

  template <typename Action>
  void for_each_case(const Action& action) const {
    run_.files.for_each([&](const FileRecord& file) {
      for (const CaseRecord& of : file.cases) action(of);
    });
  }

  bool verbose() const { return style_.verbosity == Verbosity::verbose; }

  void audit_lines(const AuditRecord& audit) {
    const std::string& text = style_.verbosity == Verbosity::quiet ? audit.flagged : audit.text;
    if (!text.empty()) audits_.push_back(text);
  }

  std::vector<ClaimLine> lines_of(const CaseRecord& of) const {
    if (!verbose()) return claim_lines(of, run_.strict);
    std::vector<ClaimLine> lines;
    for (const ClaimRecord& claim : of.claims) lines.push_back({claim.id, &claim, 1});
    return lines;
  }

  std::string case_lines(const CaseRecord& of) const {
    std::string text;
    if (verbose()) {
      if (told_) text += "\n";
      text += of.name;
      if (!of.title.empty()) text += ": " + printable(of.title);
      text += "\n";
    }
    for (const ClaimLine& line : lines_of(of)) text += claim_line(line);
    for (const ShownRecord& shown : of.shown)
      text += std::string{shown.is_lost ? "! show  " : "  show  "} +
              (shown.instance.empty() ? "" : shown.instance + "  ") +
              (shown.joint ? joint_as_written(shown) + ": " : shown.term + " = ") + shown.value +
              "\n";
    return text;
  }

  std::string claim_line(const ClaimLine& line) const {
    const ClaimRecord& claim = *line.claim;
    const bool attention = needs_attention(claim, run_.strict);
    std::string verdict = verdict_line(claim.decision);
    const std::size_t gap = line.id.size() < width_ ? width_ - line.id.size() : 0;
    if (style_.colour) {
      const bool conditional = attention && claim.outcome == Outcome::as_expected;
      verdict = coloured(verdict, conditional ? Outcome::vacuous : claim.outcome);
    }
    std::string text = (attention ? "! " : "  ") + line.id + std::string(gap + 2, ' ') + verdict;
    if (claim.outcome == Outcome::wrong)
      text += "  (expected " + expected_verdict(claim.expectation) + ")";
    if (line.instances > 1) text += "  (" + std::to_string(line.instances) + " instances)";
    text += "\n";
    if (verbose()) text += details(claim);
    return text;
  }

  static std::string details(const ClaimRecord& claim) {
    const Decision& decision = claim.decision;
    std::string text = "      " + std::to_string(claim.time.count() / 1000) + " ms";
    if (decision.evidence != Evidence::none) text += ", " + to_text(decision.evidence);
    if (!decision.certificate.empty()) text += " (" + decision.certificate + ")";
    std::string used;
    for (const std::string& label : decision.assumptions_used)
      used += (used.empty() ? ", using " : ", ") + label;
    text += used + "\n";
    if (const std::string tree = in_words(decision.subdivision); !tree.empty())
      text += "      " + tree + "\n";
    for (const auto& [name, value] : decision.derived)
      text += "      " + name + " = " + value + "\n";
    for (const auto& [name, value] : decision.details)
      text += "      " + name + ": " + value + "\n";
    if (decision.verdict != Verdict::refuted) return text;
    text += "      false for " + in_words(decision.witness) + ": left side " +
            decision.witness.left + ", right side " + decision.witness.right + "\n";
    if (!decision.reason.empty()) text += "      " + printable(decision.reason) + "\n";
    return text;
  }

  void findings(const CaseRecord& of) {
    // Keyed by place and label: what makes a family.
    std::map<std::pair<FilePlace, std::string>, std::size_t> told;
    std::size_t left_out = 0;
    for (const ClaimRecord& claim : of.claims) {
      if (!needs_attention(claim, run_.strict)) continue;
      if (++told[{claim.place, claim.label}] > most_findings_of_a_family) {
        ++left_out;
        continue;
      }
      paragraphs_.push_back(claim.finding);
    }
    for (const ShownRecord& shown : of.shown)
      if (shown.is_lost)
        paragraphs_.push_back(shown.place.file + ":" + std::to_string(shown.place.line) + ":" +
                              std::to_string(shown.place.column) + ": " + of.name +
                              ": nothing to show: " + shown.value + "\n");
    if (left_out > 0)
      paragraphs_.push_back(of.name + ": " + std::to_string(left_out) +
                            " more of the same families need attention\n");
  }

  const RunRecord& run_;
  const ReportStyle& style_;
  const ReportSink& sink_;
  std::size_t width_ = 0;
  bool told_ = false;
  /// What is told after the lines of all claims.
  std::vector<std::string> paragraphs_;
  std::vector<std::string> audits_;
};

}  // namespace

void text_report(const RunRecord& run, const ReportStyle& style, const ReportSink& sink) {
  TextReport{run, style, sink}.write();
}

std::string mistakes(const Report& report) { return mistakes(record_of(report)); }

std::string mistakes(const RunRecord& run) {
  std::string text;
  const Summary& summary = run.files.summary();
  // Looking at many files takes its time.
  if (summary.mistakes == 0 && summary.unreadable_files == 0) return text;
  run.files.for_each([&](const FileRecord& file) {
    if (!file.unreadable.empty())
      text += "patchproof: cannot read '" + printable(file.path) + "': " + file.unreadable + "\n";
    for (const DiagnosticRecord& diagnostic : file.diagnostics) text += diagnostic.text;
  });
  return text;
}

}  // namespace patchproof
