#pragma once

#include <memory>
#include <vector>

#include <patchproof/net/byte_reader.hpp>
#include <patchproof/net/segment_writer.hpp>

namespace patchproof {

/// The points of Bézier segments in the form that `SegmentWriter` writes, one after the other:
/// segment by segment, v faster than u, and in each of them (k, l) with l faster than k.
class SegmentReader {
 public:
  virtual ~SegmentReader() = default;
  /// The coordinates of the next point. Only to be called as often as there are points.
  /// @throws NetFault where there is something else, also a shape that is not the one expected.
  virtual void read(std::vector<Rational>& coordinates) = 0;
  /// Nothing but the end may come now. @throws NetFault
  virtual void finish() = 0;
};

/// A reader of segments of this shape, from JSON or from lines.
std::unique_ptr<SegmentReader> segment_reader(bool json, ByteSource source,
                                              const SegmentShape& shape);

}  // namespace patchproof
