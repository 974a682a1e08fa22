#include <patchproof/grid/tape_builder.hpp>

#include <algorithm>

#include <patchproof/kernel/basis.hpp>

namespace patchproof {

namespace {

constexpr std::size_t longest_series = 256;
constexpr std::size_t most_components = 10'000;
constexpr long highest_power = 64;
constexpr int highest_basis = 64;

// A function as a lambda and the orders of the derivatives that are taken of it.
struct Differentiated {
  const Term* lambda = nullptr;
  std::vector<unsigned> orders;
};

Differentiated differentiated(const Term& function) {
  Differentiated result;
  for (const Term* term = &function;; term = &term->child(0)) {
    if (term->operation() == Operation::lambda) {
      result.lambda = term;
      result.orders.resize(term->formals().size());
      return result;
    }
    if (term->operation() == Operation::derivative) {
      const Indices& orders = term->indices();
      result.orders.resize(std::max(result.orders.size(), orders.size()));
      for (std::size_t k = 0; k < orders.size(); ++k)
        result.orders[k] += static_cast<unsigned>(orders[k]);
    } else if (term->operation() != Operation::definition) {
      throw Declined{"an unknown function"};
    }
  }
}

}  // namespace

/// What the formal parameters are while a body is calculated, and what was calculated already.
struct TapeBuilder::Scope {
  /// The highest power of each small quantity, the first one counting fastest.
  std::vector<unsigned> orders;
  std::size_t length = 1;
  std::map<unsigned, Series> formals;
  std::unordered_map<const TermNode*, Value> values;
};

TapeBuilder::TapeBuilder(Tape& tape, const std::vector<KnownValue>& known,
                         bool scalars_are_variables)
    : tape_{tape},
      scalars_are_variables_{scalars_are_variables},
      outermost_{std::make_unique<Scope>()} {
  for (const KnownValue& one : known) known_.emplace(one.symbol->ordinal, one.value);
}

TapeBuilder::~TapeBuilder() = default;

std::vector<Tape::Step> TapeBuilder::components(const Term& term) {
  std::vector<Step> result;
  for (const Series& series : value(term, *outermost_)) result.push_back(series.front());
  return result;
}

const TapeBuilder::Value& TapeBuilder::value(const Term& term, Scope& scope) {
  const auto found = scope.values.find(term.address());
  if (found != scope.values.end()) return found->second;
  Value result = computed(term, scope);
  if (result.size() > most_components) throw Declined{"too many components"};
  return scope.values.emplace(term.address(), std::move(result)).first->second;
}

TapeBuilder::Value TapeBuilder::computed(const Term& term, Scope& scope) {
  switch (term.operation()) {
    case Operation::number:
      return Value(term.type().component_count(), constant(tape_.number(term.number()), scope));
    case Operation::symbol:
      return of_symbol(term, scope);
    case Operation::definition:
      return value(term.child(0), scope);
    case Operation::tuple:
    case Operation::matrix: {
      Value result;
      for (const Term& child : term.children()) {
        const Value& part = value(child, scope);
        result.insert(result.end(), part.begin(), part.end());
      }
      return result;
    }
    case Operation::sum: {
      std::vector<const Value*> parts;
      for (const Term& child : term.children()) parts.push_back(&value(child, scope));
      Value result;
      for (std::size_t k = 0; k < parts.front()->size(); ++k) {
        std::vector<std::pair<const Series*, bool>> summands;
        for (const Value* part : parts) summands.emplace_back(&part->at(k), false);
        result.push_back(sum(summands));
      }
      return result;
    }
    case Operation::negation: {
      Value result;
      for (const Series& component : value(term.child(0), scope))
        result.push_back(sum({{&component, true}}));
      return result;
    }
    case Operation::product:
      return of_product(term, scope);
    case Operation::quotient:
      return of_quotient(term, scope);
    case Operation::power:
      return of_power(term, scope);
    case Operation::apply:
      return of_apply(term, scope);
    case Operation::component:
      return {value(term.child(0), scope).at(static_cast<std::size_t>(term.indices().at(0)))};
    case Operation::entry: {
      const Indices& at = term.indices();
      return of_block(term.child(0), {at.at(0), at.at(0), at.at(1), at.at(1)}, scope);
    }
    case Operation::slice:
      return of_block(term.child(0), term.indices(), scope);
    case Operation::transpose:
      return of_transpose(term.child(0), scope);
    case Operation::matrix_product:
      return of_matrix_product(term, scope);
    case Operation::dot:
      return of_dot(term, scope);
    case Operation::cross:
      return of_cross(term, scope);
    case Operation::bernstein:
      return of_bernstein(term, scope);
    case Operation::bspline_basis: {
      if (term.basis_function().degree > highest_basis) throw Declined{"too high a degree"};
      const Value& argument = value(term.child(0), scope);
      return of_polynomial(basis_coefficients(term.basis_function()), argument.front(), scope);
    }
    default:
      throw Declined{"no polynomial"};
  }
}

TapeBuilder::Value TapeBuilder::of_symbol(const Term& term, Scope& scope) {
  const Symbol& symbol = *term.symbol();
  const auto formal = scope.formals.find(symbol.ordinal);
  if (formal != scope.formals.end()) return {formal->second};
  if (const auto known = known_.find(symbol.ordinal); known != known_.end()) {
    if (!resolving_.insert(symbol.ordinal).second) throw Declined{"defined by itself"};
    Value result = value(known->second, scope);
    resolving_.erase(symbol.ordinal);
    return result;
  }
  const bool is_variable = symbol.role == Symbol::Role::parameter ||
                           (symbol.role == Symbol::Role::scalar && scalars_are_variables_);
  if (is_variable && symbol.type.is_scalar()) {
    const auto index = static_cast<std::uint32_t>(variables_.size());
    return {
        constant(tape_.variable(variables_.emplace(symbol.ordinal, index).first->second), scope)};
  }
  if (symbol.role != Symbol::Role::scalar && symbol.role != Symbol::Role::point)
    throw Declined{"an unknown function"};
  const auto [first, is_new] =
      first_symbol_.emplace(symbol.ordinal, static_cast<std::uint32_t>(symbols_));
  const std::size_t count = symbol.type.component_count();
  if (is_new) symbols_ += count;
  Value result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back(constant(tape_.symbol(first->second + static_cast<std::uint32_t>(k)), scope));
  return result;
}

TapeBuilder::Value TapeBuilder::of_apply(const Term& term, Scope& scope) {
  const Differentiated function = differentiated(term.child(0));
  const Formals& formals = function.lambda->formals();
  std::vector<std::uintptr_t> key{reinterpret_cast<std::uintptr_t>(function.lambda->address()),
                                  reinterpret_cast<std::uintptr_t>(&scope)};
  std::vector<Series> arguments;
  std::size_t longest = scope.length;
  for (std::size_t k = 0; k < formals.size(); ++k) {
    arguments.push_back(value(term.child(k + 1), scope).at(0));
    key.insert(key.end(), arguments.back().begin(), arguments.back().end());
    key.push_back(function.orders[k]);
    longest *= function.orders[k] + 1;
    if (longest > longest_series) throw Declined{"derivatives of too high an order"};
  }
  std::unique_ptr<Scope>& inner = scopes_[key];
  if (!inner) {
    inner = std::make_unique<Scope>();
    inner->orders = scope.orders;
    inner->length = longest;
    // Everything from outside is a series without the new quantities.
    inner->formals = scope.formals;
    for (auto& [ordinal, series] : inner->formals) series.resize(longest, Tape::zero);
    std::size_t stride = scope.length;
    for (std::size_t k = 0; k < formals.size(); ++k) {
      Series series = arguments[k];
      series.resize(longest, Tape::zero);
      if (function.orders[k] > 0) {
        inner->orders.push_back(function.orders[k]);
        series[stride] = tape_.number(1);
        stride *= function.orders[k] + 1;
      }
      inner->formals[formals[k]->ordinal] = std::move(series);
    }
  }
  // The coefficient of the highest powers, times their factorials.
  Rational factor{1};
  for (const unsigned order : function.orders)
    for (unsigned k = 2; k <= order; ++k) factor *= Rational{k};
  const Step factor_step = tape_.number(factor);
  Value result;
  for (const Series& component : value(function.lambda->child(0), *inner)) {
    Series series{component.end() - static_cast<std::ptrdiff_t>(scope.length), component.end()};
    for (Step& step : series) step = tape_.product(step, factor_step);
    result.push_back(std::move(series));
  }
  return result;
}

TapeBuilder::Value TapeBuilder::of_product(const Term& term, Scope& scope) {
  Value result = value(term.child(0), scope);
  for (std::size_t k = 1; k < term.children().size(); ++k) {
    const Value& next = value(term.child(k), scope);
    Value both;
    for (std::size_t i = 0; i < std::max(result.size(), next.size()); ++i)
      both.push_back(
          product(result[result.size() == 1 ? 0 : i], next[next.size() == 1 ? 0 : i], scope));
    result = std::move(both);
  }
  return result;
}

TapeBuilder::Value TapeBuilder::of_quotient(const Term& term, Scope& scope) {
  const Series& divisor = value(term.child(1), scope).front();
  for (std::size_t k = 0; k < divisor.size(); ++k)
    if (!tape_.is_number(divisor[k]) || (k > 0 && divisor[k] != Tape::zero))
      throw Declined{"a quotient"};
  const Rational number = tape_.number_of(divisor.front());
  if (number == 0) throw Declined{"division by zero"};
  const Series inverse = constant(tape_.number(1 / number), scope);
  Value result;
  for (const Series& component : value(term.child(0), scope))
    result.push_back(product(component, inverse, scope));
  return result;
}

TapeBuilder::Value TapeBuilder::of_power(const Term& term, Scope& scope) {
  const long exponent = term.exponent();
  if (exponent < 0 || exponent > highest_power) throw Declined{"such a power"};
  return {power(value(term.child(0), scope).front(), static_cast<unsigned>(exponent), scope)};
}

TapeBuilder::Value TapeBuilder::of_block(const Term& term, const Indices& at, Scope& scope) {
  const Value& matrix = value(term, scope);
  const std::size_t width = term.type().inner->component_count();
  Value result;
  for (int i = at.at(0); i <= at.at(1); ++i)
    for (int j = at.at(2); j <= at.at(3); ++j)
      for (std::size_t k = 0; k < width; ++k)
        result.push_back(
            matrix.at(static_cast<std::size_t>(i * term.type().columns + j) * width + k));
  return result;
}

TapeBuilder::Value TapeBuilder::of_transpose(const Term& term, Scope& scope) {
  Value result;
  for (int j = 0; j < term.type().columns; ++j) {
    const Value column = of_block(term, {0, term.type().rows - 1, j, j}, scope);
    result.insert(result.end(), column.begin(), column.end());
  }
  return result;
}

TapeBuilder::Value TapeBuilder::of_matrix_product(const Term& term, Scope& scope) {
  Value left = value(term.child(0), scope);
  const auto rows = static_cast<std::size_t>(term.child(0).type().rows);
  auto inner = static_cast<std::size_t>(term.child(0).type().columns);
  std::size_t left_width = term.child(0).type().inner->component_count();
  for (std::size_t n = 1; n < term.children().size(); ++n) {
    const Value& right = value(term.child(n), scope);
    const auto columns = static_cast<std::size_t>(term.child(n).type().columns);
    const std::size_t right_width = term.child(n).type().inner->component_count();
    const std::size_t width = std::max(left_width, right_width);
    Value both;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        for (std::size_t k = 0; k < width; ++k) {
          std::vector<Series> products;
          for (std::size_t l = 0; l < inner; ++l)
            products.push_back(product(
                left.at((i * inner + l) * left_width + (left_width > 1 ? k : 0)),
                right.at((l * columns + j) * right_width + (right_width > 1 ? k : 0)), scope));
          std::vector<std::pair<const Series*, bool>> summands;
          for (const Series& one : products) summands.emplace_back(&one, false);
          both.push_back(sum(summands));
        }
    left = std::move(both);
    inner = columns;
    left_width = width;
  }
  return left;
}

TapeBuilder::Value TapeBuilder::of_dot(const Term& term, Scope& scope) {
  const Value& a = value(term.child(0), scope);
  const Value& b = value(term.child(1), scope);
  std::vector<Series> products;
  for (std::size_t k = 0; k < a.size(); ++k) products.push_back(product(a[k], b.at(k), scope));
  std::vector<std::pair<const Series*, bool>> summands;
  for (const Series& one : products) summands.emplace_back(&one, false);
  return {sum(summands)};
}

TapeBuilder::Value TapeBuilder::of_cross(const Term& term, Scope& scope) {
  const Value& a = value(term.child(0), scope);
  const Value& b = value(term.child(1), scope);
  Value result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Series first = product(a.at((k + 1) % 3), b.at((k + 2) % 3), scope);
    const Series second = product(a.at((k + 2) % 3), b.at((k + 1) % 3), scope);
    result.push_back(sum({{&first, false}, {&second, true}}));
  }
  return result;
}

