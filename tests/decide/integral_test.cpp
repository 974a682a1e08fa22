#include <catch2/catch.hpp>
#include <random>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

// A polynomial in s and t with small random coefficients.
std::string random_polynomial(std::mt19937& random) {
  std::uniform_int_distribution<int> number{-5, 5};
  std::uniform_int_distribution<int> exponent{0, 4};
  std::string text = std::to_string(number(random) + 6);
  for (int k = 0; k < 4; ++k)
    text += " + (" + std::to_string(number(random)) + ")*s^" + std::to_string(exponent(random)) +
            "*t^" + std::to_string(exponent(random));
  return "(" + text + ")";
}

const std::string unknown_functions =
    "scalar a, b, c, x\nscalar f(t) : C^2\nscalar g(t) : C^2\nscalar h(u, v) : C^4\nscalar k(u, v) "
    ": C^2\n";

std::string of_functions(const std::string& proposition) {
  return verdict(unknown_functions, proposition);
}

}  // namespace

TEST_CASE("the integral is linear, and its ranges add up", "[integral][law]") {
  std::mt19937 random{2024};
  for (int round = 0; round < 8; ++round) {
    const std::string p = random_polynomial(random);
    const std::string q = random_polynomial(random);
    const std::string over = ", s in [a, b], t in [0, 2])";
    CHECK(verdict("scalar a, b, c, x", "integral(x*" + p + " - 3*" + q + over + " == x*integral(" +
                                           p + over + " - 3*integral(" + q + over) == "PROVED");
    CHECK(verdict("scalar a, b, c, t", "integral(" + p + ", s in [a, b]) + integral(" + p +
                                           ", s in [b, c]) == integral(" + p + ", s in [a, c])") ==
          "PROVED");
    CHECK(verdict("scalar a, b, c, t", "integral(" + p + ", s in [a, b]) == -integral(" + p +
                                           ", s in [b, a])") == "PROVED");
  }
  CHECK(of_functions("integral(x*f(s) + g(s), s in [a, b]) == x*integral(f(s), s in [a, b]) + "
                     "integral(g(s), s in [a, b])") == "PROVED");
}

TEST_CASE("the order of integration does not matter", "[integral][law]") {
  std::mt19937 random{7};
  for (int round = 0; round < 8; ++round) {
    const std::string p = random_polynomial(random);
    CHECK(verdict("scalar a, b", "integral(" + p +
                                     ", s in [0, a], t in [b, 3]) == integral(integral(" + p +
                                     ", s in [0, a]), t in [b, 3])") == "PROVED");
  }
  CHECK(of_functions("integral(h(s,t)^2*f(t), s in [0, 1], t in [0, 2]) == "
                     "integral(h(s,t)^2*f(t), t in [0, 2], s in [0, 1])") == "PROVED");
  CHECK(of_functions("integral(f(s)*g(t), s in [0, 1], t in [a, b]) == "
                     "integral(f(s), s in [0, 1])*integral(g(s), s in [a, b])") == "PROVED");
  CHECK(of_functions("integral(h(s,t)^2, s in [0, 1], t in [0, 1]) == "
                     "integral(h(t,s)^2, s in [0, 1], t in [0, 1])") == "PROVED");
  // Another range is another integral.
  CHECK(of_functions("integral(h(s,t)^2, s in [0, 1], t in [0, 2]) == "
                     "integral(h(t,s)^2, s in [0, 1], t in [0, 2])") == "REFUTED");
}

TEST_CASE("the fundamental theorem holds in both directions", "[integral][law]") {
  CHECK(of_functions("integral(f'(s), s in [a, b]) == f(b) - f(a)") == "PROVED");
  CHECK(of_functions("integral(h_uv(s,t), s in [0, a], t in [0, b]) == "
                     "h(a,b) - h(a,0) - h(0,b) + h(0,0)") == "PROVED");
  CHECK(of_functions("integral(x*f'(2*s + c), s in [0, 1]) == x/2*(f(2 + c) - f(c))") == "PROVED");
  CHECK(of_functions("integral(f'(s), s in [a, b]) == f(a) - f(b)") == "REFUTED");
  const std::string upper = unknown_functions + "let F(x) = integral(f(s)*g(s), s in [a, x])\n";
  CHECK(verdict(upper, "F'(x) == f(x)*g(x)") == "PROVED");
  CHECK(verdict(upper, "F(a) == 0") == "PROVED");
  CHECK(verdict(upper, "F'(x) == f(x)*g(a)") == "REFUTED");
  const std::string lower = unknown_functions + "let F(x) = integral(h(s,x)^2, s in [x, x^2])\n";
  CHECK(verdict(lower,
                "F'(x) == 2*x*h(x^2,x)^2 - h(x,x)^2 + "
                "2*integral(h(s,x)*h_v(s,x), s in [x, x^2])") == "PROVED");
}

