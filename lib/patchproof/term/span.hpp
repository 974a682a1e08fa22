#pragma once

#include <memory>
#include <string>

namespace patchproof {

/// A text with a name, as read from a file or standard input.
struct SourceText {
  std::string name;
  std::string text;
};

/// Where something was written: bytes [begin, end) of a source text.
struct Span {
  std::shared_ptr<const SourceText> source;
  std::size_t begin = 0;
  std::size_t end = 0;
};

}  // namespace patchproof
