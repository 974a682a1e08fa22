#include <algorithm>
#include <charconv>
#include <cstring>

#include <patchproof/net/csv_lines.hpp>
#include <patchproof/net/net_fault.hpp>

namespace patchproof {

namespace {

bool is_blank(int c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_letter(int c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }
bool is_end_of_line(int c) { return c == '\n' || c == '#' || c == ByteReader::end_of_text; }

bool is_of_field(unsigned char c) {
  return c > ' ' ? c != ',' && c != ';' && c != '#'
                 : c != ' ' && c != '\t' && c != '\r' && c != '\n';
}

std::string words(char separator) {
  return separator == ' ' ? "a blank" : "'" + std::string(1, separator) + "'";
}

/// How many characters of a field are looked at; the first one too many is the mistake.
constexpr std::size_t longest_field = longest_coordinate + 1;

}  // namespace

CsvLine CsvLines::next() {
  for (;;) {
    blanks();
    begin_ = end_ = bytes_.offset();
    const int c = bytes_.peek();
    if (c == ByteReader::end_of_text) return CsvLine::end;
    if (c == '\n') {
      bytes_.advance();
      return CsvLine::empty;
    }
    if (c != '#') return CsvLine::fields;
    end_of_line();
  }
}

bool CsvLines::at_letter() { return is_letter(bytes_.peek()); }

std::string CsvLines::word() {
  std::string result{field()};
  end_ = bytes_.offset();
  return result;
}

std::pair<std::size_t, std::size_t> CsvLines::shape(const std::string& example) {
  constexpr std::size_t most = 1'000'000;
  const auto fail = [&](std::size_t at, std::size_t end) {
    throw NetFault{at, end, "expected a shape like '" + example + "'",
                   "whole numbers from 1 to " + std::to_string(most)};
  };
  const auto count = [&] {
    blanks();
    const std::size_t at = bytes_.offset();
    const std::string_view token = field();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    const bool whole = error == std::errc{} && end == token.data() + token.size();
    if (!whole || value < 1 || value > most) fail(at, at + token.size());
    end_ = at + token.size();
    return value;
  };
  const std::size_t first = count();
  blanks();
  const std::size_t at = bytes_.offset();
  const std::string_view times = field();
  if (times != "x") fail(at, at + times.size());
  const std::size_t second = count();
  blanks();
  if (!is_end_of_line(bytes_.peek())) fail(bytes_.offset(), bytes_.offset() + 1);
  end_of_line();
  return {first, second};
}

void CsvLines::names(const std::string& first) {
  const char offset = first == "X" ? 'X' - 'x' : 0;
  std::string expected;
  for (const char name : {'y', 'z', 'w'}) {
    if (!separator()) return;
    const std::size_t at = bytes_.offset();
    const std::string_view found = field();
    if (found.size() != 1 || found[0] != name + offset)
      throw NetFault{at, at + found.size(), "expected the names x, y, z, w in this order",
                     "the coordinates of a point stand in this order"};
    end_ = at + 1;
  }
  if (separator())
    throw NetFault{bytes_.offset(), bytes_.offset() + 1, "more than four names of coordinates"};
}

std::string_view CsvLines::field() { return bytes_.take_while(is_of_field, longest_field); }

bool CsvLines::blanks() {
  bool any = false;
  for (; is_blank(bytes_.peek()); bytes_.advance()) any = true;
  return any;
}

bool CsvLines::separator() {
  const std::size_t at = bytes_.offset();
  const bool any = blanks();
  const int c = bytes_.peek();
  if (is_end_of_line(c)) {
    end_of_line();
    return false;
  }
  const char found = c == ',' || c == ';' ? static_cast<char>(c) : ' ';
  // A field stops at blanks and separators, so there is one of them, unless it was too long.
  if (found == ' ' && !any) return false;
  if (separator_ == '\0') separator_ = found;
  if (found != separator_) {
    const std::size_t place = found == ' ' ? at : bytes_.offset();
    throw NetFault{place, place + 1,
                   words(found) + " between coordinates, and before it " + words(separator_),
                   "one separator for the whole text; decimals are written with a point"};
  }
  if (found == ' ') return true;
  bytes_.advance();
  blanks();
  return true;
}

void CsvLines::end_of_line() {
  if (bytes_.peek() == '#')
    while (bytes_.peek() != '\n' && bytes_.peek() != ByteReader::end_of_text) bytes_.advance();
  if (bytes_.peek() == '\n') bytes_.advance();
}

void CsvLines::fail_as_missing(std::size_t at) const {
  throw NetFault{at, at + 1, "a coordinate is missing here",
                 "between separators, and behind the last one, stands a number"};
}

}  // namespace patchproof
