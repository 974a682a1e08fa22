// A calculation that is zero on a grid modulo enough primes is zero; here compared with polynomials
// written out over the rational numbers.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>

#include <patchproof/algebra/polynomial.hpp>
#include <patchproof/grid/grid_run.hpp>
#include <patchproof/grid/modulus.hpp>

namespace patchproof {

namespace {

constexpr Variable first_symbol = 100;

// A calculation and what it comes to.
struct Both {
  Tape::Step step = Tape::zero;
  Polynomial polynomial;
};

class RandomTape {
 public:
  explicit RandomTape(std::uint64_t seed) : random_{seed} {
    for (std::uint32_t k = 0; k < 2; ++k)
      steps_.push_back({tape_.variable(k), Polynomial::variable(k)});
    for (std::uint32_t k = 0; k < 3; ++k)
      steps_.push_back({tape_.symbol(k), Polynomial::variable(first_symbol + k)});
  }

  std::uint64_t below(std::uint64_t end) { return random_() % end; }

  Rational number() {
    const auto above = static_cast<long>(below(9)) - 4;
    switch (below(12)) {
      case 0:
        return Rational{above, static_cast<long>(below(6)) + 1};
      case 1:
        return Rational{Integer{large_primes()[below(3)]} * above};
      case 2:
        return Rational{Integer{1}, Integer{large_primes()[below(2)]}} * Rational{above};
      default:
        return Rational{above};
    }
  }

  void grow() {
    const Both& a = steps_[below(steps_.size())];
    const Both& b = steps_[below(steps_.size())];
    Both next;
    switch (below(4)) {
      case 0: {
        const Rational factor = number();
        next = {tape_.product(tape_.number(factor), a.step), scaled(a.polynomial, factor)};
        break;
      }
      case 1:
        next = {tape_.sum({{a.step, false}, {b.step, false}}),
                sum(a.polynomial, b.polynomial, budget_)};
        break;
      case 2:
        next = {tape_.difference(a.step, b.step), difference(a.polynomial, b.polynomial, budget_)};
        break;
      default:
        try {
          next = {tape_.product(a.step, b.step), product(a.polynomial, b.polynomial, budget_)};
        } catch (const Declined&) {
          return;
        }
    }
    if (next.polynomial.terms().size() < 60) steps_.push_back(std::move(next));
  }

  // Two ways to the same thing, or almost: one coefficient off.
  Both nearly_zero() {
    const Both a = steps_[below(steps_.size())];
    const Both b = steps_[below(steps_.size())];
    const Rational factor = number();
    const Tape::Step left =
        tape_.product(tape_.number(factor), tape_.sum({{a.step, false}, {b.step, true}}));
    const Tape::Step right = tape_.sum({{tape_.product(tape_.number(factor), a.step), false},
                                        {tape_.product(tape_.number(factor), b.step), true}});
    Both result{tape_.difference(left, right), {}};
    if (below(2) == 0) {
      const Both& other = steps_[below(steps_.size())];
      result = {tape_.sum({{result.step, false}, {other.step, false}}), other.polynomial};
    }
    return result;
  }

  void check_bounds(const Both& both) const {
    if (both.step == Tape::zero) {
      CHECK(both.polynomial.is_zero());
      return;
    }
    const Tape::Entry& entry = tape_.entry(both.step);
    const std::vector<std::uint32_t>& support = tape_.support(both.step);
    Integer norm = 0;
    for (const Polynomial::Term& term : both.polynomial.terms()) {
      const Rational whole = term.coefficient * Rational{entry.denominator};
      REQUIRE(denominator(whole) == 1);
      norm += boost::multiprecision::abs(numerator(whole));
      for (const auto& [variable, exponent] : term.monomial.powers()) {
        if (variable < first_symbol) {
          CHECK(exponent <= entry.degrees[variable]);
        } else {
          CHECK(exponent == 1);
          CHECK(std::binary_search(support.begin(), support.end(), variable - first_symbol));
        }
      }
    }
    CHECK(norm <= entry.norm);
  }

  bool is_zero(const Both& both) { return are_zero(tape_, {both.step}, budget_); }
  const std::vector<Both>& steps() const { return steps_; }

