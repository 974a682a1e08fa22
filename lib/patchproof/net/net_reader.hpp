#pragma once

#include <string_view>

#include <patchproof/net/byte_reader.hpp>
#include <patchproof/net/point_net.hpp>

namespace patchproof {

/// A net from lines of points: one point on a line, `x, y, z`, its coordinates as `exact_number`
/// reads them. One separator for the whole text: comma, semicolon, or blanks. `#` begins a comment.
///
/// Empty lines end a row of the net; lines with a comment only say nothing. Or the first line is
/// `net 4 x 7`: then the points of 4 rows follow, 7 in each, and empty lines say nothing. The names
/// of the coordinates may stand before the points: `x,y,z`.
/// @throws NetFault
PointNet net_from_csv(ByteSource source, const NetLimits& limits = {});

/// A net from JSON (RFC 8259): rows, in them points, in them coordinates:
/// [[[0, 0, 1], [0, 1, "1/3"]], …]. Or {"points": [[…], …], "degrees": [3, 3],
/// "knots": [[…], […]], "comment": "…"}, of which only the points have to be there.
///
/// Numbers are read from their digits, so 0.1 is 1/10; whatever else `exact_number` reads stands in
/// quotes.
/// @throws NetFault
PointNet net_from_json(ByteSource source, const NetLimits& limits = {});

/// From JSON where the name of the file ends so, otherwise from lines.
/// @throws NetFault
PointNet net_from_file(std::string_view file_name, ByteSource source, const NetLimits& limits = {});

/// Whether the name of a file ends in ".json", in letters of either size.
bool is_json_file(std::string_view file_name);

}  // namespace patchproof
