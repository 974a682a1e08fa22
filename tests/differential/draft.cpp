#include "draft.hpp"

#include <stdexcept>

namespace patchproof::differential {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

void declare_symbols(Draft& draft, const std::vector<std::string>& names) {
  for (const std::string& name : names) draft.python.push_back(name + " = Symbol('" + name + "')");
}

/// A polynomial with a variable for each coefficient. Degree 5 is more than any claim can tell from
/// an arbitrary function; in two parameters 3 is.
Value generic_polynomial(const std::string& name, std::size_t arity) {
  Value result = value_of_number(0);
  const unsigned degree = arity == 1 ? 5 : 3;
  for (unsigned i = 0; i <= degree; ++i)
    for (unsigned j = 0; j <= (arity == 1 ? 0 : degree); ++j) {
      const PlainPolynomial powers =
          product(power(plain_variable("$1"), i), power(plain_variable("$2"), j));
      const std::string coefficient = name + "#" + std::to_string(i) + std::to_string(j);
      result = plus(result, times(value_of_variable(coefficient), {1, 1, {{powers}}}));
    }
  return result;
}

std::string in_quotes(const std::string& text) { return "'" + text + "'"; }

std::string keyword_of(const DeclaredFunction& function) {
  if (function.type == Type::scalar) return "scalar";
  return function.formals.size() == 1 ? "curve" : "patch";
}

}  // namespace

void declare_parameters(Draft& draft, const std::vector<std::string>& names) {
  draft.declarations.push_back("param " + listed(names) + " in [0, 1]");
  declare_symbols(draft, names);
  for (const std::string& name : names) {
    draft.parameters.push_back(name);
    draft.scalars.push_back(scalar_name(name));
  }
}

void declare_scalars(Draft& draft, const std::vector<std::string>& names) {
  draft.declarations.push_back("scalar " + listed(names));
  declare_symbols(draft, names);
  for (const std::string& name : names) draft.scalars.push_back(scalar_name(name));
}

void declare_points(Draft& draft, const std::vector<std::string>& names) {
  draft.declarations.push_back("point " + listed(names));
  declare_symbols(draft, names);
  for (const std::string& name : names) draft.points.push_back(point_name(name));
}

void declare_points_in_space(Draft& draft, const std::vector<std::string>& names) {
  draft.declarations.push_back("point " + listed(names) + " in R^3");
  for (const std::string& name : names) {
    draft.python.push_back(name + " = in_space('" + name + "')");
    Value value{3, 1, {}};
    for (const std::string component : {".x", ".y", ".z"}) {
      value.entries.push_back({plain_variable(name + component)});
      draft.scalars.push_back(scalar_name(name + component));
    }
    draft.environment.values[name] = value;
    draft.points.push_back(point_name(name));
  }
}

void declare_array(Draft& draft, const std::string& name, std::size_t rows, std::size_t columns,
                   Type type) {
  const bool list = columns == 0;
  const auto range = [](std::size_t n) { return "0.." + std::to_string(n - 1); };
  draft.declarations.push_back((type == Type::scalar ? "scalar " : "point ") + name + "[" +
                               range(rows) + (list ? "" : ", " + range(columns)) + "]");
  draft.python.push_back(name + " = net('" + name + "', " + std::to_string(rows) + ", " +
                         std::to_string(list ? 1 : columns) + ")");
  Value value{rows, list ? 1 : columns, {}};
  draft.arrays.push_back(name);
  std::vector<Node> elements;
  for (std::size_t i = 0; i < value.rows; ++i)
    for (std::size_t j = 0; j < value.columns; ++j) {
      std::vector<Node> indices{number(static_cast<long>(i))};
      if (!list) indices.push_back(number(static_cast<long>(j)));
      elements.push_back(element(name, indices, type));
      value.entries.push_back({plain_variable(case_text(elements.back()))});
    }
  draft.environment.values[name] = value;
  std::vector<Node>& words = type == Type::scalar ? draft.scalars : draft.points;
  words.insert(words.end(), elements.begin(), elements.end());
}

void declare_unknown(Draft& draft, const DeclaredFunction& function) {
  draft.declarations.push_back(keyword_of(function) + " " + function.name + "(" +
                               listed(function.formals) + ") : C^" +
                               std::to_string(function.order + 1));
  draft.python.push_back(function.name + " = unknown('" + function.name + "', " +
                         std::to_string(function.formals.size()) + ")");
  draft.environment.functions[function.name] = {
      function.formals.size(), generic_polynomial(function.name, function.formals.size())};
  draft.functions.push_back(function);
}

void declare_defined(Draft& draft, const DeclaredFunction& function, const Node& definition) {
  // A scalar function is named with `let`, which knows no derivatives by name.
  const bool named = function.type == Type::scalar;
  draft.declarations.push_back((named ? "let" : keyword_of(function)) + " " + function.name + "(" +
                               listed(function.formals) + ") = " + case_text(definition));
  std::string formals;
  for (const std::string& name : function.formals) formals += in_quotes(name) + ", ";
  draft.python.push_back(function.name + " = defined((" + formals + "), " +
                         python_text(definition) + ")");
  draft.environment.functions[function.name] =
      function_meaning(definition, draft.environment, function.formals);
  draft.functions.push_back(function);
}

void assume_different(Draft& draft, const Node& a, const Node& b) {
  draft.declarations.push_back("assume different: " + case_text(a) + " != " + case_text(b));
  draft.divisors.push_back(difference(a, b));
  draft.divisors.push_back(difference(b, a));
}

bool is_list(const Draft& draft, const std::string& array) {
  return draft.environment.values.at(array).columns == 1;
}

Node element_of(const Draft& draft, const std::string& array, std::size_t i, std::size_t j) {
  const std::string text = is_list(draft, array)
                               ? array + "[" + std::to_string(i) + "]"
                               : array + "[" + std::to_string(i) + ", " + std::to_string(j) + "]";
  for (const std::vector<Node>* words : {&draft.points, &draft.scalars})
    for (const Node& word : *words)
      if (word->kind == Kind::element && case_text(word) == text) return word;
  throw std::logic_error{"no element " + text};
}

}  // namespace patchproof::differential
