#include <patchproof/net/segment_comparison.hpp>

#include <catch2/catch.hpp>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_writer.hpp>
#include <tests/net/random_surface.hpp>

using namespace patchproof;

namespace {

SegmentShape shape_of(const Surface& surface) {
  return {surface.u.spans(), surface.v.spans(), static_cast<std::size_t>(surface.u.degree()),
          static_cast<std::size_t>(surface.v.degree()), surface.net.dimension};
}

std::string written(const Surface& surface, bool json) {
  std::string text;
  SegmentWriter writer{json, shape_of(surface), [&](const std::string& part) { text += part; }};
  segments_of(surface.net, surface.u, surface.v, 1,
              [&](const SegmentStrip& strip) { writer.add(strip); });
  writer.finish();
  return text;
}

struct Compared {
  std::size_t different = 0;
  std::optional<SegmentDifference> first;
  std::string fault;
};

Compared compared(const Surface& surface, bool json, const std::string& text) {
  SegmentComparison comparison{json, whole_text(text), shape_of(surface)};
  try {
    segments_of(surface.net, surface.u, surface.v, 1,
                [&](const SegmentStrip& strip) { comparison.compare(strip); });
    comparison.finish();
    return {comparison.different_points(), comparison.first(), ""};
  } catch (const NetFault& fault) {
    return {0, std::nullopt, std::to_string(fault.begin) + ": " + fault.message};
  }
}

/// Two bilinear segments, over the knots 0, 1, 2 in v.
Surface small() {
  PointNet net;
  net.rows = 2;
  net.columns = 3;
  net.dimension = 1;
  net.coordinates = {0, 1, 2, 3, 4, 5};
  return {net, KnotVector::clamped_uniform(1, 2), KnotVector::clamped_uniform(1, 3)};
}

}  // namespace

TEST_CASE("Segments that are written are read as the same", "[net][law]") {
  std::mt19937_64 random{7};
  for (int k = 0; k < 60; ++k) {
    const Surface surface = random_surface(random);
    for (const bool json : {false, true}) {
      const Compared result = compared(surface, json, written(surface, json));
      CHECK(result.fault.empty());
      CHECK(result.different == 0);
    }
  }
}

TEST_CASE("A single wrong coordinate is found wherever it is", "[net][law]") {
  std::mt19937_64 random{8};
  for (int k = 0; k < 150; ++k) {
    const Surface surface = random_surface(random);
    const SegmentShape shape = shape_of(surface);
    const SegmentPoints points = segment_points(surface);
    const std::size_t wrong = random() % (shape.points() * shape.dimension);
    // The segments as lines, in the order of the file, which is that of the map.
    std::string text;
    std::size_t number = 0;
    SegmentDifference expected;
    for (const auto& [place, value] : points) {
      const bool is_wrong = number == wrong;
      const Rational found =
          is_wrong ? value + Rational{1, 1 + static_cast<int>(random() % 1000)} : value;
      if (is_wrong)
        expected = {std::get<0>(place),
                    std::get<1>(place),
                    std::get<2>(place),
                    std::get<3>(place),
                    std::get<4>(place),
                    value,
                    found};
      append_number(found, text);
      text += ++number % shape.dimension == 0 ? "\n" : ",";
    }
    const Compared result = compared(surface, false, text);
    CHECK(result.different == 1);
    REQUIRE(result.first);
    CHECK(result.first->u_span == expected.u_span);
    CHECK(result.first->v_span == expected.v_span);
    CHECK(result.first->k == expected.k);
    CHECK(result.first->l == expected.l);
    CHECK(result.first->coordinate == expected.coordinate);
    CHECK(result.first->exact == expected.exact);
    CHECK(result.first->found == expected.found);
  }
}

TEST_CASE("Lines of segments have a heading, comments and empty lines where one likes", "[net]") {
  CHECK(written(small(), false) == "segments 1 x 2\n0\n1\n3\n4\n\n1\n2\n4\n5\n\n");
  CHECK(compared(small(), false, "# c\n\n0\n1.0\n3 # c\n\n4\n1\n2/1\n4\n0x5\n").fault.empty());
}

TEST_CASE("JSON of segments is an object or only its points", "[net]") {
  CHECK(written(small(), true) ==
        "{\"degrees\": [1, 1],\n \"segments\": [1, 2],\n \"points\": [\n"
        "  [[[[0], [1]], [[3], [4]]],\n   [[[1], [2]], [[4], [5]]]]]}\n");
  CHECK(
      compared(small(), true, "[[[[[0],[1]],[[3],[4]]],[[[1],[2]],[[4],[\"5\"]]]]]").fault.empty());
  CHECK(compared(small(), true,
                 "{\"points\":[[[[[0],[1]],[[3],[4]]],[[[1],[2]],[[4],[5]]]]],\"comment\":\"\"}")
            .fault.empty());
}

TEST_CASE("Files that are no segments of the net are refused", "[net][reject]") {
  const auto lines = [](const std::string& text) { return compared(small(), false, text).fault; };
  CHECK(lines("0\n1\n3\n") == "6: the segments end after 3 points; 8 belong to the net");
  CHECK(lines("0\n1\n3\n4\n1\n2\n4\n5\n6\n") == "16: more than the 8 points of the segments");
  CHECK(lines("0,1\n") == "2: a point with 2 coordinates; those of the net have 1");
  CHECK(lines("segments 2 x 2\n") == "0: 2 x 2 segments; the net has 1 x 2");
  CHECK(lines("segments 2\n") == "10: expected a shape like 'segments 4 x 7'");
  CHECK(lines("net 2 x 2\n") == "0: expected a number, found 'net'");
  CHECK(lines("0\nx\n") == "2: expected a number, found 'x'");
  CHECK(lines("") == "0: the segments end after 0 points; 8 belong to the net");
  const auto json = [](const std::string& text) { return compared(small(), true, text).fault; };
  CHECK(json("[[[[[0],[1]],[[3],[4]]]]]") ==
        "23: expected ',' and more the segments of a row, found ']'");
  CHECK(json("[[[[[0],[1],[2]]]]]") == "11: expected ']', as there are no more, found ','");
  CHECK(json("[[[[[0,1]]]]]") == "4: a point with 2 coordinates; those of the net have 1");
  CHECK(json("{\"degrees\": [2, 1]}") == "12: other degrees than those of the net, [1, 1]");
  CHECK(json("{\"segments\": [2, 1]}") == "13: other segments than those of the net, [1, 2]");
  CHECK(json("{\"net\": 1}") == "1: unknown or second member \"net\"");
  CHECK(json("{\"comment\": \"\"}") == "14: expected ',' and a member \"points\", found '}'");
  CHECK(json("[]") == "1: expected '[' and the segments of a row, found ']'");
  CHECK(json("7") == "0: expected '[' and rows of segments, found '7'");
}
