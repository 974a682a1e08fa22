#include <algorithm>

#include <patchproof/language/position_table.hpp>
#include <patchproof/language/utf8.hpp>

namespace patchproof {
namespace {

/// Moves over the character at `byte`.
void step(std::string_view text, std::size_t& byte, Position& position) {
  if (text[byte] == '\n') {
    ++position.line;
    position.column = 1;
    ++byte;
  } else if (byte == 0 && text.substr(0, byte_order_mark.size()) == byte_order_mark) {
    byte += byte_order_mark.size();
  } else {
    ++position.column;
    byte += std::max<std::size_t>(1, utf8_length(text, byte));
  }
}

/// Whether a walk that stands at `byte` may step once more without passing `goal`.
bool may_step(std::string_view text, std::size_t byte, std::size_t goal) {
  return byte < goal && byte < text.size() &&
         byte + std::max<std::size_t>(1, utf8_length(text, byte)) <= goal;
}

Position walked(std::string_view text, std::size_t byte, Position position, std::size_t goal) {
  while (may_step(text, byte, goal)) step(text, byte, position);
  return position;
}

}  // namespace

// Only the line itself has to be walked through.
Position position_of(const SourceText& source, std::size_t byte) {
  const std::string_view text = source.text;
  const std::string_view before = text.substr(0, byte);
  Position position;
  std::size_t begin = 0;
  for (std::size_t end = before.find('\n'); end != std::string_view::npos;
       end = before.find('\n', begin)) {
    ++position.line;
    begin = end + 1;
  }
  return walked(text, begin, position, byte);
}

PositionTable::PositionTable(const SourceText& source) : source_(&source) {
  constexpr std::size_t distance = 256;
  std::size_t byte = 0;
  Position position;
  marks_.push_back({byte, position});
  while (byte < source.text.size()) {
    step(source.text, byte, position);
    if (byte >= marks_.back().byte + distance) marks_.push_back({byte, position});
  }
}

Position PositionTable::at(std::size_t byte) const {
  const auto after =
      std::upper_bound(marks_.begin(), marks_.end(), byte,
                       [](std::size_t place, const Mark& mark) { return place < mark.byte; });
  const Mark& mark = *(after - 1);
  return walked(source_->text, mark.byte, mark.position, byte);
}

}  // namespace patchproof
