#pragma once

#include <functional>
#include <string>

#include <patchproof/net/segments.hpp>

namespace patchproof {

/// How many Bézier segments of which kind a file has.
struct SegmentShape {
  std::size_t u_spans = 0;
  std::size_t v_spans = 0;
  std::size_t u_degree = 0;
  std::size_t v_degree = 0;
  std::size_t dimension = 0;

  std::size_t points_of_segment() const { return (u_degree + 1) * (v_degree + 1); }
  std::size_t points() const { return u_spans * v_spans * points_of_segment(); }
};

/// Writes Bézier segments, strip by strip, as lines of points or as JSON; docs/nets.md has the
/// form.
class SegmentWriter {
 public:
  /// Takes the next part of the text.
  using Write = std::function<void(const std::string& text)>;

  SegmentWriter(bool json, const SegmentShape& shape, Write write);
  /// The next strip.
  void add(const SegmentStrip& strip);
  /// What stands behind the last strip.
  void finish();

 private:
  void add_segment(const SegmentStrip& strip, std::size_t t);
  void add_json_segment(const SegmentStrip& strip, std::size_t t);

  bool json_;
  SegmentShape shape_;
  Write write_;
  std::string text_;
};

}  // namespace patchproof
