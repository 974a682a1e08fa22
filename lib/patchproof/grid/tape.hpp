#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// Thrown where the method does not apply; nothing is known then.
class Declined : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A calculation written down step by step: polynomials over the rational numbers in a few
/// variables, each of degree at most one in the symbols together.
///
/// Each step knows what is needed to decide whether it is zero: a bound for its degree in each
/// variable, and for the size of its coefficients.
class Tape {
 public:
  using Step = std::uint32_t;
  static constexpr Step zero = static_cast<Step>(-1);
  static constexpr std::size_t most_variables = 6;

  enum class Operation { number, variable, symbol, sum, product };

  struct Summand {
    Step step;
    bool negative;
    friend bool operator==(const Summand&, const Summand&) = default;
  };

  struct Entry {
    Operation operation;
    /// Variable or symbol: which one. Sum: where its summands begin.
    std::uint32_t index = 0;
    /// Sum: how many summands. Product: the two factors; the second has no symbols.
    std::uint32_t count = 0;
    Step first = zero;
    Step second = zero;
    Rational number = {};
    std::array<std::uint16_t, most_variables> degrees{};
    /// Which symbols occur: the number of a list of them.
    std::uint32_t support = 0;
    /// denominator * polynomial has whole coefficients, whose absolute values add up to `norm` at
    /// most.
    Integer denominator = 1;
    Integer norm = 0;
    /// Of the calculation: where the index looks for it first.
    std::uint64_t hash = 0;
  };

  Step number(const Rational& value);
  Step variable(std::uint32_t index);
  Step symbol(std::uint32_t index);
  Step sum(std::vector<Summand> summands);
  /// @throws Declined when both factors have symbols.
  Step product(Step a, Step b);
  Step difference(Step a, Step b) { return sum({{a, false}, {b, true}}); }

  const std::vector<Entry>& entries() const { return entries_; }
  const Entry& entry(Step step) const { return entries_[step]; }
  const std::vector<Summand>& summands() const { return summands_; }
  /// The symbols that occur in a step, in order.
  const std::vector<std::uint32_t>& support(Step step) const {
    return supports_[entries_[step].support];
  }
  bool has_symbols(Step step) const { return entries_[step].support != 0; }
  bool is_number(Step step) const {
    return step == zero || entries_[step].operation == Operation::number;
  }
  Rational number_of(Step step) const { return step == zero ? Rational{} : entries_[step].number; }

 private:
  /// The step that is already there with this hash and this property, or `zero`.
  template <typename Same>
  Step found(std::uint64_t hash, const Same& same) const;
  Step add(std::uint64_t hash, Entry entry);
  std::uint32_t support_number(std::vector<std::uint32_t> symbols);
  std::uint32_t common_support(const std::vector<Summand>& summands);
  void enter(Step step);

  std::vector<Entry> entries_;
  std::vector<Summand> summands_;
  /// Lists of symbols, each there once; the first is empty.
  std::vector<std::vector<std::uint32_t>> supports_{{}};
  std::map<std::vector<std::uint32_t>, std::uint32_t> support_numbers_{{{}, 0}};
  std::size_t symbols_in_supports_ = 0;
  /// The same calculation is written down once: a hash table of all steps with places to spare,
  /// whose number is a power of two; `zero` where there is none.
  std::vector<Step> index_;
};

}  // namespace patchproof
