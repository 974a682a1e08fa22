#include <patchproof/mutation/rereading.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// Bytes keep their places: what is taken away becomes blank.
std::shared_ptr<const SourceText> only(const syntax::File& file, const syntax::Case& kept) {
  SourceText result = *file.source;
  for (const syntax::Case& other : file.cases) {
    if (other.span.begin == kept.span.begin) continue;
    for (std::size_t k = other.span.begin; k < other.span.end; ++k)
      if (result.text[k] != '\n') result.text[k] = ' ';
  }
  return std::make_shared<const SourceText>(std::move(result));
}

// A word whose beginning is nowhere in the text, either.
std::string fresh_in(const std::string& text) {
  std::string word = "changed";
  while (text.find(word) != std::string::npos) word += "x";
  return word;
}

bool is_over_limit(const ClaimResult& result) {
  return result.outcome == Outcome::unknown && result.decision.reason.starts_with("limit");
}

bool derives(const Case& read) {
  return std::any_of(read.claims.begin(), read.claims.end(),
                     [](const Claim& claim) { return claim.verb == "derive"; });
}

}  // namespace

std::string name_of(const Claim& claim) { return claim.label + claim.instance; }

Rereading::Rereading(const syntax::File& file, const syntax::Case& kept, const Limits& limits,
                     const Loader& load)
    : source_{only(file, kept)}, limits_{limits}, load_{load}, fresh_{fresh_in(source_->text)} {}

std::optional<Case> Rereading::read(std::vector<Edit> edits) const {
  std::sort(edits.begin(), edits.end());
  const auto text =
      std::make_shared<const SourceText>(SourceText{source_->name, changed(source_->text, edits)});
  ReadFile file = read_cases(text, limits_, load_);
  if (!file.diagnostics.empty() || file.cases.size() != 1) return std::nullopt;
  Case read = std::move(file.cases.front());
  read.shown.clear();
  return read;
}

std::vector<ClaimResult> results_of(const Case& read, const ClaimFilter& wanted,
                                    const std::function<bool(const ClaimResult&)>& enough) {
  VerificationOptions options;
  options.engines = Engines::kernel;
  std::vector<ClaimResult> result;
  // What is derived would be derived again for each claim: then all are decided together.
  if (derives(read)) {
    options.wanted = wanted;
    return verified(read, options).claims;
  }
  Case one = read;
  for (const Claim& claim : read.claims) {
    if (!wanted(claim)) continue;
    one.claims = {claim};
    for (ClaimResult& decided : verified(one, options).claims) {
      result.push_back(std::move(decided));
      if (enough(result.back())) return result;
    }
  }
  return result;
}

Fate fate_of(const std::optional<Case>& read, const ClaimFilter& wanted) {
  if (!read) return Fate::meaningless;
  const auto is_noticed = [](const ClaimResult& result) {
    return result.outcome != Outcome::as_expected && result.outcome != Outcome::internal &&
           !is_over_limit(result);
  };
  const std::vector<ClaimResult> results = results_of(*read, wanted, is_noticed);
  Fate fate = Fate::survives;
  for (const ClaimResult& result : results) {
    if (result.outcome == Outcome::internal) return Fate::internal;
    if (is_noticed(result)) return Fate::noticed;
    if (is_over_limit(result)) fate = Fate::undecided;
  }
  return fate;
}

}  // namespace patchproof
