#include <unistd.h>
#include <verify/open_file.hpp>
#include <verify/paths.hpp>

#include <algorithm>

#include <patchproof/report/claim_json.hpp>
#include <patchproof/report/excerpt.hpp>

namespace patchproof {

namespace {

// Limits of time are kept by whoever works; a claim on which that does not happen is given up after
// this many seconds.
unsigned most_seconds(const Limits& limits) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(limits.time).count();
  constexpr long most = 1'000'000;
  return seconds == 0 && limits.time.count() == 0
             ? 0
             : static_cast<unsigned>(3 * std::min<long>(seconds, most) + 10);
}

CaseFile read_file(const Work& work, std::size_t file, CacheKeys& keys) {
  CheckOptions options = work.options;
  if (work.cache) options.load = keys.remembering(options.load);
  CaseFile read = std::move(read_files({input_of(work, file)}, options).front());
  if (work.cache) keys.note(read, work.cache->program(), options.engines);
  return read;
}

}  // namespace

Input input_of(const Work& work, std::size_t file) {
  const auto known = work.known.find(file);
  if (known != work.known.end()) return known->second;
  return input_at(work.paths[file]);
}

OpenFile::OpenFile(const Work& work, std::size_t file)
    : work_{work}, number_{file}, file_{read_file(work, file, keys_)} {
  for (const Case& of : file_.cases) {
    verifiers_.push_back(std::make_unique<CaseVerifier>(
        of, work.options.engines, [&of] { ::alarm(most_seconds(of.limits)); }));
    results_.push_back({work.whole_files() ? of : Case{}, {}, {}});
  }
  for (std::size_t of = 0; of < file_.cases.size(); ++of) add_items(of);
  std::stable_sort(items_.begin(), items_.end(),
                   [](const Item& a, const Item& b) { return a.kind < b.kind; });
}

void OpenFile::add_items(std::size_t of) {
  const Case& given = file_.cases[of];
  const std::size_t before = items_.size();
  std::size_t claims = 0;
  for (std::size_t k = 0; k < given.claims.size(); ++k) {
    if (!work_.selection.contains(given, given.claims[k])) continue;
    if (work_.shard.contains(claim_id(given, given.claims[k])))
      items_.push_back({Item::Kind::claim, of, k, claims});
    ++claims;
  }
  // A case nothing was asked of is left out. What is not about single claims is in one shard.
  const bool asked = work_.selection.everything() || claims > 0;
  const bool own = asked && work_.shard.contains(given.name);
  shares_.push_back({asked, own || items_.size() > before, claims});
  if (!own) return;
  for (std::size_t k = 0; k < given.shown.size(); ++k)
    items_.push_back({Item::Kind::shown, of, k, 0});
  if (work_.options.audit && !given.assumptions.empty())
    items_.push_back({Item::Kind::audit, of, 0, 0});
  if (work_.checked) items_.push_back({Item::Kind::certified, of, 0, 0});
}

Message OpenFile::description() const {
  std::vector<const Case*> all;
  for (const Case& of : file_.cases) all.push_back(&of);
  Message message;
  message["unreadable"] = file_.unreadable;
  message["diagnostics"] = Message::array();
  for (const Diagnostic& diagnostic : file_.diagnostics) {
    const DiagnosticRecord record = record_of(diagnostic);
    Message one = to_json(record);
    one["text"] = record.text;
    message["diagnostics"].push_back(std::move(one));
  }
  message["cases"] = Message::array();
  for (std::size_t of = 0; of < file_.cases.size(); ++of) {
    const CaseRecord record = record_of(file_.cases[of]);
    Message one{{"name", record.name}, {"title", record.title}, {"excerpt", record.excerpt}};
    add_place(record.place, one);
    one["in_run"] = shares_[of].in_run;
    one["in_shard"] = shares_[of].in_shard;
    one["claims"] = shares_[of].claims;
    message["cases"].push_back(std::move(one));
  }
  message["unmatched"] = work_.selection.unmatched(all);
  message["claims"] = std::count_if(items_.begin(), items_.end(), [](const Item& item) {
    return item.kind == Item::Kind::claim;
  });
  message["items"] = items_.size();
  return message;
}

