#include <unistd.h>
#include <verify/message.hpp>

#include <array>
#include <cerrno>
#include <cstdint>
#include <limits>
#include <vector>

namespace patchproof {

namespace {

constexpr std::size_t length_bytes = 4;

bool write_bytes(int descriptor, const std::uint8_t* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    data += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

bool send(int descriptor, const Message& message) {
  std::vector<std::uint8_t> bytes(length_bytes);
  Message::to_cbor(message, bytes);
  const std::size_t length = bytes.size() - length_bytes;
  if (length > std::numeric_limits<std::uint32_t>::max()) return false;
  for (std::size_t k = 0; k < length_bytes; ++k)
    bytes[k] = static_cast<std::uint8_t>(length >> (8 * k));
  return write_bytes(descriptor, bytes.data(), bytes.size());
}

bool Mailbox::receive() {
  std::array<char, 1 << 16> piece;
  for (;;) {
    const ssize_t count = ::read(descriptor_, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes_.append(piece.data(), static_cast<std::size_t>(count));
    return true;
  }
}

std::optional<Message> Mailbox::next() {
  if (bytes_.size() - begin_ < length_bytes) return std::nullopt;
  std::size_t length = 0;
  for (std::size_t k = 0; k < length_bytes; ++k)
    length |= std::size_t{static_cast<std::uint8_t>(bytes_[begin_ + k])} << (8 * k);
  if (bytes_.size() - begin_ - length_bytes < length) {
    bytes_.erase(0, begin_);
    begin_ = 0;
    return std::nullopt;
  }
  const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(begin_ + length_bytes);
  Message message = Message::from_cbor(first, first + static_cast<std::ptrdiff_t>(length));
  begin_ += length_bytes + length;
  return message;
}

}  // namespace patchproof
