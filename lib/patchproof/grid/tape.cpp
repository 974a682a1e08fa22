#include <patchproof/grid/tape.hpp>

#include <algorithm>
#include <cstring>

namespace patchproof {

namespace {

constexpr std::size_t most_steps = 100'000;
constexpr unsigned most_bits = 1200;
constexpr unsigned highest_degree = 10'000;

template <typename Part>
void append(std::string& key, const Part& part) {
  char bytes[sizeof(Part)];
  std::memcpy(bytes, &part, sizeof(Part));
  key.append(bytes, sizeof(Part));
}

}  // namespace

Tape::Step Tape::add(const std::string& key, Entry entry) {
  if (entries_.size() >= most_steps) throw Declined{"too many steps"};
  if (entry.norm != 0 && msb(entry.norm) > most_bits) throw Declined{"numbers that are too large"};
  if (msb(entry.denominator) > most_bits) throw Declined{"numbers that are too large"};
  const auto step = static_cast<Step>(entries_.size());
  entries_.push_back(std::move(entry));
  known_.emplace(key, step);
  return step;
}

Tape::Step Tape::number(const Rational& value) {
  if (value == 0) return zero;
  std::string key = "n";
  if (value.is_small()) {
    append(key, value.words().numerator);
    append(key, value.words().denominator);
  } else {
    key += to_text(value);
  }
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Entry entry{Operation::number};
  entry.number = value;
  entry.denominator = denominator(value);
  entry.norm = boost::multiprecision::abs(numerator(value));
  return add(key, std::move(entry));
}

Tape::Step Tape::variable(std::uint32_t index) {
  if (index >= most_variables) throw Declined{"too many variables"};
  std::string key = "v";
  append(key, index);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Entry entry{Operation::variable};
  entry.index = index;
  entry.degrees[index] = 1;
  entry.norm = 1;
  return add(key, std::move(entry));
}

Tape::Step Tape::symbol(std::uint32_t index) {
  std::string key = "s";
  append(key, index);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Entry entry{Operation::symbol};
  entry.index = index;
  entry.low = index;
  entry.high = index + 1;
  entry.norm = 1;
  return add(key, std::move(entry));
}

Tape::Step Tape::sum(std::vector<Summand> summands) {
  std::erase_if(summands, [](const Summand& summand) { return summand.step == zero; });
  if (summands.empty()) return zero;
  if (summands.size() == 1 && !summands.front().negative) return summands.front().step;
  if (std::all_of(summands.begin(), summands.end(),
                  [&](const Summand& summand) { return is_number(summand.step); })) {
    Rational total;
    for (const auto& [step, negative] : summands)
      total += negative ? -number_of(step) : number_of(step);
    return number(total);
  }
  std::sort(summands.begin(), summands.end(), [](const Summand& a, const Summand& b) {
    return a.step != b.step ? a.step < b.step : a.negative < b.negative;
  });
  std::string key = "+";
  for (const Summand& summand : summands) {
    append(key, summand.step);
    key += summand.negative ? '-' : '+';
  }
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Entry entry{Operation::sum};
  entry.index = static_cast<std::uint32_t>(summands_.size());
  entry.count = static_cast<std::uint32_t>(summands.size());
  for (const Summand& summand : summands) {
    const Entry& part = entries_[summand.step];
    for (std::size_t k = 0; k < most_variables; ++k)
      entry.degrees[k] = std::max(entry.degrees[k], part.degrees[k]);
    if (part.low < part.high) {
      entry.low = entry.low == entry.high ? part.low : std::min(entry.low, part.low);
      entry.high = std::max(entry.high, part.high);
    }
    // a/d + b/e = (a * m/d + b * m/e)/m for the least common multiple m.
    if (part.denominator == entry.denominator) {
      entry.norm += part.norm;
      continue;
    }
    const Integer common = lcm(entry.denominator, part.denominator);
    entry.norm =
        entry.norm * (common / entry.denominator) + part.norm * (common / part.denominator);
    entry.denominator = common;
  }
  summands_.insert(summands_.end(), summands.begin(), summands.end());
  return add(key, std::move(entry));
}

Tape::Step Tape::product(Step a, Step b) {
  if (a == zero || b == zero) return zero;
  if (is_number(a) && is_number(b)) return number(number_of(a) * number_of(b));
  if (is_number(a) && number_of(a) == 1) return b;
  if (is_number(b) && number_of(b) == 1) return a;
  const auto has_symbols = [&](Step step) { return entries_[step].low < entries_[step].high; };
  if (has_symbols(a) && has_symbols(b)) throw Declined{"a product of symbols"};
  if (has_symbols(b) || (!has_symbols(a) && a < b)) std::swap(a, b);
  std::string key = "*";
  append(key, a);
  append(key, b);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Entry entry{Operation::product};
  const Entry& left = entries_[a];
  const Entry& right = entries_[b];
  entry.first = a;
  entry.second = b;
  for (std::size_t k = 0; k < most_variables; ++k) {
    const unsigned degree = unsigned{left.degrees[k]} + right.degrees[k];
    if (degree > highest_degree) throw Declined{"too high a degree"};
    entry.degrees[k] = static_cast<std::uint16_t>(degree);
  }
  entry.low = left.low;
  entry.high = left.high;
  entry.denominator = left.denominator * right.denominator;
  entry.norm = left.norm * right.norm;
  return add(key, std::move(entry));
}

}  // namespace patchproof
