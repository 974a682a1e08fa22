#include <string>
#include <utility>

#include <patchproof/net/csv_lines.hpp>
#include <patchproof/net/json_tokens.hpp>
#include <patchproof/net/knot_vector.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/segment_reader.hpp>

namespace patchproof {

namespace {

void require_dimension(std::size_t found, const SegmentShape& shape, BytePlace place) {
  if (found == shape.dimension) return;
  throw NetFault{place.begin, place.end,
                 "a point with " + counted(found, "coordinate") + "; those of the net have " +
                     std::to_string(shape.dimension)};
}

void require_spans(std::size_t u, std::size_t v, const SegmentShape& shape, BytePlace place) {
  if (u == shape.u_spans && v == shape.v_spans) return;
  throw NetFault{place.begin, place.end,
                 std::to_string(u) + " x " + std::to_string(v) + " segments; the net has " +
                     std::to_string(shape.u_spans) + " x " + std::to_string(shape.v_spans)};
}

class SegmentLines : public SegmentReader {
 public:
  SegmentLines(ByteSource source, const SegmentShape& shape)
      : lines_{std::move(source)}, shape_{shape} {}

  void read(std::vector<Rational>& coordinates) override {
    if (!next_point())
      throw NetFault{lines_.offset(), lines_.offset(),
                     "the segments end after " + counted(read_, "point") + "; " +
                         std::to_string(shape_.points()) + " belong to the net"};
    coordinates.clear();
    lines_.numbers([&](Rational number, BytePlace place) {
      if (coordinates.size() == shape_.dimension)
        require_dimension(shape_.dimension + 1, shape_, place);
      coordinates.push_back(std::move(number));
    });
    require_dimension(coordinates.size(), shape_, lines_.place());
    ++read_;
  }

  void finish() override {
    if (next_point())
      throw NetFault{lines_.offset(), lines_.offset() + 1,
                     "more than the " + counted(shape_.points(), "point") + " of the segments"};
  }

 private:
  bool next_point() {
    for (;;) {
      const CsvLine line = lines_.next();
      if (line == CsvLine::end) return false;
      if (line == CsvLine::empty) continue;
      if (read_ > 0 || has_heading_ || !lines_.at_letter()) return true;
      heading();
    }
  }

  void heading() {
    has_heading_ = true;
    const std::size_t at = lines_.offset();
    if (const std::string word = lines_.word(); word != "segments")
      static_cast<void>(exact_number(word, at));
    const auto [u, v] = lines_.shape("segments 4 x 7");
    require_spans(u, v, shape_, lines_.place());
  }

  CsvLines lines_;
  SegmentShape shape_;
  std::size_t read_ = 0;
  bool has_heading_ = false;
};

class SegmentJson : public SegmentReader {
 public:
  SegmentJson(ByteSource source, const SegmentShape& shape)
      : json_{std::move(source)}, shape_{shape} {}

  void read(std::vector<Rational>& coordinates) override {
    if (s_ + t_ + k_ + l_ == 0) begin();
    open();
    const std::size_t point = json_.last().begin;
    coordinates.clear();
    do {
      if (coordinates.size() == shape_.dimension)
        require_dimension(shape_.dimension + 1, shape_, {point, json_.last().end});
      coordinates.push_back(json_.number());
    } while (json_.more(']'));
    require_dimension(coordinates.size(), shape_, json_.since(point));
    close();
  }

  void finish() override {
    if (is_object_)
      while (json_.more('}')) member();
    json_.expect_end();
  }

 private:
  void begin() {
    is_object_ = json_.accept('{');
    if (!is_object_) return;
    while (member() != "points") json_.expect(',', "',' and a member \"points\"");
  }

  /// Reads a member; of the points only their name.
  std::string member() {
    const std::string name = json_.name();
    const BytePlace place = json_.last();
    json_.expect(':', "':'");
    if (name == "segments")
      pair("segments", 1'000'000, shape_.u_spans, shape_.v_spans);
    else if (name == "degrees")
      pair("degrees", highest_net_degree, shape_.u_degree, shape_.v_degree);
    else if (name == "comment")
      json_.skip_text();
    else if (name != "points" || has_points_)
      throw NetFault{place.begin, place.end, "unknown or second member \"" + name + "\"",
                     "segments have \"points\", \"degrees\", \"segments\" and \"comment\""};
    has_points_ = has_points_ || name == "points";
    return name;
  }

  void pair(const std::string& what, int most, std::size_t u, std::size_t v) {
    const std::size_t begin = json_.next();
    std::vector<std::size_t> found;
    json_.list("'[' and two numbers", [&] {
      found.push_back(static_cast<std::size_t>(json_.whole("each of the " + what, 1, most)));
    });
    if (found != std::vector{u, v})
      throw NetFault{begin, json_.last().end,
                     "other " + what + " than those of the net, [" + std::to_string(u) + ", " +
                         std::to_string(v) + "]"};
  }

  /// What stands before the coordinates of the point (k, l) of segment (s, t).
  void open() {
    const auto next = [&](bool first, const std::string& of_what) {
      first ? json_.expect('[', "'[' and " + of_what)
            : json_.expect(',', "',' and more " + of_what);
    };
    if (l_ == 0 && k_ == 0 && t_ == 0) next(s_ == 0, "rows of segments");
    if (l_ == 0 && k_ == 0) next(t_ == 0, "the segments of a row");
    if (l_ == 0) next(k_ == 0, "the rows of a segment");
    next(l_ == 0, "the points of a row");
    json_.expect('[', "'[' and the coordinates of a point");
  }

  /// What stands behind them; goes on to the next point.
  void close() {
    const auto ends = [&](std::size_t& index, std::size_t last) {
      if (index++ != last) return false;
      json_.expect(']', "']', as there are no more");
      index = 0;
      return true;
    };
    const bool all = ends(l_, shape_.v_degree) && ends(k_, shape_.u_degree) &&
                     ends(t_, shape_.v_spans - 1) && ends(s_, shape_.u_spans - 1);
    static_cast<void>(all);
  }

  JsonTokens json_;
  SegmentShape shape_;
  bool is_object_ = false;
  bool has_points_ = false;
  /// Of the next point.
  std::size_t s_ = 0;
  std::size_t t_ = 0;
  std::size_t k_ = 0;
  std::size_t l_ = 0;
};

}  // namespace

std::unique_ptr<SegmentReader> segment_reader(bool json, ByteSource source,
                                              const SegmentShape& shape) {
  if (json) return std::make_unique<SegmentJson>(std::move(source), shape);
  return std::make_unique<SegmentLines>(std::move(source), shape);
}

}  // namespace patchproof
