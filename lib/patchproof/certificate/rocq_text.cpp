#include <patchproof/certificate/rocq_text.hpp>

#include <algorithm>
#include <utility>

#include <patchproof/certificate/rocq_layout.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;

// Levels of Rocq's notations: the smaller, the tighter.
constexpr int of_sum = 50;
constexpr int of_product = 40;
constexpr int of_opposite = 35;
constexpr int of_power = 30;
constexpr int of_call = 10;
constexpr int of_name = 0;

std::string bracketed(const std::string& text, int own, int allowed) {
  return own > allowed ? "(" + text + ")" : text;
}

}  // namespace

// fun u v => (fun u v => …) u v is the function inside.
const ScalarFunction& RocqText::without_application(const ScalarFunction& function) {
  const Scalar& body = *function.body;
  const bool applied = body.kind == Kind::application &&
                       body.function->kind == ScalarFunction::Kind::lambda &&
                       body.children.size() == function.formals.size();
  if (!applied) return function;
  const Symbols& inside = symbols_.of(body.function);
  for (std::size_t k = 0; k < body.children.size(); ++k) {
    const Scalar& argument = *body.children[k];
    const unsigned formal = function.formals[k]->ordinal;
    if (argument.kind != Kind::variable || argument.coordinate.symbol->ordinal != formal ||
        inside.contains(formal))
      return function;
  }
  return without_application(*body.function);
}

std::string RocqText::variable(const Coordinate& coordinate) const {
  const auto bound = bound_.find(coordinate.symbol->ordinal);
  return bound == bound_.end() ? names_.text(coordinate) : bound->second;
}

std::vector<std::string> RocqText::enter(const std::vector<SymbolPointer>& formals,
                                         const Symbols& inside) {
  std::set<std::string> taken;
  for (const auto& [ordinal, symbol] : inside) {
    const auto bound = bound_.find(ordinal);
    taken.insert(bound != bound_.end() ? bound->second : names_.variable(symbol).name);
  }
  std::vector<std::string> result;
  for (const SymbolPointer& formal : formals) {
    // The names of the library have long names; only those of the case are one letter long.
    std::string name = rocq_identifier(formal->name);
    while (taken.contains(name) || name == "R" || name == "I" || name == "S" || name == "O")
      name += "'";
    taken.insert(name);
    result.push_back(name);
  }
  for (std::size_t k = 0; k < formals.size(); ++k) bound_[formals[k]->ordinal] = result[k];
  return result;
}

std::string RocqText::binder(const std::vector<SymbolPointer>& formals, const ScalarPointer& body) {
  Symbols inside = symbols_.of(body);
  for (const SymbolPointer& formal : formals) inside.erase(formal->ordinal);
  const std::map<unsigned, std::string> outside = bound_;
  std::string result = "fun";
  for (const std::string& name : enter(formals, inside)) result += " " + name;
  result += " => " + expression(body, 100);
  bound_ = outside;
  return result;
}

std::string RocqText::expression(const ScalarPointer& scalar, int level) {
  const auto child = [&](std::size_t k, int allowed) {
    return expression(scalar->children[k], allowed);
  };
  // From the left to the right: what is met first gets its name first, whatever the compiler.
  const auto pair = [&](int left, const char* sign, int right) {
    std::string text = child(0, left);
    text += sign;
    return text + child(1, right);
  };
  switch (scalar->kind) {
    case Kind::integer: {
      const bool negative = scalar->number < 0;
      // Without brackets Rocq would read the opposite of a number in some places.
      return negative ? "(" + scalar->number.str() + ")" : scalar->number.str();
    }
    case Kind::variable: {
      const std::string text = variable(scalar->coordinate);
      return bracketed(text, text.find(' ') == std::string::npos ? of_name : of_call, level);
    }
    case Kind::sum: return bracketed(pair(of_sum, " + ", of_sum - 1), of_sum, level);
    case Kind::difference:
      return bracketed(pair(of_sum, " - ", of_sum - 1), of_sum, level);
    case Kind::product:
      return bracketed(pair(of_product, " * ", of_opposite - 1), of_product, level);
    case Kind::quotient:
      return bracketed(pair(of_product, " / ", of_opposite - 1), of_product, level);
    case Kind::opposite: {
      // -2 would be a number, not the opposite of one.
      const bool number = scalar->children[0]->kind == Kind::integer;
      const std::string inner = child(0, of_power);
      return bracketed("- " + (number ? "(" + inner + ")" : inner), of_opposite, level);
    }
    case Kind::power:
      return bracketed(child(0, of_call) + " ^ " + std::to_string(scalar->order), of_power, level);
    case Kind::bernstein:
      return bracketed("Bern " + std::to_string(scalar->order) + " " +
                           std::to_string(scalar->index) + " " + child(0, of_name),
                       of_call, level);
    case Kind::root: return bracketed("sqrt " + child(0, of_name), of_call, level);
    case Kind::application: return bracketed(application(*scalar), of_call, level);
    case Kind::integral: {
      const std::string integrand = binder({scalar->formal}, scalar->children[2]);
      return bracketed("RInt (" + integrand + ") " + pair(of_name, " ", of_name), of_call, level);
    }
    case Kind::named: {
      const ScalarPointer& value = scalar->children.front();
      const Symbols& symbols = symbols_.of(value);
      if (depends_on_bound(symbols)) return expression(value, level);
      const std::string text =
          named(scalar->name, scalar->index, value.get(), symbols, value, nullptr);
      return bracketed(text, text.find(' ') == std::string::npos ? of_name : of_call, level);
    }
  }
  return {};
}

