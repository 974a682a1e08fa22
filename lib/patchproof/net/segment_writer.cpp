#include <utility>

#include <patchproof/net/net_writer.hpp>
#include <patchproof/net/segment_writer.hpp>

namespace patchproof {

SegmentWriter::SegmentWriter(bool json, const SegmentShape& shape, Write write)
    : json_{json}, shape_{shape}, write_{std::move(write)} {
  const auto pair = [&](std::size_t u, const std::string& between, std::size_t v) {
    return std::to_string(u) + between + std::to_string(v);
  };
  text_ = json_ ? "{\"degrees\": [" + pair(shape.u_degree, ", ", shape.v_degree) +
                      "],\n \"segments\": [" + pair(shape.u_spans, ", ", shape.v_spans) +
                      "],\n \"points\": ["
                : "segments " + pair(shape.u_spans, " x ", shape.v_spans) + "\n";
}

void SegmentWriter::add(const SegmentStrip& strip) {
  if (json_) text_ += strip.number() == 0 ? "\n  [" : ",\n  [";
  for (std::size_t t = 0; t < shape_.v_spans; ++t)
    json_ ? add_json_segment(strip, t) : add_segment(strip, t);
  if (json_) text_ += "]";
  write_(std::exchange(text_, {}));
}

void SegmentWriter::finish() {
  if (json_) text_ += "]}\n";
  write_(std::exchange(text_, {}));
}

void SegmentWriter::add_segment(const SegmentStrip& strip, std::size_t t) {
  for (std::size_t k = 0; k <= shape_.u_degree; ++k) {
    for (std::size_t l = 0; l <= shape_.v_degree; ++l) {
      for (std::size_t c = 0; c < shape_.dimension; ++c) {
        if (c > 0) text_ += ',';
        append_number(strip.coordinate(t, k, l, c), text_);
      }
      text_ += '\n';
    }
  }
  text_ += '\n';
}

void SegmentWriter::add_json_segment(const SegmentStrip& strip, std::size_t t) {
  if (t > 0) text_ += ",\n   ";
  text_ += '[';
  for (std::size_t k = 0; k <= shape_.u_degree; ++k) {
    text_ += k == 0 ? "[" : ", [";
    for (std::size_t l = 0; l <= shape_.v_degree; ++l) {
      text_ += l == 0 ? "[" : ", [";
      for (std::size_t c = 0; c < shape_.dimension; ++c) {
        if (c > 0) text_ += ", ";
        append_json_number(strip.coordinate(t, k, l, c), text_);
      }
      text_ += ']';
    }
    text_ += ']';
  }
  text_ += ']';
}

}  // namespace patchproof
