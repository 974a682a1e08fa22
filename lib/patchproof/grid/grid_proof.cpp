#include <patchproof/grid/grid_proof.hpp>

#include <algorithm>
#include <array>
#include <optional>

#include <patchproof/grid/modulus.hpp>
#include <patchproof/grid/tape_builder.hpp>

namespace patchproof {

namespace {

using Step = Tape::Step;
using Entry = Tape::Entry;
using Residue = Modulus::Residue;

/// So many residues are kept at the most: 32 MB.
constexpr std::size_t most_values = 4'000'000;
/// More additions and multiplications than this are not begun: a second or so.
constexpr std::uint64_t most_work = 200'000'000;

/// The length of the primes.
constexpr std::uint64_t prime_bits = 61;

/// Calculates all steps of a tape at the points of a grid, modulo a prime.
class GridRun {
 public:
  GridRun(const Tape& tape, const std::vector<Step>& wanted) : tape_{tape}, wanted_{wanted} {
    for (const Step step : wanted)
      for (std::size_t k = 0; k < Tape::most_variables; ++k)
        degrees_[k] = std::max(degrees_[k], tape.entry(step).degrees[k]);
    places_.reserve(tape.entries().size());
    std::size_t place = 0;
    for (const Entry& entry : tape.entries()) {
      places_.push_back(place);
      place += 1 + (entry.high - entry.low);
    }
    if (place > most_values) throw Declined{"too many values"};
    values_.resize(place);
    find_levels();
  }

  /// About how many additions and multiplications one prime costs.
  std::uint64_t work() const {
    std::uint64_t result = 0;
    std::uint64_t points = 1;
    for (std::size_t level = 0; level <= Tape::most_variables; ++level) {
      if (level > 0) points *= std::uint64_t{degrees_[level - 1]} + 1;
      for (const Step step : levels_[level]) {
        result += points * work_of(tape_.entry(step));
      }
      if (points > most_work || result > most_work) return most_work + 1;
    }
    return result;
  }

  bool all_zero(const Modulus& modulus) {
    modulus_ = &modulus;
    run(0);
    return visit(0);
  }

 private:
  static std::uint64_t width_of(const Entry& entry) { return 1 + (entry.high - entry.low); }

  std::uint64_t work_of(const Entry& entry) const {
    std::uint64_t result = width_of(entry);
    for (std::uint32_t k = 0; k < entry.count; ++k)
      result += width_of(tape_.entry(tape_.summands()[entry.index + k].step));
    return result;
  }

  // Level 0 is the same everywhere; level k + 1 changes with variable k, and perhaps with earlier
  // ones.
  void find_levels() {
    for (std::size_t step = 0; step < tape_.entries().size(); ++step) {
      const auto& degrees = tape_.entries()[step].degrees;
      std::size_t level = 0;
      for (std::size_t k = 0; k < degrees.size(); ++k)
        if (degrees[k] > 0) level = k + 1;
      levels_[level].push_back(static_cast<Step>(step));
    }
  }

  bool visit(std::size_t variable) {
    if (variable == Tape::most_variables)
      return std::all_of(wanted_.begin(), wanted_.end(), [&](Step step) { return is_zero(step); });
    for (unsigned value = 0; value <= degrees_[variable]; ++value) {
      point_[variable] = modulus_->residue(Integer{value});
      run(variable + 1);
      if (!visit(variable + 1)) return false;
    }
    return true;
  }

  bool is_zero(Step step) const {
    const Entry& entry = tape_.entry(step);
    const Residue* value = &values_[places_[step]];
    return std::all_of(value, value + 1 + (entry.high - entry.low),
                       [](Residue part) { return part == 0; });
  }

  void run(std::size_t level) {
    for (const Step step : levels_[level]) calculate(step);
  }

  // First what has no symbols, then the coefficients of the symbols from `low` on.
  void calculate(Step step) {
    const Entry& entry = tape_.entry(step);
    Residue* result = &values_[places_[step]];
    const std::size_t width = entry.high - entry.low;
    switch (entry.operation) {
      case Tape::Operation::number:
        result[0] = modulus_->residue(entry.number);
        return;
      case Tape::Operation::variable:
        result[0] = point_[entry.index];
        return;
      case Tape::Operation::symbol:
        result[0] = 0;
        result[1] = modulus_->residue(Integer{1});
        return;
      case Tape::Operation::product: {
        const Residue factor = values_[places_[entry.second]];
        const Residue* other = &values_[places_[entry.first]];
        for (std::size_t k = 0; k <= width; ++k) result[k] = modulus_->product(other[k], factor);
        return;
      }
      case Tape::Operation::sum:
        std::fill(result, result + 1 + width, 0);
        for (std::uint32_t k = 0; k < entry.count; ++k)
          add(tape_.summands()[entry.index + k], entry.low, result);
    }
  }

