#include <verify/file_state.hpp>

#include <algorithm>

#include <patchproof/report/claim_json.hpp>

namespace patchproof {

void FileState::describe(const Message& description) {
  const std::size_t digest = std::hash<Message>{}(description);
  if (described_) {
    if (digest != digest_) give_up("it was changed while its claims were decided");
    return;
  }
  described_ = true;
  digest_ = digest;
  record_.path = path_;
  record_.unreadable = description.at("unreadable").get<std::string>();
  for (const Message& one : description.at("diagnostics")) {
    DiagnosticRecord& diagnostic = record_.diagnostics.emplace_back(diagnostic_from(one));
    diagnostic.text = one.at("text").get<std::string>();
  }
  for (const Message& one : description.at("cases")) {
    CaseRecord& of = record_.cases.emplace_back();
    of.name = one.at("name").get<std::string>();
    of.title = one.at("title").get<std::string>();
    of.excerpt = one.at("excerpt").get<std::string>();
    of.place = place_from(one);
    shares_.push_back({one.at("in_run").get<bool>(), one.at("in_shard").get<bool>(),
                       one.at("claims").get<std::size_t>()});
  }
  unmatched_ = description.at("unmatched").get<std::vector<std::string>>();
  claims_.resize(description.at("claims").get<std::size_t>());
  missing_ = description.at("items").get<std::size_t>();
  received_.resize(missing_);
}

std::string FileState::take(const Message& answer) {
  const auto item = answer.at("item").get<std::size_t>();
  if (item >= received_.size() || received_[item]) return "";
  received_[item] = true;
  --missing_;
  const auto of = answer.at("of").get<std::size_t>();
  CaseRecord& in = record_.cases.at(of);
  if (answer.contains("claim")) {
    ClaimRecord claim = claim_from(answer.at("claim"));
    claim.time = std::chrono::microseconds{answer.at("time").get<std::int64_t>()};
    claim.position = answer.at("position").get<std::size_t>();
    claims_.at(item) = {of, std::move(claim)};
    return claims_.at(item).second.id;
  }
  if (answer.contains("shown")) {
    // Not in the order they come in, but in that of the items.
    shown_.emplace(item, std::pair{of, shown_from(answer.at("shown"))});
  } else if (answer.contains("audit")) {
    const Message& audit = answer.at("audit");
    in.audit = {audit.at("text").get<std::string>(), audit.at("flagged").get<std::string>(),
                audit.at("json").get<std::string>(), audit.at("has_flagged").get<bool>(),
                audit.at("is_lost").get<bool>()};
  } else if (answer.contains("certified")) {
    const auto ids = answer.at("certified").get<std::vector<std::string>>();
    for (auto& [place, claim] : claims_)
      if (place == of && std::find(ids.begin(), ids.end(), claim.id) != ids.end()) {
        claim.decision.evidence = Evidence::certified;
        claim.decision.certificate = answer.at("by").get<std::string>();
      }
  }
  return "";
}

void FileState::give_up(const std::string& why) {
  described_ = true;
  record_ = {path_, why, {}, {}};
  shares_.clear();
  claims_.clear();
  shown_.clear();
  received_.clear();
  missing_ = 0;
}

FileRecord FileState::record() {
  for (auto& [of, claim] : claims_) record_.cases.at(of).claims.push_back(std::move(claim));
  for (auto& [item, shown] : shown_)
    record_.cases.at(shown.first).shown.push_back(std::move(shown.second));
  return std::move(record_);
}

}  // namespace patchproof
