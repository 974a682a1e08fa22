#include <patchproof/grid/tape_values.hpp>

#include <algorithm>

namespace patchproof {

namespace {

using Entry = Tape::Entry;

/// So many residues are kept at the most: 32 MB.
constexpr std::size_t most_values = 4'000'000;

}  // namespace

TapeValues::TapeValues(const Tape& tape) : tape_{tape} {
  places_.reserve(tape.entries().size());
  std::size_t place = 0;
  for (Step step = 0; step < tape.entries().size(); ++step) {
    places_.push_back(place);
    place += width_of(step);
  }
  if (place > most_values) throw Declined{"too many values"};
  values_.resize(place);
  find_positions();
}

void TapeValues::find_positions() {
  first_position_.resize(tape_.summands().size());
  for (Step step = 0; step < tape_.entries().size(); ++step) {
    const Entry& entry = tape_.entry(step);
    if (entry.operation != Tape::Operation::sum) continue;
    const std::vector<std::uint32_t>& all = tape_.support(step);
    for (std::uint32_t k = entry.index; k < entry.index + entry.count; ++k) {
      const Step part = tape_.summands()[k].step;
      first_position_[k] = positions_.size();
      if (tape_.entry(part).support == entry.support) continue;
      if (positions_.size() > most_values) throw Declined{"too many values"};
      auto place = all.begin();
      for (const std::uint32_t symbol : tape_.support(part)) {
        place = std::lower_bound(place, all.end(), symbol);
        positions_.push_back(static_cast<std::uint32_t>(place - all.begin()));
      }
    }
  }
}

std::uint64_t TapeValues::work_of(Step step) const {
  const Entry& entry = tape_.entry(step);
  std::uint64_t result = width_of(step);
  for (std::uint32_t k = 0; k < entry.count; ++k)
    result += width_of(tape_.summands()[entry.index + k].step);
  return result;
}

void TapeValues::calculate(Step step) {
  const Entry& entry = tape_.entry(step);
  Residue* result = &values_[places_[step]];
  const std::size_t width = width_of(step);
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
      for (std::size_t k = 0; k < width; ++k) result[k] = modulus_->product(other[k], factor);
      return;
    }
    case Tape::Operation::sum:
      std::fill(result, result + width, 0);
      for (std::uint32_t k = entry.index; k < entry.index + entry.count; ++k)
        add(k, entry.support, result);
  }
}

void TapeValues::add(std::uint32_t summand, std::uint32_t support, Residue* result) const {
  const auto [step, negative] = tape_.summands()[summand];
  const Residue* value = &values_[places_[step]];
  const std::size_t width = width_of(step);
  if (tape_.entry(step).support == support) {
    for (std::size_t k = 0; k < width; ++k) result[k] = combined(result[k], value[k], negative);
    return;
  }
  result[0] = combined(result[0], value[0], negative);
  const std::uint32_t* position = positions_.data() + first_position_[summand];
  for (std::size_t k = 1; k < width; ++k) {
    Residue& own = result[1 + position[k - 1]];
    own = combined(own, value[k], negative);
  }
}

std::optional<std::size_t> TapeValues::first_part_not_zero(Step step) const {
  const Residue* value = &values_[places_[step]];
  const Residue* end = value + width_of(step);
  const Residue* found = std::find_if(value, end, [](Residue part) { return part != 0; });
  if (found == end) return std::nullopt;
  return static_cast<std::size_t>(found - value);
}

}  // namespace patchproof
