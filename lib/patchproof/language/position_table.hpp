#pragma once

#include <vector>

#include <patchproof/language/diagnostic.hpp>

namespace patchproof {

/// Lines and columns of many places of one text.
///
/// Looking a place up takes time logarithmic in the length of the text, even when the text is one
/// line of ten megabytes. The text must outlive the table.
class PositionTable {
 public:
  explicit PositionTable(const SourceText& source);

  /// Same as `position_of(source, byte)`.
  Position at(std::size_t byte) const;

 private:
  struct Mark {
    std::size_t byte;
    Position position;
  };
  const SourceText* source_;
  std::vector<Mark> marks_;  // in the order of the text, never far apart
};

}  // namespace patchproof
