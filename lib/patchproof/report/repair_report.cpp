#include <patchproof/report/repair_report.hpp>

#include <algorithm>
#include <stdexcept>

#include <patchproof/language/utf8.hpp>
#include <patchproof/report/excerpt.hpp>

namespace patchproof {

namespace {

ExitCode code_of(Repairs::Outcome outcome) {
  switch (outcome) {
    case Repairs::Outcome::found:
      return ExitCode::as_expected;
    case Repairs::Outcome::stopped:
      return ExitCode::unknown;
    case Repairs::Outcome::internal:
      return ExitCode::internal;
    default:
      return ExitCode::wrong;
  }
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string headline(const Repairs& statement) {
  const std::string place = place_of(statement.statement);
  std::string text = (place.empty() ? "" : place + ": ") + printable(statement.id) + ": ";
  if (statement.instances > 1) text += std::to_string(statement.instances) + " instances, ";
  if (statement.repairs.empty())
    return text +
           (statement.outcome == Repairs::Outcome::not_tried ? "not tried: " : "no repair: ") +
           statement.reason + "\n";
  text += counted(statement.repairs.size(), "repair", "repairs") + " of " +
          counted(statement.repairs.front().size(), "change", "changes");
  if (!statement.complete)
    text +=
        ", perhaps more: stopped after " + std::to_string(statement.tried) + " changed statements";
  return text + "\n";
}

std::string in_words(const Repair& repair, const std::string& printed) {
  std::string text;
  if (!repair.reversed.empty())
    text = repair.reversed + " taken backwards (reversed)";
  else
    for (const Edit& edit : repair.edits)
      text += (text.empty() ? "" : ", ") + in_words(printed, edit);
  text += ": " + to_text(repair.verdict);
  for (std::size_t k = 0; k < repair.conditions.size(); ++k)
    text += (k == 0 ? " " : ", ") + repair.conditions[k];
  return text +
         (repair.evidence == Evidence::both_engines ? ", by both engines" : ", by the kernel");
}

std::string paragraph(const Repairs& statement) {
  std::string text = headline(statement);
  text += "  - " + printable(statement.printed) + "\n";
  for (const Repair& repair : statement.repairs) {
    text += "  + " + printable(repair.text) + "\n";
    text += "    " + marks_of(statement.printed, repair.edits) + "\n";
    text += "    " + printable(in_words(repair, statement.printed)) + "\n";
  }
  return text;
}

std::string summary(const RepairReport& report) {
  const auto with = static_cast<std::size_t>(
      std::count_if(report.statements.begin(), report.statements.end(),
                    [](const Repairs& s) { return s.outcome == Repairs::Outcome::found; }));
  if (report.statements.empty()) return "no false statement";
  return counted(report.statements.size(), "false statement", "false statements") + ": " +
         std::to_string(with) + " with a repair, " +
         std::to_string(report.statements.size() - with) + " without";
}

}  // namespace

ExitCode exit_code(const RepairReport& report) {
  ExitCode worst = report.statements.empty() ? ExitCode::nothing_ran : ExitCode::as_expected;
  for (const FileReport& file : report.files)
    if (!file.unreadable.empty() || !file.diagnostics.empty())
      worst = graver(worst, ExitCode::unreadable);
  for (const Repairs& statement : report.statements)
    worst = graver(worst, code_of(statement.outcome));
  return worst;
}

std::string text_of(const RepairReport& report) {
  std::string text;
  for (const Repairs& statement : report.statements) text += paragraph(statement) + "\n";
  return text + summary(report) + "\n";
}

std::string written(const RepairReport& report, std::string_view format) {
  if (format == "text") return text_of(report);
  if (format == "json") return json_of(report);
  throw std::invalid_argument{"there is no format '" + std::string{format} + "'"};
}

}  // namespace patchproof
