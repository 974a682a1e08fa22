#include <catch2/catch.hpp>
#include <fstream>
#include <random>
#include <sstream>

#include <patchproof/figure/decimal.hpp>
#include <patchproof/figure/figures.hpp>
#include <patchproof/figure/studio.hpp>
#include <patchproof/figure/svg_writer.hpp>
#include <patchproof/figure/tikz_writer.hpp>
#include <tests/decide/verdicts.hpp>

namespace patchproof {

namespace {

CaseResult result_of(const std::string& statements) {
  return results_of("case t\n  param u, v in [0, 1]\n" + statements + "end\n").front();
}

Figure figure_of(const std::string& statements, const std::vector<std::string>& names,
                 const FigureOptions& options = {}) {
  const Drawing drawing = drawing_of(result_of(statements), names, options);
  INFO(drawing.problem);
  REQUIRE(drawing.figure);
  return *drawing.figure;
}

template <typename Kind>
std::vector<Kind> all(const Figure& figure) {
  std::vector<Kind> result;
  for (const Shape& shape : figure.shapes)
    if (const auto* found = std::get_if<Kind>(&shape)) result.push_back(*found);
  return result;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++result;
  return result;
}

// Angles may have to be cut finer, and all be worked out again.
Point sample(const CaseResult& result, const std::string& name,
             const std::vector<Rational>& place) {
  Budget budget{Limits{}};
  Workspace workspace{budget};
  for (;;) try {
      return Studio{result, {name}, workspace}.subjects().front().at(place);
    } catch (const FinerAngles&) {
      continue;
    }
}

const std::string bezier = "  point V[0..3, 0..3]\n  patch b(u, v) = bezier(V)\n";
const std::string coons =
    "  curve C1(u), C2(u), D1(v), D2(v) : C^1\n"
    "  assume corners: C1(0) == D1(0), C1(1) == D2(0), C2(0) == D1(1), C2(1) == D2(1)\n"
    "  patch r(u, v) = coons(C1, C2, D1, D2)\n  prove south: r(u,0) == C1(u)\n";

}  // namespace

TEST_CASE("[law] samples of a patch are its exact values") {
  const CaseResult result =
      result_of("  patch p(u, v) = (u*(1-u)/3, v^3 - u, (1+u)/(2+v))\n  let f(u, v) = u - v^2\n");
  Budget budget{Limits{}};
  Workspace workspace{budget};
  const Studio studio{result, {"p", "f"}, workspace};
  std::mt19937 random{3};
  for (int n = 0; n < 50; ++n) {
    const Rational u{random() % 12, 11};
    const Rational v{random() % 18, 17};
    CHECK(studio.subjects()[0].at({u, v}) ==
          Point{Rational{u * (1 - u) / 3}, Rational{v * v * v - u}, Rational{(1 + u) / (2 + v)}});
    CHECK(studio.subjects()[1].at({u, v}) == Point{u, v, Rational{u - v * v}});
  }
}

TEST_CASE("[law] samples of elementary functions are within 2^-40") {
  const CaseResult result = result_of("  patch p(u, v) = (sin(pi*u/2), sqrt(1 + v), exp(u - v))\n");
  const Point at = sample(result, "p", {Rational{1, 3}, Rational{7, 9}});
  const auto is_near = [](const Rational& x, const Rational& y) {
    return abs(x - y) <= Rational{1, Integer{1} << 40};
  };
  CHECK(is_near(at[0], {1, 2}));
  CHECK(is_near(at[1], {4, 3}));
  // exp(-4/9), from its series by hand.
  Rational term = 1;
  Rational total = 0;
  for (int k = 1; k < 20; ++k) {
    total += term;
    term *= Rational{-4, 9 * k};
  }
  CHECK(is_near(at[2], total));
}

TEST_CASE("a corner that is 0/0 is drawn by a place nearby, a range is the one declared") {
  const CaseResult result =
      results_of(
          "case t\n  param u in [0, 2], v in [1, 3]\n"
          "  patch p(u, v) = (u*v/(u+v-1), v, 0)\n  prove p: p(u,v).y == v\nend\n")
          .front();
  Budget budget{Limits{}};
  Workspace workspace{budget};
  const Studio studio{result, {"p"}, workspace};
  CHECK(studio.subjects()[0].at({0, 0})[1] == 1 + Rational{2, 8192});
  CHECK(studio.subjects()[0].at({1, 1}) == Point{Rational{3, 2}, 3, 0});
}

TEST_CASE("[law] written numbers are at most half a unit of the last digit off") {
  std::mt19937 random{5};
  for (int n = 0; n < 2000; ++n) {
    const Rational x{static_cast<long>(random() % 4001) - 2000, 1 + random() % 997};
    const std::string text = decimal(x, 2);
    const bool negative = text.front() == '-';
    const Rational read = *number_from_text(negative ? text.substr(1) : text);
    CHECK(abs(x - (negative ? Rational{-read} : read)) <= Rational{1, 200});
  }
  CHECK(decimal({1, 200}, 2) == "0.01");
  CHECK(decimal({-1, 200}, 2) == "-0.01");
  CHECK(decimal({-1, 201}, 2) == "0");
  CHECK(decimal({31, 10}, 2) == "3.1");
  CHECK(decimal(-7, 2) == "-7");
}

TEST_CASE("[law] the corners of a drawing are the projected corners, to one scale") {
  const Figure figure =
      figure_of("  patch b(u, v) = bezier([(0,0,1), (0,2,0) ; (3,0,-1), (3,2,5)])\n", {"b"});
  const std::vector<Dot> dots = all<Dot>(figure);
  REQUIRE(dots.size() == 4);
  const Projection projection{View{}};
  const std::vector<Point> corners{{0, 0, 1}, {0, 2, 0}, {3, 0, -1}, {3, 2, 5}};
  const Point origin = projection(corners[0]);
  const Rational scale = (dots[3].at.x - dots[0].at.x) / (projection(corners[3])[0] - origin[0]);
  CHECK(scale > 0);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point seen = projection(corners[k]) - origin;
    CHECK(dots[k].at.x - dots[0].at.x == scale * seen[0]);
    CHECK(dots[k].at.y - dots[0].at.y == scale * seen[1]);
  }
}

