#pragma once

#include <string>

#include <patchproof/net/point_net.hpp>

namespace patchproof {

/// Where something stands in a text: bytes [begin, end).
struct BytePlace {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Takes the coordinates of a net one after the other, and sees that all points have as many, and
/// all rows as many points. Everything throws NetFault where the net does not become one.
class NetBuilder {
 public:
  explicit NetBuilder(NetLimits limits) : limits_{std::move(limits)} {}

  void add(Rational coordinate, BytePlace place);
  /// The coordinates added last are a point, written there.
  void end_point(BytePlace place);
  /// The points added last are a row, which ends there.
  void end_row(BytePlace place);
  /// Points of rows that are all of this length.
  std::size_t points() const { return points_; }
  std::size_t rows() const { return net_.rows; }
  /// Whether points were added since the last row ended.
  bool in_row() const { return points_ > points_before_; }
  /// The net, once the text has ended there.
  PointNet finished(std::size_t end);
  /// The same for points in one sequence, which are `rows` rows.
  PointNet finished_as(std::size_t rows, std::size_t columns, BytePlace shape);

 private:
  NetLimits limits_;
  PointNet net_;
  std::size_t points_ = 0;
  /// When the present row began.
  std::size_t points_before_ = 0;
  std::size_t coordinates_before_ = 0;
  std::size_t large_bytes_ = 0;
};

/// "1 point", "3 points".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace patchproof
