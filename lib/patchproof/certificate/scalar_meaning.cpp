#include <patchproof/certificate/scalar_meaning.hpp>

#include <stdexcept>

#include <patchproof/certificate/scalars.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;

const char* sign_of(Kind kind) {
  switch (kind) {
    case Kind::sum: return "+";
    case Kind::difference: return "-";
    case Kind::product: return "*";
    case Kind::quotient: return "/";
    default: return nullptr;
  }
}

const char* derivative_word(std::size_t arity, std::size_t slot) {
  if (arity == 1) return "Derive";
  if (arity == 2) return slot == 0 ? "D_u" : "D_v";
  return slot == 0 ? "D_1" : slot == 1 ? "D_2" : "D_3";
}

}  // namespace

const ScalarMeaning::Scope* ScalarMeaning::with(const SymbolPointer& symbol, std::size_t level,
                                                const Scope* outer) {
  return &scopes_.emplace_back(Scope{symbol->ordinal, level, nullptr, nullptr, outer});
}

std::size_t ScalarMeaning::free(const Coordinate& coordinate) {
  const RocqVariable& variable = names_.variable(coordinate.symbol);
  const auto level = levels_.find(variable.name);
  if (level == levels_.end())
    throw NotScalar{"nothing binds " + coordinate.symbol->name};
  std::string head = "#" + std::to_string(level->second);
  const std::vector<unsigned>& indices = names_.indices(coordinate.symbol);
  for (const unsigned index : indices) head += " " + std::to_string(index);
  if (variable.indices > indices.size()) head += " " + std::to_string(coordinate.index);
  return table_.number_of(head);
}

std::size_t ScalarMeaning::variable(const Coordinate& coordinate, const Scope* scope,
                                    std::size_t depth) {
  for (; scope; scope = scope->outer)
    if (scope->ordinal == coordinate.symbol->ordinal)
      return scope->value ? of(scope->value, scope->value_scope, depth)
                          : table_.number_of("#" + std::to_string(scope->level));
  return free(coordinate);
}

std::size_t ScalarMeaning::of(const ScalarPointer& scalar, const Scope* scope, std::size_t depth) {
  const auto key = std::make_tuple(static_cast<const void*>(scalar.get()),
                                   static_cast<const void*>(scope), depth);
  const auto known = values_.find(key);
  if (known != values_.end()) return known->second;
  const std::size_t result =
      sign_of(scalar->kind) ? from_the_left(scalar, scope, depth) : computed(*scalar, scope, depth);
  seen_.push_back(scalar);
  values_.emplace(key, result);
  return result;
}

// Long sums hang to the left, deeper than functions should call each other.
std::size_t ScalarMeaning::from_the_left(const ScalarPointer& scalar, const Scope* scope,
                                         std::size_t depth) {
  std::vector<const Scalar*> spine;
  const ScalarPointer* left = &scalar;
  for (; sign_of((*left)->kind); left = &(*left)->children[0]) spine.push_back(left->get());
  std::size_t result = of(*left, scope, depth);
  for (std::size_t k = spine.size(); k-- > 0;)
    result = table_.number_of(sign_of(spine[k]->kind),
                              {result, of(spine[k]->children[1], scope, depth)});
  return result;
}

std::size_t ScalarMeaning::computed(const Scalar& scalar, const Scope* scope, std::size_t depth) {
  const auto child = [&](std::size_t k) { return of(scalar.children[k], scope, depth); };
  switch (scalar.kind) {
    case Kind::integer: return table_.number_of(scalar.number.str());
    case Kind::variable: return variable(scalar.coordinate, scope, depth);
    case Kind::opposite: return table_.number_of("opposite", {child(0)});
    case Kind::power: return table_.number_of("^ " + std::to_string(scalar.order), {child(0)});
    case Kind::bernstein:
      return table_.number_of(
          "Bern " + std::to_string(scalar.order) + " " + std::to_string(scalar.index), {child(0)});
    case Kind::root: return table_.number_of("sqrt", {child(0)});
    case Kind::application: return application(scalar.function, scalar.children, scope, depth);
    case Kind::integral:
      return table_.number_of(
          "RInt",
          {abstraction({scalar.formal}, scalar.children[2], scope, depth), child(0), child(1)});
    case Kind::named: return child(0);
    default: throw std::logic_error{"a pair that is no pair"};
  }
}

std::size_t ScalarMeaning::application(const ScalarFunctionPointer& function,
                                       const Arguments& arguments, const Scope* scope,
                                       std::size_t depth) {
  std::vector<std::size_t> values;
  for (const ScalarPointer& argument : arguments) values.push_back(of(argument, scope, depth));
  const ScalarFunction* head = function.get();
  while (head->kind == ScalarFunction::Kind::named) head = head->inner.get();
  if (head->kind != ScalarFunction::Kind::lambda) {
    std::vector<std::size_t> parts{this->function(function, scope, depth)};
    parts.insert(parts.end(), values.begin(), values.end());
    return table_.number_of("apply", std::move(parts));
  }
  if (head->formals.size() != arguments.size())
    throw std::logic_error{"a function with another number of arguments"};
  seen_functions_.push_back(function);
  // Equal arguments make the same scope, so that what is shared is looked at once.
  const auto [entry, is_new] = applications_.try_emplace(
      std::make_tuple(static_cast<const void*>(head), static_cast<const void*>(scope), depth,
                      std::move(values)),
      scope);
  if (is_new)
    for (std::size_t k = 0; k < arguments.size(); ++k)
      entry->second = &scopes_.emplace_back(
          Scope{head->formals[k]->ordinal, 0, arguments[k], scope, entry->second});
  return of(head->body, entry->second, depth);
}

std::size_t ScalarMeaning::abstraction(const std::vector<SymbolPointer>& formals,
                                       const ScalarPointer& body, const Scope* scope,
                                       std::size_t depth) {
  for (std::size_t k = 0; k < formals.size(); ++k) scope = with(formals[k], depth + k, scope);
  std::size_t result = of(body, scope, depth + formals.size());
  for (std::size_t k = 0; k < formals.size(); ++k) result = table_.number_of("fun R", {result});
  return result;
}

std::size_t ScalarMeaning::function(const ScalarFunctionPointer& function, const Scope* scope,
                                    std::size_t depth) {
  switch (function->kind) {
    case ScalarFunction::Kind::unknown: return free(function->coordinate);
    case ScalarFunction::Kind::lambda:
      return abstraction(function->formals, function->body, scope, depth);
    case ScalarFunction::Kind::derivative:
      return table_.number_of(derivative_word(function->arity, function->slot),
                              {this->function(function->inner, scope, depth)});
    default: return this->function(function->inner, scope, depth);
  }
}

}  // namespace patchproof
