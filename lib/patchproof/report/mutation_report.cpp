#include <patchproof/report/mutation_report.hpp>

#include <algorithm>
#include <stdexcept>

#include <patchproof/language/utf8.hpp>
#include <patchproof/repair/line.hpp>
#include <patchproof/report/excerpt.hpp>

namespace patchproof {

namespace {

using Why = Mutant::Why;

/// Whoever has read so many has seen enough of one part.
constexpr std::size_t most_lines = 15;

bool says_the_same(const Mutant& mutant) {
  return mutant.fate == Fate::survives && (mutant.why == Why::same || mutant.why == Why::assumed);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string reason_of(const Mutant& mutant) {
  if (mutant.fate == Fate::undecided) return ": not decided within the limits";
  switch (mutant.why) {
    case Why::same:
      return ": says the same";
    case Why::assumed:
      return ": says the same under the assumptions";
    case Why::data:
      return ": says the same for these data: " + joined(mutant.data);
    case Why::independent:
      return ": no claim notices it" +
             (mutant.differs_at.empty() ? "" : "; differs at " + printable(mutant.differs_at));
    default:
      return "";
  }
}

bool is_listed(const Mutant& mutant, bool verbose) {
  if (mutant.fate == Fate::undecided || mutant.fate == Fate::internal) return true;
  return mutant.fate == Fate::survives && (verbose || !says_the_same(mutant));
}

std::string id_of(const CaseMutation& of, const SiteMutants& site) {
  if (site.kind == Site::Kind::definition) return "definition " + site.name;
  return of.name + (site.kind == Site::Kind::claim ? "." : ": ") + site.name;
}

// The numbers of data in one line: which entries may be others.
std::string data_line(const SiteMutants& site) {
  std::vector<std::string> owners;
  for (const Mutant& mutant : site.mutants) {
    if (mutant.fate != Fate::survives) continue;
    const std::string& words = mutant.change.error.words;
    const std::string owner = words.substr(0, words.find(": "));
    if (owners.empty() || owners.back() != owner) owners.push_back(owner);
  }
  return "  no claim notices other numbers in " + joined(owners) + "\n";
}

bool is_free(const SiteMutants& site) {
  const MutationCount count = count_of(site);
  return site.kind == Site::Kind::data && count.tried > 0 && count.unnoticed == count.tried;
}

// All data of a case that the claims do not depend on.
std::string free_data(const CaseMutation& of) {
  constexpr std::size_t widest = 60;
  std::string text;
  std::string symbols;
  for (const SiteMutants& site : of.sites) {
    if (!is_free(site)) continue;
    const std::string written = in_one_line(site.span);
    text += "  " + place_of(site.span) + ": " +
            printable(written.size() <= widest ? written : written.substr(0, widest - 3) + "...") +
            "\n";
    if (!site.for_symbols.empty())
      symbols += (symbols.empty() ? "" : "; ") + printable(site.for_symbols);
  }
  if (text.empty()) return "";
  if (!symbols.empty()) symbols = "  = try: all claims hold for symbols as well: " + symbols + "\n";
  return of.name + ": no claim notices changes of these data\n" + text + symbols + "\n";
}

// A declaration that is another one where no claim looks.
std::string place_line(const SiteMutants& site) {
  const bool differs = std::any_of(site.mutants.begin(), site.mutants.end(),
                                   [](const Mutant& m) { return !m.differs_at.empty(); });
  return differs ? "  = try: a claim that says what " + site.name + " is there\n" : "";
}

std::string paragraph(const CaseMutation& of, const SiteMutants& site, bool verbose) {
  const MutationCount count = count_of(site);
  const bool shown = std::any_of(site.mutants.begin(), site.mutants.end(),
                                 [&](const Mutant& m) { return is_listed(m, verbose); });
  if (!shown || is_free(site)) return "";
  std::string text = place_of(site.span) + ": " + id_of(of, site) + ": " +
                     std::to_string(count.unnoticed) + " of " +
                     counted(count.tried, "change", "changes") + " not noticed";
  if (site.left_out > 0) text += " (" + std::to_string(site.left_out) + " more not tried)";
  text += "\n" + excerpt_of(site.span);
  if (site.kind == Site::Kind::data && count.undecided == 0 && count.internal == 0)
    return text + data_line(site) + "\n";
  std::size_t listed = 0;
  for (const Mutant& mutant : site.mutants) {
    if (!is_listed(mutant, verbose)) continue;
    if (++listed > most_lines && !verbose) continue;
    text += "  " + place_of(mutant.place) + ": " + printable(mutant.change.error.words) +
            reason_of(mutant) + "\n";
  }
  if (listed > most_lines && !verbose)
    text += "  and " + std::to_string(listed - most_lines) + " more, which --verbose lists\n";
  return text + place_line(site) + "\n";
}

std::string data_paragraph(const CaseMutation& of) {
  if (of.hidden == 0) return "";
  std::string text = of.name + ": the data hide " + counted(of.hidden, "change", "changes") + "\n";
  for (const std::string& shape : of.shapes) text += "  = why: " + shape + "\n";
  for (const BetterData& better : of.better) {
    const bool is_first = &better == &of.better.front();
    text += "  = try: " + std::string{is_first ? "" : "and "} +
            (better.for_symbols ? "for symbols, " : "with ") + printable(better.words) + ": then " +
            std::to_string(better.noticed) + " of " + std::to_string(of.hidden) +
            (better.noticed == 1 ? " is noticed" : " are noticed");
    if (!better.other_values.empty())
      text += ", but these have to be put right: " + joined(better.other_values);
    text += "\n";
  }
  if (of.better.empty()) text += "  = no small change of the data was found that shows them\n";
  return text + "\n";
}

std::string claims_paragraph(const CaseMutation& of) {
  std::string text;
  if (!of.wrong.empty())
    text += of.name +
            ": not as expected without any change, so of no use here: " + joined(of.wrong) + "\n";
  if (!of.undecided.empty())
    text += of.name +
            ": not decided within the limits, so of no use here: " + joined(of.undecided) + "\n";
  return text.empty() ? "" : text + "\n";
}

std::string summary(const MutationReport& report) {
  const MutationCount all = count_of(report);
  if (all.tried == 0) return "nothing to change";
  const auto cases = static_cast<std::size_t>(
      std::count_if(report.cases.begin(), report.cases.end(),
                    [](const CaseMutation& of) { return !of.name.empty(); }));
  std::string text = counted(all.tried, "change", "changes") + " in " +
                     counted(cases, "case", "cases") + ": " + std::to_string(all.noticed) +
                     " noticed, " + std::to_string(all.unnoticed) + " not noticed";
  if (all.same > 0) text += ", " + std::to_string(all.same) + " say the same";
  if (all.undecided > 0) text += ", " + std::to_string(all.undecided) + " not decided";
  return text;
}

}  // namespace

MutationCount count_of(const SiteMutants& site) {
  MutationCount count;
  for (const Mutant& mutant : site.mutants) {
    if (mutant.fate == Fate::meaningless) continue;
    ++count.tried;
    if (mutant.fate == Fate::noticed) ++count.noticed;
    if (mutant.fate == Fate::undecided) ++count.undecided;
    if (mutant.fate == Fate::internal) ++count.internal;
    if (mutant.fate == Fate::survives) ++(says_the_same(mutant) ? count.same : count.unnoticed);
  }
  return count;
}

MutationCount count_of(const MutationReport& report) {
  MutationCount all;
  for (const CaseMutation& of : report.cases)
    for (const SiteMutants& site : of.sites) {
      const MutationCount count = count_of(site);
      all.tried += count.tried;
      all.noticed += count.noticed;
      all.unnoticed += count.unnoticed;
      all.same += count.same;
      all.undecided += count.undecided;
      all.internal += count.internal;
    }
  return all;
}

ExitCode exit_code(const MutationReport& report) {
  const MutationCount all = count_of(report);
  ExitCode worst = all.tried == 0 ? ExitCode::nothing_ran : ExitCode::as_expected;
  if (all.undecided > 0) worst = graver(worst, ExitCode::unknown);
  if (all.unnoticed > 0) worst = graver(worst, ExitCode::wrong);
  if (all.internal > 0) worst = graver(worst, ExitCode::internal);
  for (const CaseMutation& of : report.cases) {
    if (!of.undecided.empty()) worst = graver(worst, ExitCode::unknown);
    if (!of.wrong.empty()) worst = graver(worst, ExitCode::wrong);
  }
  for (const FileReport& file : report.files)
    if (!file.unreadable.empty() || !file.diagnostics.empty())
      worst = graver(worst, ExitCode::unreadable);
  return worst;
}

std::string text_of(const MutationReport& report) {
  std::string text;
  for (const CaseMutation& of : report.cases) {
    text += claims_paragraph(of);
    for (const SiteMutants& site : of.sites) text += paragraph(of, site, report.verbose);
    text += free_data(of) + data_paragraph(of);
  }
  return text + summary(report) + "\n";
}

std::string written(const MutationReport& report, std::string_view format) {
  if (format == "text") return text_of(report);
  if (format == "json") return json_of(report);
  throw std::invalid_argument{"there is no format '" + std::string{format} + "'"};
}

}  // namespace patchproof