  void add(const Tape::Summand& summand, std::uint32_t low, Residue* result) const {
    const Entry& entry = tape_.entry(summand.step);
    const Residue* value = &values_[places_[summand.step]];
    const auto combined = [&](Residue a, Residue b) {
      return summand.negative ? modulus_->difference(a, b) : modulus_->sum(a, b);
    };
    result[0] = combined(result[0], value[0]);
    Residue* own = result + 1 + (entry.low - low);
    for (std::uint32_t k = 0; k < entry.high - entry.low; ++k)
      own[k] = combined(own[k], value[1 + k]);
  }

  const Tape& tape_;
  const std::vector<Step>& wanted_;
  std::array<std::uint16_t, Tape::most_variables> degrees_{};
  std::vector<std::size_t> places_;
  std::vector<Residue> values_;
  std::array<std::vector<Step>, Tape::most_variables + 1> levels_;
  std::array<Residue, Tape::most_variables> point_{};
  const Modulus* modulus_ = nullptr;
};

bool has_residues(const Tape& tape, const Modulus& modulus) {
  return std::all_of(tape.entries().begin(), tape.entries().end(), [&](const Entry& entry) {
    return entry.operation != Tape::Operation::number || modulus.has_residue(entry.number);
  });
}

// Every value of the parameters is allowed, and there is one.
bool is_plain(const Goal& goal) {
  const auto is_number = [](const Term& term) { return term.is_number(); };
  return goal.assumptions.empty() &&
         std::all_of(goal.ranges.begin(), goal.ranges.end(),
                     [&](const ParameterRange& range) {
                       return is_number(range.lower) && is_number(range.upper) &&
                              range.lower.number() < range.upper.number();
                     }) &&
         std::all_of(goal.statements.begin(), goal.statements.end(),
                     [](const Statement& s) { return s.relation == Relation::equal; });
}

std::optional<bool> attempt(const Goal& goal, bool scalars_are_variables, Budget& budget) {
  try {
    Tape tape;
    TapeBuilder builder{tape, goal.known, scalars_are_variables};
    std::vector<Step> differences;
    for (const Statement& statement : goal.statements) {
      const std::vector<Step> left = builder.components(statement.left);
      const std::vector<Step> right = builder.components(statement.right);
      if (left.size() != right.size()) return false;
      for (std::size_t k = 0; k < left.size(); ++k)
        differences.push_back(tape.difference(left[k], right[k]));
    }
    budget.spend(tape.entries().size());
    return are_zero(tape, differences, budget);
  } catch (const Declined&) {
    return std::nullopt;
  }
}

}  // namespace

bool are_zero(const Tape& tape, const std::vector<Step>& steps, Budget& budget) {
  std::vector<Step> wanted;
  Integer norm = 0;
  for (const Step step : steps) {
    if (step == Tape::zero) continue;
    wanted.push_back(step);
    norm = std::max(norm, tape.entry(step).norm);
  }
  if (wanted.empty()) return true;
  GridRun run{tape, wanted};
  // Declined before anything is spent: others have to do with what is left.
  const std::uint64_t work = run.work();
  const std::uint64_t primes = msb(norm) / (prime_bits - 1) + 1;
  if (work > most_work / primes) throw Declined{"too much work"};
  Integer product = 1;
  for (const std::uint64_t prime : large_primes()) {
    const Modulus modulus{prime};
    if (!has_residues(tape, modulus)) continue;
    budget.spend(work);
    if (!run.all_zero(modulus)) return false;
    product *= prime;
    if (product > norm) return true;
  }
  throw Declined{"numbers that are too large"};
}

bool holds_on_grid(const Goal& goal, Budget& budget) {
  if (!is_plain(goal)) return false;
  if (const std::optional<bool> answer = attempt(goal, false, budget)) return *answer;
  return attempt(goal, true, budget).value_or(false);
}

}  // namespace patchproof
