#include <map>

#include <recheck/node_reader.hpp>

namespace recheck {

namespace {

const std::vector<std::string_view>& role_names() {
  static const std::vector<std::string_view> names{"parameter", "scalar", "point", "function",
                                                   "bound"};
  return names;
}

Type value_type(const Place& place, const Limits& limits) {
  Type type;
  if (place.is_text()) {
    place.one_of({"scalar"});
    return type;
  }
  place.require_members({"point"});
  type.kind = Type::Kind::point;
  type.any = place["point"].is_text();
  if (type.any) {
    place["point"].one_of({"any"});
    return type;
  }
  type.dimension = place["point"].whole(limits.extent + 1);
  if (type.dimension == 0) place["point"].fail("a point has coordinates");
  return type;
}

Type type_at(const Place& place, const Limits& limits) {
  if (!place.has("function")) return value_type(place, limits);
  place.require_members({"function", "to"});
  const std::vector<Place> parameters = place["function"].items();
  for (const Place& parameter : parameters) parameter.text();
  if (parameters.empty() || parameters.size() > limits.extent)
    place["function"].fail("a wrong number of parameters");
  Type type = value_type(place["to"], limits);
  type.arguments = parameters.size();
  return type;
}

bool fits(Symbol::Role role, const Type& type) {
  switch (role) {
    case Symbol::Role::point:
      return type.kind == Type::Kind::point && !type.is_function();
    case Symbol::Role::function:
      return type.is_function();
    default:
      return type.is_scalar();
  }
}

Symbol symbol_of(const Place& place, const Limits& limits) {
  place.require_members({"name", "role", "type", "ordinal", "?smoothness"});
  Symbol symbol;
  symbol.name = place["name"].text();
  symbol.role = static_cast<Symbol::Role>(place["role"].one_of(role_names()));
  symbol.type = type_at(place["type"], limits);
  symbol.ordinal = place["ordinal"].whole(std::size_t{1} << 32);
  if (!fits(symbol.role, symbol.type)) place["type"].fail("the role wants another type");
  if (place.has("smoothness")) {
    if (symbol.role != Symbol::Role::function) place["smoothness"].fail("this is no function");
    symbol.smoothness = place["smoothness"].whole(limits.extent);
  }
  return symbol;
}

}  // namespace

std::vector<Symbol> symbols_of(const Place& table, const Limits& limits) {
  const std::vector<Place> places = table.items();
  if (places.size() > limits.symbols) table.fail("there are too many symbols");
  std::vector<Symbol> symbols;
  std::map<std::size_t, std::size_t> ordinals;
  for (const Place& place : places) {
    symbols.push_back(symbol_of(place, limits));
    const auto [other, fresh] = ordinals.emplace(symbols.back().ordinal, symbols.size() - 1);
    if (!fresh)
      place["ordinal"].fail(std::to_string(symbols.back().ordinal) + " is that of symbols[" +
                            std::to_string(other->second) + "] too");
  }
  return symbols;
}

}  // namespace recheck
