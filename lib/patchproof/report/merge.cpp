#include <patchproof/report/merge.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <patchproof/report/claim_json.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

std::optional<ShardRecord> shard_from(const Json& document) {
  if (!document.contains("shard")) return std::nullopt;
  const Json& shard = document.at("shard");
  ShardRecord record{count_from(shard.at("number")), count_from(shard.at("of")),
                     count_from(shard.at("claims")),
                     shard.at("cases").get<std::vector<std::string>>()};
  constexpr std::size_t most_shards = 100'000;
  if (record.number == 0 || record.number > record.of || record.of > most_shards)
    throw std::invalid_argument{"there is no such shard"};
  return record;
}

AuditRecord audit_from(const Json& object) {
  AuditRecord audit;
  audit.json = object.dump();
  if (object.contains("lost"))
    return lost_audit(object.at("case").get<std::string>(), object.at("lost").get<std::string>());
  for (const Json& assumption : object.at("assumptions"))
    if (assumption.at("status") == "flagged") {
      audit.has_flagged = true;
      audit.flagged += object.at("case").get<std::string>() + ": nothing needs '" +
                       assumption.at("name").get<std::string>() + "'\n";
    }
  audit.text = audit.flagged;
  return audit;
}

/// Puts what belongs to a case into it, in the order in which the cases are first spoken of.
class Cases {
 public:
  CaseRecord& named(const std::string& name) {
    const auto [place, is_new] = index_.emplace(name, cases_.size());
    if (is_new) cases_.emplace_back().name = name;
    return cases_[place->second];
  }
  std::vector<CaseRecord> all() { return std::move(cases_); }

 private:
  std::map<std::string, std::size_t> index_;
  std::vector<CaseRecord> cases_;
};

RunRecord run_from(const Json& document) {
  RunRecord run{{}, document.at("strict").get<bool>(), shard_from(document)};
  FileRecord file;
  for (const Json& one : document.at("diagnostics"))
    file.diagnostics.push_back(diagnostic_from(one));
  Cases cases;
  for (const Json& one : document.at("claims"))
    cases.named(one.at("case").get<std::string>()).claims.push_back(claim_from(one));
  for (const Json& one : document.at("shown"))
    cases.named(one.at("case").get<std::string>()).shown.push_back(shown_from(one));
  if (document.contains("audits"))
    for (const Json& one : document.at("audits"))
      cases.named(one.at("case").get<std::string>()).audit = audit_from(one);
  file.cases = cases.all();
  run.files.push_back(std::move(file));
  for (const Json& one : document.at("unreadable"))
    run.files.push_back(
        {one.at("path").get<std::string>(), one.at("message").get<std::string>(), {}, {}});
  return run;
}

/// Finds out whether reports belong together.
class Comparison {
 public:
  explicit Comparison(const std::vector<ReadReport>& reports) : reports_{reports} {}

  std::vector<std::string> complaints() {
    for (const ReadReport& report : reports_) compare(report);
    compare_claims();
    if (reports_.front().run.shard) look_for_gaps();
    return complaints_;
  }

 private:
  void compare(const ReadReport& report) {
    const ReadReport& first = reports_.front();
    if (report.version != version)
      complain("'" + report.name + "' was written by version " + report.version + ", not " +
               std::string{version});
    if (report.run.strict != first.run.strict)
      complain("'" + first.name + "' and '" + report.name + "' differ in --strict");
    const auto& a = first.run.shard;
    const auto& b = report.run.shard;
    if (a.has_value() != b.has_value())
      complain("of '" + first.name + "' and '" + report.name + "' only one is about a shard");
    else if (a && (a->of != b->of || a->claims != b->claims || a->cases != b->cases))
      complain("'" + first.name + "' and '" + report.name + "' are about shards of different runs");
  }

  void compare_claims() {
    std::map<std::string, const ReadReport*> seen;
    for (const ReadReport& report : reports_) {
      std::size_t twice = 0;
      std::string example;
      report.run.files.for_each([&](const FileRecord& file) {
        for (const CaseRecord& of : file.cases)
          for (const ClaimRecord& claim : of.claims)
            if (!seen.emplace(claim.id, &report).second && ++twice == 1)
              example = "'" + claim.id + "' is in '" + seen.at(claim.id)->name + "' and in '" +
                        report.name + "'";
      });
      if (twice > 0)
        complain(example +
                 (twice > 1 ? ", and so are " + std::to_string(twice - 1) + " more" : ""));
    }
    claims_ = seen.size();
  }

  void look_for_gaps() {
    const ShardRecord& shard = *reports_.front().run.shard;
    std::set<std::size_t> numbers;
    for (const ReadReport& report : reports_)
      if (report.run.shard) numbers.insert(report.run.shard->number);
    for (std::size_t number = 1; number <= shard.of; ++number)
      if (!numbers.contains(number))
        complain("shard " + std::to_string(number) + " of " + std::to_string(shard.of) +
                 " is missing");
    if (numbers.size() == shard.of && claims_ != shard.claims)
      complain("there are " + std::to_string(claims_) + " claims where the run had " +
               std::to_string(shard.claims));
  }

  void complain(const std::string& what) { complaints_.push_back(what); }

  const std::vector<ReadReport>& reports_;
  std::size_t claims_ = 0;
  std::vector<std::string> complaints_;
};

bool same_mistake(const DiagnosticRecord& a, const DiagnosticRecord& b) {
  return a.place == b.place && a.message == b.message;
}

}  // namespace

ReadReport report_from_json(const std::string& name, const std::string& text) {
  try {
    const Json document = Json::parse(text);
    return {name, document.at("version").get<std::string>(), run_from(document)};
  } catch (const std::exception& error) {
    throw std::invalid_argument{std::string{"no report of 'patchproof check --format json': "} +
                                error.what()};
  }
}

MergedReport merged(const std::vector<ReadReport>& reports) {
  MergedReport result;
  if (reports.empty()) return result;
  result.complaints = Comparison{reports}.complaints();
  result.run.strict = reports.front().run.strict;
  FileRecord all;
  std::vector<FileRecord> unreadable;
  Cases cases;
  // What every shard says is said once.
  if (reports.front().run.shard)
    for (const std::string& name : reports.front().run.shard->cases) cases.named(name);
  for (const ReadReport& report : reports)
    report.run.files.for_each([&](const FileRecord& file) {
      if (!file.unreadable.empty() &&
          std::none_of(unreadable.begin(), unreadable.end(),
                       [&](const FileRecord& other) { return other.path == file.path; }))
        unreadable.push_back(file);
      for (const DiagnosticRecord& one : file.diagnostics)
        if (std::none_of(all.diagnostics.begin(), all.diagnostics.end(),
                         [&](const auto& other) { return same_mistake(one, other); }))
          all.diagnostics.push_back(one);
      for (const CaseRecord& of : file.cases) {
        CaseRecord& into = cases.named(of.name);
        into.claims.insert(into.claims.end(), of.claims.begin(), of.claims.end());
        into.shown.insert(into.shown.end(), of.shown.begin(), of.shown.end());
        if (of.audit) into.audit = of.audit;
      }
    });
  all.cases = cases.all();
  for (CaseRecord& of : all.cases)
    std::stable_sort(of.claims.begin(), of.claims.end(),
                     [](const auto& a, const auto& b) { return a.position < b.position; });
  result.run.files.push_back(std::move(all));
  for (FileRecord& file : unreadable) result.run.files.push_back(std::move(file));
  return result;
}

}  // namespace patchproof
