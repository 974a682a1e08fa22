#include <patchproof/language/functional.hpp>

#include <algorithm>
#include <functional>

#include <patchproof/language/elaborator.hpp>

namespace patchproof {

namespace {

using syntax::Expression;
using Kind = Expression::Kind;

// Every part of the expression, the whole first.
void each_part(const Expression& expression, const std::function<void(const Expression&)>& visit) {
  visit(expression);
  for (const auto& operand : expression.operands) each_part(*operand, visit);
  for (const syntax::Argument& argument : expression.arguments)
    if (argument.value) each_part(*argument.value, visit);
  for (const auto& row : expression.rows)
    for (const auto& entry : row) each_part(*entry, visit);
}

// q' and q_uv, where q is the formal and 'q_uv' is not declared by itself.
bool is_derivative_of(const std::string& formal, const std::string& name, const Scope& scope) {
  if (name.size() <= formal.size() || name.compare(0, formal.size(), formal) != 0) return false;
  const char mark = name[formal.size()];
  return mark == '\'' || (mark == '_' && scope.find(name) == nullptr);
}

class Usage {
 public:
  Usage(const std::string& formal, const Scope& scope) : formal_{formal}, scope_{scope} {}

  bool in(const Expression& expression) const {
    bool found = false;
    each_part(expression, [&](const Expression& part) { found = found || at(part); });
    return found;
  }

 private:
  bool is_formal(const Expression& e) const { return e.kind == Kind::name && e.text == formal_; }

  bool at(const Expression& part) const {
    if (part.kind == Kind::name) return is_derivative_of(formal_, part.text, scope_);
    if (part.kind == Kind::index) return is_formal(*part.operands.front());
    if (part.kind != Kind::call) return false;
    const Expression& callee = *part.operands.front();
    if (is_formal(callee)) return true;
    const Entity* entity = callee.kind == Kind::name ? scope_.find(callee.text) : nullptr;
    for (std::size_t k = 0; k < part.arguments.size(); ++k) {
      const auto& value = part.arguments[k].value;
      if (!value || !is_formal(*value)) continue;
      if (callee.kind == Kind::name && callee.text == "diff" && k == 0) return true;
      if (entity != nullptr && entity->kind == Entity::Kind::functional &&
          k < entity->functional->is_function.size() && entity->functional->is_function[k])
        return true;
    }
    return false;
  }

  const std::string& formal_;
  const Scope& scope_;
};

}  // namespace

std::vector<bool> functions_among(const std::vector<syntax::Name>& formals,
                                  const Expression& expression, const Scope& scope) {
  std::vector<bool> result;
  for (const syntax::Name& formal : formals)
    result.push_back(Usage{formal.text, scope}.in(expression));
  return result;
}

std::vector<syntax::Name> integration_variables(const Expression& expression) {
  std::vector<syntax::Name> result;
  each_part(expression, [&](const Expression& part) {
    const bool is_integral = part.kind == Kind::call && part.operands.front()->kind == Kind::name &&
                             part.operands.front()->text == "integral";
    if (!is_integral || !result.empty()) return;
    for (const syntax::Argument& argument : part.arguments)
      if (argument.range) result.push_back(argument.range->name);
  });
  return result;
}

// The formals stand for the functions given, under the names of parameters that the integral uses.
Term Elaborator::functional_call(const Functional& functional, const syntax::Expression& call,
                                 const Scope& scope) {
  const std::string& name = call.operands.front()->text;
  const std::size_t count = functional.formals.size();
  if (call.arguments.size() != count)
    throw Fault{call.span, "'" + name + "' takes " + std::to_string(count) + " argument" +
                               (count == 1 ? "" : "s") + ", not " +
                               std::to_string(call.arguments.size())};
  const std::vector<syntax::Name> variables = integration_variables(*functional.value);
  Scope inside{&functional.scope};
  std::vector<Term> arguments;
  for (std::size_t k = 0; k < count; ++k) {
    if (!call.arguments[k].value)
      throw Fault{call.span, "a running index is not an argument of a functional"};
    Term given = expression(*call.arguments[k].value, scope);
    if (!functional.is_function[k]) {
      given = decayed(construct_.value(scope, given));
    } else if (!variables.empty() && !given.type().is_matrix()) {
      syntax::Formal formal{functional.formals[k], {}};
      formal.type.kind =
          variables.size() == 1 ? syntax::FormalType::Kind::curve : syntax::FormalType::Kind::patch;
      formal.type.parameters = variables;
      given = as_function(formal, given, scope);
    }
    arguments.push_back(given);
    inside.declare(functional.formals[k].text, given);
  }
  try {
    const Term value = expression(*functional.value, inside);
    return construct_.definition(name, decayed(value), std::move(arguments), call.span);
  } catch (const Fault& fault) {
    const bool nested = fault.diagnostic.message.compare(0, 4, "in '") == 0;
    throw Fault{
        call.span,
        nested ? fault.diagnostic.message : "in '" + name + "': " + fault.diagnostic.message,
        fault.diagnostic.help};
  }
}

}  // namespace patchproof