Message OpenFile::item(std::size_t index, const std::string* lost) {
  const Item& item = items_.at(index);
  Message message;
  switch (item.kind) {
    case Item::Kind::claim:
      message = claim(item, lost);
      break;
    case Item::Kind::shown:
      message = shown(item, lost);
      break;
    case Item::Kind::audit:
      message = audit(item, lost);
      break;
    case Item::Kind::certified:
      message = certified(item, lost);
      break;
  }
  ::alarm(0);
  message["of"] = item.of;
  message["item"] = index;
  return message;
}

Message OpenFile::claim(const Item& item, const std::string* lost) {
  const Case& of = file_.cases[item.of];
  if (lost == nullptr)
    if (const std::optional<ClaimRecord> record = kept(item))
      return {{"claim", to_json(*record, of.name)}, {"time", 0}, {"position", item.position}};
  ClaimResult result;
  if (lost == nullptr) {
    result = verifiers_[item.of]->decided(item.index);
  } else {
    result.claim = of.claims[item.index];
    result.decision.reason = *lost;
    result.outcome = Outcome::unknown;
  }
  const ClaimRecord record = record_of(of, result);
  if (lost == nullptr) keep(item, record);
  if (work_.whole_files()) results_[item.of].claims.push_back(std::move(result));
  return {{"claim", to_json(record, of.name)},
          {"time", record.time.count()},
          {"position", item.position}};
}

// What it says of the claim is read from the text of today; only what was decided is taken over.
std::optional<ClaimRecord> OpenFile::kept(const Item& item) const {
  if (!work_.cache || work_.whole_files()) return std::nullopt;
  const std::optional<Message> found = work_.cache->find(keys_.digest(item.of, item.index));
  if (!found) return std::nullopt;
  const Case& of = file_.cases[item.of];
  ClaimResult undecided;
  undecided.claim = of.claims[item.index];
  ClaimRecord record = record_of(of, undecided);
  try {
    const ClaimRecord before = claim_from(*found);
    record.decision = before.decision;
    record.outcome = before.outcome;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  record.finding = "";
  return record;
}

// Not what depends on how fast this machine is today, and nothing that somebody has to look at.
void OpenFile::keep(const Item& item, const ClaimRecord& record) const {
  if (!work_.cache || work_.whole_files()) return;
  const Verdict verdict = record.decision.verdict;
  const bool is_decided = verdict == Verdict::proved || verdict == Verdict::refuted;
  if (!is_decided || record.outcome != Outcome::as_expected || !record.finding.empty()) return;
  work_.cache->keep(keys_.digest(item.of, item.index), to_json(record, file_.cases[item.of].name));
}

Message OpenFile::shown(const Item& item, const std::string* lost) {
  const Case& of = file_.cases[item.of];
  ::alarm(most_seconds(of.limits));
  if (lost == nullptr)
    return {{"shown", to_json(record_of(verifiers_[item.of]->described(item.index)), of.name)}};
  const Shown& shown = of.shown[item.index];
  const ShownRecord record{
      place_at(shown.span), shown.instance, as_written(shown.span), *lost, std::nullopt, true};
  return {{"shown", to_json(record, of.name)}};
}

Message OpenFile::audit(const Item& item, const std::string* lost) const {
  const Case& of = file_.cases[item.of];
  const AuditRecord record =
      lost == nullptr ? record_of(audited(of, results_[item.of])) : lost_audit(of.name, *lost);
  return {{"audit",
           {{"text", record.text},
            {"flagged", record.flagged},
            {"json", record.json},
            {"has_flagged", record.has_flagged},
            {"is_lost", record.is_lost}}}};
}

Message OpenFile::certified(const Item& item, const std::string* lost) const {
  // Without an answer the evidence stays what it is.
  if (lost != nullptr) return Message::object();
  const CertifiedClaims certified = certified_claims(*work_.checked, results_[item.of]);
  return {{"certified", certified.ids}, {"by", certified.by}};
}

}  // namespace patchproof
