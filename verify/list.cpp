#include <verify/list.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/report/report.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

struct Entry {
  std::string id;
  const Claim* claim;
};

std::vector<Entry> entries(const std::vector<const Case*>& cases, const Selection& selection) {
  std::vector<Entry> result;
  for (const Case* of : cases)
    for (const Claim& claim : of->claims)
      if (selection.contains(*of, claim)) result.push_back({claim_id(*of, claim), &claim});
  return result;
}

std::string as_lines(const std::vector<Entry>& claims) {
  constexpr std::size_t widest = 60;
  std::size_t width = 0;
  for (const Entry& entry : claims) width = std::max(width, std::min(entry.id.size(), widest));
  std::string text;
  for (const Entry& entry : claims) {
    const std::size_t gap = entry.id.size() < width ? width - entry.id.size() : 0;
    text += entry.id + std::string(gap + 2, ' ') + to_text(entry.claim->expectation) + "\n";
  }
  return text;
}

std::string as_json(const std::vector<Entry>& claims) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& entry : claims) {
    const Span& span = entry.claim->span;
    list.push_back({{"id", entry.id},
                    {"file", span.source->name},
                    {"line", position_of(*span.source, span.begin).line},
                    {"expectation", to_text(entry.claim->expectation)}});
  }
  nlohmann::ordered_json document{{"version", version}, {"claims", list}};
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string list_of(const std::vector<const Case*>& cases, const Selection& selection,
                    std::string_view format) {
  const std::vector<Entry> claims = entries(cases, selection);
  return format == "json" ? as_json(claims) : as_lines(claims);
}

}  // namespace patchproof
