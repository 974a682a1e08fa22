#pragma once

#include <string>
#include <vector>

#include <patchproof/language/elaborator.hpp>

namespace patchproof {

/// One call of a builtin: its arguments, and what is needed to read them.
struct BuiltinCall {
  const syntax::Expression& expression;
  const Scope& scope;
  Elaborator& elaborator;

  const Span& span() const { return expression.span; }
  Construction& construct() const { return elaborator.construct(); }
  std::size_t count() const { return expression.arguments.size(); }

  Term term(std::size_t k) const {
    const syntax::Argument& argument = expression.arguments.at(k);
    if (!argument.value) throw Fault{span(), "a running index is not expected here"};
    return elaborator.expression(*argument.value, scope);
  }
  Term value(std::size_t k) const { return decayed(construct().value(scope, term(k))); }
  Term scalar(std::size_t k, const std::string& what) const {
    return construct().scalar(scope, term(k), what);
  }
  int whole(std::size_t k, const std::string& what) const {
    return static_cast<int>(construct().whole_number(term(k), what));
  }
  Term matrix(std::size_t k) const {
    const Term result = term(k);
    if (!result.type().is_matrix())
      throw Fault{result.span(), "a matrix, net or list is needed here, not a " +
                                     to_text(result.type())};
    return result;
  }
  std::vector<syntax::Binder> binders(std::size_t from) const {
    std::vector<syntax::Binder> result;
    for (std::size_t k = from; k < count(); ++k) {
      if (!expression.arguments[k].binder)
        throw Fault{span(), "a running index is needed here, as in 'i in 0..3'"};
      result.push_back(*expression.arguments[k].binder);
    }
    return result;
  }
};

/// diff(f, u) and diff(f, u, 2, v, 2); of a function again a function, of a value in parameters a
/// value.
Term derivative_of(const BuiltinCall& call);

/// integral(f, u in [a, b], v in [c, d]): the variables are new, and the integrand is read with them
/// in place of parameters of the same names.
Term integral_of(const BuiltinCall& call);

}  // namespace patchproof
