#include <catch2/catch.hpp>
#include <random>

#include "algebra/random_algebra.hpp"
#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

// Knots of a random spline: multiplicities inside up to the degree, ends clamped or not.
struct RandomSpline {
  int degree = 0;
  int points = 0;
  std::vector<Rational> knots;

  // The intervals of the domain that are not empty.
  std::vector<std::pair<Rational, Rational>> pieces() const {
    std::vector<std::pair<Rational, Rational>> result;
    for (int k = degree; k < points; ++k) {
      const Rational& a = knots[static_cast<std::size_t>(k)];
      const Rational& b = knots[static_cast<std::size_t>(k) + 1];
      if (a < b) result.emplace_back(a, b);
    }
    return result;
  }
  std::string list() const {
    std::string text;
    for (const Rational& knot : knots) text += (text.empty() ? "[" : ", ") + to_text(knot);
    return text + "]";
  }
  std::string data() const { return "degree " + std::to_string(degree) + ", knots " + list(); }
  std::string declaration() const {
    return "param t in [0, 1]\npoint d[0.." + std::to_string(points - 1) +
           "]\nspline T = bspline(d, " + data() + ")\n";
  }
};

RandomSpline random_spline(std::mt19937& random) {
  RandomSpline result;
  result.degree = 1 + static_cast<int>(random() % 4);
  const int pieces = 1 + static_cast<int>(random() % 3);
  const bool clamped = random() % 3 != 0;
  const int outside = clamped ? 0 : result.degree;
  Rational knot{static_cast<int>(random() % 5) - 2, 2};
  const auto step = [&] {
    knot += Rational{1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 3)};
  };
  const auto add = [&](int times) {
    for (int k = 0; k < times; ++k) result.knots.push_back(knot);
  };
  for (int k = 0; k < outside; ++k, step()) add(1);
  add(clamped ? result.degree + 1 : 1);
  for (int k = 1; k < pieces; ++k) {
    step();
    add(1 + static_cast<int>(random() % static_cast<unsigned>(result.degree)));
  }
  step();
  add(clamped ? result.degree + 1 : 1);
  for (int k = 0; k < outside; ++k) {
    step();
    add(1);
  }
  result.points = static_cast<int>(result.knots.size()) - result.degree - 1;
  return result;
}

// Whether every claim among the statements has the verdict PROVED.
void check_proved(const std::string& statements) {
  INFO(statements);
  const std::string lines = verdicts(statements);
  INFO(lines);
  std::istringstream each{lines};
  std::size_t count = 0;
  for (std::string line; std::getline(each, line); ++count)
    // "label PROVED", perhaps with the assumptions used, but without conditions.
    CHECK((line.find(" PROVED") != std::string::npos && line.find('{') == std::string::npos));
  CHECK(count > 0);
}

std::string piece_claims(const std::string& name, std::size_t count, const std::string& left,
                         const std::string& right) {
  return "prove " + name + ": " + left + " == " + right + " for i in 0.." +
         std::to_string(count - 1) + "\n";
}

}  // namespace

TEST_CASE("pieces of any spline are the Bézier curves of its Bézier points, which merge again",
          "[law]") {
  std::mt19937 random{120};
  for (int k = 0; k < 12; ++k) {
    const RandomSpline s = random_spline(random);
    const std::string p = std::to_string(s.degree);
    check_proved(s.declaration() + "let b = bezier_net(T)\nspline R = merged(b, " + s.data() +
                 ")\nspline One = bspline(net(1, i in 0.." + std::to_string(s.points - 1) + "), " +
                 s.data() + ")\n" +
                 piece_claims("bezier", s.pieces().size(), "segment(T, i)",
                              "bezier(b[" + p + "*i.." + p + "*i+" + p + "])") +
                 piece_claims("unity", s.pieces().size(), "segment(One, i)(t)", "1") +
                 piece_claims("merged", s.pieces().size(), "segment(R, i)", "segment(T, i)"));
  }
}

