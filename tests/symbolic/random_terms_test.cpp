#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>

#include <patchproof/symbolic/second_opinion.hpp>
#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

// Terms drawn at random, and terms that are equal to them by a textbook identity.
class Drawer {
 public:
  Drawer(unsigned seed, std::vector<Term> letters) : random_{seed}, letters_{std::move(letters)} {}

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Term term(int depth) {
    if (depth == 0) return leaf();
    switch (below(9)) {
      case 0:
      case 1:
        return term(depth - 1) + term(depth - 1);
      case 2:
        return term(depth - 1) - term(depth - 1);
      case 3:
      case 4:
        return term(depth - 1) * term(depth - 1);
      case 5:
        return power(term(depth - 1), 1 + below(3));
      case 6:
        return term(depth - 1) / (power(leaf(), 2) + 1);
      case 7:
        return below(2) == 0 ? sin(term(depth - 1)) : cos(term(depth - 1));
      default:
        return below(2) == 0 ? sqrt(power(leaf(), 2) + 1) : bernstein(3, below(4), leaf());
    }
  }

  // The same term with some of its parts written in another way.
  Term rewritten(const Term& t) {
    if (t.children().empty()) return below(3) == 0 ? 3 * t / 3 : t;
    std::vector<Term> c;
    for (const Term& child : t.children()) c.push_back(rewritten(child));
    switch (t.operation()) {
      case Operation::sum:
        return c[1] + c[0];
      case Operation::product:
        return below(2) == 0 ? c[1] * c[0] : (c[0] - 1) * c[1] + c[1];
      case Operation::quotient:
        return below(2) == 0 ? c[0] * (1 / c[1]) : (2 * c[0]) / (c[1] + c[1]);
      case Operation::sine:
        return below(2) == 0 ? 2 * (sin(c[0] / 2) * cos(c[0] / 2)) : cos(pi() / 2 - c[0]);
      case Operation::cosine:
        return below(2) == 0 ? 1 - 2 * power(sin(c[0] / 2), 2) : -sin(c[0] - pi() / 2);
      case Operation::square_root:
        return below(2) == 0 ? sqrt(9 * c[0]) / 3 : c[0] / sqrt(c[0]);
      default:
        return make_term(t.operation(), t.type(), c, t->payload);
    }
  }

 private:
  Term leaf() {
    return below(4) == 0
               ? number(below(7) - 3, 1 + below(3))
               : letters_[static_cast<std::size_t>(below(static_cast<int>(letters_.size())))];
  }

  std::mt19937 random_;
  std::vector<Term> letters_;
};

// The value in floating point: a check from outside all exact arithmetic.
double value(const Term& t, const std::vector<std::pair<unsigned, double>>& at) {
  const auto child = [&](std::size_t i) { return value(t.child(i), at); };
  switch (t.operation()) {
    case Operation::number:
      return numerator(t.number()).convert_to<double>() / denominator(t.number()).convert_to<double>();
    case Operation::pi:
      return std::acos(-1.0);
    case Operation::symbol:
      for (const auto& [ordinal, x] : at) {
        if (ordinal == t.symbol()->ordinal) return x;
      }
      return 0;
    case Operation::sum:
      return child(0) + child(1);
    case Operation::negation:
      return -child(0);
    case Operation::product:
      return child(0) * child(1);
    case Operation::quotient:
      return child(0) / child(1);
    case Operation::power:
      return std::pow(child(0), static_cast<double>(t.exponent()));
    case Operation::sine:
      return std::sin(child(0));
    case Operation::cosine:
      return std::cos(child(0));
    case Operation::square_root:
      return std::sqrt(child(0));
    case Operation::bernstein: {
      const int i = t.indices()[1];
      const double x = child(0);
      const double binomial = i == 0 || i == 3 ? 1 : 3;
      return binomial * std::pow(x, i) * std::pow(1 - x, 3 - i);
    }
    default:
      throw std::logic_error{"an operation that is not drawn"};
  }
}

}  // namespace

TEST_CASE("a term rewritten by identities is never found different", "[law]") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term a = declare.scalar("a");
  int proved = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Drawer draw{seed, {u, a}};
    const Term left = draw.term(3);
    const Term right = draw.rewritten(left);
    const SecondOpinion opinion = terms::opinion(left, right);
    CAPTURE(seed, opinion.reason, opinion.normal_form);
    CHECK(opinion.answer != Answer::fails);
    proved += opinion.answer == Answer::holds ? 1 : 0;
  }
  CHECK(proved >= 380);
}

TEST_CASE("terms found equal have equal values, and terms found different do not", "[law]") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term a = declare.scalar("a");
  for (unsigned seed = 0; seed < 400; ++seed) {
    Drawer draw{seed, {u, a}};
    const Term left = draw.term(2);
    const Term right = draw.below(2) == 0 ? draw.term(2) : draw.rewritten(left);
    const SecondOpinion opinion = terms::opinion(left, right);
    double largest = 0;
    for (const auto& [x, y] : {std::pair{0.3, 1.7}, {1.1, -0.4}, {-0.6, 0.9}}) {
      const std::vector<std::pair<unsigned, double>> at{{u.symbol()->ordinal, x},
                                                        {a.symbol()->ordinal, y}};
      const double scale = 1 + std::abs(value(left, at));
      largest = std::max(largest, std::abs(value(left, at) - value(right, at)) / scale);
    }
    CAPTURE(seed, opinion.reason, opinion.normal_form, largest);
    if (opinion.answer == Answer::holds) CHECK(largest < 1e-9);
    if (opinion.answer == Answer::fails) CHECK(largest > 1e-9);
    if (opinion.answer == Answer::none) SUCCEED("no answer is no wrong answer");
  }
}

TEST_CASE("the derivative follows the rules for products, quotients and compositions", "[law]") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term a = declare.scalar("a");
  const Term F = declare.scalar_function("F", {"t"});
  for (unsigned seed = 0; seed < 100; ++seed) {
    Drawer draw{seed, {u, a}};
    const Term f = draw.term(2);
    const Term g = draw.term(2);
    const auto d = [&](const Term& x) { return at(derivative(lambda({u}, x), {1}), {u}); };
    CAPTURE(seed);
    CHECK(holds(d(f * g), d(f) * g + f * d(g)));
    CHECK(holds(d(f / (1 + g * g)),
                (d(f) * (1 + g * g) - f * (2 * (g * d(g)))) / power(1 + g * g, 2)));
    CHECK(holds(d(at(F, {f})), at(derivative(F, {1}), {f}) * d(f)));
    CHECK(holds(d(sin(f)), cos(f) * d(f)));
  }
}

TEST_CASE("a function at an argument is its body with the argument in place", "[law]") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  const std::vector<Term> arguments{number(0), number(-2, 3), b, a + b, power(u, 2) - 1, sqrt(b)};
  for (unsigned seed = 0; seed < 120; ++seed) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      Drawer draw{seed, {u, a}};
      Drawer same{seed, {arguments[i], a}};
      const SecondOpinion opinion =
          terms::opinion(at(lambda({u}, draw.term(2)), {arguments[i]}), same.term(2));
      CAPTURE(seed, i, opinion.reason, opinion.normal_form);
      CHECK(opinion.answer == Answer::holds);
    }
  }
}
