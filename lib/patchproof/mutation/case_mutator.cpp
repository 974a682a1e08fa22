#include <patchproof/mutation/case_mutator.hpp>

#include <algorithm>

namespace patchproof {

namespace {

using Why = Mutant::Why;

bool is_proved(Verdict verdict) {
  return verdict == Verdict::proved || verdict == Verdict::proved_if;
}

std::vector<Edit> together(std::vector<Edit> a, const std::vector<Edit>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// The label in the source of the claims that the site stands for, and of those that use it.
bool is_of(const Claim& claim, const std::string& label) {
  return claim.label == label ||
         std::find(claim.uses.begin(), claim.uses.end(), label) != claim.uses.end();
}

}  // namespace

CaseMutator::CaseMutator(const syntax::File& file, const syntax::Case& written, const Case& given,
                         const MutationOptions& options)
    : written_{written},
      given_{given},
      options_{options},
      text_{file, written, options.limits, options.load},
      data_{data_of(written)} {
  for (const syntax::Statement& s : written.statements)
    if (s.kind == syntax::Statement::Kind::assume)
      unassumed_.push_back({s.span.begin, s.span.end, "", ""});
}

Edit CaseMutator::for_symbols(const Data& data) {
  const Span& span = data.statement->span;
  return {span.begin, span.end, data.for_symbols, "datum"};
}

bool CaseMutator::wants(const std::string& label) const {
  return std::any_of(given_.claims.begin(), given_.claims.end(), [&](const Claim& claim) {
    return claim.label == label && (!options_.wanted || options_.wanted(given_, claim));
  });
}

bool CaseMutator::wants_everything() const {
  return std::all_of(given_.claims.begin(), given_.claims.end(), [&](const Claim& claim) {
    return !options_.wanted || options_.wanted(given_, claim);
  });
}

void CaseMutator::look_at_claims(CaseMutation& result) {
  const std::optional<Case> read = text_.read({});
  if (!read) return;
  const auto all = [](const Claim&) { return true; };
  for (const ClaimResult& claim : results_of(*read, all, [](const ClaimResult&) { return false; })) {
    const std::string name = name_of(claim.claim);
    if (claim.outcome == Outcome::as_expected)
      observers_.insert(name);
    else if (wants(claim.claim.label))
      (claim.outcome == Outcome::unknown ? result.undecided : result.wrong).push_back(name);
  }
  for (const Data& data : data_)
    result.shapes.insert(result.shapes.end(), data.shape.begin(), data.shape.end());
  find_general();
}

// All data at once when that has a meaning; otherwise one after the other, as far as it goes.
void CaseMutator::find_general() {
  for (const Data& data : data_) general_.push_back(for_symbols(data));
  if (!general_.empty() && !text_.read(general_)) {
    general_.clear();
    for (const Data& data : data_) {
      general_.push_back(for_symbols(data));
      if (!text_.read(general_)) general_.pop_back();
    }
  }
  general_observers_ = general_.empty() ? observers_ : holding(general_);
}

std::set<std::string> CaseMutator::holding(const std::vector<Edit>& edits) const {
  std::set<std::string> result;
  const std::optional<Case> read = text_.read(edits);
  if (!read) return result;
  const auto is_observer = [&](const Claim& c) { return observers_.contains(name_of(c)); };
  const auto never = [](const ClaimResult&) { return false; };
  for (const ClaimResult& claim : results_of(*read, is_observer, never))
    if (claim.outcome == Outcome::as_expected) result.insert(name_of(claim.claim));
  return result;
}

std::vector<SiteMutants> CaseMutator::sites() const {
  std::vector<SiteMutants> result;
  for (const Site& site : sites_of(written_, text_.fresh_word())) {
    const bool wanted = site.kind == Site::Kind::claim ? wants(site.name) : wants_everything();
    if (!wanted) continue;
    SiteMutants mutants{site.kind, site.name, site.span, site.errors.size(), {}};
    for (const SiteError& error : the_most_different(site.errors, options_.most)) {
      const Edit& edit = error.error.edit;
      Mutant mutant{error, {site.span.source, edit.begin, edit.end}, fate(site, error), {}, {}};
      if (mutant.fate == Fate::survives) explain(site.kind, mutant);
      mutants.mutants.push_back(std::move(mutant));
    }
    result.push_back(std::move(mutants));
  }
  return result;
}

Fate CaseMutator::fate(const Site& site, const SiteError& error) const {
  const bool is_claim = site.kind == Site::Kind::claim;
  return fate_of(text_.read({error.error.edit}), [&](const Claim& claim) {
    return observers_.contains(name_of(claim)) && (!is_claim || is_of(claim, site.name));
  });
}

Verdict CaseMutator::compared(const SiteError& error, std::vector<Edit> edits) const {
  edits.push_back({error.comparison_at, error.comparison_at, error.comparison, ""});
  const std::optional<Case> read = text_.read(edits);
  if (!read) return Verdict::unknown;
  const auto is_comparison = [&](const Claim& c) { return c.label == text_.fresh_word(); };
  const auto is_other = [](const ClaimResult& r) { return !is_proved(r.decision.verdict); };
  Verdict verdict = Verdict::unknown;
  for (const ClaimResult& result : results_of(*read, is_comparison, is_other)) {
    verdict = result.decision.verdict;
    if (!is_proved(verdict)) return verdict;
  }
  return verdict;
}

bool CaseMutator::notices(const Mutant& mutant, const std::vector<Edit>& other,
                          const std::set<std::string>& noticing) const {
  const SiteError& error = mutant.change;
  return fate_of(text_.read(together(other, {error.error.edit})), [&](const Claim& claim) {
           return noticing.contains(name_of(claim));
         }) == Fate::noticed;
}

// Whether the changed part is another one, or has claims that see it, after changes of the data.
bool CaseMutator::differs(const SiteError& error, const std::vector<Edit>& edits) const {
  if (!error.comparison.empty()) return compared(error, edits) == Verdict::refuted;
  return fate_of(text_.read(together(edits, {error.error.edit})), [&](const Claim& claim) {
           return general_observers_.contains(name_of(claim));
         }) == Fate::noticed;
}

void CaseMutator::explain(Site::Kind kind, Mutant& mutant) const {
  const SiteError& error = mutant.change;
  if (kind == Site::Kind::data) {
    mutant.why = Why::independent;
    return;
  }
  if (!error.comparison.empty()) {
    if (is_proved(compared(error, together(general_, unassumed_)))) {
      mutant.why = Why::same;
      return;
    }
    if (!unassumed_.empty() && is_proved(compared(error, general_))) {
      mutant.why = Why::assumed;
      return;
    }
    const bool seen_differs = compared(error, {}) == Verdict::refuted;
    if (kind != Site::Kind::claim && seen_differs && !notices(mutant, general_, general_observers_)) {
      mutant.why = Why::independent;
      return;
    }
  } else if (!differs(error, general_)) {
    mutant.why = Why::independent;
    return;
  }
  mutant.why = !general_.empty() && differs(error, general_) ? Why::data : Why::untold;
  if (mutant.why == Why::data) name_data(mutant);
}

void CaseMutator::name_data(Mutant& mutant) const {
  std::vector<std::string> all;
  for (const Data& data : data_) {
    const Edit edit = for_symbols(data);
    if (std::find(general_.begin(), general_.end(), edit) == general_.end()) continue;
    all.push_back(data.name);
    if (differs(mutant.change, {edit})) mutant.data.push_back(data.name);
  }
  if (mutant.data.empty()) mutant.data = all;
}

}  // namespace patchproof
