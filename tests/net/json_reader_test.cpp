#include <catch2/catch.hpp>
#include <random>

#include <patchproof/net/net_writer.hpp>
#include <tests/net/net_messages.hpp>

using namespace patchproof;

namespace {

std::string json(const std::string& text) { return net_message("a.json", text); }

/// The mistake without the excerpt.
std::string first_line(const std::string& text) {
  const std::string message = json(text);
  return message.substr(0, message.find('\n'));
}

PointNet random_net(std::mt19937_64& random) {
  PointNet net;
  net.rows = 1 + random() % 5;
  net.columns = 1 + random() % 5;
  net.dimension = 1 + random() % 4;
  for (std::size_t k = 0; k < net.rows * net.columns * net.dimension; ++k) {
    const auto top = static_cast<std::int64_t>(random() >> (1 + random() % 60));
    const auto bottom = static_cast<std::int64_t>(random() >> (1 + random() % 60)) + 1;
    Rational value{random() % 2 == 0 ? top : -top, bottom};
    if (random() % 4 == 0) value *= value * value;
    net.coordinates.push_back(std::move(value));
  }
  return net;
}

}  // namespace

TEST_CASE("Numbers of JSON are read from their digits", "[net]") {
  const PointNet net = net_from_json(
      whole_text(R"( [ [[0.1, "1/3", 1e-2], [-0, "0x1.8p-3", 9007199254740993.5]] ] )"));
  CHECK(net_as_csv(net) == "1/10,1/3,1/100\n0,3/16,18014398509481987/2\n\n");
}

TEST_CASE("An object has degrees and knots besides", "[net]") {
  const PointNet net = net_from_json(whole_text(
      R"({"comment": "a \"net\"", "degrees": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, "1/2", 0.5]],
          "points": [[[1], [2]], [[3], [4]]]})"));
  CHECK(net.degrees == std::array<int, 2>{1, 1});
  REQUIRE(net.knots);
  CHECK((*net.knots)[1] == std::vector<Rational>{0, 0, Rational{1, 2}, Rational{1, 2}});
  CHECK(net_as_json(net_from_json(whole_text(net_as_json(net)))) == net_as_json(net));
}

TEST_CASE("Nets stay the same as lines and as JSON, however the text is cut", "[net][law]") {
  std::mt19937_64 random{3};
  for (int k = 0; k < 200; ++k) {
    const PointNet net = random_net(random);
    const std::string lines = net_as_csv(net);
    const PointNet again = net_from_json(whole_text(net_as_json(net_from_csv(whole_text(lines)))));
    CHECK(again.coordinates == net.coordinates);
    CHECK(net_as_csv(again) == lines);
    std::size_t at = 0;
    const std::size_t block = 1 + random() % 7;
    const PointNet in_blocks = net_from_csv([&] {
      const std::string_view next =
          std::string_view{lines}.substr(std::min(at, lines.size()), block);
      at += block;
      return next;
    });
    CHECK(in_blocks.coordinates == net.coordinates);
  }
}

TEST_CASE("JSON that is no net is refused where it stops being one", "[net][reject]") {
  CHECK(json("[[[1,2],[3]]]") ==
        R"(a.json:1:9: error: a point with 1 coordinate; the points before have 2
     1 | [[[1,2],[3]]]
       |         ^^^
)");
  CHECK(json("[[[1],[2]],\n [[3]]]") ==
        R"(a.json:2:2: error: row 2 has 1 point; the rows before have 2
     2 |  [[3]]]
       |  ^
)");
  CHECK(json("[[[1/3]]]") == R"(a.json:1:4: error: '1/3' is no number of JSON
     1 | [[[1/3]]]
       |    ^^^
       = help: put it in quotes: "1/3"
)");
  CHECK(first_line("[[[1,NaN]]]") == "a.json:1:6: error: 'NaN' is not a point of any patch");
  CHECK(first_line("[[1,2]]") ==
        "a.json:1:3: error: expected '[' and the coordinates of a point, found '1'");
  CHECK(first_line("[]") == "a.json:1:3: error: there are no points");
  CHECK(first_line("[[]]") == "a.json:1:2: error: a row without points");
  CHECK(first_line("[[[]]]") == "a.json:1:3: error: a point without coordinates");
  CHECK(first_line("") ==
        "a.json:1:1: error: expected '[' and rows of points, found the end of the text");
  CHECK(first_line("[[[1,\"1/3\"]]") ==
        "a.json:1:13: error: expected ',' or ']', found the end of the text");
  CHECK(first_line("[[[1]]] x") == "a.json:1:9: error: expected the end of the text, found 'x'");
  CHECK(first_line("[[[1],]]") ==
        "a.json:1:7: error: expected '[' and the coordinates of a point, found ']'");
  CHECK(first_line(std::string(100'000, '[')) == "a.json:1:4: error: expected a number, found '['");
  CHECK(first_line("[[[01]]]") == "a.json:1:4: error: '01' is no number of JSON");
  CHECK(first_line("[[[.5]]]") == "a.json:1:4: error: '.5' is no number of JSON");
  CHECK(first_line("[[[1e401]]]") == "a.json:1:4: error: an exponent beyond 400");
  CHECK(first_line("[[[\"a\"]]]") == "a.json:1:5: error: expected a number, found 'a'");
  CHECK(first_line("[[[\"\\u0031\"]]]") ==
        "a.json:1:4: error: an escape where a number or a name stands");
  CHECK(first_line("[[[\"1]]]") == "a.json:1:4: error: a text without its closing '\"'");
  CHECK(first_line("[[[null]]]") == "a.json:1:4: error: expected a number, found 'null'");
  CHECK(first_line("[[[1 2]]]") == "a.json:1:6: error: expected ',' or ']', found '2'");
}

TEST_CASE("Objects that are no net are refused", "[net][reject]") {
  CHECK(json(R"({"weights": 1})") == R"(a.json:1:2: error: unknown member "weights"
     1 | {"weights": 1}
       |  ^^^^^^^^^
       = help: a net has "points", "degrees", "knots" and "comment"
)");
  CHECK(first_line(R"({"degrees": [3, 3]})") == "a.json:1:1: error: there is no member \"points\"");
  CHECK(first_line(R"({"points": [[[1]]], "points": 1})") ==
        "a.json:1:21: error: a second member \"points\"");
  CHECK(first_line(R"({"degrees": [0, 3]})") ==
        "a.json:1:14: error: a degree is a whole number from 1 to 9");
  CHECK(first_line(R"({"degrees": [2.5, 3]})") ==
        "a.json:1:14: error: a degree is a whole number from 1 to 9");
  CHECK(first_line(R"({"degrees": [3]})") ==
        "a.json:1:13: error: a surface has two degrees, one for u and one for v");
  CHECK(first_line(R"({"knots": [[1]]})") ==
        "a.json:1:11: error: a surface has two lists of knots, one for u and one for v");
  CHECK(first_line(R"({"points" [[[1]]]})") == "a.json:1:11: error: expected ':', found '['");
  CHECK(first_line(R"({points: 1})") ==
        "a.json:1:2: error: expected a name in quotes, found 'points'");
  CHECK(first_line("{\"comment\": \"open\n\"}") ==
        "a.json:1:13: error: a text without its closing '\"'");
}
