#include <patchproof/algebra/budget.hpp>

#include <atomic>
#include <limits>

namespace patchproof {

namespace {

using Clock = std::chrono::steady_clock;
using Counter = std::size_t (*)();

// The clock and the memory count are read once in so many steps: reading them costs more than a
// step does.
constexpr std::uint64_t steps_between_checks = 4096;

// The one setting of the whole program: how its memory is counted, fixed before any claim.
std::atomic<Counter>& byte_counter() {
  static std::atomic<Counter> counter{nullptr};
  return counter;
}

// A limit beyond what the clock can represent is no limit.
Clock::time_point end_after(std::chrono::milliseconds time) {
  const Clock::time_point now = Clock::now();
  const auto longest =
      std::chrono::duration_cast<std::chrono::milliseconds>(Clock::time_point::max() - now);
  if (time.count() == 0 || time >= longest) return Clock::time_point::max();
  return now + time;
}

}  // namespace

Budget::Budget(const Limits& limits)
    : limits_{limits}, end_{end_after(limits.time)}, memory_at_start_{bytes_in_use()} {}

void Budget::spend(std::uint64_t steps) {
  const std::uint64_t left = std::numeric_limits<std::uint64_t>::max() - steps_;
  steps_ = steps > left ? std::numeric_limits<std::uint64_t>::max() : steps_ + steps;
  if (limits_.steps != 0 && steps_ > limits_.steps) {
    throw OverBudget{"more than " + std::to_string(limits_.steps) + " steps"};
  }
  unchecked_ += steps < steps_between_checks ? steps : steps_between_checks;
  if (unchecked_ < steps_between_checks) return;
  unchecked_ = 0;
  if (end_ != Clock::time_point::max() && Clock::now() >= end_) {
    throw OverBudget{"more than " + std::to_string(limits_.time.count()) + " ms"};
  }
  if (limits_.memory != 0 && bytes_in_use() > memory_at_start_ &&
      bytes_in_use() - memory_at_start_ > limits_.memory) {
    throw OverBudget{"more than " + std::to_string(limits_.memory) + " bytes of memory"};
  }
}

void Budget::require_terms(std::size_t terms) {
  if (limits_.terms != 0 && terms > limits_.terms) {
    throw OverBudget{"more than " + std::to_string(limits_.terms) + " terms"};
  }
}

std::size_t bytes_in_use() {
  const Counter counter = byte_counter().load();
  return counter == nullptr ? 0 : counter();
}

void count_bytes_with(std::size_t (*counter)()) { byte_counter().store(counter); }

}  // namespace patchproof
