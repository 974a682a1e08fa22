#include <verify/run_assembly.hpp>
#include <verify/temporary_store.hpp>

#include <algorithm>

namespace patchproof {

namespace {

DiagnosticRecord occurs_twice(const CaseRecord& second, const std::string& first_file,
                              std::size_t first_line) {
  const std::string message = "case '" + second.name + "' occurs twice (first in " + first_file +
                              ", line " + std::to_string(first_line) + ")";
  const FilePlace& at = second.place;
  const std::string place =
      at.file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
  return {at, message, "", place + ": error: " + message + "\n" + second.excerpt};
}

}  // namespace

RunAssembly::RunAssembly(const Work& work) : work_{work} {
  run_.files = FileRecords{std::make_unique<TemporaryStore>()};
  run_.strict = work.options.strict;
  if (!work.shard.is_all()) run_.shard = ShardRecord{work.shard.number, work.shard.of, 0, {}};
}

bool RunAssembly::is_taken(const CaseRecord& of, FileRecord& file) {
  const auto [first, is_new] = first_.emplace(of.name, FirstUse{files_, of.place.line});
  if (!is_new)
    file.diagnostics.push_back(
        occurs_twice(of, work_.paths[first->second.file], first->second.line));
  return !is_new;
}

void RunAssembly::add(FileRecord file, const std::vector<CaseShare>& shares) {
  const std::size_t mistakes = file.diagnostics.size();
  std::vector<CaseRecord> cases = std::move(file.cases);
  file.cases.clear();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (is_taken(cases[k], file) || !shares[k].in_run) continue;
    for (ClaimRecord& claim : cases[k].claims) claim.position += claims_;
    claims_ += shares[k].claims;
    if (run_.shard) run_.shard->cases.push_back(cases[k].name);
    if (shares[k].in_shard) file.cases.push_back(std::move(cases[k]));
  }
  if (run_.shard) run_.shard->claims = claims_;
  if (file.diagnostics.size() > mistakes)
    std::stable_sort(file.diagnostics.begin(), file.diagnostics.end(),
                     [](const auto& a, const auto& b) { return a.place < b.place; });
  run_.files.push_back(std::move(file));
  ++files_;
}

}  // namespace patchproof