TEST_CASE("integration by parts", "[integral][law]") {
  CHECK(of_functions("integral(f'(s)*g(s), s in [a, b]) == f(b)*g(b) - f(a)*g(a) - "
                     "integral(f(s)*g'(s), s in [a, b])") == "PROVED");
  // f has no third derivative: the product stays as it is.
  CHECK(of_functions("integral(f''(s)*g'(s), s in [a, b]) == integral(g'(t)*f''(t), t in [a, b])") ==
        "PROVED");
  CHECK(of_functions("integral(s*f''(s), s in [0, 1]) == f'(1) - f(1) + f(0)") == "PROVED");
  CHECK(of_functions("integral(f'(s)*g(s), s in [a, b]) == -integral(f(s)*g'(s), s in [a, b])") ==
        "REFUTED");
}

TEST_CASE("known integrals", "[integral][literature]") {
  // Farin, Curves and Surfaces for CAGD, ch. 5: each Bernstein polynomial has the integral 1/(n+1).
  CHECK(verdicts(
            "scalar x\nprove all: integral(bernstein(5, i, t), t in [0, 1]) == 1/6 for i in 0..5\n")
            .find("PROVED") == std::string("all[i=0] ").size());
  // Euler's beta function: integral of t^3 (1-t)^4 = 3! 4! / 8!.
  CHECK(verdict("", "integral(t^3*(1-t)^4, t in [0, 1]) == 1/280") == "PROVED");
  CHECK(verdict("", "integral(t^3*(1-t)^4, t in [0, 1]) == 1/281") == "REFUTED");
  CHECK(verdict("scalar r", "integral(x^2 + y^2, x in [-r, r], y in [-r, r]) == 8/3*r^4") ==
        "PROVED");
  CHECK(verdict("", "integral((t, t^2, 1), t in [0, 3]) == (9/2, 9, 3)") == "PROVED");
  // A divisor that does not vanish anywhere and does not depend on the variable is kept outside.
  CHECK(verdict("scalar a", "integral(t/(a^2 + 1), t in [0, 2]) == 2/(a^2 + 1)") == "PROVED");
  CHECK(verdict("scalar a", "integral(t/a, t in [0, 2]) == 2/a") == "PROVED IF");
}

TEST_CASE("the integral of squares is not negative, forward", "[integral]") {
  CHECK(of_functions("integral(h(s,t)^2, s in [0, 1], t in [0, 2]) >= 0") == "PROVED");
  CHECK(of_functions("integral(h(s,t)^2*s^2*f(t)^4, s in [-1, 1], t in [0, 2]) >= 0") == "PROVED");
  CHECK(of_functions("2*integral(f(s)^2, s in [0, 1]) + integral(g(s)^2, s in [0, 1]) >= "
                     "integral(f(s)^2, s in [0, 1])") == "PROVED");
  CHECK(of_functions("integral(f(s)^2, s in [a, b]) >= 0") != "PROVED");
  CHECK(of_functions("integral(f(s)^2*s, s in [-1, 0]) >= 0") != "PROVED");
  CHECK(of_functions("integral(f(s)^2, s in [0, 1]) > 0") != "PROVED");
  CHECK(of_functions("integral(f(s), s in [0, 1]) >= 0") != "PROVED");
}

TEST_CASE("an integral that does not exist has no value", "[integral][reject]") {
  CHECK(verdicts("prove p: integral(1/u, u in [0, 1]) == 1\n") ==
        "p ERROR (the integrand has no value at u = 0)\n");
  CHECK(verdicts("prove p: integral(u/u, u in [0, 1]) == 1\n") ==
        "p ERROR (the integrand has no value at u = 0)\n");
  CHECK(verdicts("prove p: integral(1/(2*u - 1)^3, u in [0, 1]) == 0\n") ==
        "p ERROR (the integrand has no value for some u between 0 and 1)\n");
  CHECK(verdicts("scalar a\nprove p: integral(1/(u - a), u in [0, 1]) == 1\n") ==
        "p UNKNOWN (the integral has a value only where -a + u != 0 for all values of its "
        "variables, which was not shown)\n");
  CHECK(verdicts("prove p: integral(1/(u + 1), u in [0, 1]) == 1\n") ==
        "p UNKNOWN (the integral of a quotient whose divisor depends on a variable of the integral "
        "is not worked out in this version)\n");
  CHECK(verdicts("prove p: integral(sqrt(u^2 + 1), u in [0, 1]) == 1\n") ==
        "p UNKNOWN (the integral of a root that depends on a variable of the integral is not "
        "worked out in this version)\n");
  CHECK(verdicts(
            "scalar f(t) : C^1\nprove p: integral(f(s*integral(f(t), t in [0, s])), s in [0, 1]) "
            "== 1\n") ==
        "p UNKNOWN (an integral inside another that depends on its variables is not worked out in "
        "this version)\n");
}

