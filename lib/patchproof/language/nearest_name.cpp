#include <algorithm>

#include <patchproof/language/nearest_name.hpp>

namespace patchproof {
namespace {

constexpr std::size_t longest_word = 64;  // keeps a ten megabyte word from costing anything

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::move(last);
    last = std::move(row);
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() < 2 || word.size() > longest_word) return "";
  std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  std::string nearest;
  for (const std::string& name : known) {
    if (name == word) return name;
    const std::size_t shorter = std::min(name.size(), word.size());
    if (name.size() + word.size() - 2 * shorter > allowed) continue;
    const std::size_t changes = distance(word, name);
    if (changes > allowed || changes >= shorter) continue;
    if (nearest.empty() || changes < allowed) {
      nearest = name;
      allowed = changes;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(word, known);
  return nearest.empty() ? "" : "did you mean '" + nearest + "'?";
}

}  // namespace patchproof
