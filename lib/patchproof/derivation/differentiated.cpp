#include <patchproof/derivation/differentiated.hpp>

#include <patchproof/derivation/shapes.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

Term scalar(Operation operation, std::vector<Term> children, TermNode::Payload payload = {}) {
  return make_term(operation, Type::scalar(), std::move(children), std::move(payload));
}

// Thrown where there is no rule.
struct NoRule {};

class Differentiation {
 public:
  explicit Differentiation(const SymbolPointer& symbol) : symbol_{symbol} {}

  Term of(const Term& value) {
    if (!free_symbols(value).contains(symbol_->ordinal)) return zero_of(value.type());
    switch (value.operation()) {
      case Operation::symbol: return number_term(1);
      case Operation::tuple:
      case Operation::matrix:
      case Operation::component:
      case Operation::entry:
      case Operation::slice:
      case Operation::transpose:
      case Operation::negation: return each_child(value);
      case Operation::sum: return sum(value);
      case Operation::product:
      case Operation::matrix_product:
      case Operation::dot:
      case Operation::cross: return product(value);
      case Operation::quotient: return quotient(value);
      case Operation::power: return power(value);
      case Operation::sine: return chain(scalar(Operation::cosine, {value.child(0)}), value.child(0));
      case Operation::cosine:
        return chain(scalar(Operation::negation, {scalar(Operation::sine, {value.child(0)})}),
                     value.child(0));
      case Operation::exponential: return chain(value, value.child(0));
      case Operation::square_root:
        return chain(scalar(Operation::quotient,
                            {number_term(1), scalar(Operation::product, {number_term(2), value})}),
                     value.child(0));
      case Operation::bernstein: return bernstein(value);
      case Operation::apply: return apply(value);
      case Operation::definition: return of(value.child(0));
      default: throw NoRule{};
    }
  }

 private:
  Term each_child(const Term& value) {
    std::vector<Term> children;
    for (const Term& child : value.children()) children.push_back(of(child));
    return make_term(value.operation(), value.type(), std::move(children), value->payload);
  }

  Term sum(const Term& value) {
    std::vector<Term> parts;
    for (const Term& child : value.children())
      if (Term part = of(child); !is_zero_term(part)) parts.push_back(std::move(part));
    return sum_of(std::move(parts), value.type());
  }

  // One summand for each factor that is not constant.
  Term product(const Term& value) {
    std::vector<Term> parts;
    for (std::size_t k = 0; k < value.children().size(); ++k) {
      std::vector<Term> factors = value.children();
      factors[k] = of(factors[k]);
      if (is_zero_term(factors[k])) continue;
      parts.push_back(make_term(value.operation(), value.type(), std::move(factors)));
    }
    return sum_of(std::move(parts), value.type());
  }

  Term quotient(const Term& value) {
    const Term& above = value.child(0);
    const Term& below = value.child(1);
    const Term slope = of(above);
    if (!free_symbols(below).contains(symbol_->ordinal))
      return make_term(Operation::quotient, value.type(), {slope, below});
    const Term first = make_term(Operation::product, value.type(), {below, slope});
    const Term second = make_term(Operation::product, value.type(), {of(below), above});
    const Term difference =
        make_term(Operation::sum, value.type(),
                  {first, make_term(Operation::negation, value.type(), {second})});
    return make_term(Operation::quotient, value.type(),
                     {difference, scalar(Operation::power, {below}, 2L)});
  }

  Term power(const Term& value) {
    const long n = value.exponent();
    const Term lower = n == 2 ? value.child(0) : scalar(Operation::power, {value.child(0)}, n - 1);
    return scalar(Operation::product, {number_term(n), lower, of(value.child(0))});
  }

  Term chain(const Term& outer, const Term& inner) {
    return scalar(Operation::product, {of(inner), outer});
  }

  // n (B_{i-1}^{n-1} - B_i^{n-1}). Source: Farin, Curves and Surfaces for CAGD, derivatives of Bézier
  // curves.
  Term bernstein(const Term& value) {
    const int n = value.indices().at(0);
    const int i = value.indices().at(1);
    std::vector<Term> parts;
    if (i > 0) parts.push_back(scalar(Operation::bernstein, {value.child(0)}, Indices{n - 1, i - 1}));
    if (i < n)
      parts.push_back(scalar(Operation::negation, {scalar(Operation::bernstein, {value.child(0)},
                                                          Indices{n - 1, i})}));
    if (n == 0 || parts.empty()) return number_term(0);
    const Term difference = parts.size() == 1 ? parts.front() : scalar(Operation::sum, parts);
    return scalar(Operation::product, {number_term(n), difference, of(value.child(0))});
  }

  Term apply(const Term& value) {
    const Term& function = value.child(0);
    const std::size_t count = value.children().size() - 1;
    std::vector<Term> parts;
    for (std::size_t k = 0; k < count; ++k) {
      const Term inner = of(value.child(k + 1));
      if (is_zero_term(inner)) continue;
      Indices orders(count, 0);
      orders[k] = 1;
      std::vector<Term> children = value.children();
      children.front() = derivative_of(function, orders);
      const Term outer = make_term(Operation::apply, value.type(), std::move(children));
      parts.push_back(is_number(inner, 1)
                          ? outer
                          : make_term(Operation::product, value.type(), {inner, outer}));
    }
    return sum_of(std::move(parts), value.type());
  }

  const SymbolPointer& symbol_;
};

}  // namespace

std::optional<Term> differentiated(const Term& value, const SymbolPointer& symbol) {
  try {
    return Differentiation{symbol}.of(value);
  } catch (const NoRule&) {
    return std::nullopt;
  }
}

}  // namespace patchproof
