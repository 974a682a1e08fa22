#include <patchproof/grid/tape_builder.hpp>

#include <algorithm>

#include <patchproof/kernel/basis.hpp>

namespace patchproof {

namespace {

constexpr std::size_t longest_series = 256;
constexpr std::size_t most_components = 150'000;
constexpr std::size_t most_work = 10'000'000;
constexpr long highest_power = 64;

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
  spend(1);
  Value result = computed(term, scope);
  if (result.size() > most_components) throw Declined{"too many components"};
  return scope.values.emplace(term.address(), std::move(result)).first->second;
}

void TapeBuilder::spend(std::size_t work) {
  work_ += work;
  if (work_ > most_work) throw Declined{"too much to be written down"};
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
    // Nothing in it means a formal parameter.
    Value result = value(known->second, *outermost_);
    for (Series& component : result) component.resize(scope.length, Tape::zero);
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
    spend((1 + scope.formals.size() + formals.size()) * longest);
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

}  // namespace patchproof
