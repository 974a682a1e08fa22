#include <patchproof/certificate/python_text.hpp>

#include <algorithm>
#include <utility>

#include <patchproof/certificate/scalar_nodes.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;

// How tightly the operators of Python bind: the smaller, the tighter.
constexpr int of_lambda = 90;
constexpr int of_sum = 50;
constexpr int of_product = 40;
constexpr int of_opposite = 35;
constexpr int of_power = 30;
constexpr int of_call = 0;

constexpr const char* name_characters =
    "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

// A name, a number, or a call: letters and digits, and at the end something in brackets.
bool is_operand(const std::string& text) {
  const std::size_t open = text.find_first_of("([");
  const std::string name = text.substr(0, open);
  if (name.empty() || name.find_first_not_of(name_characters) != std::string::npos) return false;
  int depth = 0;
  for (std::size_t k = open; k < text.size(); ++k) {
    if (text[k] == '(' || text[k] == '[') ++depth;
    if (text[k] == ')' || text[k] == ']') --depth;
    if (depth == 0 && k + 1 < text.size()) return false;
  }
  return true;
}

std::string bracketed(const std::string& text, int own, int allowed) {
  return own > allowed && !is_operand(text) ? "(" + text + ")" : text;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string result;
  for (const std::string& part : parts) result += (result.empty() ? "" : ", ") + part;
  return result;
}

// The scalar without the sign it begins with: x for -x, 2*x for (-2)*x; none without a sign.
ScalarPointer without_sign(const ScalarPointer& scalar) {
  switch (scalar->kind) {
    case Kind::integer:
      return scalar->number < 0 ? scalar_number(Rational{-scalar->number}) : nullptr;
    case Kind::opposite:
      return scalar->children[0];
    case Kind::product:
    case Kind::quotient: {
      const ScalarPointer first = without_sign(scalar->children[0]);
      return first ? scalar_pair(scalar->kind, first, scalar->children[1]) : nullptr;
    }
    default:
      return nullptr;
  }
}

bool is_number(const ScalarPointer& scalar, int number) {
  return scalar->kind == Kind::integer && scalar->number == number;
}

}  // namespace

// What is 0 is left out, and a sign at the beginning is taken away. Each part is written once: nested
// sums would take too long otherwise.
std::string PythonText::sum(const Scalar& scalar, int level) {
  const ScalarPointer turned = without_sign(scalar.children[1]);
  const bool added = (scalar.kind == Kind::sum) == !turned;
  const std::string left = expression(scalar.children[0], of_sum);
  const std::string right = expression(turned ? turned : scalar.children[1], of_product);
  if (right == "0") return bracketed(left, of_sum, level);
  if (left == "0" && added) return bracketed(right, of_product, level);
  return bracketed(left + (added ? " + " : " - ") + right, of_sum, level);
}

// One times x is x, minus one times x is -x, and nothing is left of zero times x.
std::string PythonText::product(const Scalar& scalar, int level) {
  const ScalarPointer& first = scalar.children[0];
  const ScalarPointer& second = scalar.children[1];
  if (is_number(first, 0) || is_number(second, 0)) return "0";
  if (is_number(first, 1)) return expression(second, level);
  if (is_number(second, 1)) return expression(first, level);
  if (is_number(first, -1))
    return bracketed("-" + expression(second, of_power), of_opposite, level);
  return bracketed(expression(first, of_product) + "*" + expression(second, of_power), of_product,
                   level);
}

// The argument that can stand for a formal parameter in the body: a variable without indices.
std::string PythonText::plain_name(const ScalarPointer& scalar) {
  if (scalar->kind != Kind::variable) return "";
  const std::string text = variable(scalar->coordinate);
  return text.find('[') == std::string::npos ? text : "";
}

