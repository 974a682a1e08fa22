#include <patchproof/derivation/tidied.hpp>

#include <algorithm>
#include <map>
#include <unordered_map>

#include <patchproof/derivation/matrix_terms.hpp>
#include <patchproof/derivation/shapes.hpp>
#include <patchproof/term/binding.hpp>
#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

constexpr long highest_power_of_number = 64;
// Signs of summands that are looked for again.
constexpr std::size_t longest_repeated = 200;

class Tidying {
 public:
  Term of(const Term& term) {
    const auto known = done_.find(term.address());
    if (known != done_.end()) return known->second;
    seen_.push_back(term);
    return done_.emplace(term.address(), compute(term)).first->second;
  }

 private:
  Term compute(const Term& term) {
    switch (term.operation()) {
      case Operation::number:
      case Operation::pi:
      case Operation::symbol:
      case Operation::lambda:
      case Operation::integral:
      case Operation::derivative: return term;
      default: break;
    }
    std::vector<Term> children;
    bool changed = false;
    const std::size_t count = term.operation() == Operation::definition ? 0 : term.children().size();
    for (std::size_t k = 0; k < count; ++k) {
      children.push_back(of(term.child(k)));
      changed = changed || children.back().address() != term.child(k).address();
    }
    if (term.operation() == Operation::definition) return definition(term);
    const Term rebuilt = changed ? make_term(term.operation(), term.type(), children, term->payload,
                                             term.span())
                                 : term;
    switch (term.operation()) {
      case Operation::sum: return sum(rebuilt);
      case Operation::negation: return negated(rebuilt.child(0));
      case Operation::product: return product(rebuilt);
      case Operation::quotient: return quotient(rebuilt);
      case Operation::power: return power(rebuilt);
      case Operation::sine: return is_number(rebuilt.child(0), 0) ? number_term(0) : rebuilt;
      case Operation::cosine:
      case Operation::exponential: return is_number(rebuilt.child(0), 0) ? number_term(1) : rebuilt;
      case Operation::bernstein: return bernstein(rebuilt);
      case Operation::matrix_product: return matrix_product(rebuilt);
      case Operation::transpose: return transpose(rebuilt);
      case Operation::component: return component(rebuilt);
      case Operation::entry: return entry(rebuilt);
      case Operation::dot: return dot(rebuilt);
      default: return rebuilt;
    }
  }

  // A value such as H03(0): its arguments are numbers, so it is one.
  Term definition(const Term& term) {
    if (term.type().is_function()) return term;
    const Term value = of(term.child(0));
    return value.is_number() ? value : term;
  }

  static Term negated(const Term& term) {
    if (term.is_number()) return number_term(-term.number());
    if (is_zero_term(term)) return term;
    if (term.operation() == Operation::negation) return term.child(0);
    return make_term(Operation::negation, term.type(), {term});
  }

  static void collect(const Term& term, bool negative, std::vector<Term>& parts, Rational& number) {
    if (term.operation() == Operation::sum) {
      for (const Term& child : term.children()) collect(child, negative, parts, number);
      return;
    }
    if (term.operation() == Operation::negation)
      return collect(term.child(0), !negative, parts, number);
    if (term.is_number()) {
      number += negative ? Rational{-term.number()} : term.number();
      return;
    }
    if (!is_zero_term(term)) parts.push_back(negative ? negated(term) : term);
  }

  static bool has_bound_variables(const Term& term) {
    if (term.operation() == Operation::lambda) return true;
    return std::any_of(term.children().begin(), term.children().end(), has_bound_variables);
  }

  // e + e is 2e. What cancels is left standing: a reader wants to see it go.
  static std::vector<Term> repeated_once(const std::vector<Term>& parts) {
    std::vector<Term> result;
    std::vector<int> counts;
    std::map<std::string, std::size_t> places;
    for (const Term& part : parts) {
      const std::string text = to_text(part, 2 * longest_repeated);
      // Long texts are cut off, and bound variables are called as others are: such texts may be
      // those of different terms.
      const bool comparable = text.size() <= longest_repeated && !has_bound_variables(part);
      std::string key = text;
      for (const auto& [ordinal, symbol] : free_symbols(part)) key += " " + std::to_string(ordinal);
      const auto [place, fresh] =
          comparable ? places.try_emplace(key, result.size()) : std::pair{places.end(), true};
      if (fresh) {
        result.push_back(part);
        counts.push_back(1);
      } else {
        ++counts[place->second];
      }
    }
    for (std::size_t k = 0; k < result.size(); ++k)
      if (counts[k] > 1)
        result[k] = product(make_term(Operation::product, result[k].type(),
                                      {number_term(counts[k]), result[k]}));
    return result;
  }

