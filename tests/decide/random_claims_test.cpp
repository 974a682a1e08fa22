#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"
#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

const std::string scalars = "scalar x0, x1, x2\n";
const std::string parameters = "param x0, x1, x2 in [0, 1]\n";

// The values of x0, x1, x2 in a witness; what it does not name is arbitrary.
Point place_of(const WitnessReport& witness) {
  Point result{{0, 0}, {1, 0}, {2, 0}};
  for (const auto& [name, value] : witness.values) {
    const std::size_t slash = value.find('/');
    const bool negative = value.front() == '-';
    const std::string above = value.substr(negative ? 1 : 0, slash - (negative ? 1 : 0));
    Rational number = *number_from_text(above);
    if (slash != std::string::npos) number /= *number_from_text(value.substr(slash + 1));
    result[static_cast<Variable>(name.at(1) - '0')] = negative ? Rational{-number} : number;
  }
  return result;
}

ClaimResult only_claim(const std::string& declarations, const std::string& proposition) {
  const auto results =
      results_of("case t\n" + declarations + "prove p: " + proposition + "\nend\n");
  return results.at(0).claims.at(0);
}

std::string text(const Polynomial& p) { return "(" + words(p) + ")"; }

}  // namespace

TEST_CASE("identities of the ring are proved by both engines", "[law]") {
  std::mt19937 random{110};
  for (int i = 0; i < 60; ++i) {
    const std::string a = text(random_polynomial(random, 3, 3, 4));
    const std::string b = text(random_polynomial(random, 3, 3, 4));
    const std::string c = text(random_polynomial(random, 3, 2, 4));
    INFO(a << "\n" << b << "\n" << c);
    const ClaimResult result =
        only_claim(i % 2 == 0 ? scalars : parameters, a + "*(" + b + " - " + c + ")^2 == " + a +
                                                          "*" + b + "^2 - 2*" + a + "*" + b + "*" +
                                                          c + " + " + c + "^2*" + a);
    CHECK(result.decision.verdict == Verdict::proved);
    CHECK(result.decision.evidence == Evidence::both_engines);
  }
}

TEST_CASE("polynomials that differ are refuted where their values differ", "[law]") {
  std::mt19937 random{111};
  for (int i = 0; i < 150; ++i) {
    const bool inside = i % 2 == 0;
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_polynomial(random);
    if (a == b) continue;
    INFO(words(a) << "\n" << words(b));
    const ClaimResult result =
        only_claim(inside ? parameters : scalars, text(a) + " == " + text(b));
    REQUIRE(result.decision.verdict == Verdict::refuted);
    CHECK(result.decision.evidence == Evidence::both_engines);
    const Point at = place_of(result.decision.witness);
    CHECK(value_at(a, at) != value_at(b, at));
    CHECK(to_text(value_at(a, at)) == result.decision.witness.left);
    CHECK(to_text(value_at(b, at)) == result.decision.witness.right);
    if (!inside) continue;
    for (const auto& [variable, value] : at) CHECK((0 <= value && value <= 1));
  }
}

TEST_CASE("witnesses satisfy the assumptions they are found under", "[law]") {
  std::mt19937 random{112};
  int refuted = 0;
  for (int i = 0; i < 100; ++i) {
    const Polynomial equation = random_polynomial(random, 3, 1, 3);
    const Polynomial positive = random_polynomial(random, 3, 1, 3);
    const Polynomial claim = random_polynomial(random, 3, 2, 3);
    INFO(words(equation) << " == 0, " << words(positive) << " > 0, " << words(claim));
    const ClaimResult result = only_claim(
        scalars + "assume e: " + words(equation) + " == 0\nassume i: " + words(positive) + " > 0\n",
        words(claim) + " == 0");
    CHECK(result.decision.verdict != Verdict::internal);
    if (result.decision.verdict != Verdict::refuted) continue;
    ++refuted;
    const Point at = place_of(result.decision.witness);
    CHECK(value_at(equation, at) == 0);
    CHECK(value_at(positive, at) > 0);
    CHECK(value_at(claim, at) != 0);
  }
  CHECK(refuted > 30);
}