TEST_CASE("a knot inserted anywhere leaves a spline as it is", "[law]") {
  std::mt19937 random{121};
  for (int k = 0; k < 12; ++k) {
    const RandomSpline s = random_spline(random);
    const auto pieces = s.pieces();
    const std::size_t chosen = random() % pieces.size();
    const Rational ratio{1 + static_cast<int>(random() % 3), 4};
    const auto& [a, b] = pieces[chosen];
    std::string claims;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::string old = "segment(T, " + std::to_string(i) + ")";
      const auto piece = [&](std::size_t at) {
        return "segment(I, " + std::to_string(at) + ")(t)";
      };
      const std::string label = "prove p" + std::to_string(i) + ": ";
      const std::string r = to_text(ratio);
      if (i == chosen)
        claims += label + piece(i) + " == " + old + "(" + r + "*t), " + piece(i + 1) +
                  " == " + old + "(" + r + " + (1 - " + r + ")*t)\n";
      else
        claims += label + piece(i < chosen ? i : i + 1) + " == " + old + "(t)\n";
    }
    check_proved(s.declaration() + "spline I = insert_knot(T, " +
                 to_text(Rational{a + ratio * (b - a)}) + ")\n" + claims);
  }
}

TEST_CASE("a knot that is there already is inserted up to the degree", "[law]") {
  std::mt19937 random{122};
  int inserted = 0;
  for (int k = 0; k < 40 && inserted < 8; ++k) {
    const RandomSpline s = random_spline(random);
    const auto pieces = s.pieces();
    // Ends count as well where the spline is not clamped.
    const Rational knot = random() % 2 == 0 ? pieces.front().second : pieces.front().first;
    const auto times = std::count(s.knots.begin(), s.knots.end(), knot);
    if (times >= s.degree) continue;
    ++inserted;
    check_proved(s.declaration() + "spline I = insert_knot(T, " + to_text(knot) + ")\n" +
                 piece_claims("same", pieces.size(), "segment(I, i)", "segment(T, i)"));
  }
  CHECK(inserted == 8);
}

TEST_CASE("one degree higher the spline is the same", "[law]") {
  std::mt19937 random{123};
  for (int k = 0; k < 10; ++k) {
    const RandomSpline s = random_spline(random);
    check_proved(s.declaration() + "spline E = elevate_degree(T)\n" +
                 piece_claims("same", s.pieces().size(), "segment(E, i)", "segment(T, i)"));
  }
}

TEST_CASE("Greville abscissae as control points give the parameter", "[law]") {
  std::mt19937 random{124};
  for (int k = 0; k < 12; ++k) {
    const RandomSpline s = random_spline(random);
    std::string claims;
    const auto pieces = s.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      claims += "prove p" + std::to_string(i) + ": segment(X, " + std::to_string(i) +
                ")(t) == (1-t)*" + "(" + to_text(pieces[i].first) + ") + t*(" +
                to_text(pieces[i].second) + ")\n";
    check_proved(s.declaration() + "spline X = bspline(greville(T), " + s.data() + ")\n" + claims);
  }
}

TEST_CASE("knots that are symbols take the values of knots that are numbers", "[law]") {
  std::mt19937 random{125};
  for (int k = 0; k < 8; ++k) {
    RandomSpline s = random_spline(random);
    // The same knots, each different value a symbol that is assumed to have that value.
    std::string knots;
    std::string assumed;
    std::string names;
    int count = 0;
    for (std::size_t i = 0; i < s.knots.size(); ++i) {
      if (i == 0 || s.knots[i] != s.knots[i - 1]) {
        ++count;
        names += (count == 1 ? "" : ", ") + std::string{"k"} + std::to_string(count);
        assumed += (count == 1 ? "" : ", ") + std::string{"k"} + std::to_string(count) +
                   " == " + to_text(s.knots[i]);
      }
      knots += (i == 0 ? "k" : ", k") + std::to_string(count);
    }
    check_proved(s.declaration() + "scalar " + names + "\nassume values: " + assumed +
                 "\nspline S = bspline(d, degree " + std::to_string(s.degree) + ", knots [" +
                 knots + "])\n" +
                 piece_claims("same", s.pieces().size(), "segment(S, i)", "segment(T, i)") +
                 "prove net: bezier_net(S) == bezier_net(T)\n");
  }
}

