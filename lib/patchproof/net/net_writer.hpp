#pragma once

#include <string>

#include <patchproof/net/point_net.hpp>

namespace patchproof {

/// The net as lines of points, an empty line behind each row, as `net_from_csv` reads it: numbers
/// as p or p/q. Degrees and knots are not part of it.
std::string net_as_csv(const PointNet& net);

/// The net as JSON, as `net_from_json` reads it: whole numbers as such, others as "p/q"; with its
/// degrees and knots, where it has them.
std::string net_as_json(const PointNet& net);

/// Adds the number to a text, as p or p/q.
void append_number(const Rational& number, std::string& text);

/// Adds the number as JSON: a whole number as such, as "p/q" otherwise.
void append_json_number(const Rational& number, std::string& text);

}  // namespace patchproof