std::string RocqText::application(const Scalar& scalar) {
  std::string result = function_text(scalar.function);
  for (const ScalarPointer& argument : scalar.children)
    result += " " + expression(argument, of_name);
  return result;
}

std::string RocqText::function_text(const ScalarFunctionPointer& function) {
  switch (function->kind) {
    case ScalarFunction::Kind::unknown: return variable(function->coordinate);
    case ScalarFunction::Kind::lambda:
      return "(" + binder(function->formals, function->body) + ")";
    case ScalarFunction::Kind::named: {
      const Symbols& symbols = symbols_.of(function->inner);
      if (depends_on_bound(symbols)) return function_text(function->inner);
      return named(function->name, function->slot, function->inner.get(), symbols, nullptr,
                   function->inner);
    }
    case ScalarFunction::Kind::derivative: {
      const std::string inner = function_text(function->inner);
      const bool atomic = inner.front() == '(' || inner.find(' ') == std::string::npos;
      const std::string argument = atomic ? inner : "(" + inner + ")";
      if (function->arity == 1) return "Derive " + argument;
      if (function->arity == 2) return (function->slot == 0 ? "D_u " : "D_v ") + argument;
      return "D_" + std::to_string(function->slot + 1) + " " + argument;
    }
  }
  return {};
}

bool RocqText::depends_on_bound(const Symbols& symbols) const {
  return std::any_of(symbols.begin(), symbols.end(), [&](const auto& entry) {
    return entry.second->role == Symbol::Role::bound || bound_.contains(entry.first);
  });
}

// The definition takes what it depends on as arguments, in the order of declaration.
std::string RocqText::named(const std::string& name, std::size_t component, const void* key,
                            const Symbols& symbols, const ScalarPointer& value,
                            const ScalarFunctionPointer& function) {
  const auto found = defined_.find(key);
  if (found != defined_.end()) return found->second;
  std::string head;
  std::string arguments;
  std::set<std::string> listed;
  for (const auto& [ordinal, symbol] : symbols) {
    const RocqVariable& variable = names_.variable(symbol);
    if (!listed.insert(variable.name).second) continue;
    head += " (" + variable.name + " : " + variable.type() + ")";
    arguments += " " + variable.name;
  }
  // Nothing of what is bound where it is used means anything in a definition.
  const std::map<unsigned, std::string> outside = std::exchange(bound_, {});
  std::string body;
  if (function && function->kind == ScalarFunction::Kind::lambda) {
    std::string formals;
    const ScalarFunction& inner = without_application(*function);
    for (const std::string& formal : enter(inner.formals, symbols)) formals += " " + formal;
    head += " (" + formals.substr(1) + " : R)";
    body = expression(inner.body, 100);
  } else {
    body = function ? function_text(function) : expression(value, 100);
    if (function)
      head += " : " + [&] {
        std::string type;
        for (std::size_t k = 0; k < function->arity; ++k) type += "R -> ";
        return type;
      }() + "R";
  }
  bound_ = outside;
  if (!function || function->kind == ScalarFunction::Kind::lambda) head += " : R";
  // A name of its own for each component, and for another meaning of the same name.
  const std::string wanted = component == 0 ? name : name + "_" + std::to_string(component);
  const auto [known, is_new] = meanings_.try_emplace(wanted + head + " :=\n  " + body + ".");
  if (is_new) {
    known->second = names_.fresh(wanted);
    definitions_.push_back(
        {known->second, with_short_lines("Definition " + known->second +
                                         known->first.substr(wanted.size()))});
  }
  return defined_.emplace(key, known->second + arguments).first->second;
}

}  // namespace patchproof