TEST_CASE("a rational spline with one weight for all points is polynomial", "[law]") {
  std::mt19937 random{126};
  for (int k = 0; k < 8; ++k) {
    const RandomSpline s = random_spline(random);
    check_proved(s.declaration() + "scalar c\nassume weight: c > 0\nspline W = bspline(d, degree " +
                 std::to_string(s.degree) + ", weights net(c, i in 0.." +
                 std::to_string(s.points - 1) + "), knots " + s.list() + ")\n" +
                 piece_claims("same", s.pieces().size(), "segment(W, i)", "segment(T, i)") +
                 "prove net: bezier_net(W) == bezier_net(T)\n");
  }
}

TEST_CASE("the knot insertion of the NURBS book", "[literature]") {
  // Piegl & Tiller, The NURBS Book, example 5.1: p = 3, U = {0,0,0,0,1,2,3,4,5,5,5,5}, u = 5/2.
  check_proved(R"(point P[0..7]
spline T = bspline(P, degree 3, knots [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5])
let Q = control_points(insert_knot(T, 5/2))
prove q: Q == [P[0], P[1], P[2], 1/6*P[2] + 5/6*P[3], 1/2*P[3] + 1/2*P[4], 5/6*P[4] + 1/6*P[5], P[5], P[6], P[7]]
)");
}

TEST_CASE("the rational spline of the NURBS book", "[literature]") {
  // Piegl & Tiller, The NURBS Book, example 4.1: p = 2, C(1) = (7/5, 6/5).
  check_proved(R"(matrix P = [(0,0) ; (1,1) ; (3,2) ; (4,1) ; (5,-1)]
spline C = bspline(P, degree 2, weights [1, 4, 1, 1, 1], knots [0, 0, 0, 1, 2, 3, 3, 3])
prove at_1: segment(C, 0)(1) == (7/5, 6/5), segment(C, 1)(0) == (7/5, 6/5)
)");
}

TEST_CASE("a symbolic knot is a condition unless the order of the knots is assumed") {
  const std::string spline = "point d[0..2]\nscalar a, b\n";
  const std::string rest =
      "spline T = bspline(d, degree 2, knots [a, a, a, b, b, b])\n"
      "prove net: bezier_net(T) == d\n";
  CHECK(verdicts(spline + rest) == "net PROVED IF {a - b != 0}\n");
  CHECK(verdicts(spline + "assume order: a < b\n" + rest) == "net PROVED uses order\n");
  CHECK(verdicts(spline + "assume order: a == b\n" + rest).substr(0, 9) == "net ERROR");
}

TEST_CASE("the denominator of a rational curve is a condition unless its weights are positive") {
  const std::string curve = "param t in [0, 1]\npoint b[0..2]\nscalar w[0..2]\n";
  const std::string rest = "curve C(t) = rational_bezier(b, w)\nprove same: C(t) - C(t) == 0\n";
  CHECK(verdicts(curve + rest).substr(0, 14) == "same PROVED IF");
  CHECK(verdicts(curve + "assume positive: w[i] > 0 for i in 0..2\n" + rest) ==
        "same PROVED uses positive\n");
  CHECK(verdicts(curve + "assume positive: w[i] >= 0 for i in 0..2\n" + rest).substr(0, 14) ==
        "same PROVED IF");
  CHECK(verdicts(curve + "assume positive: w[i] > 0 for i in 0..1\n" + rest).substr(0, 14) ==
        "same PROVED IF");
}

}  // namespace patchproof
