#include "meaning.hpp"

#include <stdexcept>

#include "constructions.hpp"

namespace patchproof::differential {
namespace {

/// The exact number a literal is: "12", "3/7", "0.125".
Rational number_meaning(const std::string& text) {
  const std::size_t slash = text.find('/');
  const Rational above = *number_from_text(text.substr(0, slash));
  if (slash == std::string::npos) return above;
  return above / *number_from_text(text.substr(slash + 1));
}

std::size_t index_meaning(const Node& node, const Environment& environment) {
  const Value value = meaning(node, environment);
  return static_cast<std::size_t>(numerator(plain_value(value.entries.at(0).above)));
}

/// The parameter in which a curve is written that a construction takes in this place.
std::string parameter_of_argument(const std::string& construction, std::size_t index) {
  if (construction == "ruled_in_u") return "v";
  if (construction.find("coons") != std::string::npos && index >= 2) return "v";
  if (construction == "translation_surface" && index == 1) return "v";
  return "u";
}

PlainSpline spline_meaning(const Node& node, const Environment& environment) {
  if (node->kind == Kind::name) return environment.splines.at(node->text);
  PlainSpline spline = spline_meaning(node->operands[0], environment);
  if (node->text == "elevate_degree") return spline;
  // A knot more cuts the piece it lies in.
  const Rational knot = number_meaning(node->operands[1]->text);
  for (std::size_t k = 0; k < spline.pieces.size(); ++k) {
    const Rational length = spline.breaks[k + 1] - spline.breaks[k];
    const Rational cut = (knot - spline.breaks[k]) / length;
    if (cut <= 0 || cut >= 1) continue;
    const Function whole = spline.pieces[k];
    const auto part = [&](const Rational& from, const Rational& to) {
      const Value t = plus(value_of_number(from),
                           times(value_of_number(to - from), value_of_variable(formal(0))));
      return Function{1, applied(whole, {t})};
    };
    spline.pieces[k] = part(0, cut);
    const auto next = static_cast<std::ptrdiff_t>(k + 1);
    spline.pieces.insert(spline.pieces.begin() + next, part(cut, 1));
    spline.breaks.insert(spline.breaks.begin() + next, knot);
    return spline;
  }
  throw std::logic_error{"no new knot"};
}

Function function_of_call(const Node& node, const Environment& environment) {
  if (node->text == "segment")
    return spline_meaning(node->operands[0], environment)
        .pieces.at(index_meaning(node->operands[1], environment));
  const bool of_functions = node->text.find("coons") != std::string::npos ||
                            node->text.rfind("ruled", 0) == 0 ||
                            node->text == "translation_surface" || node->text == "hermite_loft";
  std::vector<Given> given;
  for (std::size_t i = 0; i < node->operands.size(); ++i) {
    const Node& operand = node->operands[i];
    const bool scalar = node->text == "ruled_over" && i >= 2;
    if (of_functions && !scalar)
      given.push_back(
          {{}, function_meaning(operand, environment, {parameter_of_argument(node->text, i)})});
    else
      given.push_back({meaning(operand, environment), {}});
  }
  return construction(node->text, given);
}

Value value_of_apply(const Node& node, const Environment& environment) {
  Function function = function_meaning(node->operands[0], environment, {});
  std::vector<Value> arguments;
  for (std::size_t i = 1; i < node->operands.size(); ++i)
    arguments.push_back(meaning(node->operands[i], environment));
  if (arguments.size() != function.arity) throw std::logic_error{"wrong number of arguments"};
  for (const char variable : node->derivative) {
    const std::size_t index = function.arity == 2 && variable == 'v' ? 1 : 0;
    function.body = differentiated(function.body, formal(index));
  }
  return applied(function, arguments);
}

Value value_of_integral(const Node& node, const Environment& environment) {
  Environment inside = environment;
  inside.values.erase(node->text);
  const Value body = meaning(node->operands[0], inside);
  const PlainFraction& f = body.entries.at(0);
  if (body.entries.size() != 1 || derivative(f.below, node->text).size() > 0)
    throw std::logic_error{"only polynomials are integrated"};
  const Value whole{1, 1, {{antiderivative(f.above, node->text), f.below}}};
  const Value low = meaning(node->operands[1], environment);
  const Value high = meaning(node->operands[2], environment);
  return plus(substituted(whole, {{node->text, high.entries[0]}}),
              minus(substituted(whole, {{node->text, low.entries[0]}})));
}

Value value_of_call(const Node& node, const Environment& environment) {
  if (node->text == "diff")
    return differentiated(meaning(node->operands[0], environment), node->operands[1]->text);
  std::vector<Value> given;
  for (const Node& operand : node->operands) given.push_back(meaning(operand, environment));
  return built_in(node->text, given);
}

Value value_of_running_sum(const Node& node, const Environment& environment) {
  Environment inside = environment;
  Value result = value_of_number(0);
  const std::size_t high = index_meaning(node->operands[2], environment);
  for (std::size_t i = index_meaning(node->operands[1], environment); i <= high; ++i) {
    inside.values[node->text] = value_of_number(Rational(i));
    result = plus(result, meaning(node->operands[0], inside));
  }
  return result;
}

Value value_of_element(const Node& node, const Environment& environment) {
  const Value& array = environment.values.at(node->text);
  const std::size_t i = index_meaning(node->operands[0], environment);
  const std::size_t j =
      node->operands.size() > 1 ? index_meaning(node->operands[1], environment) : 0;
  if (i >= array.rows || j >= array.columns) throw std::logic_error{"no such element"};
  return {1, 1, {array.at(i, j)}};
}

}  // namespace

Value meaning(const Node& node, const Environment& environment) {
  const auto part = [&](std::size_t i) { return meaning(node->operands.at(i), environment); };
  switch (node->kind) {
    case Kind::number:
      return value_of_number(number_meaning(node->text));
    case Kind::name: {
      const auto found = environment.values.find(node->text);
      return found == environment.values.end() ? value_of_variable(node->text) : found->second;
    }
    case Kind::element:
      return value_of_element(node, environment);
    case Kind::sum:
    case Kind::product: {
      Value result = part(0);
      for (std::size_t i = 1; i < node->operands.size(); ++i)
        result = node->kind == Kind::sum ? plus(result, part(i)) : times(result, part(i));
      return result;
    }
    case Kind::negative:
      return minus(part(0));
    case Kind::quotient:
      return divided(part(0), part(1));
    case Kind::power: {
      Value result = value_of_number(1);
      const Value base = part(0);
      for (unsigned long k = std::stoul(node->text); k > 0; --k) result = times(result, base);
      return result;
    }
    case Kind::apply:
      return value_of_apply(node, environment);
    case Kind::call:
      return value_of_call(node, environment);
    case Kind::running_sum:
      return value_of_running_sum(node, environment);
    case Kind::integral:
      return value_of_integral(node, environment);
    case Kind::matrix: {
      const std::size_t columns = std::stoul(node->text);
      Value result{node->operands.size() / columns, columns, {}};
      for (std::size_t i = 0; i < node->operands.size(); ++i)
        result.entries.push_back(part(i).entries.at(0));
      return result;
    }
  }
  throw std::logic_error{"no such expression"};
}

Function function_meaning(const Node& node, const Environment& environment,
                          const std::vector<std::string>& formals) {
  if (node->type == Type::function)
    return node->kind == Kind::name ? environment.functions.at(node->text)
                                    : function_of_call(node, environment);
  Environment inside = environment;
  std::map<std::string, PlainFraction> renamed;
  for (std::size_t i = 0; i < formals.size(); ++i) {
    inside.values.erase(formals[i]);
    renamed[formals[i]] = {plain_variable(formal(i))};
  }
  return {formals.size(), substituted(meaning(node, inside), renamed)};
}

}  // namespace patchproof::differential
