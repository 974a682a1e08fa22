#pragma once

#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include <patchproof/grid/tape.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// Writes down how the components of a term are calculated.
///
/// Derivatives are Taylor coefficients: the body of the function is calculated with u + e in place
/// of u, without the powers of e above the order of the derivative. Such a truncated series is a
/// list of steps, one for each combination of powers.
class TapeBuilder {
 public:
  /// Scalars in `variables` are variables of the polynomials, as parameters are; other ones, and
  /// points, are symbols.
  TapeBuilder(Tape& tape, const std::vector<KnownValue>& known, bool scalars_are_variables);
  ~TapeBuilder();

  /// The components of a value, none of them a series.
  /// @throws Declined for what is no such polynomial.
  std::vector<Tape::Step> components(const Term& term);

  /// The variables that were met, and the number of the first component of each symbol, by
  /// ordinal.
  const std::map<unsigned, std::uint32_t>& variables() const { return variables_; }
  const std::map<unsigned, std::uint32_t>& symbols() const { return first_symbol_; }

 private:
  using Step = Tape::Step;
  /// Basis functions of higher degrees are left to others.
  static constexpr int highest_basis = 256;
  using Series = std::vector<Step>;
  using Value = std::vector<Series>;

  /// What the formal parameters are while a body is calculated, and what was calculated already.
  struct Scope {
    /// The highest power of each small quantity, the first one counting fastest.
    std::vector<unsigned> orders;
    std::size_t length = 1;
    std::map<unsigned, Series> formals;
    std::unordered_map<const TermNode*, Value> values;
    /// Of each base those that were needed, from the power 0 on.
    std::map<Series, std::vector<Series>> powers;
    /// Bernstein polynomials by argument, degree and index.
    std::map<std::tuple<Series, int, int>, Series> bernstein;
  };

  const Value& value(const Term& term, Scope& scope);
  Value computed(const Term& term, Scope& scope);
  Value of_symbol(const Term& term, Scope& scope);
  Value of_apply(const Term& term, Scope& scope);
  Value of_product(const Term& term, Scope& scope);
  Value of_quotient(const Term& term, Scope& scope);
  Value of_power(const Term& term, Scope& scope);
  Value of_block(const Term& term, const Indices& at, Scope& scope);
  Value of_transpose(const Term& term, Scope& scope);
  Value of_matrix_product(const Term& term, Scope& scope);
  Value of_dot(const Term& term, Scope& scope);
  Value of_cross(const Term& term, Scope& scope);
  Value of_polynomial(const std::vector<Rational>& coefficients, const Series& argument,
                      Scope& scope);
  Value of_bernstein(const Term& term, Scope& scope);
  Series bernstein(const Series& argument, int degree, int index, Scope& scope);

  /// Counts what writing down costs.
  /// @throws Declined when it is too much.
  void spend(std::size_t work);
  Series constant(Step step, const Scope& scope) const;
  Series sum(const std::vector<std::pair<const Series*, bool>>& parts);
  Series product(const Series& a, const Series& b, const Scope& scope);
  Series power(const Series& base, unsigned exponent, Scope& scope);

  Tape& tape_;
  std::map<unsigned, Term> known_;
  std::set<unsigned> resolving_;
  bool scalars_are_variables_;
  std::map<unsigned, std::uint32_t> variables_;
  /// Ordinal -> number of the first component.
  std::map<unsigned, std::uint32_t> first_symbol_;
  std::size_t symbols_ = 0;
  std::size_t work_ = 0;
  std::unique_ptr<Scope> outermost_;
  /// Scopes of applications, by what is applied to what.
  std::map<std::vector<std::uintptr_t>, std::unique_ptr<Scope>> scopes_;
};

}  // namespace patchproof
