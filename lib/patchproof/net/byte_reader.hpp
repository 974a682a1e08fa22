#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace patchproof {

/// Gives the next block of a text, or an empty one at its end; a block is looked at until the next
/// one is asked for. What goes wrong while reading is thrown.
using ByteSource = std::function<std::string_view()>;

/// A whole text as a source of one block. The text has to live as long.
ByteSource whole_text(std::string_view text);

/// The bytes of a text, one after the other, of which only one block is in memory.
class ByteReader {
 public:
  /// What `peek` is behind the last byte.
  static constexpr int end_of_text = -1;

  explicit ByteReader(ByteSource source);
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// The next byte, from 0 to 255, or `end_of_text`.
  int peek() {
    if (at_ == block_.size() && !refill()) return end_of_text;
    return static_cast<unsigned char>(block_[at_]);
  }
  /// Leaves the byte behind; only where there is one.
  void advance() { ++at_; }
  /// How many bytes were left behind.
  std::size_t offset() const { return before_ + at_; }

  /// Takes bytes for which `wanted(byte)` holds, at most `most`. The view is valid until the next
  /// call of any function.
  template <typename Wanted>
  std::string_view take_while(const Wanted& wanted, std::size_t most) {
    const std::size_t from = at_;
    run(wanted, most);
    std::string_view taken = block_.substr(from, at_ - from);
    if (at_ < block_.size() || taken.size() == most) return taken;
    // The token goes on in the next block.
    spilled_.assign(taken);
    while (spilled_.size() < most && refill()) {
      run(wanted, most - spilled_.size());
      spilled_.append(block_.substr(0, at_));
      if (at_ < block_.size()) break;
    }
    return spilled_;
  }

 private:
  template <typename Wanted>
  void run(const Wanted& wanted, std::size_t most) {
    const std::size_t last = block_.size() - at_ < most ? block_.size() : at_ + most;
    while (at_ < last && wanted(static_cast<unsigned char>(block_[at_]))) ++at_;
  }
  /// Asks for the next block; false at the end of the text.
  bool refill();

  ByteSource source_;
  std::string_view block_;
  std::size_t at_ = 0;
  /// Bytes in the blocks before.
  std::size_t before_ = 0;
  std::string spilled_;
  /// The first blocks, where they are very short.
  std::string start_;
};

}  // namespace patchproof
