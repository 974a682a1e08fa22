#include <patchproof/algebra/budget.hpp>

#include <catch2/catch.hpp>
#include <thread>

using patchproof::Budget;
using patchproof::Limits;
using patchproof::OverBudget;

namespace {

Limits no_limits() { return {std::chrono::milliseconds{0}, 0, 0, 0}; }

std::size_t pretended_bytes = 0;

}  // namespace

TEST_CASE("the steps of a budget are counted exactly", "[reject]") {
  Limits limits = no_limits();
  limits.steps = 10;
  Budget budget{limits};
  budget.spend(4);
  budget.spend(6);
  CHECK_THROWS_AS(budget.spend(1), OverBudget);
  CHECK_THROWS_WITH(budget.spend(1), "more than 10 steps");
}

TEST_CASE("a count of steps too large for the counter is over budget, not small", "[reject]") {
  Limits limits = no_limits();
  limits.steps = 10;
  Budget budget{limits};
  budget.spend(5);
  CHECK_THROWS_AS(budget.spend(~std::uint64_t{0}), OverBudget);
}

TEST_CASE("a budget ends with its time", "[reject]") {
  Limits limits = no_limits();
  limits.time = std::chrono::milliseconds{1};
  Budget budget{limits};
  std::this_thread::sleep_for(std::chrono::milliseconds{3});
  CHECK_THROWS_WITH(budget.spend(1'000'000), "more than 1 ms");
  Budget small_steps{limits};
  std::this_thread::sleep_for(std::chrono::milliseconds{3});
  CHECK_THROWS_AS(
      [&] {
        for (int i = 0; i < 5000; ++i) small_steps.spend(1);
      }(),
      OverBudget);
}

TEST_CASE("a budget ends when the memory in use has grown beyond it", "[reject]") {
  patchproof::count_bytes_with([] { return pretended_bytes; });
  pretended_bytes = 1000;
  Limits limits = no_limits();
  limits.memory = 50;
  Budget budget{limits};
  pretended_bytes = 1050;
  CHECK_NOTHROW(budget.spend(10'000));
  pretended_bytes = 10;
  CHECK_NOTHROW(budget.spend(10'000));
  pretended_bytes = 1051;
  CHECK_THROWS_WITH(budget.spend(10'000), "more than 50 bytes of memory");
  patchproof::count_bytes_with(nullptr);
  CHECK(patchproof::bytes_in_use() == 0);
}

TEST_CASE("a polynomial may have as many terms as the limit says and no more", "[reject]") {
  Limits limits = no_limits();
  limits.terms = 7;
  Budget budget{limits};
  CHECK_NOTHROW(budget.require_terms(7));
  CHECK_THROWS_WITH(budget.require_terms(8), "more than 7 terms");
}

TEST_CASE("zero means no limit, and so does a time beyond the clock") {
  Limits limits = no_limits();
  Budget budget{limits};
  CHECK_NOTHROW(budget.spend(~std::uint64_t{0}));
  CHECK_NOTHROW(budget.spend(~std::uint64_t{0}));
  CHECK_NOTHROW(budget.require_terms(~std::size_t{0}));
  limits.time = std::chrono::milliseconds::max();
  Budget endless{limits};
  CHECK_NOTHROW(endless.spend(1'000'000));
}