std::string PythonText::application(const Scalar& scalar, int level) {
  const ScalarFunction& function = *scalar.function;
  std::vector<std::string> arguments;
  bool plain = function.kind == ScalarFunction::Kind::lambda;
  for (const ScalarPointer& argument : scalar.children) {
    arguments.push_back(expression(argument, of_lambda));
    plain = plain && !plain_name(argument).empty();
  }
  if (!plain) return function_text(scalar.function) + "(" + joined(arguments) + ")";
  const std::map<unsigned, std::string> outside = bound_;
  for (std::size_t k = 0; k < arguments.size(); ++k)
    bound_[function.formals[k]->ordinal] = arguments[k];
  const std::string result = expression(function.body, level);
  bound_ = outside;
  return result;
}

std::string PythonText::variable(const Coordinate& coordinate) {
  const auto bound = bound_.find(coordinate.symbol->ordinal);
  return bound == bound_.end() ? names_.text(coordinate) : bound->second;
}

bool PythonText::depends_on_bound(const Symbols& symbols) const {
  return std::any_of(symbols.begin(), symbols.end(), [&](const auto& entry) {
    return entry.second->role == Symbol::Role::bound || bound_.contains(entry.first);
  });
}

std::vector<std::string> PythonText::enter(const std::vector<SymbolPointer>& formals,
                                           const ScalarPointer& body) {
  std::set<std::string> inside;
  for (const auto& entry : symbols_.of(body)) {
    const bool own = std::any_of(formals.begin(), formals.end(), [&](const auto& formal) {
      return formal->ordinal == entry.first;
    });
    if (own) continue;
    const auto bound = bound_.find(entry.first);
    inside.insert(bound != bound_.end() ? bound->second : names_.stem(entry.second));
  }
  std::vector<std::string> result;
  for (const SymbolPointer& formal : formals) {
    std::string name = python_identifier(formal->name);
    // Only a parameter of the case may be hidden by a formal of its name.
    const auto hides = [&] {
      return inside.contains(name) || (names_.is_taken(name) && !names_.is_parameter(name));
    };
    while (hides()) name += "_";
    inside.insert(name);
    names_.reserve(name);
    result.push_back(name);
  }
  for (std::size_t k = 0; k < formals.size(); ++k) bound_[formals[k]->ordinal] = result[k];
  return result;
}

std::string PythonText::lambda(const std::vector<SymbolPointer>& formals,
                               const ScalarPointer& body) {
  const std::map<unsigned, std::string> outside = bound_;
  std::string result = "lambda " + joined(enter(formals, body)) + ": ";
  result += expression(body, of_sum);
  bound_ = outside;
  return result;
}

bool PythonText::is_symbolic(const Scalar& scalar) const {
  const auto symbolic = [this](const ScalarPointer& child) { return is_symbolic(*child); };
  switch (scalar.kind) {
    case Kind::integer:
    case Kind::named:
      return false;
    case Kind::variable:
      return !bound_.contains(scalar.coordinate.symbol->ordinal);
    case Kind::sum:
    case Kind::difference:
    case Kind::product:
    case Kind::opposite:
    case Kind::power:
      return std::any_of(scalar.children.begin(), scalar.children.end(), symbolic);
    case Kind::application:
      return scalar.function->kind != ScalarFunction::Kind::named &&
             scalar.function->kind != ScalarFunction::Kind::lambda;
    default:
      return true;
  }
}

std::string PythonText::quotient(const Scalar& scalar) {
  const ScalarPointer& above = scalar.children[0];
  const ScalarPointer& below = scalar.children[1];
  if (above->kind == Kind::integer && below->kind == Kind::integer)
    return "Rational(" + above->number.str() + ", " + below->number.str() + ")";
  const std::string left = expression(above, of_product);
  const std::string right = expression(below, of_power);
  // What is left out of sums and products may leave a whole number.
  const auto safe = [&](const ScalarPointer& part, const std::string& text) {
    return is_symbolic(*part) && text.find_first_not_of("-0123456789") != std::string::npos;
  };
  if (safe(above, left) || safe(below, right)) return left + "/" + right;
  return left + "/S(" + expression(below, 100) + ")";
}

