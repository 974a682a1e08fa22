#pragma once

#include <string>
#include <utility>

#include <patchproof/algebra/rational.hpp>
#include <patchproof/net/byte_reader.hpp>
#include <patchproof/net/net_builder.hpp>

namespace patchproof {

/// The tokens of a JSON text, one after the other, numbers as they are written. What is asked for
/// and is not there is a NetFault. Nothing is nested by itself: the depth is that of the caller.
class JsonTokens {
 public:
  explicit JsonTokens(ByteSource source) : bytes_{std::move(source)} {}

  /// Whether this sign, one of []{}:, comes next; nothing is taken.
  bool is(char sign);
  /// Takes the sign if it comes next.
  bool accept(char sign);
  /// Takes the sign. `what` is for the message: "expected '[', as a row begins with".
  void expect(char sign, const std::string& what);
  /// Takes `,` and tells that something follows, or takes `close`.
  bool more(char close);

  /// A number, or a text with one in it.
  Rational number();
  /// A whole number from `low` to `high`.
  int whole(const std::string& what, int low, int high);
  /// A text without escapes, of at most 100 characters, such as the name of a member.
  std::string name();
  /// Passes over a text of any kind.
  void skip_text();
  /// Nothing but blanks may follow.
  void expect_end();

  /// Where the next token begins.
  std::size_t next();
  /// What was read since byte `from`.
  BytePlace since(std::size_t from) const { return {from, end_}; }
  /// Where the token taken last stands.
  BytePlace last() const { return {begin_, end_}; }

  /// Calls item() for each entry of the list that comes next. `what` says what begins with '['.
  template <typename Item>
  void list(const std::string& what, const Item& item) {
    expect('[', what);
    if (accept(']')) return;
    do item();
    while (more(']'));
  }

 private:
  [[noreturn]] void fail_expected(const std::string& what);
  /// The text that comes next; of a longer one only its first `most` characters.
  std::string_view quoted(std::size_t most);

  ByteReader bytes_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::string text_;
};

}  // namespace patchproof
