#include <recheck/field.hpp>

#include <algorithm>
#include <bit>
#include <numeric>

namespace recheck {

Atom Field::fresh(const Key& key, Meaning meaning) {
  Meter::require(meanings_.size() + 1, meter_.limits().atoms, "atoms");
  Meter::require(meaning.depth, meter_.limits().depth, "functions within functions");
  const Atom atom = static_cast<Atom>(meanings_.size());
  meanings_.push_back(std::move(meaning));
  found_[key].push_back(atom);
  return atom;
}

Atom Field::coordinate(SymbolIndex symbol, std::size_t index) {
  const Key key{Meaning::Kind::coordinate, symbol, index, {}};
  const auto found = found_.find(key);
  if (found != found_.end()) return found->second.front();
  return fresh(key, {Meaning::Kind::coordinate, symbol, index, {}, {}, 0, 0});
}

Atom Field::slot(SymbolIndex function, std::size_t index) {
  const Key key{Meaning::Kind::slot, function, index, {}};
  const auto found = found_.find(key);
  if (found != found_.end()) return found->second.front();
  return fresh(key, {Meaning::Kind::slot, function, index, {}, {}, 0, 0});
}

bool Field::equal(const std::vector<Quotient>& a, const std::vector<Quotient>& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!difference(a[k], b[k]).numerator.empty()) return false;
  return true;
}

Atom Field::jet(SymbolIndex function, std::size_t index, const std::vector<std::size_t>& orders,
                const std::vector<Quotient>& arguments) {
  const std::size_t total = std::accumulate(orders.begin(), orders.end(), std::size_t{0});
  if (total > symbol(function).smoothness)
    throw Rejection{"a derivative of order " + std::to_string(total) + " of '" +
                    symbol(function).name + "', which is only assumed C^" +
                    std::to_string(symbol(function).smoothness)};
  const Key key{Meaning::Kind::jet, function, index, orders};
  // A copy: looking for equal arguments makes no atoms, but nothing here should depend on that.
  const std::vector<Atom> alike = found_[key];
  for (const Atom atom : alike)
    if (equal(arguments, meaning(atom).arguments)) return atom;
  std::size_t depth = 1;
  for (const Quotient& argument : arguments)
    for (const Atom atom : atoms_within(argument, *this))
      depth = std::max(depth, meaning(atom).depth + 1);
  return fresh(key, {Meaning::Kind::jet, function, index, orders, arguments, 0, depth});
}

Quotient Field::sum(const Quotient& a, const Quotient& b) {
  if (a.numerator.empty()) return b;
  if (b.numerator.empty()) return a;
  Quotient result{{}, a.denominator};
  for (const auto& [factor, exponent] : b.denominator) {
    unsigned& common = result.denominator[factor];
    common = std::max(common, exponent);
  }
  const auto expanded = [&](const Quotient& part) {
    Polynomial numerator = part.numerator;
    for (const auto& [factor, exponent] : result.denominator) {
      const auto own = part.denominator.find(factor);
      const unsigned has = own == part.denominator.end() ? 0 : own->second;
      for (unsigned k = has; k < exponent; ++k)
        numerator = recheck::product(numerator, factor, meter_);
    }
    return numerator;
  };
  result.numerator = without_squares_of_roots(recheck::sum(expanded(a), expanded(b), meter_));
  if (result.numerator.empty()) result.denominator.clear();
  return result;
}

Quotient Field::difference(const Quotient& a, const Quotient& b) { return sum(a, multiple(b, -1)); }

Quotient Field::product(const Quotient& a, const Quotient& b) {
  Quotient result{without_squares_of_roots(recheck::product(a.numerator, b.numerator, meter_)),
                  a.denominator};
  if (result.numerator.empty()) return {};
  for (const auto& [factor, exponent] : b.denominator) {
    unsigned& total = result.denominator[factor];
    total += exponent;
    Meter::require(total, meter_.limits().exponent, "exponents");
  }
  return result;
}

Quotient Field::power(const Quotient& a, std::size_t exponent) {
  Meter::require(exponent, meter_.limits().exponent, "exponents");
  // The binary digits of the exponent, the greatest first.
  Quotient result = number(1);
  for (std::size_t digit = std::bit_floor(exponent); digit > 0; digit /= 2) {
    result = product(result, result);
    if ((exponent & digit) != 0) result = product(result, a);
  }
  return result;
}

Polynomial Field::monic(const Polynomial& a) { return scaled(a, 1 / a.rbegin()->second, meter_); }

Quotient Field::inverse(const Quotient& a) {
  if (a.numerator.empty()) throw Rejection{"division by zero"};
  Quotient result = number(1 / a.numerator.rbegin()->second);
  for (const auto& [factor, exponent] : a.denominator)
    for (unsigned k = 0; k < exponent; ++k)
      result.numerator = recheck::product(result.numerator, factor, meter_);
  result.numerator = without_squares_of_roots(std::move(result.numerator));
  if (!recheck::number_in(a.numerator)) result.denominator.emplace(monic(a.numerator), 1);
  return result;
}

Quotient Field::multiple(const Quotient& a, const Rational& factor) {
  if (factor == 0) return {};
  return {scaled(a.numerator, factor, meter_), a.denominator};
}

std::optional<Rational> number_in(const Quotient& a) {
  if (!a.denominator.empty()) return std::nullopt;
  return number_in(a.numerator);
}

std::set<Atom> atoms_within(const Quotient& a, const Field& field) {
  std::set<Atom> result;
  std::vector<Atom> open;
  const auto visit = [&](const Quotient& part) {
    const auto take = [&](const Polynomial& polynomial) {
      for (const Atom atom : atoms_in(polynomial))
        if (result.insert(atom).second) open.push_back(atom);
    };
    take(part.numerator);
    for (const auto& [factor, exponent] : part.denominator) take(factor);
  };
  visit(a);
  while (!open.empty()) {
    const Atom atom = open.back();
    open.pop_back();
    for (const Quotient& argument : field.meaning(atom).arguments) visit(argument);
  }
  return result;
}

}  // namespace recheck
