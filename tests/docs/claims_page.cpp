#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include <tests/docs/claims_page.hpp>

namespace patchproof::test {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> result;
  std::istringstream stream{text};
  for (std::string part; std::getline(stream, part, separator);) result.push_back(part);
  return result;
}

// The titles of the documents, in the order of the page.
const std::vector<std::pair<std::string, std::string>>& documents() {
  static const std::vector<std::pair<std::string, std::string>> table{
      {"sk", "Plochy určené okrajom (Slovak)"},
      {"sk2", "Plochy určené okrajom, second copy (Slovak)"},
      {"si", "Diskretne Coonsove ploskve (Slovenian)"},
      {"cz", "Plochy, Počítačová grafika 2023/24 (Czech)"},
      {"ru", "Лоскут Куна (Russian)"},
      {"ext", "What a reader expects next to the notes"},
  };
  return table;
}

// How a claim counts on the page.
std::string kind_of(const ClaimResult& result) {
  if (result.outcome != Outcome::as_expected) return "not as expected";
  const bool free = !result.decision.free.empty();
  switch (result.decision.verdict) {
    case Verdict::proved: return free ? "derived with free unknowns" : "proved";
    case Verdict::proved_if: return "proved under a condition";
    case Verdict::refuted: return "refuted";
    case Verdict::inconsistent: return "shown inconsistent";
    default: return "open";
  }
}

// "proved a, b; refuted c": labels in the order of the case, families once.
std::string summary(const std::vector<ClaimResult>& claims) {
  std::vector<std::pair<std::string, std::vector<std::string>>> kinds;
  for (const ClaimResult& result : claims) {
    const std::string kind = kind_of(result);
    auto found = std::find_if(kinds.begin(), kinds.end(), [&](auto& k) { return k.first == kind; });
    if (found == kinds.end()) found = kinds.insert(kinds.end(), {kind, {}});
    std::vector<std::string>& labels = found->second;
    if (std::find(labels.begin(), labels.end(), result.claim.label) == labels.end())
      labels.push_back(result.claim.label);
  }
  std::string text;
  for (const auto& [kind, labels] : kinds) {
    text += (text.empty() ? "" : "; ") + kind + " ";
    for (std::size_t k = 0; k < labels.size(); ++k) text += (k == 0 ? "" : ", ") + labels[k];
  }
  return text;
}

std::set<std::string> kinds_in(const Item& item, const Results& results) {
  std::set<std::string> kinds;
  for (const std::string& name : item.cases) {
    for (const ClaimResult& result : results.at(name)) {
      kinds.insert(kind_of(result));
      if (result.claim.verb == "corrected") kinds.insert("corrected");
    }
  }
  return kinds;
}

}  // namespace

std::vector<Item> items_of(const std::string& text) {
  std::vector<Item> result;
  const std::vector<std::string> lines = split(text, '\n');
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::vector<std::string> columns = split(lines[k], '\t');
    if (columns.size() != 6)
      throw std::runtime_error{"line " + std::to_string(k + 1) + " has " +
                               std::to_string(columns.size()) + " columns, not 6"};
    Item item{columns[0], columns[1], columns[2], columns[3], columns[4], {}, ""};
    if (columns[5].rfind("-: ", 0) == 0)
      item.reason = columns[5].substr(3);
    else
      item.cases = split(columns[5], ' ');
    result.push_back(std::move(item));
  }
  return result;
}

std::string fault_of(const Item& item, const Results& results) {
  const auto document =
      std::find_if(documents().begin(), documents().end(),
                   [&](const auto& entry) { return entry.first == item.document; });
  if (document == documents().end()) return "the document '" + item.document + "' is not known";
  for (const std::string& name : item.cases)
    if (!results.contains(name)) return "there is no case '" + name + "'";
  if (item.cases.empty()) return item.reason.empty() ? "it has neither cases nor a reason" : "";
  const std::set<std::string> kinds = kinds_in(item, results);
  if (kinds.contains("not as expected")) return "a claim is not decided as expected";
  const bool something_proved = kinds.contains("proved") ||
                                kinds.contains("proved under a condition") ||
                                kinds.contains("derived with free unknowns");
  if (!something_proved) return "nothing is proved";
  if (item.verdict == "OVERCLAIM" && !kinds.contains("refuted")) return "nothing is refuted";
  if (item.verdict == "FALSE-AS-PRINTED" && !kinds.contains("corrected")) return "no erratum";
  static const std::set<std::string> words{"TRUE",           "TRUE-WITH-HYPOTHESIS",
                                           "OVERCLAIM",      "FALSE-AS-PRINTED",
                                           "UNDER-SPECIFIED"};
  if (!words.contains(item.verdict)) return "'" + item.verdict + "' needs no cases";
  return "";
}

std::string claims_page(const std::vector<Item>& items, const Results& results) {
  std::string page =
      "# Every claim of the notes\n\n"
      "Written by `make claims` from `cases/items.tsv` and the verdicts of this build; a test\n"
      "compares. The column *verdict* says how the statement stands as printed; the last column\n"
      "names the cases and what became of each of their claims.\n";
  std::map<std::string, std::size_t> counts;
  for (const Item& item : items) ++counts[item.verdict];
  page += "\n" + std::to_string(items.size()) + " items:";
  std::string comma = " ";
  for (const auto& [verdict, count] : counts) {
    page += comma + std::to_string(count) + " " + verdict;
    comma = ", ";
  }
  page += ".\n";
  for (const auto& [id, title] : documents()) {
    page += "\n## " + title +
            "\n\n| item | section | statement | verdict | claims |\n|---|---|---|---|---|\n";
    for (const Item& item : items) {
      if (item.document != id) continue;
      std::string claims = item.reason;
      for (const std::string& name : item.cases)
        claims += (claims.empty() ? "`" : "<br>`") + name + "`: " + summary(results.at(name));
      page += "| " + item.id + " | " + item.section + " | " + item.statement + " | " +
              item.verdict + " | " + claims + " |\n";
    }
  }
  return page;
}

}  // namespace patchproof::test
