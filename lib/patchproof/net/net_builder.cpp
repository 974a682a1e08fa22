#include <utility>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/net_builder.hpp>
#include <patchproof/net/net_fault.hpp>

namespace patchproof {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void NetBuilder::add(Rational coordinate, BytePlace place) {
  if (net_.coordinates.size() - coordinates_before_ == limits_.dimension)
    throw NetFault{place.begin, place.end,
                   "a point with more than " + counted(limits_.dimension, "coordinate")};
  if (!coordinate.is_small()) {
    large_bytes_ += bit_length(coordinate) / 4 + sizeof(Rational);
    if (large_bytes_ > limits_.bytes_of_large_numbers)
      throw NetFault{place.begin, place.end,
                     "the numbers up to here need more than " +
                         std::to_string(limits_.bytes_of_large_numbers >> 20U) + " MB",
                     "write them with fewer digits"};
  }
  net_.coordinates.push_back(std::move(coordinate));
}

void NetBuilder::end_point(BytePlace place) {
  const std::size_t count = net_.coordinates.size() - coordinates_before_;
  if (count == 0) throw NetFault{place.begin, place.end, "a point without coordinates"};
  if (net_.dimension == 0) net_.dimension = count;
  if (count != net_.dimension)
    throw NetFault{place.begin, place.end,
                   "a point with " + counted(count, "coordinate") + "; the points before have " +
                       std::to_string(net_.dimension)};
  if (net_.rows > 0 && points_ - points_before_ == net_.columns)
    throw NetFault{place.begin, place.end,
                   "row " + std::to_string(net_.rows + 1) + " has more points than the " +
                       std::to_string(net_.columns) + " of the rows before"};
  if (points_ == limits_.points)
    throw NetFault{place.begin, place.end, "more than " + counted(limits_.points, "point"),
                   limits_.help};
  ++points_;
  coordinates_before_ = net_.coordinates.size();
}

void NetBuilder::end_row(BytePlace place) {
  const std::size_t count = points_ - points_before_;
  if (count == 0) throw NetFault{place.begin, place.end, "a row without points"};
  if (net_.rows == 0) net_.columns = count;
  if (count != net_.columns)
    throw NetFault{place.begin, place.end,
                   "row " + std::to_string(net_.rows + 1) + " has " + counted(count, "point") +
                       "; the rows before have " + std::to_string(net_.columns)};
  ++net_.rows;
  points_before_ = points_;
}

PointNet NetBuilder::finished(std::size_t end) {
  if (points_ == 0) throw NetFault{end, end, "there are no points"};
  return std::move(net_);
}

PointNet NetBuilder::finished_as(std::size_t rows, std::size_t columns, BytePlace shape) {
  if (points_ != rows * columns)
    throw NetFault{shape.begin, shape.end,
                   std::to_string(rows) + " x " + std::to_string(columns) + " are " +
                       counted(rows * columns, "point") + ", and there " +
                       (points_ == 1 ? "is " : "are ") + std::to_string(points_)};
  net_.rows = rows;
  net_.columns = columns;
  return std::move(net_);
}

}  // namespace patchproof
