#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace patchproof {

/// A text is not what Rocq prints for the statements of a certificate.
class RocqUnreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A word or a sign of what Rocq prints.
struct RocqToken {
  enum class Kind { name, number, sign, end };
  Kind kind = Kind::end;
  std::string_view text;
  /// Of its first byte in the whole text.
  std::size_t position = 0;
  /// No space stands before it.
  bool follows_closely = false;
};

/// The first word or sign at or behind a position. Its view looks into the text, which has to outlive
/// it. What is no sign of the language is a sign of one byte; behind the last one comes the end.
RocqToken rocq_token(std::string_view text, std::size_t position);

}  // namespace patchproof
