#include <patchproof/grid/tape.hpp>

#include <algorithm>

namespace patchproof {

namespace {

constexpr std::size_t most_steps = 400'000;
constexpr std::size_t most_in_supports = 4'000'000;
constexpr unsigned most_bits = 1200;
constexpr unsigned highest_degree = 10'000;

// The finalizer of splitmix64: every bit of the result depends on every bit of the words.
// Source: Steele, Lea, Flood: Fast splittable pseudorandom number generators (2014).
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  std::uint64_t x = hash * 0x9e3779b97f4a7c15U + word + 1;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

std::uint64_t hash_of(Tape::Operation operation, std::uint64_t first, std::uint64_t second) {
  return mixed(mixed(static_cast<std::uint64_t>(operation), first), second);
}

std::uint64_t hash_of(const Rational& value) {
  if (!value.is_small())
    return hash_of(Tape::Operation::number, std::hash<std::string>{}(to_text(value)), 0);
  return hash_of(Tape::Operation::number, static_cast<std::uint64_t>(value.words().numerator),
                 static_cast<std::uint64_t>(value.words().denominator));
}

}  // namespace

template <typename Same>
Tape::Step Tape::found(std::uint64_t hash, const Same& same) const {
  if (index_.empty()) return zero;
  const std::size_t mask = index_.size() - 1;
  for (std::size_t place = hash & mask; index_[place] != zero; place = (place + 1) & mask) {
    const Entry& entry = entries_[index_[place]];
    if (entry.hash == hash && same(entry)) return index_[place];
  }
  return zero;
}

void Tape::enter(Step step) {
  const std::size_t mask = index_.size() - 1;
  std::size_t place = entries_[step].hash & mask;
  while (index_[place] != zero) place = (place + 1) & mask;
  index_[place] = step;
}

Tape::Step Tape::add(std::uint64_t hash, Entry entry) {
  if (entries_.size() >= most_steps) throw Declined{"too many steps"};
  if (entry.norm != 0 && msb(entry.norm) > most_bits) throw Declined{"numbers that are too large"};
  if (msb(entry.denominator) > most_bits) throw Declined{"numbers that are too large"};
  const auto step = static_cast<Step>(entries_.size());
  entry.hash = hash;
  entries_.push_back(std::move(entry));
  if (2 * entries_.size() > index_.size()) {
    constexpr std::size_t least = 64;
    index_.assign(std::max(least, 2 * index_.size()), zero);
    for (Step one = 0; one < step; ++one) enter(one);
  }
  enter(step);
  return step;
}

std::uint32_t Tape::support_number(std::vector<std::uint32_t> symbols) {
  const auto number = static_cast<std::uint32_t>(supports_.size());
  const auto [found, is_new] = support_numbers_.emplace(std::move(symbols), number);
  if (is_new) {
    symbols_in_supports_ += found->first.size();
    if (symbols_in_supports_ > most_in_supports) throw Declined{"too many symbols"};
    supports_.push_back(found->first);
  }
  return found->second;
}

std::uint32_t Tape::common_support(const std::vector<Summand>& summands) {
  std::vector<std::uint32_t> numbers;
  for (const Summand& summand : summands)
    if (has_symbols(summand.step)) numbers.push_back(entries_[summand.step].support);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (numbers.empty()) return 0;
  if (numbers.size() == 1) return numbers.front();
  std::vector<std::uint32_t> symbols;
  for (const std::uint32_t number : numbers)
    symbols.insert(symbols.end(), supports_[number].begin(), supports_[number].end());
  std::sort(symbols.begin(), symbols.end());
  symbols.erase(std::unique(symbols.begin(), symbols.end()), symbols.end());
  return support_number(std::move(symbols));
}

Tape::Step Tape::number(const Rational& value) {
  if (value == 0) return zero;
  const std::uint64_t hash = hash_of(value);
  const auto same = [&](const Entry& entry) {
    return entry.operation == Operation::number && entry.number == value;
  };
  if (const Step step = found(hash, same); step != zero) return step;
  Entry entry{Operation::number};
  entry.number = value;
  entry.denominator = denominator(value);
  entry.norm = boost::multiprecision::abs(numerator(value));
  return add(hash, std::move(entry));
}

Tape::Step Tape::variable(std::uint32_t index) {
  if (index >= most_variables) throw Declined{"too many variables"};
  const std::uint64_t hash = hash_of(Operation::variable, index, 0);
  const auto same = [&](const Entry& entry) {
    return entry.operation == Operation::variable && entry.index == index;
  };
  if (const Step step = found(hash, same); step != zero) return step;
  Entry entry{Operation::variable};
  entry.index = index;
  entry.degrees[index] = 1;
  entry.norm = 1;
  return add(hash, std::move(entry));
}

Tape::Step Tape::symbol(std::uint32_t index) {
  const std::uint64_t hash = hash_of(Operation::symbol, index, 0);
  const auto same = [&](const Entry& entry) {
    return entry.operation == Operation::symbol && entry.index == index;
  };
  if (const Step step = found(hash, same); step != zero) return step;
  Entry entry{Operation::symbol};
  entry.index = index;
  entry.support = support_number({index});
  entry.norm = 1;
  return add(hash, std::move(entry));
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
  std::uint64_t hash = static_cast<std::uint64_t>(Operation::sum);
  for (const auto& [step, negative] : summands)
    hash = mixed(hash, 2 * std::uint64_t{step} + (negative ? 1 : 0));
  const auto same = [&](const Entry& entry) {
    return entry.operation == Operation::sum && entry.count == summands.size() &&
           std::equal(summands.begin(), summands.end(), summands_.begin() + entry.index);
  };
  if (const Step step = found(hash, same); step != zero) return step;
  Entry entry{Operation::sum};
  entry.index = static_cast<std::uint32_t>(summands_.size());
  entry.count = static_cast<std::uint32_t>(summands.size());
  entry.support = common_support(summands);
  for (const Summand& summand : summands) {
    const Entry& part = entries_[summand.step];
    for (std::size_t k = 0; k < most_variables; ++k)
      entry.degrees[k] = std::max(entry.degrees[k], part.degrees[k]);
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
  return add(hash, std::move(entry));
}

Tape::Step Tape::product(Step a, Step b) {
  if (a == zero || b == zero) return zero;
  if (is_number(a) && is_number(b)) return number(number_of(a) * number_of(b));
  if (is_number(a) && number_of(a) == 1) return b;
  if (is_number(b) && number_of(b) == 1) return a;
  if (has_symbols(a) && has_symbols(b)) throw Declined{"a product of symbols"};
  if (has_symbols(b) || (!has_symbols(a) && a < b)) std::swap(a, b);
  const std::uint64_t hash = hash_of(Operation::product, a, b);
  const auto same = [&](const Entry& entry) {
    return entry.operation == Operation::product && entry.first == a && entry.second == b;
  };
  if (const Step step = found(hash, same); step != zero) return step;
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
  entry.support = left.support;
  entry.denominator = left.denominator * right.denominator;
  entry.norm = left.norm * right.norm;
  return add(hash, std::move(entry));
}

}  // namespace patchproof