  static Term sum(const Term& term) {
    std::vector<Term> parts;
    Rational number = 0;
    collect(term, false, parts, number);
    parts = repeated_once(parts);
    if (!term.type().is_scalar()) return sum_of(std::move(parts), term.type());
    // 1 - u, but u - 1.
    const bool number_first = term.child(0).is_number();
    if (number != 0)
      parts.insert(number_first ? parts.begin() : parts.end(), number_term(number));
    return sum_of(std::move(parts), term.type());
  }

  static Term product(const Term& term) {
    Rational number = 1;
    std::vector<Term> factors;
    bool negative = false;
    gather(term, factors, number, negative);
    if (number == 0) return zero_of(term.type());
    for (const Term& factor : factors)
      if (is_zero_term(factor)) return zero_of(term.type());
    if (negative) number = -number;
    negative = number < 0;
    if (negative) number = -number;
    if (factors.empty()) return number_term(negative ? Rational{-number} : number);
    if (number != 1) factors.insert(factors.begin(), number_term(number));
    const Term result = factors.size() == 1 ? factors.front()
                                            : make_term(Operation::product, term.type(), factors);
    return negative ? negated(result) : result;
  }

  static void gather(const Term& term, std::vector<Term>& factors, Rational& number,
                     bool& negative) {
    for (const Term& child : term.children()) {
      if (child.is_number())
        number *= child.number();
      else if (child.operation() == Operation::negation) {
        negative = !negative;
        if (child.child(0).operation() == Operation::product)
          gather(child.child(0), factors, number, negative);
        else
          factors.push_back(child.child(0));
      } else if (child.operation() == Operation::product)
        gather(child, factors, number, negative);
      else
        factors.push_back(child);
    }
  }

  static Term quotient(const Term& term) {
    const Term& above = term.child(0);
    const Term& below = term.child(1);
    if (is_number(below, 0)) return term;
    if (is_zero_term(above) && below.is_number()) return zero_of(term.type());
    if (is_number(below, 1)) return above;
    if (below.is_number())
      return product(make_term(Operation::product, term.type(),
                               {number_term(1 / below.number()), above}));
    return term;
  }

  static Term power(const Term& term) {
    const Term& base = term.child(0);
    const long n = term.exponent();
    if (n == 0) return base.is_number() && base.number() == 0 ? term : number_term(1);
    if (n == 1) return base;
    if (!base.is_number() || n < 0 || n > highest_power_of_number) return term;
    Rational result = 1;
    for (long k = 0; k < n; ++k) result *= base.number();
    return number_term(result);
  }

  static Term bernstein(const Term& term) {
    const int n = term.indices().at(0);
    const int i = term.indices().at(1);
    if (n == 0) return number_term(1);
    if (!term.child(0).is_number() || n > highest_power_of_number) return term;
    const Rational t = term.child(0).number();
    Rational result = 1;
    for (int k = 0; k < i; ++k) result *= t * (n - k) / (k + 1);
    for (int k = 0; k < n - i; ++k) result *= 1 - t;
    return number_term(result);
  }

  static bool is_written_out(const Term& matrix) {
    return matrix.operation() == Operation::matrix;
  }

  Term matrix_product(const Term& term) {
    for (const Term& factor : term.children())
      if (!is_written_out(factor)) return term;
    Term result = term.child(0);
    for (std::size_t k = 1; k < term.children().size(); ++k)
      result = of(matrix_product_of(result, term.child(k)));
    if (term.type().is_matrix() || !result.type().is_matrix()) return result;
    return result.child(0);
  }

  static Term transpose(const Term& term) {
    return is_written_out(term.child(0)) ? transposed(term.child(0)) : term;
  }

  static Term component(const Term& term) {
    const Term& point = term.child(0);
    const auto k = static_cast<std::size_t>(term.indices().at(0));
    if (point.operation() != Operation::tuple || k >= point.children().size()) return term;
    return point.child(k);
  }

  static Term entry(const Term& term) {
    const Term& matrix = term.child(0);
    if (!is_written_out(matrix)) return term;
    const auto columns = static_cast<std::size_t>(matrix.type().columns);
    return matrix.child(static_cast<std::size_t>(term.indices().at(0)) * columns +
                        static_cast<std::size_t>(term.indices().at(1)));
  }

  Term dot(const Term& term) {
    const Term& a = term.child(0);
    const Term& b = term.child(1);
    if (a.operation() != Operation::tuple || b.operation() != Operation::tuple ||
        a.children().size() != b.children().size())
      return term;
    std::vector<Term> parts;
    for (std::size_t k = 0; k < a.children().size(); ++k)
      parts.push_back(
          make_term(Operation::product, Type::scalar(), {a.child(k), b.child(k)}));
    return of(sum_of(std::move(parts), Type::scalar()));
  }

  std::unordered_map<const TermNode*, Term> done_;
  std::vector<Term> seen_;
};

}  // namespace

Term tidied(const Term& term) { return Tidying{}.of(term); }

}  // namespace patchproof
