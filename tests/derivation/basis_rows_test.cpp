#include <patchproof/derivation/basis_rows.hpp>

#include <catch2/catch.hpp>

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
  Term P = declare.point("P");
  Term Q = declare.point("Q");
};

std::string rows(const Term& value) {
  const std::optional<BasisRows> result = basis_rows(value);
  if (!result) return "none";
  std::string text;
  for (std::size_t k = 0; k < result->basis.size(); ++k)
    text +=
        (k > 0 ? "; " : "") + to_text(result->basis[k]) + ": " + to_text(result->coefficients[k]);
  return text;
}

}  // namespace

TEST_CASE("the coefficients of a sum in one basis, in order, those that occur") {
  const Letters l;
  const auto B = [&](int i) { return bernstein(2, i, l.u); };
  CHECK(rows(3 * (B(1) * l.P) - B(0) * l.Q + l.a * (B(1) * l.Q)) == "none");
  const auto term = [&](std::vector<Term> factors) {
    return make_term(Operation::product, Type::point(Type::any_dimension), std::move(factors));
  };
  CHECK(rows(term({number(3), B(1), l.P}) - term({B(0), l.Q}) + term({l.a, B(1), l.Q})) ==
        "bernstein(2, 0, u): -Q; bernstein(2, 1, u): 3*P + a*Q");
  CHECK(rows(-(term({B(2), l.P}) - term({B(2), l.Q}))) == "bernstein(2, 2, u): -P + Q");
}

TEST_CASE("a sum that is not in one basis has no rows") {
  const Letters l;
  const Term one = bernstein(2, 0, l.u) * l.P;
  CHECK(rows(one) == "bernstein(2, 0, u): P");
  CHECK(rows(one + l.Q) == "none");
  CHECK(rows(one + l.a * l.Q) == "none");
  CHECK(rows(one + bernstein(3, 0, l.u) * l.Q) == "none");
  CHECK(rows(one + bernstein(2, 0, l.v) * l.Q) == "none");
  CHECK(rows(bernstein(2, 0, 1 - l.u) * l.P) == "none");
  CHECK(rows(bernstein(2, 0, l.u)) == "none");
  CHECK(rows(make_term(Operation::product, l.P.type(),
                       {bernstein(2, 0, l.u), bernstein(2, 1, l.u), l.P})) == "none");
}

TEST_CASE("basis functions times their coefficients are the sum again", "[law]") {
  // Coefficients without basis functions of their own at their top.
  const Letters l;
  for (unsigned seed = 0; seed < 100; ++seed) {
    TermDrawer draw{seed, {l.a}, {}, {}};
    const int degree = 1 + draw.below(4);
    const auto summand = [&] {
      return bernstein(degree, draw.below(degree + 1), l.u) *
             (draw.below(2) == 0 ? sin(draw.scalar(1)) : l.a + draw.scalar(1));
    };
    Term value = summand();
    for (int k = 0; k < 4; ++k) value = draw.below(2) == 0 ? value + summand() : value - summand();
    const std::optional<BasisRows> found = basis_rows(value);
    INFO(seed << ": " << to_text(value));
    REQUIRE(found);
    std::vector<Term> parts;
    for (std::size_t k = 0; k < found->basis.size(); ++k) {
      if (k > 0) CHECK(found->basis[k - 1].indices().at(1) < found->basis[k].indices().at(1));
      parts.push_back(found->basis[k] * found->coefficients[k]);
    }
    const std::string said = decided_equation(
        value, parts.size() == 1 ? parts.front() : make_term(Operation::sum, value.type(), parts));
    CHECK((said == "holds" || said == "ERROR none"));
  }
}