TEST_CASE("inequalities are proved only where no point of a grid contradicts", "[law]") {
  std::mt19937 random{113};
  int proved = 0;
  int refuted = 0;
  for (int i = 0; i < 150; ++i) {
    const Polynomial p = random_polynomial(random, 2, 2, 4);
    const bool strict = random() % 2 == 0;
    INFO(words(p) << (strict ? " > 0" : " >= 0"));
    const ClaimResult result = only_claim(parameters, words(p) + (strict ? " > 0" : " >= 0"));
    const Verdict verdict = result.decision.verdict;
    REQUIRE(
        (verdict == Verdict::proved || verdict == Verdict::refuted || verdict == Verdict::unknown));
    if (verdict == Verdict::refuted) {
      ++refuted;
      const Rational value = value_at(p, place_of(result.decision.witness));
      CHECK((strict ? value <= 0 : value < 0));
    }
    if (verdict != Verdict::proved) continue;
    ++proved;
    for (int a = 0; a <= 6; ++a) {
      for (int b = 0; b <= 6; ++b) {
        const Rational value = value_at(p, {{0, Rational(a, 6)}, {1, Rational(b, 6)}});
        REQUIRE((strict ? value > 0 : value >= 0));
      }
    }
  }
  CHECK(proved > 20);
  CHECK(refuted > 20);
}

TEST_CASE("quotients of polynomials: proved with their conditions, refuted where they have a value",
          "[law]") {
  std::mt19937 random{114};
  for (int i = 0; i < 60; ++i) {
    const Polynomial a = random_polynomial(random, 2, 2, 3);
    const Polynomial b = random_nonzero(random, 2, 2, 3);
    const Polynomial c = random_nonzero(random, 2, 1, 2);
    const std::string quotient = text(a) + "/" + text(b);
    INFO(quotient << ", " << words(c));
    const ClaimResult same = only_claim(scalars, "(" + text(a) + "*" + text(c) + ")/(" + text(b) +
                                                     "*" + text(c) + ") == " + quotient);
    const bool numbers = b.is_constant() && c.is_constant();
    const bool conditional = !same.decision.conditions.empty();
    CHECK(same.decision.verdict == (conditional ? Verdict::proved_if : Verdict::proved));
    CHECK((!numbers || !conditional));
    // No condition is left only where the divisors are nowhere zero.
    for (int k = 0; !conditional && k < 20; ++k) {
      const Point at = random_point(random, 2);
      REQUIRE(value_at(b, at) * value_at(c, at) != 0);
    }
    const ClaimResult different =
        only_claim(scalars, quotient + " == " + quotient + " + " + text(c));
    REQUIRE(different.decision.verdict == Verdict::refuted);
    const Point at = place_of(different.decision.witness);
    CHECK(value_at(b, at) != 0);
    CHECK(value_at(c, at) != 0);
    CHECK(to_text(Rational{value_at(a, at) / value_at(b, at)}) == different.decision.witness.left);
  }
}

TEST_CASE("what is shown can be read again and is the same", "[law]") {
  std::mt19937 random{115};
  for (int i = 0; i < 80; ++i) {
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_nonzero(random, 3, 1, 2);
    const std::string written = i % 2 == 0 ? text(a) : text(a) + "/" + text(b);
    const std::string& declarations = i % 4 < 2 ? scalars : parameters;
    const auto results = results_of("case t\n" + declarations + "show " + written + "\nend\n");
    const std::string shown = results.at(0).shown.at(0).value;
    INFO(written << "\n" << shown);
    const ClaimResult same = only_claim(declarations, written + " == " + shown);
    CHECK(
        (same.decision.verdict == Verdict::proved || same.decision.verdict == Verdict::proved_if));
  }
}

TEST_CASE("linear systems are solved, and the solution satisfies them", "[law]") {
  std::mt19937 random{116};
  int proved = 0;
  for (int i = 0; i < 60; ++i) {
    // Equations that x0, x1 satisfy for chosen values.
    const Rational first = random_rational(random);
    const Rational second = random_rational(random);
    std::string equations;
    Rational determinant = 0;
    int rows[2][2];
    for (int r = 0; r < 2; ++r) {
      rows[r][0] = random_small(random, 3);
      rows[r][1] = random_small(random, 3);
      const Rational right = rows[r][0] * first + rows[r][1] * second;
      equations += (r == 0 ? "" : ", ") + std::string{"("} + std::to_string(rows[r][0]) +
                   ")*x0 + (" + std::to_string(rows[r][1]) + ")*x1 == " + to_text(right);
    }
    determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    INFO(equations);
    const std::string lines = verdicts(scalars + "derive d: x0, x1 from " + equations + " gives " +
                                       to_text(first) + ", " + to_text(second) + "\n");
    if (determinant == 0) {
      CHECK(lines.rfind("d UNDERDETERMINED", 0) == 0);
    } else {
      CHECK(lines == "d PROVED\n");
      ++proved;
    }
  }
  CHECK(proved > 30);
}

}  // namespace patchproof
