#include <catch2/catch.hpp>
#include <random>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

std::string number(std::mt19937& random, int least, int most) {
  const int span = most - least + 1;
  return std::to_string(least + static_cast<int>(random() % static_cast<unsigned>(span)));
}

}  // namespace

TEST_CASE("a surface in other parameters goes on with G^2, however it is run through", "[law]") {
  std::mt19937 random{401};
  for (int i = 0; i < 6; ++i) {
    const std::string alpha = number(random, 1, 3) + "/2";
    const std::string gamma = number(random, -2, 2) + "*u*(1-u)";
    const std::string beta = number(random, -2, 2);
    const std::string given = " with " + alpha + ", " + gamma;
    const std::string height = number(random, -2, 2) + "*u^2 + " + number(random, -2, 2) +
                               "*u*v + " + number(random, -2, 2) + "*v^2";
    const std::string text = "param u, v in [0, 1]\npatch P(u, v) = (u, v, " + height + ")\n" +
                             "patch R(u, v) = P(u + v*(" + gamma + "), 1 + v*(" + alpha +
                             ") + v^2*(" + beta + ")/2)\n" +
                             R"~(patch P_back(u, v) = P(u, 1-v)
patch R_back(u, v) = R(u, 1-v)
prove a: G^2 joint of P at v = 1 and R at v = 0
prove b: G^2 joint of P_back at v = 0 and R at v = 0
prove c: G^2 joint of P at v = 1 and R_back at v = 1
prove d: G^2 joint of P_back at v = 0 and R_back at v = 1
refute e: G^1 joint of P_back at v = 0 and P at v = 1
)~";
    const auto joint = [&](const std::string& label, const std::string& sides,
                           const std::string& functions) {
      return "prove " + label + ": G^2 joint of " + sides + functions + ", " + beta + ", 0\n";
    };
    INFO(text);
    CHECK(verdicts(text + joint("f", "P at v = 1 and R at v = 0", given) +
                   joint("g", "P_back at v = 0 and R_back at v = 1", given)) ==
          "a PROVED\nb PROVED\nc PROVED\nd PROVED\ne REFUTED\nf PROVED\ng PROVED\n");
  }
}

TEST_CASE("a change of one point of the second row breaks the tangent plane", "[law]") {
  std::mt19937 random{402};
  for (int i = 0; i < 5; ++i) {
    std::string p = "[";
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        p += "(" + std::to_string(3 * row) + ", " + std::to_string(3 * column) + ", " +
             number(random, -2, 2) + ")" +
             (column < 2 ? ", "
              : row < 2  ? " ; "
                         : "]");
    const std::string text = "param u, v in [0, 1]\nmatrix p = " + p + R"~(
matrix r = [p[0,2], 2*p[0,2] - p[0,1], (0, 13, 1) ;
            p[1,2], 2*p[1,2] - p[1,1], (3, 13, 2) ;
            p[2,2], 2*p[2,2] - p[2,1], (6, 13, 0)]
matrix s = [r[0,0], r[0,1], r[0,2] ; r[1,0], r[1,1] + (0, 0, 1/100), r[1,2] ; r[2,0], r[2,1], r[2,2]]
patch P(u, v) = bezier(p)
patch R(u, v) = bezier(r)
patch S(u, v) = bezier(s)
prove smooth: G^1 joint of P at v = 1 and R at v = 0
prove given: G^1 joint of P at v = 1 and R at v = 0 with 1, 0
refute moved: G^1 joint of P at v = 1 and S at v = 0
)~";
    INFO(text);
    CHECK(verdicts(text) == "smooth PROVED\ngiven PROVED\nmoved REFUTED\n");
  }
}

TEST_CASE("curves of equal curvature have a G^2 joint, others not", "[literature]") {
  // Farin, Curves and Surfaces for CAGD, ch. 11. Both curves have curvature 2 at the origin.
  CHECK(verdicts(R"~(
  param t in [0, 1]
  curve p(t) = (t - 1, (t - 1)^2)
  curve q(t) = (3*t + t^3, 9*t^2)
  curve other(t) = (3*t, 8*t^2)
  prove same: G^2 joint of p at t = 1 and q at t = 0
  prove given: G^2 joint of p at t = 1 and q at t = 0 with 3, 0
  prove tangent: G^1 joint of p at t = 1 and other at t = 0
  refute curvature: G^2 joint of p at t = 1 and other at t = 0
  refute backwards: G^1 joint of p at t = 1 and p at t = 1
)~") == "same PROVED\ngiven PROVED\ntangent PROVED\ncurvature REFUTED\nbackwards REFUTED\n");
}

TEST_CASE("the connecting function alpha has to be positive") {
  const std::string patches = R"~(
  param u, v in [0, 1]
  scalar k
  patch P(u, v) = (u, v, u*v)
  patch R(u, v) = P(u, 1 + k*v)
)~";
  const std::string joint = "  prove g: G^1 joint of P at v = 1 and R at v = 0 with k, 0\n";
  CHECK(verdicts(patches + "  assume up: k > 0\n" + joint) == "g PROVED uses up\n");
  CHECK(verdicts(patches + "  assume k < 0\n" + joint) == "g REFUTED\n");
  CHECK(verdicts(patches + joint) == "g REFUTED\n");
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  patch P(u, v) = (u, v, u*v)
  patch R(u, v) = (u, 1 + u*v, u*(1 + u*v))
  refute zero_at_an_end: G^1 joint of P at v = 1 and R at v = 0
  refute given: G^1 joint of P at v = 1 and R at v = 0 with u, 0
)~") == "zero_at_an_end REFUTED\ngiven REFUTED\n");
}

TEST_CASE("planar patches have a G^1 joint where they do not fold") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  patch P(u, v) = (u, v)
  patch R(u, v) = (u + v*u, 1 + v + u*v)
  patch folded(u, v) = (u, 1 - v)
  prove go_on: G^1 joint of P at v = 1 and R at v = 0
  prove second: G^2 joint of P at v = 1 and R at v = 0
  refute folds: G^1 joint of P at v = 1 and folded at v = 0
)~") == "go_on PROVED\nsecond PROVED\nfolds REFUTED\n");
}

TEST_CASE("points of any dimension are enough when the functions are given") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  scalar lam
  assume onward: lam > 0
  point a[0..2], b[0..2], c[0..2]
  patch P(u, v) = bezier([a[0], b[0], c[0] ; a[1], b[1], c[1] ; a[2], b[2], c[2]])
  patch R(u, v) = bezier([c[0], c[0] + lam*(c[0] - b[0]), a[0] ; c[1], c[1] + lam*(c[1] - b[1]), a[1] ;
                          c[2], c[2] + lam*(c[2] - b[2]), a[2]])
  prove joint: G^1 joint of P at v = 1 and R at v = 0 with lam, 0
  refute reversed: G^1 joint of P at v = 1 and R at v = 0 with -lam, 0
)~") == "joint PROVED uses onward\nreversed REFUTED\n");
}

}  // namespace patchproof
