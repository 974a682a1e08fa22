#pragma once

#include <optional>
#include <vector>

#include <patchproof/net/segment_reader.hpp>

namespace patchproof {

/// A coordinate that a file gives otherwise than it is.
struct SegmentDifference {
  /// The segment, by its spans.
  std::size_t u_span = 0;
  std::size_t v_span = 0;
  /// The Bézier point, k in u and l in v, and its coordinate.
  std::size_t k = 0;
  std::size_t l = 0;
  std::size_t coordinate = 0;
  Rational exact;
  Rational found;
};

/// Compares segments that somebody else has calculated with the exact ones, strip by strip.
class SegmentComparison {
 public:
  SegmentComparison(bool json, ByteSource source, const SegmentShape& shape);

  /// Compares the next strip. @throws NetFault
  void compare(const SegmentStrip& strip);
  /// After the last strip. @throws NetFault
  void finish() { reader_->finish(); }

  /// How many Bézier points are different, and the first of them in the order of the file.
  std::size_t different_points() const { return different_points_; }
  const std::optional<SegmentDifference>& first() const { return first_; }

 private:
  void compare_point(const SegmentStrip& strip, std::size_t t, std::size_t k, std::size_t l);

  SegmentShape shape_;
  std::unique_ptr<SegmentReader> reader_;
  std::vector<Rational> found_;
  std::size_t different_points_ = 0;
  std::optional<SegmentDifference> first_;
};

}  // namespace patchproof
