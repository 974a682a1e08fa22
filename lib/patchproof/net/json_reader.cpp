#include <set>

#include <patchproof/net/json_tokens.hpp>
#include <patchproof/net/knot_vector.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_reader.hpp>

namespace patchproof {

namespace {

class NetOfJson {
 public:
  NetOfJson(ByteSource source, const NetLimits& limits)
      : limits_{limits}, json_{std::move(source)} {}

  PointNet read() {
    PointNet net;
    if (json_.is('{')) {
      object();
      net = std::move(net_);
    } else {
      net = points();
    }
    json_.expect_end();
    net.degrees = degrees_;
    net.knots = std::move(knots_);
    return net;
  }

 private:
  void object() {
    const std::size_t begin = json_.next();
    std::set<std::string> members;
    json_.expect('{', "'{'");
    if (!json_.accept('}')) {
      do {
        const std::string name = json_.name();
        if (!members.insert(name).second)
          throw NetFault{json_.last().begin, json_.last().end, "a second member \"" + name + "\""};
        member(name);
      } while (json_.more('}'));
    }
    if (!members.contains("points"))
      throw NetFault{begin, begin + 1, "there is no member \"points\"",
                     R"({"points": [[[x, y, z], ...], ...], "degrees": [3, 3]})"};
  }

  void member(const std::string& name) {
    const BytePlace place = json_.last();
    json_.expect(':', "':'");
    if (name == "points")
      net_ = points();
    else if (name == "degrees")
      degrees();
    else if (name == "knots")
      knots();
    else if (name == "comment")
      json_.skip_text();
    else
      throw NetFault{place.begin, place.end, "unknown member \"" + name + "\"",
                     "a net has \"points\", \"degrees\", \"knots\" and \"comment\""};
  }

  PointNet points() {
    NetBuilder net{limits_};
    json_.list("'[' and rows of points", [&] {
      const std::size_t row = json_.next();
      json_.list("'[' and the points of a row", [&] {
        const std::size_t point = json_.next();
        json_.list("'[' and the coordinates of a point", [&] {
          Rational coordinate = json_.number();
          net.add(std::move(coordinate), json_.last());
        });
        net.end_point(json_.since(point));
      });
      // Of a row only its bracket is shown: the row itself may be very long.
      net.end_row({row, row + 1});
    });
    return net.finished(json_.last().end);
  }

  void degrees() {
    const std::size_t begin = json_.next();
    std::vector<int> values;
    json_.list("'[' and two degrees",
               [&] { values.push_back(json_.whole("a degree", 1, highest_net_degree)); });
    if (values.size() != 2) fail_as_not_two(begin, "degrees");
    degrees_ = {values[0], values[1]};
  }

  void knots() {
    const std::size_t begin = json_.next();
    std::size_t count = 0;
    std::vector<std::vector<Rational>> values;
    json_.list("'[' and two lists of knots", [&] {
      values.emplace_back();
      json_.list("'[' and knots", [&] {
        if (++count > most_knots)
          throw NetFault{json_.last().begin, json_.last().end,
                         "more than " + std::to_string(most_knots) + " knots"};
        values.back().push_back(json_.number());
      });
    });
    if (values.size() != 2) fail_as_not_two(begin, "lists of knots");
    knots_ = {std::move(values[0]), std::move(values[1])};
  }

  [[noreturn]] static void fail_as_not_two(std::size_t begin, const std::string& what) {
    throw NetFault{begin, begin + 1, "a surface has two " + what + ", one for u and one for v"};
  }

  static constexpr std::size_t most_knots = 4'000'100;

  const NetLimits& limits_;
  JsonTokens json_;
  PointNet net_;
  std::optional<std::array<int, 2>> degrees_;
  std::optional<std::array<std::vector<Rational>, 2>> knots_;
};

}  // namespace

PointNet net_from_json(ByteSource source, const NetLimits& limits) {
  return NetOfJson{std::move(source), limits}.read();
}

}  // namespace patchproof
