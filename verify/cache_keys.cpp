#include <verify/cache_keys.hpp>

#include <patchproof/latex/sha256.hpp>

namespace patchproof {

namespace {

// No two lists of parts give the same text.
void add_part(std::string_view part, std::string& text) {
  text += std::to_string(part.size()) + ":";
  text += part;
}

std::string_view part_of(const Span& span, std::size_t begin, std::size_t end) {
  return std::string_view{span.source->text}.substr(begin, end - begin);
}

// What stands between two cases; "" where that is only blank.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

std::string text_of(const Limits& limits) {
  return std::to_string(limits.time.count()) + " " + std::to_string(limits.terms) + " " +
         std::to_string(limits.steps) + " " + std::to_string(limits.memory);
}

}  // namespace

Loader CacheKeys::remembering(const Loader& load) {
  return [this, load](const std::string& path) {
    std::optional<std::string> text = load(path);
    add_part(path, loaded_);
    add_part(text ? "there" : "not there", loaded_);
    add_part(text ? *text : "", loaded_);
    return text;
  };
}

void CacheKeys::note(const CaseFile& file, const std::string& program, Engines engines) {
  std::string common;
  add_part(program, common);
  add_part(std::to_string(static_cast<int>(engines)), common);
  add_part(loaded_, common);
  // Definitions may stand before and after a case.
  std::vector<std::string_view> gaps;
  std::size_t at = 0;
  for (const Case& of : file.cases) {
    gaps.push_back(trimmed(part_of(of.whole, at, of.whole.begin)));
    at = of.whole.end;
  }
  if (!file.cases.empty())
    gaps.push_back(trimmed(part_of(file.cases.front().whole, at, std::string_view::npos)));
  std::string all_gaps;
  for (const std::string_view gap : gaps)
    if (!gap.empty()) add_part(gap, all_gaps);
  add_part(all_gaps, common);
  common = sha256(common);
  std::size_t gaps_before = 0;
  for (std::size_t of = 0; of < file.cases.size(); ++of) {
    if (!gaps[of].empty()) ++gaps_before;
    const Case& given = file.cases[of];
    std::string text;
    add_part(common, text);
    add_part(std::to_string(gaps_before), text);
    add_part(part_of(given.whole, given.whole.begin, given.whole.end), text);
    add_part(text_of(given.limits), text);
    digests_.push_back(sha256(text));
  }
}

std::string CacheKeys::digest(std::size_t of, std::size_t claim) const {
  return sha256(digests_.at(of) + " " + std::to_string(claim));
}

}  // namespace patchproof
