#include <utility>

#include <patchproof/net/byte_reader.hpp>

namespace patchproof {

ByteSource whole_text(std::string_view text) {
  return [text]() mutable { return std::exchange(text, std::string_view{}); };
}

ByteReader::ByteReader(ByteSource source) : source_{std::move(source)} {
  // The mark some editors put at the start of a UTF-8 text; blocks may be shorter.
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (!refill()) return;
  while (block_.size() < mark.size() && mark.starts_with(block_)) {
    start_.assign(block_);
    const std::string_view next = source_();
    if (next.empty()) break;
    start_.append(next);
    block_ = start_;
  }
  if (block_.starts_with(mark)) at_ = mark.size();
}

bool ByteReader::refill() {
  const std::string_view next = source_();
  if (next.empty()) return false;
  before_ += block_.size();
  block_ = next;
  at_ = 0;
  return true;
}

}  // namespace patchproof
