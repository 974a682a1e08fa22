#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <patchproof/algebra/rational.hpp>
#include <patchproof/net/byte_reader.hpp>
#include <patchproof/net/exact_number.hpp>
#include <patchproof/net/net_builder.hpp>

namespace patchproof {

/// What a line of a text of points is.
enum class CsvLine {
  fields,  ///< something to be read by one of the functions of `CsvLines`
  empty,   ///< blanks only
  end,     ///< there is none
};

/// The lines of a text of points; lines that are only a comment are passed over. The separator is
/// the one that comes first. Everything throws NetFault for what cannot be read.
class CsvLines {
 public:
  explicit CsvLines(ByteSource source) : bytes_{std::move(source)} {}

  /// Goes to the next line. The one before has to be read to its end.
  CsvLine next();
  /// The bytes of the line that were read, without blanks around them.
  BytePlace place() const { return {begin_, end_}; }
  std::size_t offset() const { return bytes_.offset(); }

  /// Whether the line begins with a letter, so with no number.
  bool at_letter();
  /// The first word of such a line.
  std::string word();
  /// Behind a word: "4 x 7", both from 1 to 1 000 000, and nothing else. The example is for the
  /// message when there is something else.
  std::pair<std::size_t, std::size_t> shape(const std::string& example);
  /// Behind the first of them: names of coordinates, x, y, z, w in this order.
  void names(const std::string& first);

  /// Reads a line of numbers and calls take(number, place) for each.
  template <typename Take>
  void numbers(const Take& take) {
    for (bool more = true; more;) {
      const std::size_t at = bytes_.offset();
      const std::string_view token = field();
      if (token.empty()) fail_as_missing(at);
      take(exact_number(token, at), BytePlace{at, at + token.size()});
      end_ = at + token.size();
      more = separator();
    }
  }

 private:
  /// The next characters that are not blanks nor separators; views hold until the next call.
  std::string_view field();
  /// Passes over blanks; whether there were any.
  bool blanks();
  /// Passes over a separator, or over the end of the line, which is false.
  bool separator();
  /// Passes over a comment and the end of the line; something else is a mistake.
  void end_of_line();
  [[noreturn]] void fail_as_missing(std::size_t at) const;

  ByteReader bytes_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  /// ',' ';' or ' ' once it is known.
  char separator_ = '\0';
};

}  // namespace patchproof