// c0 + c1*t + c2*t^2 + …
TapeBuilder::Value TapeBuilder::of_polynomial(const std::vector<Rational>& coefficients,
                                              const Series& argument, const Scope& scope) {
  std::vector<Series> parts;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    parts.push_back(product(power(argument, static_cast<unsigned>(k), scope),
                            constant(tape_.number(coefficients[k]), scope), scope));
  std::vector<std::pair<const Series*, bool>> summands;
  for (const Series& part : parts) summands.emplace_back(&part, false);
  return {sum(summands)};
}

TapeBuilder::Value TapeBuilder::of_bernstein(const Term& term, Scope& scope) {
  const int degree = term.indices().at(0);
  const int index = term.indices().at(1);
  if (index < 0 || index > degree) return {constant(Tape::zero, scope)};
  if (degree > highest_basis) throw Declined{"too high a degree"};
  const Series& t = value(term.child(0), scope).front();
  const Series one = constant(tape_.number(1), scope);
  const Series rest = sum({{&one, false}, {&t, true}});
  Rational choices{1};
  for (int k = 1; k <= index; ++k) choices = choices * Rational{degree - index + k} / Rational{k};
  const Series both = product(power(t, static_cast<unsigned>(index), scope),
                              power(rest, static_cast<unsigned>(degree - index), scope), scope);
  return {product(both, constant(tape_.number(choices), scope), scope)};
}

