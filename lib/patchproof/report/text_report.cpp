#include <patchproof/report/text_report.hpp>

#include <algorithm>
#include <map>

#include <patchproof/language/utf8.hpp>
#include <patchproof/report/audit_text.hpp>
#include <patchproof/report/claim_lines.hpp>
#include <patchproof/report/colour.hpp>
#include <patchproof/report/excerpt.hpp>
#include <patchproof/report/finding.hpp>
#include <patchproof/report/summary.hpp>
#include <patchproof/report/verdict_words.hpp>

namespace patchproof {

namespace {

constexpr std::size_t widest_id = 60;
/// Of a family, so many members are explained; the others are much like them.
constexpr std::size_t most_findings_of_a_family = 3;

// The words after `show`, in one line.
std::string joint_as_written(const ShownResult& shown) {
  const std::string all = as_written(shown.joint->span);
  std::string text;
  for (const char c : all) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank || (!text.empty() && text.back() != ' ')) text += blank ? ' ' : c;
  }
  return printable(text);
}

class TextReport {
 public:
  TextReport(const Report& report, const ReportStyle& style) : report_{report}, style_{style} {
    for_each_case([&](const CaseResult& result) {
      for (const ClaimLine& line : lines_of(result))
        width_ = std::max(width_, std::min(line.id.size(), widest_id));
    });
  }

  std::string text() {
    if (style_.verbosity != Verbosity::quiet)
      for_each_case([&](const CaseResult& result) { case_lines(result); });
    for_each_case([&](const CaseResult& result) { findings(result); });
    for (const FileReport& file : report_.files)
      for (const CaseAudit& audit : file.audits) audit_lines(audit);
    if (!text_.empty()) text_ += "\n";
    const std::string summary = in_words(summary_of(report_));
    return text_ + (style_.colour ? bold(summary) : summary) + "\n";
  }

 private:
  template <typename Action>
  void for_each_case(const Action& action) const {
    for (const FileReport& file : report_.files)
      for (const CaseResult& result : file.cases) action(result);
  }

  bool verbose() const { return style_.verbosity == Verbosity::verbose; }

  void audit_lines(const CaseAudit& audit) {
    const std::string text = audit_text(audit, style_.verbosity == Verbosity::quiet);
    if (!text.empty()) text_ += (text_.empty() ? "" : "\n") + text;
  }

  std::vector<ClaimLine> lines_of(const CaseResult& result) const {
    if (!verbose()) return claim_lines(result, report_.strict);
    std::vector<ClaimLine> lines;
    for (const ClaimResult& claim : result.claims)
      lines.push_back({claim_id(result.verified, claim.claim), &claim, 1});
    return lines;
  }

  void case_lines(const CaseResult& result) {
    const Case& verified = result.verified;
    if (verbose()) {
      if (!text_.empty()) text_ += "\n";
      text_ += verified.name;
      if (!verified.title.empty()) text_ += ": " + printable(verified.title);
      text_ += "\n";
    }
    for (const ClaimLine& line : lines_of(result)) claim_line(line);
    for (const ShownResult& shown : result.shown)
      text_ += "  show  " + (shown.instance.empty() ? "" : shown.instance + "  ") +
               (shown.joint ? joint_as_written(shown) + ": " : shown.term + " = ") + shown.value +
               "\n";
  }

  void claim_line(const ClaimLine& line) {
    const ClaimResult& result = *line.result;
    const bool attention = needs_attention(result, report_.strict);
    std::string verdict = verdict_line(result.decision);
    const std::size_t gap = line.id.size() < width_ ? width_ - line.id.size() : 0;
    if (style_.colour) {
      const bool conditional = attention && result.outcome == Outcome::as_expected;
      verdict = coloured(verdict, conditional ? Outcome::vacuous : result.outcome);
    }
    text_ += (attention ? "! " : "  ") + line.id + std::string(gap + 2, ' ') + verdict;
    if (result.outcome == Outcome::wrong)
      text_ += "  (expected " + expected_verdict(result.claim.expectation) + ")";
    if (line.instances > 1) text_ += "  (" + std::to_string(line.instances) + " instances)";
    text_ += "\n";
    if (verbose()) details(result);
  }

  void details(const ClaimResult& result) {
    const Decision& decision = result.decision;
    text_ += "      " + std::to_string(result.time.count() / 1000) + " ms";
    if (decision.evidence != Evidence::none) text_ += ", " + to_text(decision.evidence);
    if (!decision.certificate.empty()) text_ += " (" + decision.certificate + ")";
    std::string used;
    for (const std::string& label : decision.assumptions_used)
      used += (used.empty() ? ", using " : ", ") + label;
    text_ += used + "\n";
    if (const std::string tree = in_words(decision.subdivision); !tree.empty())
      text_ += "      " + tree + "\n";
    for (const auto& [name, value] : decision.derived)
      text_ += "      " + name + " = " + value + "\n";
    for (const auto& [name, value] : decision.details)
      text_ += "      " + name + ": " + value + "\n";
    if (decision.verdict != Verdict::refuted) return;
    text_ += "      false for " + in_words(decision.witness) + ": left side " +
             decision.witness.left + ", right side " + decision.witness.right + "\n";
    if (!decision.reason.empty()) text_ += "      " + printable(decision.reason) + "\n";
  }

  void findings(const CaseResult& result) {
    // Keyed by place and label: what makes a family.
    std::map<std::pair<std::size_t, std::string>, std::size_t> told;
    std::size_t left_out = 0;
    for (const ClaimResult& claim : result.claims) {
      if (!needs_attention(claim, report_.strict)) continue;
      if (++told[{claim.claim.span.begin, claim.claim.label}] > most_findings_of_a_family) {
        ++left_out;
        continue;
      }
      if (!text_.empty()) text_ += "\n";
      text_ += finding(result.verified, claim);
    }
    if (left_out > 0)
      text_ += "\n" + result.verified.name + ": " + std::to_string(left_out) +
               " more of the same families need attention\n";
  }

  const Report& report_;
  const ReportStyle& style_;
  std::size_t width_ = 0;
  std::string text_;
};

}  // namespace

std::string text_report(const Report& report, const ReportStyle& style) {
  return TextReport{report, style}.text();
}

std::string mistakes(const Report& report) {
  std::string text;
  for (const FileReport& file : report.files) {
    if (!file.unreadable.empty())
      text += "patchproof: cannot read '" + printable(file.path) + "': " + file.unreadable + "\n";
    for (const Diagnostic& diagnostic : file.diagnostics) text += to_text(diagnostic);
  }
  return text;
}

}  // namespace patchproof
