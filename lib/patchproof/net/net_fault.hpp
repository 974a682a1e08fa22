#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <utility>

namespace patchproof {

/// Thrown by the readers of nets: bytes [begin, end) of a text cannot be read, or do not fit what
/// stands before them.
class NetFault : public std::exception {
 public:
  NetFault(std::size_t begin_at, std::size_t end_at, std::string what_is_wrong,
           std::string what_to_do = "")
      : begin{begin_at},
        end{end_at},
        message{std::move(what_is_wrong)},
        help{std::move(what_to_do)} {}
  const char* what() const noexcept override { return message.c_str(); }

  std::size_t begin;
  std::size_t end;
  std::string message;
  /// What to do about it; "" when the message says it all.
  std::string help;
};

}  // namespace patchproof
