#include <charconv>
#include <utility>

#include <patchproof/net/csv_lines.hpp>
#include <patchproof/net/net_builder.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_reader.hpp>

namespace patchproof {

namespace {

/// `net 4 x 7`
struct Shape {
  std::size_t rows = 0;
  std::size_t columns = 0;
  BytePlace place;
};

class NetOfLines {
 public:
  NetOfLines(ByteSource source, const NetLimits& limits)
      : limits_{limits}, lines_{std::move(source)}, net_{limits} {}

  PointNet read() {
    for (CsvLine line = lines_.next(); line != CsvLine::end; line = lines_.next()) {
      if (line == CsvLine::empty && net_.in_row() && !shape_) net_.end_row(lines_.place());
      if (line == CsvLine::fields) fields();
    }
    const std::size_t end = lines_.offset();
    if (net_.in_row() && !shape_) net_.end_row({end, end});
    if (shape_ && net_.points() > 0)
      return net_.finished_as(shape_->rows, shape_->columns, shape_->place);
    return net_.finished(end);
  }

 private:
  void fields() {
    if (lines_.at_letter()) return heading();
    is_first_ = false;
    lines_.numbers([&](Rational number, BytePlace place) { net_.add(std::move(number), place); });
    net_.end_point(lines_.place());
  }

  void heading() {
    const std::size_t at = lines_.offset();
    const std::string word = lines_.word();
    if (word == "net" && is_first_ && !shape_) {
      const auto [rows, columns] = lines_.shape("net 4 x 7");
      shape_ = Shape{rows, columns, lines_.place()};
      if (rows > limits_.points / columns)
        throw NetFault{shape_->place.begin, shape_->place.end,
                       "more than " + counted(limits_.points, "point"), limits_.help};
    } else if ((word == "x" || word == "X") && is_first_) {
      lines_.names(word);
      is_first_ = false;
    } else {
      static_cast<void>(exact_number(word, at));
    }
  }

  const NetLimits& limits_;
  CsvLines lines_;
  NetBuilder net_;
  /// Nothing but `net 4 x 7` has come so far.
  bool is_first_ = true;
  std::optional<Shape> shape_;
};

}  // namespace

PointNet net_from_csv(ByteSource source, const NetLimits& limits) {
  return NetOfLines{std::move(source), limits}.read();
}

bool is_json_file(std::string_view file_name) {
  constexpr std::string_view ending = ".json";
  if (file_name.size() < ending.size()) return false;
  file_name.remove_prefix(file_name.size() - ending.size());
  for (std::size_t k = 0; k < ending.size(); ++k) {
    const char c = file_name[k];
    if (('A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != ending[k]) return false;
  }
  return true;
}

PointNet net_from_file(std::string_view file_name, ByteSource source, const NetLimits& limits) {
  return is_json_file(file_name) ? net_from_json(std::move(source), limits)
                                 : net_from_csv(std::move(source), limits);
}

}  // namespace patchproof
