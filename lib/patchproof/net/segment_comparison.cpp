#include <utility>

#include <patchproof/net/segment_comparison.hpp>

namespace patchproof {

SegmentComparison::SegmentComparison(bool json, ByteSource source, const SegmentShape& shape)
    : shape_{shape}, reader_{segment_reader(json, std::move(source), shape)} {}

void SegmentComparison::compare(const SegmentStrip& strip) {
  for (std::size_t t = 0; t < shape_.v_spans; ++t)
    for (std::size_t k = 0; k <= shape_.u_degree; ++k)
      for (std::size_t l = 0; l <= shape_.v_degree; ++l) compare_point(strip, t, k, l);
}

void SegmentComparison::compare_point(const SegmentStrip& strip, std::size_t t, std::size_t k,
                                      std::size_t l) {
  reader_->read(found_);
  for (std::size_t c = 0; c < shape_.dimension; ++c) {
    const Rational exact = strip.coordinate(t, k, l, c);
    if (exact == found_[c]) continue;
    ++different_points_;
    if (!first_) first_ = SegmentDifference{strip.number(), t, k, l, c, exact, found_[c]};
    return;
  }
}

}  // namespace patchproof
