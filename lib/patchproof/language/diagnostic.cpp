#include <algorithm>
#include <map>
#include <string_view>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/utf8.hpp>

namespace patchproof {
namespace {

constexpr std::size_t widest_line = 120;  // characters; longer lines are cut around the caret

std::size_t characters_in(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) {
    at += std::max<std::size_t>(1, utf8_length(text, at));
  }
  return count;
}

/// Characters [first, first + count) of a text that is valid UTF-8.
std::string_view characters(std::string_view text, std::size_t first, std::size_t count) {
  std::size_t begin = 0;
  for (; first > 0 && begin < text.size(); --first) begin += utf8_length(text, begin);
  std::size_t end = begin;
  for (; count > 0 && end < text.size(); --count) end += utf8_length(text, end);
  return text.substr(begin, end - begin);
}

/// The line of `text` that holds `byte`, without its line end.
std::string_view line_around(std::string_view text, std::size_t byte, std::size_t& begin) {
  begin = byte == 0 ? 0 : text.rfind('\n', byte - 1) + 1;  // npos + 1 is 0
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (begin == 0 && line.substr(0, byte_order_mark.size()) == byte_order_mark) {
    begin = byte_order_mark.size();
    line.remove_prefix(begin);
  }
  return line;
}

/// The source line, and below it the carets.
std::string excerpt(const Span& span, std::size_t line_number) {
  const std::string_view text = span.source->text;
  const std::size_t place = std::min(span.begin, text.size());
  std::size_t line_begin = 0;
  const std::string_view line = line_around(text, place, line_begin);

  const auto inside = [&](std::size_t byte) {
    return std::clamp(byte, line_begin, line_begin + line.size()) - line_begin;
  };
  const std::size_t first = inside(place);
  const std::size_t last = std::max(first, inside(std::max(span.end, place)));
  std::size_t column = characters_in(line.substr(0, first));
  std::size_t width = std::max<std::size_t>(1, characters_in(line.substr(first, last - first)));
  std::string shown = printable(line);

  const std::size_t length = characters_in(shown);
  if (length > widest_line) {
    const std::size_t start =
        column <= widest_line / 2
            ? 0
            : std::min(column - widest_line / 2, length - std::min(length, widest_line));
    const std::string_view before = start > 0 ? "..." : "";
    const std::string_view after = start + widest_line < length ? "..." : "";
    width = std::min(width, std::max<std::size_t>(1, start + widest_line - column));
    column = column - start + before.size();
    shown = std::string(before) + std::string(characters(shown, start, widest_line)) +
            std::string(after);
  }

  std::string number = std::to_string(line_number);
  if (number.size() < 6) number.insert(0, 6 - number.size(), ' ');
  const std::string margin(number.size(), ' ');
  std::string result = number + " |" + (shown.empty() ? "" : " ") + shown + "\n";
  return result + margin + " | " + std::string(column, ' ') + std::string(width, '^') + "\n";
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
  const Span& span = diagnostic.span;
  std::string result;
  if (span.source) {
    const Position position = position_of(*span.source, span.begin);
    result += printable(span.source->name) + ":" + std::to_string(position.line) + ":" +
              std::to_string(position.column) + ": ";
    result += "error: " + printable(diagnostic.message) + "\n";
    result += excerpt(span, position.line);
  } else {
    result += "error: " + printable(diagnostic.message) + "\n";
  }
  if (!diagnostic.help.empty()) result += "       = help: " + printable(diagnostic.help) + "\n";
  return result;
}

std::vector<Diagnostic> in_order(std::vector<Diagnostic> diagnostics, std::size_t most) {
  // Texts keep the order in which they are first spoken of; addresses would be an accident.
  std::map<const SourceText*, std::size_t> rank;
  for (const Diagnostic& diagnostic : diagnostics) {
    rank.emplace(diagnostic.span.source.get(), rank.size());
  }
  const auto place = [&](const Diagnostic& diagnostic) {
    return std::pair{rank.at(diagnostic.span.source.get()), diagnostic.span.begin};
  };
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
  const auto same_place = [&](const Diagnostic& a, const Diagnostic& b) {
    // Without a text there is no place to share.
    return a.span.source && place(a) == place(b);
  };
  diagnostics.erase(std::unique(diagnostics.begin(), diagnostics.end(), same_place),
                    diagnostics.end());
  if (diagnostics.size() > most) diagnostics.resize(most);
  return diagnostics;
}

}  // namespace patchproof
