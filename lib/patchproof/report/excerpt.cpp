#include <patchproof/report/excerpt.hpp>

#include <algorithm>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/utf8.hpp>

namespace patchproof {

namespace {

constexpr std::size_t most_lines = 12;
constexpr std::size_t widest_line = 120;
constexpr std::size_t number_width = 6;

std::string first_characters(const std::string& text, std::size_t count) {
  std::size_t end = 0;
  for (; count > 0 && end < text.size(); --count)
    end += std::max<std::size_t>(1, utf8_length(text, end));
  return end < text.size() ? text.substr(0, end) + "..." : text;
}

// A message shows one line, with carets: the same look, without the words of the message.
std::string one_line(const Span& span) {
  const std::string message = to_text(Diagnostic{span, "", ""});
  return message.substr(message.find('\n') + 1);
}

std::string numbered(std::size_t number, const std::string& line) {
  std::string digits = std::to_string(number);
  if (digits.size() < number_width) digits.insert(0, number_width - digits.size(), ' ');
  return digits + " |" + (line.empty() ? "" : " ") + line + "\n";
}

}  // namespace

std::string place_of(const Span& span) {
  if (!span.source) return "";
  const Position position = position_of(*span.source, span.begin);
  return printable(span.source->name) + ":" + std::to_string(position.line) + ":" +
         std::to_string(position.column);
}

std::string excerpt_of(const Span& span) {
  if (!span.source) return "";
  const std::string& text = span.source->text;
  const std::size_t begin = std::min(span.begin, text.size());
  const std::size_t end = std::clamp(span.end, begin, text.size());
  const std::size_t first_end = text.find('\n', begin);
  if (first_end == std::string::npos || first_end >= end) return one_line(span);
  std::size_t number = position_of(*span.source, begin).line;
  std::size_t at = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;  // npos + 1 is 0
  std::string result;
  for (std::size_t lines = 0; at < end; ++lines, ++number) {
    if (lines == most_lines) return result + std::string(number_width, ' ') + " | ...\n";
    const std::size_t line_end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, line_end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    result += numbered(number, first_characters(printable(line), widest_line));
    at = line_end + 1;
  }
  return result;
}

std::string as_written(const Span& span) {
  if (!span.source || span.begin >= span.end) return "";
  return span.source->text.substr(span.begin, span.end - span.begin);
}

}  // namespace patchproof
