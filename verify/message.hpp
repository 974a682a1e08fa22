#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace patchproof {

/// What two processes of one run tell each other: a JSON value as CBOR (RFC 8949) after its length.
/// Strings may have any bytes.
using Message = nlohmann::ordered_json;

/// Writes a message to a pipe; false when nobody reads there any more, or for more than 4 GB.
bool send(int descriptor, const Message& message);

/// Puts together the messages that arrive through a pipe.
class Mailbox {
 public:
  explicit Mailbox(int descriptor) : descriptor_{descriptor} {}

  /// Reads what has come, or waits for something; false at the end of the pipe.
  bool receive();
  /// The next message that is complete.
  /// @throws std::exception when the bytes are no message.
  std::optional<Message> next();

 private:
  int descriptor_;
  std::string bytes_;
  std::size_t begin_ = 0;
};

}  // namespace patchproof
