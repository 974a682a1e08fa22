#include <algorithm>

#include <patchproof/language/builtin_call.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

const std::string range_help = "the lower end comes first, and is smaller than the upper one";

// A symbol of the term with one of these names that is none of these symbols.
SymbolPointer namesake(const Term& term, const Formals& formals) {
  for (const auto& [ordinal, symbol] : free_symbols(term)) {
    const SymbolPointer& s = symbol;
    const bool same_name = std::any_of(formals.begin(), formals.end(), [&](const SymbolPointer& f) {
      return f->name == s->name && f->ordinal != s->ordinal;
    });
    if (same_name) return s;
  }
  return nullptr;
}

}  // namespace

Term integral_of(const BuiltinCall& call) {
  Scope inner{&call.scope};
  Formals formals;
  std::vector<Term> children{Term{}};
  for (std::size_t k = 1; k < call.count(); ++k) {
    const std::optional<syntax::RangeBinder>& binder = call.expression.arguments[k].range;
    if (!binder)
      throw Fault{call.span(), "a variable with its range is needed here, as in 'u in [0, 1]'"};
    const syntax::Name& name = binder->name;
    if (inner.find_here(name.text) != nullptr)
      throw Fault{name.span, "the variable '" + name.text + "' occurs twice"};
    for (const auto& end : {binder->range.lower, binder->range.upper})
      children.push_back(call.construct().scalar(
          call.scope, call.elaborator.expression(*end, call.scope), "the end of a range"));
    const Term& lower = children[children.size() - 2];
    const Term& upper = children.back();
    if (lower.is_number() && upper.is_number() && lower.number() >= upper.number())
      throw Fault{
          binder->range.span,
          "the empty range [" + to_text(lower.number()) + ", " + to_text(upper.number()) + "]",
          range_help};
    formals.push_back(
        call.elaborator.workshop().symbol(name.text, Symbol::Role::bound, Type::scalar()));
    inner.declare(name.text, symbol_term(formals.back(), name.span));
  }
  for (std::size_t k = 1; k < children.size(); ++k)
    if (const SymbolPointer other = namesake(children[k], formals))
      throw Fault{children[k].span(),
                  "the ends of a range cannot contain '" + other->name +
                      "', which is a variable of this integral",
                  "give the variable of the integral another name"};
  const Term given = call.elaborator.expression(*call.expression.arguments[0].value, inner);
  const Term integrand = decayed(call.construct().value(inner, given));
  if (integrand.type().is_matrix())
    throw Fault{integrand.span(),
                "scalars and points are integrated, not a " + to_text(integrand.type())};
  if (const SymbolPointer other = namesake(integrand, formals))
    throw Fault{integrand.span(),
                "this integrand contains the parameter '" + other->name +
                    "' of the case, which is not the variable '" + other->name +
                    "' of the integral",
                "make what contains it a function, as in 'let f(" + other->name + ") = ...'"};
  children.front() = call.construct().lambda(formals, integrand, integrand.span());
  return call.construct().make(Operation::integral, integrand.type(), std::move(children), {},
                               call.span());
}

}  // namespace patchproof
