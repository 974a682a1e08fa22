#pragma once

#include <string>
#include <string_view>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// Text that is written up to a length and no further.
class BoundedText {
 public:
  /// Text of at most `longest` bytes, and the "…" that marks what is left out.
  explicit BoundedText(std::size_t longest);

  /// Whether something is left out already, so that writing more has no effect.
  bool full() const { return text_.size() > longest_; }

  void put(std::string_view text);

  /// The digits of a number that is not negative; of a long one only as many as are wanted.
  void put_digits(const Integer& number);

  /// What was written, cut off between two characters of UTF-8.
  std::string text() const;

 private:
  // At most one byte more than `longest_`: that one tells that there is more.
  std::string text_;
  std::size_t longest_;
};

}  // namespace patchproof
