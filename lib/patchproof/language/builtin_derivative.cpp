#include <algorithm>

#include <patchproof/language/builtin_call.hpp>

namespace patchproof {

Term derivative_of(const BuiltinCall& call) {
  Term function = call.term(0);
  const bool was_value = !function.type().is_function();
  std::vector<std::pair<const syntax::Expression*, int>> wanted;
  for (std::size_t k = 1; k < call.count(); ++k) {
    const syntax::Argument& argument = call.expression.arguments[k];
    if (argument.value && argument.value->kind == syntax::Expression::Kind::name &&
        !call.elaborator.is_number(*argument.value, call.scope)) {
      wanted.emplace_back(argument.value.get(), 1);
    } else if (!wanted.empty()) {
      wanted.back().second = call.whole(k, "the order of a derivative");
      if (wanted.back().second < 0)
        throw Fault{call.span(), "the order of a derivative is not negative"};
    } else {
      throw Fault{call.span(), "the name of a parameter is needed after the function",
                  "as in diff(r, u, 2, v, 2)"};
    }
  }
  Formals formals;
  if (was_value) {
    for (const auto& [name, order] : wanted) {
      const Term parameter = call.elaborator.expression(*name, call.scope);
      if (parameter.operation() != Operation::symbol || !parameter.type().is_scalar())
        throw Fault{name->span, "'" + name->text + "' is not a parameter or scalar symbol"};
      const bool known = std::any_of(formals.begin(), formals.end(), [&](const SymbolPointer& f) {
        return f->ordinal == parameter.symbol()->ordinal;
      });
      if (!known) formals.push_back(parameter.symbol());
    }
    function = call.construct().lambda(formals, decayed(function), call.span());
  }
  const std::vector<std::string>& parameters = function.type().parameters;
  Indices orders(parameters.size(), 0);
  for (const auto& [name, order] : wanted) {
    const auto place = std::find(parameters.begin(), parameters.end(), name->text);
    if (place == parameters.end())
      throw Fault{name->span, "'" + name->text + "' is not a parameter of this " +
                                  to_text(function.type())};
    orders[static_cast<std::size_t>(place - parameters.begin())] += order;
  }
  const Term result = call.construct().derivative(function, orders, call.span());
  if (!was_value) return result;
  std::vector<Term> arguments;
  for (const SymbolPointer& formal : formals)
    arguments.push_back(symbol_term(formal, call.span()));
  return call.construct().apply(result, std::move(arguments), call.span());
}

}  // namespace patchproof