TapeBuilder::Series TapeBuilder::constant(Step step, const Scope& scope) const {
  Series result(scope.length, Tape::zero);
  result.front() = step;
  return result;
}

TapeBuilder::Series TapeBuilder::sum(const std::vector<std::pair<const Series*, bool>>& parts) {
  Series result(parts.front().first->size(), Tape::zero);
  for (std::size_t k = 0; k < result.size(); ++k) {
    std::vector<Tape::Summand> summands;
    for (const auto& [series, negative] : parts) summands.push_back({(*series)[k], negative});
    result[k] = tape_.sum(std::move(summands));
  }
  return result;
}

TapeBuilder::Series TapeBuilder::product(const Series& a, const Series& b, const Scope& scope) {
  if (scope.length == 1) return {tape_.product(a.front(), b.front())};
  std::vector<std::vector<Tape::Summand>> parts(scope.length);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == Tape::zero) continue;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (b[j] == Tape::zero) continue;
      std::size_t rest_i = i;
      std::size_t rest_j = j;
      bool fits = true;
      for (const unsigned order : scope.orders) {
        fits = fits && rest_i % (order + 1) + rest_j % (order + 1) <= order;
        rest_i /= order + 1;
        rest_j /= order + 1;
      }
      // The powers add up without carrying, and so do their places.
      if (fits) parts[i + j].push_back({tape_.product(a[i], b[j]), false});
    }
  }
  Series result(scope.length, Tape::zero);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = tape_.sum(std::move(parts[k]));
  return result;
}

TapeBuilder::Series TapeBuilder::power(const Series& base, unsigned exponent, const Scope& scope) {
  Series result = constant(tape_.number(1), scope);
  for (unsigned k = 0; k < exponent; ++k) result = product(result, base, scope);
  return result;
}

}  // namespace patchproof
