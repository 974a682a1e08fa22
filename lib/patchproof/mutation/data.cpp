#include <patchproof/mutation/data.hpp>

#include <algorithm>
#include <set>

#include <patchproof/mutation/numeric.hpp>
#include <patchproof/mutation/shape.hpp>

namespace patchproof {

namespace {

using syntax::Declarator;
using syntax::Expression;
using syntax::ExpressionPointer;
using syntax::Statement;
using Kind = Expression::Kind;

// Smoother than anything a case asks for.
const std::string smooth = " : C^9";

bool is_numeric(const Expression& e) { return value_of(e).has_value(); }

bool is_point(const Expression& e) {
  return e.kind == Kind::tuple && std::all_of(e.operands.begin(), e.operands.end(),
                                              [](const auto& c) { return is_numeric(*c); });
}

/// Numbers, and functions of these parameters.
bool is_made_of_numbers(const Expression& e, const std::set<std::string>& parameters) {
  static const std::set<std::string> known{"sin", "cos", "exp", "sqrt"};
  if (e.kind == Kind::name) return parameters.contains(e.text) || e.text == "pi";
  if (e.kind == Kind::call) {
    return e.operands.front()->kind == Kind::name && known.contains(e.operands.front()->text) &&
           std::all_of(e.arguments.begin(), e.arguments.end(), [&](const syntax::Argument& a) {
             return a.value && is_made_of_numbers(*a.value, parameters);
           });
  }
  if (e.kind == Kind::index || e.kind == Kind::matrix || e.kind == Kind::hole ||
      e.kind == Kind::component)
    return false;
  return std::all_of(e.operands.begin(), e.operands.end(),
                     [&](const auto& o) { return is_made_of_numbers(*o, parameters); });
}

void add_entry(const std::string& owner, const ExpressionPointer& entry, Data& data) {
  if (entry->kind != Kind::tuple) {
    data.numbers.push_back({owner, entry->span, entry, 0});
    return;
  }
  for (std::size_t c = 0; c < entry->operands.size(); ++c)
    data.numbers.push_back(
        {owner, entry->span, entry->operands[c], entry->operands.size() - 1 - c});
}

std::vector<Rational> coordinates(const Expression& entry) {
  std::vector<Rational> result;
  if (entry.kind == Kind::tuple)
    for (const auto& c : entry.operands) result.push_back(value_of(*c).value());
  else
    result.push_back(value_of(entry).value());
  return result;
}

std::string space_of(const Expression& entry) {
  return entry.kind == Kind::tuple ? " in R^" + std::to_string(entry.operands.size()) : "";
}

std::string last_of(std::size_t count) { return "0.." + std::to_string(count - 1); }

// `matrix V = [...]`
bool add_matrix(const std::string& name, const Expression& value, Data& data) {
  const std::size_t width = value.rows.front().size();
  const Expression& first = *value.rows.front().front();
  NumericNet net;
  for (std::size_t i = 0; i < value.rows.size(); ++i) {
    std::vector<std::vector<Rational>> row;
    for (std::size_t j = 0; j < value.rows[i].size(); ++j) {
      const ExpressionPointer& entry = value.rows[i][j];
      if (!is_numeric(*entry) && !is_point(*entry)) return false;
      row.push_back(coordinates(*entry));
      if (row.back().size() != coordinates(first).size()) return false;
      const std::string index =
          value.rows.size() == 1 ? std::to_string(j) : std::to_string(i) + "," + std::to_string(j);
      add_entry(name + "[" + index + "]", entry, data);
    }
    net.push_back(std::move(row));
  }
  data.for_symbols = std::string{first.kind == Kind::tuple ? "point " : "scalar "} + name + "[" +
                     (value.rows.size() == 1 ? "" : last_of(value.rows.size()) + ", ") +
                     last_of(width) + "]" + space_of(first);
  data.shape = shape_of(name, net);
  return true;
}

bool add_value(const std::string& name, const ExpressionPointer& value, Data& data) {
  if (!is_numeric(*value) && !is_point(*value)) return false;
  add_entry(name, value, data);
  data.for_symbols = (value->kind == Kind::tuple ? "point " : "scalar ") + name + space_of(*value);
  return true;
}

bool add_function(const Declarator& d, Data& data) {
  std::set<std::string> parameters;
  std::string formals;
  for (const syntax::Name& name : d.parameters) {
    parameters.insert(name.text);
    formals += (formals.empty() ? "" : ", ") + name.text;
  }
  if (!is_made_of_numbers(*d.value, parameters)) return false;
  const bool is_scalar = d.value->kind != Kind::tuple;
  static const std::vector<std::string> keywords{"curve", "patch", "volume"};
  if (parameters.size() > keywords.size() || (is_scalar && parameters.size() > 1)) return false;
  add_entry(d.name.text, d.value, data);
  data.is_function = true;
  data.for_symbols = (is_scalar ? "scalar" : keywords[parameters.size() - 1]) + " " + d.name.text +
                     "(" + formals + ")" + space_of(*d.value) + smooth;
  return true;
}

std::string raised(const Expression& e, long by) { return to_text(value_of(e).value() + by); }

}  // namespace

std::optional<Data> data_of(const Statement& statement) {
  using Word = Statement::Kind;
  const bool may_hold = statement.kind == Word::matrix || statement.kind == Word::let ||
                        statement.kind == Word::curve || statement.kind == Word::patch ||
                        statement.kind == Word::volume || statement.kind == Word::scalar;
  if (!may_hold || statement.declarators.size() != 1) return std::nullopt;
  const Declarator& d = statement.declarators.front();
  if (!d.value) return std::nullopt;
  Data data;
  data.name = d.name.text;
  data.statement = &statement;
  const bool is_data = !d.parameters.empty()           ? add_function(d, data)
                       : d.value->kind == Kind::matrix ? add_matrix(data.name, *d.value, data)
                                                       : add_value(data.name, d.value, data);
  if (!is_data) return std::nullopt;
  return data;
}

std::vector<Data> data_of(const syntax::Case& written) {
  std::vector<Data> result;
  for (const Statement& statement : written.statements)
    if (std::optional<Data> data = data_of(statement)) result.push_back(std::move(*data));
  return result;
}

std::vector<Edit> small_changes(const Data& data, const Datum& datum) {
  const Expression& e = *datum.value;
  const auto to = [&](const std::string& text) {
    return Edit{e.span.begin, e.span.end, text, "datum"};
  };
  if (!data.is_function) return {to(raised(e, 1)), to(raised(e, 3))};
  // It vanishes on the boundary, so that curves which close stay closed.
  std::string bump;
  std::string slope;
  for (const syntax::Name& name : data.statement->declarators.front().parameters) {
    bump += (bump.empty() ? "" : "*") + name.text + "*(1-" + name.text + ")";
    slope += (slope.empty() ? "" : "*") + name.text;
  }
  const bool is_zero = e.kind == Kind::number && e.number == 0;
  const std::string start = is_zero ? "" : as_text(e.span) + " + ";
  return {to(start + bump), to(start + slope)};
}

}  // namespace patchproof