TEST_CASE("[law] a figure has the width asked for, or the greatest height") {
  FigureOptions options;
  options.width = 50;
  options.greatest_height = 40;
  const Figure wide = figure_of("  patch p(u, v) = (9*u, v)\n", {"p"}, options);
  CHECK(wide.width == 50);
  CHECK(wide.height == Rational{50, 9});
  const Figure high = figure_of("  patch p(u, v) = (u, 9*v)\n", {"p"}, options);
  CHECK(high.width == Rational{40, 9});
  CHECK(high.height == 40);
}

TEST_CASE("[law] TikZ and SVG have the same shapes, and a second figure has the same bytes") {
  FigureOptions options;
  options.twists = true;
  const Figure figure = figure_of(bezier, {"b"}, options);
  const std::string as_svg = svg(figure);
  const std::string as_tikz = tikz(figure, latex_labels({}));
  CHECK(count(as_svg, "<polygon ") == count(as_tikz, "\\filldraw["));
  CHECK(count(as_svg, "<polygon ") == all<Polygon>(figure).size());
  CHECK(count(as_svg, "<polyline ") + count(as_svg, "<line ") == count(as_tikz, "\\draw["));
  CHECK(count(as_svg, "<circle ") == count(as_tikz, "\\fill["));
  CHECK(count(as_svg, "<circle ") == 16);
  CHECK(count(as_svg, "<text ") == count(as_tikz, "\\node["));
  CHECK(count(as_svg, "<line ") == 4);
  CHECK(svg(figure_of(bezier, {"b"}, options)) == as_svg);
  CHECK(tikz(figure_of(bezier, {"b"}, options), latex_labels({})) == as_tikz);
}

TEST_CASE("example curves satisfy what the case assumes of their ends") {
  const CaseResult result = result_of(coons);
  Budget budget{Limits{}};
  Workspace workspace{budget};
  Studio studio{result, {"r", "C1", "C2", "D1", "D2"}, workspace};
  const std::vector<Subject>& s = studio.subjects();
  CHECK(s[1].at({0}) == s[3].at({0}));
  CHECK(s[1].at({1}) == s[4].at({0}));
  CHECK(s[2].at({1}) == s[4].at({1}));
  CHECK(s[0].at({Rational{1, 3}, 1}) == s[2].at({Rational{1, 3}}));
  CHECK(studio.notes() == std::vector<std::string>{"example values: C1, C2, D1, D2"});
}