TEST_CASE("the variable of an integral is not mistaken for others", "[integral]") {
  const std::string f =
      "param u, v in [0, 1]\nscalar a\nscalar f(u) : C^1\n"
      "let F(a) = integral(f(u)*f(a*u), u in [0, 1])\n";
  CHECK(verdict(f, "F(1) == integral(f(t)^2, t in [0, 1])") == "PROVED");
  CHECK(verdict(f, "F(u) == integral(f(t)*f(u*t), t in [0, 1])") == "PROVED");
  CHECK(verdict(f, "F(u) == integral(f(t)*f(t^2), t in [0, 1])") == "REFUTED");
  // A value that is itself an integral goes outside, whatever its variable is called.
  CHECK(verdict(f,
                "integral(f(u)*integral(f(u), u in [0, 1]), u in [0, 1]) == "
                "integral(f(t), t in [0, 1])^2") == "PROVED");
  CHECK(verdict(f, "F(integral(u^2, u in [0, 3])) == integral(f(u)*f(9*u), u in [0, 1])") ==
        "PROVED");
}

TEST_CASE("values on an edge hold along the edge and inside the range only", "[integral][edge]") {
  const std::string edge =
      "param u, v in [0, 1]\nscalar h(u, v) : C^2\nscalar f(u) : C^2\n"
      "assume south: h(u,0) == f(u)\n";
  CHECK(verdict(edge, "h_u(u,0) == f'(u)") == "PROVED");
  CHECK(verdict(edge, "h_uu(1/2,0) == f''(1/2)") == "PROVED");
  CHECK(verdict(edge, "h_v(u,0) == 0") == "REFUTED");
  CHECK(verdict(edge, "h(u,1) == f(u)") == "REFUTED");
  CHECK(verdict(edge, "h(2,0) == f(2)") == "UNKNOWN");
  CHECK(verdict(edge, "integral(h(s,0)^2, s in [0, 1]) == integral(f(s)^2, s in [0, 1])") ==
        "PROVED");
  CHECK(verdict(edge, "integral(h(s,0)^2, s in [0, 2]) == integral(f(s)^2, s in [0, 2])") ==
        "UNKNOWN");
  const std::string slope =
      "param u, v in [0, 1]\nscalar h(u, v) : C^2\nassume flat: h_v(u,0) == 0\n";
  CHECK(verdict(slope, "h_uv(u,0) == 0") == "PROVED");
  CHECK(verdict(slope, "h_u(u,0) == 0") != "PROVED");
  const std::string frame =
      "param u, v in [0, 1]\nscalar h(u, v) : C^2\n"
      "assume edges: h(u,0) == 0, h(u,1) == 0, h(0,v) == 0, h(1,v) == v*(1-v)\n";
  CHECK(verdict(frame, "h_v(1,v) == 1 - 2*v") == "PROVED");
  CHECK(verdict(frame, "h(1/2,1/2) == 0") == "REFUTED");
  const std::string torn =
      "param u, v in [0, 1]\nscalar h(u, v) : C^2\n"
      "assume edges: h(u,0) == 0, h(0,v) == 1\n";
  CHECK(verdict(torn, "h(u,0) == 0") != "PROVED");
}

TEST_CASE("the root of the integral of a square has a value") {
  CHECK(verdicts_of(R"(
case c
  param u in [0, 1]
  scalar f(t) : C^0
  prove squared: sqrt(integral(f(t)^2, t in [0, 1]))^2 == integral(f(t)^2, t in [0, 1])
end
)") == "squared PROVED\n");
}

TEST_CASE("a definition may integrate over a variable of its own") {
  CHECK(verdicts_of(R"(
define mean(C : curve(u), a : scalar) : scalar
  = integral(C(s), s in [0, a])/a
end
case c
  param u in [0, 1]
  curve C(u) = u^2
  prove value: mean(C, 3) == 3
  refute other: mean(C, 3) == 9
end
)") == "value PROVED\nother REFUTED\n");
}

}  // namespace patchproof
