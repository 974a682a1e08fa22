#include <algorithm>
#include <utility>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/knot_vector.hpp>
#include <patchproof/net/net_builder.hpp>

namespace patchproof {

namespace {

void require_points(int degree, std::size_t points) {
  if (degree < 1 || degree > highest_net_degree)
    throw KnotFault{"the degree has to lie between 1 and " + std::to_string(highest_net_degree)};
  if (points <= static_cast<std::size_t>(degree))
    throw KnotFault{"degree " + std::to_string(degree) + " needs at least " +
                    counted(static_cast<std::size_t>(degree) + 1, "point") + ", and there " +
                    (points == 1 ? "is " : "are ") + std::to_string(points)};
}

}  // namespace

KnotVector::KnotVector(int degree, std::vector<Rational> knots, std::size_t points)
    : degree_{degree}, knots_{std::move(knots)} {
  require_points(degree, points);
  const auto p = static_cast<std::size_t>(degree);
  if (knots_.size() != points + p + 1)
    throw KnotFault{counted(points, "point") + " of degree " + std::to_string(degree) + " need " +
                    counted(points + p + 1, "knot") + ", not " + std::to_string(knots_.size())};
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    if (knots_[k] < knots_[k - 1])
      throw KnotFault{"the knots decrease from " + to_text(knots_[k - 1]) + " to " +
                      to_text(knots_[k])};
    if (k > p && knots_[k] == knots_[k - p - 1])
      throw KnotFault{"the knot " + to_text(knots_[k]) + " occurs more than " +
                      std::to_string(p + 1) + " times"};
  }
  for (std::size_t k = p; k < points; ++k)
    if (knots_[k] < knots_[k + 1]) spans_.push_back(k);
  if (spans_.empty())
    throw KnotFault{"these knots leave no interval for the spline to be defined on"};
}

KnotVector KnotVector::clamped_uniform(int degree, std::size_t points) {
  require_points(degree, points);
  const auto p = static_cast<std::size_t>(degree);
  std::vector<Rational> knots;
  knots.reserve(points + p + 1);
  for (std::size_t k = 0; k < points + p + 1; ++k)
    knots.emplace_back(k <= p ? 0 : std::min(k, points) - p);
  return {degree, std::move(knots), points};
}

}  // namespace patchproof
