#include <patchproof/certificate/rocq_layout.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace patchproof {

namespace {

constexpr std::size_t widest = 100;

bool is_among(std::string_view word, std::string_view words) {
  return words.find(" " + std::string{word} + " ") != std::string_view::npos;
}

std::string_view word_at(std::string_view line, std::size_t at) {
  return line.substr(at, std::min(line.find(' ', at), line.size()) - at);
}

// How bad it is to break the line before a word: a sign that binds less is better.
std::optional<int> badness(std::string_view before, std::string_view word) {
  if (is_among(word, " = <> < <= > >= -> /\\ \\/ := ")) return 0;
  if (is_among(word, " + - ")) return 1;
  if (is_among(word, " * / ")) return 2;
  // A sign stays with what follows it.
  if (word == "^" || word == "=>" || word == ":" || is_among(before, " + - * / ^ : forall fun ") ||
      is_among(before, " = <> < <= > >= /\\ \\/ (- "))
    return std::nullopt;
  return before == "=>" || before == "->" ? 1 : 3;
}

std::string broken(std::string_view line) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  std::string result{line.substr(0, indent)};
  line.remove_prefix(indent);
  std::size_t room = widest - std::min(widest / 2, indent);
  // Brackets that are open where the line begins.
  int open = 0;
  while (line.size() > room) {
    std::size_t best = 0;
    int least = 0;
    int best_depth = 0;
    int depth = open;
    std::size_t word = 0;
    for (std::size_t at = 0; at < line.size() && (at <= room || best == 0); ++at) {
      if (line[at] == '(') ++depth;
      if (line[at] == ')') --depth;
      if (line[at] != ' ') continue;
      const std::optional<int> own =
          badness(line.substr(word, at - word), word_at(line, at + 1));
      word = at + 1;
      // Among equals the last one: the line is filled.
      if (!own || at == 0) continue;
      const int badness = 4 * depth + *own;
      if (best != 0 && badness > least) continue;
      best = at;
      least = badness;
      best_depth = depth;
    }
    if (best == 0) break;
    // Factors stand further in than summands, and what is in brackets further still.
    const bool factor = least - 4 * best_depth > 1;
    const std::size_t steps = static_cast<std::size_t>(std::clamp(best_depth, 0, 10)) + (factor ? 2 : 1);
    result += std::string{line.substr(0, best)} + "\n" + std::string(indent + 2 * steps, ' ');
    line.remove_prefix(best + 1);
    open = best_depth;
    room = widest - std::min(widest / 2, indent + 2 * steps);
  }
  return result + std::string{line};
}

}  // namespace

std::string with_short_lines(const std::string& text) {
  std::string result;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += broken(std::string_view{text}.substr(begin, end - begin));
    if (end < text.size()) result += '\n';
    begin = end + 1;
  }
  return result;
}

}  // namespace patchproof
