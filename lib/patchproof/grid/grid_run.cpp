#include <patchproof/grid/grid_run.hpp>

#include <algorithm>

#include <patchproof/grid/tape_values.hpp>

namespace patchproof {

namespace {

using Step = Tape::Step;
using Entry = Tape::Entry;
using Residue = Modulus::Residue;

/// More additions and multiplications than this are not begun: a second or so.
constexpr std::uint64_t most_work = 200'000'000;

/// The length of the primes.
constexpr std::uint64_t prime_bits = 61;

/// The values a variable gets: `start`, `start + distance`, …
struct Line {
  Rational start{0};
  Rational distance{1};
};
using Places = std::array<Line, Tape::most_variables>;
using Point = std::array<Rational, Tape::most_variables>;

/// Calculates all steps of a tape at the points of a grid, modulo a prime.
class GridRun {
 public:
  GridRun(const Tape& tape, const std::vector<Step>& wanted)
      : tape_{tape}, wanted_{wanted}, values_{tape} {
    for (const Step step : wanted)
      for (std::size_t k = 0; k < Tape::most_variables; ++k)
        degrees_[k] = std::max(degrees_[k], tape.entry(step).degrees[k]);
    find_levels();
  }

  /// About how many additions and multiplications one prime costs.
  std::uint64_t work() const {
    std::uint64_t result = 0;
    std::uint64_t points = 1;
    for (std::size_t level = 0; level <= Tape::most_variables; ++level) {
      if (level > 0) points *= std::uint64_t{degrees_[level - 1]} + 1;
      for (const Step step : levels_[level]) result += points * values_.work_of(step);
      if (points > most_work || result > most_work) return most_work + 1;
    }
    return result;
  }

  /// As many values of each variable as there have to be, in the ranges.
  Places within(const GridRanges& ranges) const {
    Places result;
    for (std::size_t k = 0; k < Tape::most_variables; ++k)
      result[k] = {ranges[k].start,
                   ranges[k].length / Rational{std::max<unsigned>(1, degrees_[k])}};
    return result;
  }

  bool all_zero(const Modulus& modulus, const Places& places = {}) {
    modulus_ = &modulus;
    values_.begin(modulus);
    for (std::size_t k = 0; k < Tape::most_variables; ++k) {
      starts_[k] = modulus.residue(places[k].start);
      distances_[k] = modulus.residue(places[k].distance);
    }
    run(0);
    return visit(0);
  }

  /// At one point only.
  bool all_zero_at(const Point& point, const Modulus& modulus) {
    values_.begin(modulus);
    for (std::size_t k = 0; k < Tape::most_variables; ++k)
      values_.set_variable(k, modulus.residue(point[k]));
    for (std::size_t level = 0; level <= Tape::most_variables; ++level) run(level);
    return visit(Tape::most_variables);
  }

  /// Where `all_zero` has stopped.
  Point stopped_at(const Places& places) const {
    Point result;
    for (std::size_t k = 0; k < Tape::most_variables; ++k)
      result[k] = places[k].start + Rational{at_[k]} * places[k].distance;
    return result;
  }

  /// What is not zero at the point that was looked at last.
  GridDifference difference(const Point& point) const {
    GridDifference result{point, std::nullopt};
    for (const Step step : wanted_) {
      const std::optional<std::size_t> part = values_.first_part_not_zero(step);
      if (!part) continue;
      if (*part > 0) result.symbol = tape_.support(step)[*part - 1];
      return result;
    }
    return result;
  }

 private:
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
      return std::all_of(wanted_.begin(), wanted_.end(),
                         [&](Step step) { return !values_.first_part_not_zero(step); });
    for (unsigned value = 0; value <= degrees_[variable]; ++value) {
      at_[variable] = value;
      const Residue way =
          modulus_->product(distances_[variable], modulus_->residue(Integer{value}));
      values_.set_variable(variable, modulus_->sum(starts_[variable], way));
      run(variable + 1);
      if (!visit(variable + 1)) return false;
    }
    return true;
  }

  void run(std::size_t level) {
    for (const Step step : levels_[level]) values_.calculate(step);
  }

  const Tape& tape_;
  const std::vector<Step>& wanted_;
  TapeValues values_;
  std::array<std::uint16_t, Tape::most_variables> degrees_{};
  std::array<std::vector<Step>, Tape::most_variables + 1> levels_;
  std::array<Residue, Tape::most_variables> starts_{};
  std::array<Residue, Tape::most_variables> distances_{};
  std::array<unsigned, Tape::most_variables> at_{};
  const Modulus* modulus_ = nullptr;
};

bool has_residues(const Tape& tape, const Modulus& modulus) {
  return std::all_of(tape.entries().begin(), tape.entries().end(), [&](const Entry& entry) {
    return entry.operation != Tape::Operation::number || modulus.has_residue(entry.number);
  });
}

std::vector<Step> not_written_as_zero(std::vector<Step> steps) {
  std::erase(steps, Tape::zero);
  return steps;
}

}  // namespace

bool are_zero(const Tape& tape, const std::vector<Step>& steps, Budget& budget) {
  const std::vector<Step> wanted = not_written_as_zero(steps);
  Integer norm = 0;
  for (const Step step : wanted) norm = std::max(norm, tape.entry(step).norm);
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

std::optional<GridDifference> difference_at_a_point(const Tape& tape,
                                                    const std::vector<Step>& steps,
                                                    const GridRanges& ranges, Budget& budget) {
  const std::vector<Step> wanted = not_written_as_zero(steps);
  if (wanted.empty()) return std::nullopt;
  // Small numbers, all of them different: 1/3, 2/4, 3/5, … of the range.
  Point point;
  for (std::size_t k = 0; k < Tape::most_variables; ++k)
    point[k] = ranges[k].start + ranges[k].length * Rational{static_cast<long>(k) + 1} /
                                     Rational{static_cast<long>(k) + 3};
  GridRun run{tape, wanted};
  const Modulus modulus{large_primes().front()};
  const bool fits = has_residues(tape, modulus) &&
                    std::all_of(point.begin(), point.end(),
                                [&](const Rational& value) { return modulus.has_residue(value); });
  if (!fits) return std::nullopt;
  budget.spend(tape.entries().size());
  if (run.all_zero_at(point, modulus)) return std::nullopt;
  return run.difference(point);
}

std::optional<GridDifference> difference_from_zero(const Tape& tape, const std::vector<Step>& steps,
                                                   const GridRanges& ranges, Budget& budget) {
  const std::vector<Step> wanted = not_written_as_zero(steps);
  if (wanted.empty()) return std::nullopt;
  GridRun run{tape, wanted};
  const Places places = run.within(ranges);
  for (const std::uint64_t prime : large_primes()) {
    const Modulus modulus{prime};
    const bool fits = std::all_of(places.begin(), places.end(), [&](const Line& line) {
      return modulus.has_residue(line.start) && modulus.has_residue(line.distance);
    });
    if (!fits || !has_residues(tape, modulus)) continue;
    budget.spend(run.work());
    if (!run.all_zero(modulus, places)) return run.difference(run.stopped_at(places));
  }
  return std::nullopt;
}

}  // namespace patchproof
