#include <patchproof/derivation/differentiated.hpp>

#include <catch2/catch.hpp>

#include <patchproof/derivation/tidied.hpp>
#include <patchproof/term/plain_text.hpp>
#include <tests/derivation/random_terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

struct Letters {
  Declarations declare;
  Term u = declare.parameter("u");
  Term v = declare.parameter("v");
  Term a = declare.scalar("a");
  Term f = declare.scalar_function("f", {"t"});
  Term g = declare.scalar_function("g", {"s", "t"});
  Term C = declare.curve("C", "t", 2);
  Term P = declare.point("P", 2);
};

std::string slope(const Term& term, const Term& parameter) {
  const std::optional<Term> result = differentiated(term, parameter.symbol());
  return result ? to_text(*result) : "no rule";
}

// The derivative as the engines know it.
Term derivative_at(const Term& term, const Term& u) {
  return at(derivative(lambda({u}, term), {1}), {u});
}

}  // namespace

TEST_CASE("the derivative by rules is that of the engines", "[law]") {
  const Letters l;
  int held = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    TermDrawer draw{seed, {l.u, l.a}, {l.f}, {l.P, at(l.C, {l.u})}};
    const Term term = draw.below(3) == 0 ? draw.point_of(3) : draw.scalar(3);
    const std::optional<Term> by_rules = differentiated(term, l.u.symbol());
    INFO(seed << ": " << to_text(term));
    REQUIRE(by_rules);
    INFO(to_text(*by_rules));
    const std::string said = decided_equation(*by_rules, derivative_at(term, l.u));
    // 0^0 and the like have no value, nor a derivative.
    CHECK((said == "holds" || said == "ERROR none"));
    held += said == "holds" ? 1 : 0;
  }
  CHECK(held >= 290);
}

TEST_CASE("the derivative of a Bernstein polynomial is n(B_(i-1) - B_i) of degree n-1",
          "[literature]") {
  // Farin, Curves and Surfaces for CAGD, section 5.3: derivatives of a Bézier curve.
  const Letters l;
  for (int n = 1; n <= 6; ++n) {
    for (int i = 0; i <= n; ++i) {
      std::vector<Term> parts{number(0)};
      if (i > 0) parts.push_back(n * bernstein(n - 1, i - 1, l.u));
      if (i < n) parts.push_back(-(n * bernstein(n - 1, i, l.u)));
      const std::optional<Term> by_rules = differentiated(bernstein(n, i, l.u), l.u.symbol());
      REQUIRE(by_rules);
      CAPTURE(n, i);
      CHECK(decided_equation(*by_rules, make_term(Operation::sum, Type::scalar(), parts)) ==
            "holds");
    }
  }
  CHECK(to_text(tidied(*differentiated(bernstein(3, 1, l.u), l.u.symbol()))) ==
        "3*(bernstein(2, 0, u) - bernstein(2, 1, u))");
}

TEST_CASE("the derivative of a Bezier curve has the differences of its points", "[literature]") {
  // Farin, section 5.3: the derivative of sum b_i B_i^n is n sum (b_(i+1) - b_i) B_i^(n-1).
  Declarations declare;
  const Term t = declare.parameter("t");
  std::vector<Term> b;
  for (const char* name : {"b[0]", "b[1]", "b[2]", "b[3]"}) b.push_back(declare.point(name));
  std::vector<Term> curve;
  std::vector<Term> hodograph;
  for (int i = 0; i <= 3; ++i) curve.push_back(bernstein(3, i, t) * b[static_cast<std::size_t>(i)]);
  for (std::size_t i = 0; i < 3; ++i)
    hodograph.push_back(3 * (bernstein(2, static_cast<int>(i), t) * (b[i + 1] - b[i])));
  const auto total = [](const std::vector<Term>& parts) {
    return make_term(Operation::sum, parts.front().type(), parts);
  };
  const std::optional<Term> by_rules = differentiated(total(curve), t.symbol());
  REQUIRE(by_rules);
  CHECK(decided_equation(*by_rules, total(hodograph)) == "holds");
}

TEST_CASE("each rule, in the shape a reader expects") {
  const Letters l;
  const Term u = l.u;
  CHECK(slope(l.a, u) == "0");
  CHECK(slope(l.P, u) == "(0, 0)");
  CHECK(slope(u, u) == "1");
  CHECK(slope(u + l.a, u) == "1");
  CHECK(slope(-u, u) == "-1");
  CHECK(slope(u / 3, u) == "1/3");
  CHECK(to_text(tidied(*differentiated(power(1 - u, 3), u.symbol()))) == "-3*(1 - u)^2");
  CHECK(to_text(tidied(*differentiated(u * sin(u), u.symbol()))) == "sin(u) + u*cos(u)");
  CHECK(to_text(tidied(*differentiated(sin(2 * u), u.symbol()))) == "2*cos(2*u)");
  CHECK(to_text(tidied(*differentiated(exp(-u), u.symbol()))) == "-exp(-u)");
  CHECK(slope(at(l.f, {u}), u) == "f'(u)");
  CHECK(to_text(tidied(*differentiated(at(l.f, {2 * u}), u.symbol()))) == "2*f'(2*u)");
  CHECK(slope(at(l.g, {u, l.v}), u) == "g_s(u, v)");
  CHECK(slope(at(l.g, {u, u}), u) == "g_s(u, u) + g_t(u, u)");
  CHECK(slope(at(derivative(l.g, {1, 0}), {l.v, u}), u) == "g_st(v, u)");
}

TEST_CASE("where there is no rule there is no derivative") {
  const Letters l;
  const Term det =
      make_term(Operation::determinant, Type::scalar(), {matrix(2, 2, {l.u, l.a, l.a, l.u})});
  CHECK(slope(det, l.u) == "no rule");
  CHECK(slope(det, l.v) == "0");
  Declarations declare = l.declare;
  const Term t = declare.parameter("t");
  const Term inner =
      make_term(Operation::integral, Type::scalar(), {lambda({t}, l.u * t), number(0), number(1)});
  CHECK(slope(inner, l.u) == "no rule");
  CHECK(slope(l.a + basis({1, 0, 1, {0, 0, 1, 1}}, l.u), l.u) == "no rule");
}
