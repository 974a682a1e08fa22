#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <patchproof/claims/audit.hpp>
#include <patchproof/language/parser.hpp>
#include <patchproof/language/reader.hpp>
#include <patchproof/repair/canonical.hpp>
#include <patchproof/repair/repair.hpp>
#include <tests/cases/case_files.hpp>

namespace patchproof::test {

namespace {

// A statement in a form in which only what it says counts.
std::string meaning(const std::string& text) {
  const Scope nothing;
  const std::optional<Line> line = line_of(text);
  if (!line) return text;
  std::string result;
  for (const syntax::Comparison& comparison : line->proposition.comparisons)
    result += canonical(comparison, Names{nothing, Library::prelude()}) + "; ";
  return result;
}

// Errata whose correction is not among the smallest changes. All are about exchanged degrees: for
// m > n (or m < n) one half of the printed statement is true, so the other half alone is changed.
const std::set<std::string> exceptions{"si.coons.degree.degree.printed",
                                       "si.coons.degree.degree_coons.printed",
                                       "si.coons.degree_wide.degree.printed"};

}  // namespace

TEST_CASE("the correction of every erratum of cases/ is found") {
  std::size_t count = 0;
  for (const SourceText& source : sampled_case_files()) {
    const auto shared = std::make_shared<const SourceText>(source);
    if (source.text.find("erratum") == std::string::npos) continue;
    const ReadFile file = read_cases(shared, Limits{}, case_loader());
    const Parsed parsed = parse(shared);
    RepairOptions options;
    options.wanted = [](const Case&, const Claim& claim) { return claim.verb == "printed"; };
    for (std::size_t k = 0; k < file.cases.size(); ++k) {
      const syntax::Case& written = parsed.file.cases.at(k);
      std::map<std::string, std::string> corrections;
      for (const syntax::Statement& s : written.statements)
        if (s.kind == syntax::Statement::Kind::erratum)
          corrections[file.cases[k].name + "." + s.label->text + ".printed"] =
              in_one_line(s.corrected.span);
      if (corrections.empty()) continue;
      for (const Repairs& repairs :
           repairs_of(written, file.cases[k], Library::prelude(), options)) {
        ++count;
        INFO(repairs.id << ": " << repairs.reason);
        std::set<std::string> found;
        for (const Repair& repair : repairs.repairs) {
          found.insert(meaning(repair.text));
          CHECK(repair.verdict == Verdict::proved);
          CHECK(repair.evidence == Evidence::both_engines);
        }
        const bool expected = !exceptions.contains(repairs.id);
        CHECK(found.contains(meaning(corrections.at(repairs.id))) == expected);
      }
    }
  }
  CHECK((sanitized || count >= 8));
}

TEST_CASE("every assumption of cases/ is needed, or stays for a reason") {
  for (const SourceText& source : sampled_case_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    for (const Case& given : file.cases) {
      if (given.assumptions.empty()) continue;
      VerificationOptions options;
      options.engines = Engines::kernel;
      for (const AssumptionAudit& assumption :
           audited(given, verified(given, options)).assumptions) {
        INFO(given.name << ": " << assumption.name);
        CHECK(assumption.status != AssumptionAudit::Status::flagged);
      }
    }
  }
}

}  // namespace patchproof::test