TEST_CASE("an assumption the usual example breaks is satisfied by another") {
  const CaseResult result = result_of(
      "  curve C(u), D(u) : C^1\n  scalar T\n  assume down: T < 0\n"
      "  assume ends: D(0) == C(1), D(1) == 2*C(0) - C(1)\n"
      "  patch r(u, v) = T*ruled(C, D)\n  prove south: r(u,0) == T*C(u)\n");
  Budget budget{Limits{}};
  Workspace workspace{budget};
  Studio studio{result, {"C", "D", "r"}, workspace};
  const std::vector<Subject>& s = studio.subjects();
  CHECK(s[1].at({0}) == s[0].at({1}));
  CHECK(s[1].at({1}) == Rational{2} * s[0].at({0}) - s[0].at({1}));
  CHECK(s[2].at({1, 0})[0] * s[0].at({1})[0] < 0);
}

TEST_CASE("control points that were derived follow those that are given") {
  const CaseResult result = result_of(bezier +
                                      "  derive inner: V[1,1] from b_uv(0,0) == 0\n"
                                      "    gives V[1,0] + V[0,1] - V[0,0]\n");
  Budget budget{Limits{}};
  Workspace workspace{budget};
  const Studio studio{result, {"b"}, workspace};
  const DrawnNet& net = *studio.subjects()[0].net;
  CHECK(net.rows == 4);
  CHECK(net.columns == 4);
  CHECK(net.at(1, 1) == net.at(1, 0) + net.at(0, 1) - net.at(0, 0));
  CHECK(net.at(2, 1) != net.at(2, 0) + net.at(1, 1) - net.at(1, 0));
}

TEST_CASE("the edge two patches have in common is marked, and only that") {
  const std::string patches =
      "  patch P(u, v) = (u, v, u*v)\n  patch R(u, v) = (u, 1 + v, u)\n"
      "  patch far(u, v) = (u, 3 + v, 0)\n";
  const auto marked = [](const Figure& figure) {
    std::size_t pieces = 0;
    for (const Polyline& line : all<Polyline>(figure)) pieces += line.ink == Ink::common ? 1 : 0;
    return pieces;
  };
  CHECK(marked(figure_of(patches, {"P", "R"})) == FigureOptions{}.cells);
  CHECK(marked(figure_of(patches, {"P", "far"})) == 0);
}

TEST_CASE("a refuted equation is drawn by arrows from its left to its right side") {
  const Figure figure =
      figure_of("  curve C(u) = (u, u^2)\n  refute line: C(u) == (u, u)\n", {"line"});
  const std::vector<Arrow> arrows = all<Arrow>(figure);
  CHECK(arrows.size() == 9);
  CHECK(tikz(figure, latex_labels({})).rfind("% left side: thin lines; right side: orange\n", 0) ==
        0);
  for (const Arrow& arrow : arrows) CHECK(arrow.from.x == arrow.to.x);
  CHECK(figure.notes == std::vector<std::string>{"left side: thin lines; right side: orange"});
}

TEST_CASE("zebra stripes cover the patch, and there are dark and light ones") {
  FigureOptions options;
  options.zebra = true;
  options.cells = 4;
  const Figure figure = figure_of("  patch p(u, v) = (u, v, u^2 - v^2)\n", {"p"}, options);
  std::size_t dark = 0;
  std::size_t light = 0;
  for (const Polygon& polygon : all<Polygon>(figure)) ++(polygon.strength > 50 ? dark : light);
  CHECK(dark > 0);
  CHECK(light > 0);
}

TEST_CASE("labels are mathematics in LaTeX, with indices as the case names them") {
  Notation notation;
  notation.names = {{"V", "\\mathbf{V}"}, {"alpha", "\\alpha"}, {"C1", "\\gamma"}};
  const LabelText text = latex_labels(notation);
  CHECK(text("W[0,3]") == "W_{03}");
  CHECK(text("W[10,3]") == "W_{10,3}");
  CHECK(text("V[0,3]") == "{\\mathbf{V}}_{03}");
  CHECK(text("D1") == "D_1");
  CHECK(text("C1") == "\\gamma");
  CHECK(text("r_uv(0,1)") == "r_{uv}(0,1)");
  CHECK(text("south") == "\\mathit{south}");
}

TEST_CASE("a small figure is written as expected") {
  FigureOptions options;
  options.cells = 2;
  options.cells_between_lines = 1;
  options.width = 20;
  const Figure figure = figure_of("  patch p(u, v) = (u, v)\n", {"p"}, options);
  std::ifstream file{std::string{PATCHPROOF_SOURCE_FOLDER} + "/tests/figure/square.svg"};
  std::ostringstream expected;
  expected << file.rdbuf();
  CHECK(svg(figure) == expected.str());
}

}  // namespace patchproof