 private:
  std::mt19937_64 random_;
  Budget budget_{Limits{std::chrono::milliseconds{0}, 0, 0, 0}};
  Tape tape_;
  std::vector<Both> steps_;
};

bool is_zero(const Tape& tape, Tape::Step step) {
  Budget budget{Limits{}};
  return are_zero(tape, {step}, budget);
}

}  // namespace

TEST_CASE("degrees, denominators and coefficients are within their bounds", "[law]") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomTape tape{seed};
    for (int k = 0; k < 25; ++k) tape.grow();
    INFO("seed " << seed);
    for (const Both& both : tape.steps()) tape.check_bounds(both);
  }
}

// PATCHPROOF_CLAIMS=1000000 for a long run.
TEST_CASE("the grid finds out what writing out finds out", "[law]") {
  const char* wanted = std::getenv("PATCHPROOF_CLAIMS");
  const long claims = wanted == nullptr ? 20'000 : std::atol(wanted);
  long zeros = 0;
  long others = 0;
  for (std::uint64_t seed = 0; zeros + others < claims; ++seed) {
    RandomTape tape{seed};
    for (int k = 0; k < 20; ++k) tape.grow();
    INFO("seed " << seed);
    for (int k = 0; k < 10; ++k) {
      const Both both = tape.nearly_zero();
      const bool zero = both.polynomial.is_zero();
      REQUIRE(tape.is_zero(both) == zero);
      ++(zero ? zeros : others);
    }
  }
  CHECK(zeros > claims / 10);
  CHECK(others > claims / 10);
}

TEST_CASE("a coefficient that is a multiple of a prime is not zero") {
  Tape tape;
  const Integer first{large_primes()[0]};
  const Integer second{large_primes()[1]};
  const Integer third{large_primes()[2]};
  const Tape::Step u = tape.variable(0);
  const Tape::Step a = tape.symbol(0);
  for (const Integer& number :
       {Integer{first - 1}, first, Integer{first + 1}, Integer{first * second},
        Integer{first * second - 1}, Integer{first * second * third}, Integer{2 * first}})
    for (const Tape::Step step : {u, a}) {
      const Tape::Step product = tape.product(tape.number(Rational{number}), step);
      CHECK(!is_zero(tape, product));
      // The same number reached in two ways: zero, with a bound that needs another prime.
      const Tape::Step less = tape.product(tape.number(Rational{Integer{number - 1}}), step);
      CHECK(is_zero(tape, tape.sum({{product, false}, {less, true}, {step, true}})));
      CHECK(!is_zero(tape, tape.sum({{product, false}, {less, true}})));
    }
}

TEST_CASE("a polynomial that vanishes at all whole numbers up to its degree less one is not zero") {
  Tape tape;
  const Tape::Step u = tape.variable(0);
  Tape::Step product = tape.symbol(0);
  for (int k = 0; k < 12; ++k) {
    product = tape.product(product, tape.difference(u, tape.number(Rational{k})));
    CHECK(!is_zero(tape, product));
    CHECK(!is_zero(tape, tape.product(product, tape.variable(1))));
  }
}

TEST_CASE("zeros are found out, not assumed") {
  Tape tape;
  const Tape::Step u = tape.variable(0);
  const Tape::Step v = tape.variable(1);
  const Tape::Step sum = tape.sum({{u, false}, {v, false}});
  const Tape::Step square = tape.product(sum, sum);
  const auto twice = [&](Tape::Step step) { return tape.product(tape.number(2), step); };
  const Tape::Step expanded = tape.sum({{tape.product(u, u), false},
                                        {twice(tape.product(u, v)), false},
                                        {tape.product(v, v), false}});
  CHECK(is_zero(tape, tape.difference(square, expanded)));
  CHECK(!is_zero(tape, tape.sum({{square, false}, {expanded, true}, {tape.product(u, v), false}})));
}

TEST_CASE("what the method cannot do is declined") {
  Tape tape;
  CHECK_THROWS_AS(tape.product(tape.symbol(0), tape.symbol(1)), Declined);
  CHECK_THROWS_AS(tape.variable(Tape::most_variables), Declined);
  Tape::Step large = tape.number(Rational{Integer{1} << 500});
  const Tape::Step u = tape.variable(0);
  large = tape.product(large, u);
  CHECK_THROWS_AS(tape.product(tape.product(large, large), large), Declined);
  Tape::Step high = u;
  CHECK_THROWS_AS(([&] {
                    for (int k = 0; k < 20; ++k) high = tape.product(high, high);
                  }()),
                  Declined);
}

}  // namespace patchproof