std::string PythonText::expression(const ScalarPointer& scalar, int level) {
  const auto child = [&](std::size_t k, int allowed) {
    return expression(scalar->children[k], allowed);
  };
  switch (scalar->kind) {
    case Kind::integer:
      return bracketed(scalar->number.str(), scalar->number < 0 ? of_opposite : of_call, level);
    case Kind::variable:
      return variable(scalar->coordinate);
    case Kind::sum:
    case Kind::difference:
      return sum(*scalar, level);
    case Kind::product:
      return product(*scalar, level);
    case Kind::quotient:
      return bracketed(quotient(*scalar), of_product, level);
    case Kind::opposite:
      return bracketed("-" + child(0, of_power), of_opposite, level);
    case Kind::power:
      return bracketed(child(0, of_call) + "**" + std::to_string(scalar->order), of_power, level);
    case Kind::bernstein:
      return "bernstein(" + std::to_string(scalar->order) + ", " + std::to_string(scalar->index) +
             ", " + child(0, of_lambda) + ")";
    case Kind::root:
      return "sqrt(" + child(0, of_lambda) + ")";
    case Kind::application:
      return application(*scalar, level);
    case Kind::integral:
      return "integral(" + lambda({scalar->formal}, scalar->children[2]) + ", " +
             child(0, of_lambda) + ", " + child(1, of_lambda) + ")";
    case Kind::named: {
      const ScalarPointer& value = scalar->children.front();
      if (depends_on_bound(symbols_.of(value))) return expression(value, level);
      seen_.push_back(value);
      return named(scalar->name, scalar->index, value.get(), value, nullptr);
    }
  }
  return {};
}

// A derivative of a derivative is one of higher order.
std::string PythonText::derivative_text(const ScalarFunctionPointer& function) {
  std::vector<unsigned> orders(function->arity, 0);
  ScalarFunctionPointer inner = function;
  for (; inner->kind == ScalarFunction::Kind::derivative; inner = inner->inner)
    ++orders.at(inner->slot);
  std::string result = "derivative(" + function_text(inner);
  for (const unsigned order : orders) result += ", " + std::to_string(order);
  return result + ")";
}

std::string PythonText::function_text(const ScalarFunctionPointer& function) {
  switch (function->kind) {
    case ScalarFunction::Kind::unknown:
      return variable(function->coordinate);
    case ScalarFunction::Kind::lambda:
      return "(" + lambda(function->formals, function->body) + ")";
    case ScalarFunction::Kind::derivative:
      return derivative_text(function);
    case ScalarFunction::Kind::named:
      if (depends_on_bound(symbols_.of(function->inner))) return function_text(function->inner);
      seen_functions_.push_back(function->inner);
      return named(function->name, function->slot, function->inner.get(), nullptr, function->inner);
  }
  return {};
}

std::string PythonText::named(const std::string& name, std::size_t component, const void* key,
                              const ScalarPointer& value, const ScalarFunctionPointer& function) {
  const auto found = defined_.find(key);
  if (found != defined_.end()) return found->second;
  // Nothing of what is bound where it is used means anything in a definition.
  const std::map<unsigned, std::string> outside = std::exchange(bound_, {});
  std::string text;
  const bool is_lambda = function && function->kind == ScalarFunction::Kind::lambda;
  if (is_lambda) {
    const std::string formals = joined(enter(function->formals, function->body));
    text = "(" + formals + "):\n    return " + expression(function->body, of_lambda) + "\n";
  } else {
    text = " = " + (function ? function_text(function) : expression(value, of_lambda)) + "\n";
  }
  bound_ = outside;
  // A name of its own for each component, and for another meaning of the same name.
  const std::string wanted = component == 0 ? name : name + "_" + std::to_string(component);
  const auto [known, is_new] = meanings_.try_emplace(wanted + text);
  if (is_new) {
    known->second = names_.fresh(wanted);
    definitions_.push_back((is_lambda ? "def " : "") + known->second + text);
  }
  return defined_.emplace(key, known->second).first->second;
}

}  // namespace patchproof
