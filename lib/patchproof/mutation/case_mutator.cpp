#include <patchproof/mutation/case_mutator.hpp>

#include <algorithm>

namespace patchproof {

namespace {

using Why = Mutant::Why;

bool is_proved(Verdict verdict) {
  return verdict == Verdict::proved || verdict == Verdict::proved_if;
}

// "u = 1/2, v = 0": where the two sides were found to differ.
std::string place_of(const Decision& decision, const std::set<std::string>& parameters) {
  std::string result;
  for (const auto& [name, value] : decision.witness.values)
    if (parameters.contains(name)) result += (result.empty() ? "" : ", ") + name + " = " + value;
  return result;
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

SiteMutants mutants_of(const Site& site, std::size_t most,
                       const std::function<Mutant(const SiteError&)>& mutant_of) {
  SiteMutants result{site.kind, site.name, site.span, 0, {}, ""};
  for (const SiteError& error : in_turns(site.errors)) {
    if (result.mutants.size() == most) {
      ++result.left_out;
      continue;
    }
    Mutant mutant = mutant_of(error);
    if (mutant.fate == Fate::meaningless) continue;
    // Most are noticed: what they would be compared with is of no use then.
    if (mutant.fate != Fate::survives) mutant.change.comparison.clear();
    const Edit& edit = error.error.edit;
    mutant.place = {site.span.source, edit.begin, edit.end};
    result.mutants.push_back(std::move(mutant));
  }
  std::stable_sort(
      result.mutants.begin(), result.mutants.end(),
      [](const Mutant& a, const Mutant& b) { return a.change.error.edit < b.change.error.edit; });
  return result;
}

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

// A claim that is not as expected cannot notice anything in itself.
bool CaseMutator::observes(const std::string& label) const {
  return std::all_of(given_.claims.begin(), given_.claims.end(), [&](const Claim& claim) {
    return claim.label != label || observers_.contains(name_of(claim));
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
  for (const ClaimResult& claim :
       results_of(*read, all, [](const ClaimResult&) { return false; })) {
    const std::string name = name_of(claim.claim);
    if (claim.outcome == Outcome::as_expected)
      observers_.insert(name);
    else if (wants(claim.claim.label))
      (claim.outcome == Outcome::unknown ? result.undecided : result.wrong).push_back(name);
  }
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

CaseMutator::Findings CaseMutator::findings(std::vector<Edit> edits) const {
  Findings result;
  const std::optional<Case> read = text_.read(std::move(edits));
  if (!read) return result;
  const auto is_observer = [&](const Claim& c) { return observers_.contains(name_of(c)); };
  const auto never = [](const ClaimResult&) { return false; };
  for (const ClaimResult& claim : results_of(*read, is_observer, never)) {
    const Decision& decision = claim.decision;
    if (claim.outcome == Outcome::as_expected)
      result[name_of(claim.claim)] = "";
    else if (claim.outcome != Outcome::unknown)
      result[name_of(claim.claim)] =
          to_text(decision.verdict) + decision.witness.component + " " + decision.residual;
  }
  return result;
}

CaseMutator::Findings CaseMutator::findings(std::vector<Edit> edits, const Mutant& mutant) const {
  edits.push_back(mutant.change.error.edit);
  return findings(std::move(edits));
}

std::set<std::string> CaseMutator::holding(const std::vector<Edit>& edits) const {
  std::set<std::string> result;
  for (const auto& [name, finding] : findings(edits))
    if (finding.empty()) result.insert(name);
  return result;
}

std::vector<SiteMutants> CaseMutator::sites() const {
  std::vector<SiteMutants> result;
  for (const Site& site : sites_of(written_, text_.fresh_word())) {
    const bool is_claim = site.kind == Site::Kind::claim;
    if (is_claim ? !wants(site.name) || !observes(site.name) : !wants_everything()) continue;
    result.push_back(mutants_of(site, options_.most, [&](const SiteError& error) {
      Mutant mutant{error, {}, fate(site, error), {}, {}, {}};
      if (mutant.fate == Fate::survives) explain(site.kind, mutant);
      return mutant;
    }));
    if (site.kind == Site::Kind::data) generalise(result.back());
  }
  return result;
}

void CaseMutator::generalise(SiteMutants& site) const {
  const auto survives = [](const Mutant& m) { return m.fate == Fate::survives; };
  if (!std::all_of(site.mutants.begin(), site.mutants.end(), survives)) return;
  for (const Data& data : data_)
    if (data.name == site.name && holding({for_symbols(data)}) == observers_)
      site.for_symbols = data.for_symbols;
}

Fate CaseMutator::fate(const Site& site, const SiteError& error) const {
  const bool is_claim = site.kind == Site::Kind::claim;
  return fate_of(text_.read({error.error.edit}), [&](const Claim& claim) {
    return observers_.contains(name_of(claim)) && (!is_claim || is_of(claim, site.name));
  });
}

Decision CaseMutator::compared(const SiteError& error, std::vector<Edit> edits) const {
  edits.push_back({error.comparison_at, error.comparison_at, error.comparison, ""});
  const std::optional<Case> read = text_.read(std::move(edits));
  if (!read) return {};
  const auto is_comparison = [&](const Claim& c) { return c.label == text_.fresh_word(); };
  const auto is_other = [](const ClaimResult& r) { return !is_proved(r.decision.verdict); };
  Decision decision;
  for (const ClaimResult& result : results_of(*read, is_comparison, is_other)) {
    decision = result.decision;
    if (!is_proved(decision.verdict)) break;
  }
  return decision;
}

bool CaseMutator::is_noticed_in_general(const SiteError& error) const {
  return fate_of(text_.read(together(general_, {error.error.edit})), [&](const Claim& claim) {
           return general_observers_.contains(name_of(claim));
         }) == Fate::noticed;
}

// Whether the changed part is another one, or has claims that see it, after changes of the data.
bool CaseMutator::differs(const SiteError& error, const std::vector<Edit>& edits) const {
  if (!error.comparison.empty()) return compared(error, edits).verdict == Verdict::refuted;
  const std::set<std::string> noticing = holding(edits);
  return fate_of(text_.read(together(edits, {error.error.edit})), [&](const Claim& claim) {
           return noticing.contains(name_of(claim));
         }) == Fate::noticed;
}

void CaseMutator::explain(Site::Kind kind, Mutant& mutant) const {
  if (!mutant.change.comparison.empty()) return explain_by_comparison(kind, mutant);
  const bool by_data =
      kind != Site::Kind::data && !general_.empty() && is_noticed_in_general(mutant.change);
  mutant.why = by_data ? Why::data : Why::independent;
  if (by_data) name_data(mutant);
}

void CaseMutator::explain_by_comparison(Site::Kind kind, Mutant& mutant) const {
  const SiteError& error = mutant.change;
  const Decision in_general = compared(error, together(general_, unassumed_));
  if (is_proved(in_general.verdict)) {
    mutant.why = Why::same;
  } else if (!unassumed_.empty() && is_proved(compared(error, general_).verdict)) {
    mutant.why = Why::assumed;
  } else {
    const Decision here = compared(error, {});
    // Where the claims do not hold for symbols, these say nothing about what claims notice.
    const bool is_other = here.verdict == Verdict::refuted || general_observers_ == observers_;
    if (kind != Site::Kind::claim && is_other && !is_noticed_in_general(error)) {
      mutant.why = Why::independent;
      mutant.differs_at = place_of(here, vocabulary_of(written_).parameters);
    } else {
      mutant.why = !general_.empty() && differs(error, general_) ? Why::data : Why::untold;
      if (mutant.why == Why::data) name_data(mutant);
    }
  }
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
