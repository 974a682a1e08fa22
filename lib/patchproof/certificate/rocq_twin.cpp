#include <patchproof/certificate/rocq_twin.hpp>

namespace patchproof {

namespace {

using Kind = Scalar::Kind;

}  // namespace

std::string RocqTwin::pair(const char* name, const Scalar& scalar) {
  // The left side gets its numbers first, whatever the compiler.
  const std::string left = of(scalar.children[0]);
  return std::string{"("} + name + " " + left + " " + of(scalar.children[1]) + ")";
}

std::string RocqTwin::variable(const Coordinate& coordinate) {
  const Key key{coordinate.symbol->ordinal, coordinate.index};
  for (std::size_t k = bound_.size(); k-- > 0;)
    if (bound_[k] == key) return "(Var " + std::to_string(bound_.size() - 1 - k) + ")";
  const auto [found, is_new] = variable_numbers_.try_emplace(key, variables_.size());
  if (is_new) variables_.push_back(coordinate);
  return "(Var " + std::to_string(bound_.size() + found->second) + ")";
}

std::string RocqTwin::of(const ScalarPointer& pointer) {
  const Scalar& scalar = *pointer;
  switch (scalar.kind) {
    case Kind::integer: return "(Int (" + scalar.number.str() + "))";
    case Kind::variable: return variable(scalar.coordinate);
    case Kind::sum: return pair("Add", scalar);
    case Kind::difference: return pair("Sub", scalar);
    case Kind::product: return pair("Mul", scalar);
    case Kind::quotient: return pair("Div", scalar);
    case Kind::opposite: return "(Opp " + of(scalar.children[0]) + ")";
    case Kind::power:
      return "(Pow " + of(scalar.children[0]) + " " + std::to_string(scalar.order) + ")";
    case Kind::bernstein:
      return "(Bernstein " + std::to_string(scalar.order) + " " + std::to_string(scalar.index) +
             " " + of(scalar.children[0]) + ")";
    case Kind::root: return "(Sqrt " + of(scalar.children[0]) + ")";
    case Kind::application: {
      std::string result = "(App ";
      result += of(scalar.function) + " [";
      for (std::size_t k = 0; k < scalar.children.size(); ++k)
        result += (k == 0 ? "" : "; ") + of(scalar.children[k]);
      return result + "])";
    }
    case Kind::integral: {
      const std::string lower = of(scalar.children[0]);
      const std::string ends = lower + " " + of(scalar.children[1]);
      bound_.emplace_back(scalar.formal->ordinal, 0);
      const std::string body = of(scalar.children[2]);
      bound_.pop_back();
      return "(Integral " + ends + " " + body + ")";
    }
    case Kind::named: return of(scalar.children.front());
  }
  return {};
}

std::string RocqTwin::lambda(const std::vector<SymbolPointer>& formals, const ScalarPointer& body) {
  // The first parameter is number 0, so it is bound innermost.
  for (std::size_t k = formals.size(); k-- > 0;) bound_.emplace_back(formals[k]->ordinal, 0);
  const std::string text = of(body);
  bound_.resize(bound_.size() - formals.size());
  return "(Lam " + std::to_string(formals.size()) + " " + text + ")";
}

std::string RocqTwin::of(const ScalarFunctionPointer& function) {
  switch (function->kind) {
    case ScalarFunction::Kind::lambda: return lambda(function->formals, function->body);
    case ScalarFunction::Kind::derivative:
      return "(Deriv " + std::to_string(function->slot) + " " + of(function->inner) + ")";
    case ScalarFunction::Kind::named: return of(function->inner);
    case ScalarFunction::Kind::unknown: {
      const Key key{function->coordinate.symbol->ordinal, function->coordinate.index};
      const auto [found, is_new] = function_numbers_.try_emplace(key, functions_.size());
      if (is_new) functions_.push_back(function->coordinate);
      return "(Unknown " + std::to_string(found->second) + ")";
    }
  }
  return {};
}

}  // namespace patchproof
