#pragma once

#include <string>
#include <vector>

#include <patchproof/language/scope.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// Builds terms and checks their types: the typing rules of the case language in one place.
///
/// Numbers are folded, so that indices are numbers. Functions are combined pointwise; where a
/// function stands beside a value, it is taken at the parameters it is named with: `r - C1(u)` is
/// `r(u, v) - C1(u)`. The literal 0 is also the zero point, matrix or function.
/// Every function throws Fault when types do not fit.
class Construction {
 public:
  explicit Construction(Workshop& workshop) : workshop_{workshop} {}

  /// terms[0] signs[1] terms[1] ...; signs[k] is '+' or '-'.
  Term sum(const Scope& scope, std::vector<Term> terms, const std::string& signs, const Span& span);
  /// terms[0] signs[1] terms[1] ...; signs[k] is '*' or '/'. Matrices are multiplied as matrices.
  Term product(const Scope& scope, std::vector<Term> terms, const std::string& signs,
               const Span& span);
  Term negation(const Term& term, const Span& span);
  Term power(const Term& base, const Term& exponent, const Span& span);
  Term tuple(const Scope& scope, std::vector<Term> coordinates, const Span& span);
  Term matrix(const Scope& scope, std::vector<std::vector<Term>> rows, const Span& span);
  /// A list of entries of one type: a control polygon.
  Term list(std::vector<Term> entries, const Span& span);
  Term apply(const Term& function, std::vector<Term> arguments, const Span& span);
  Term derivative(const Term& function, Indices orders, const Span& span);
  Term component(const Term& point, int index, const Span& span);
  Term entry(const Term& matrix, const std::vector<int>& indices, const Span& span);
  Term slice(const Term& matrix, const std::vector<std::pair<int, int>>& ranges, const Span& span);
  Term elementary(Operation operation, const Term& argument, const Span& span);

  /// The term as a value: functions at the parameters they are named with.
  Term value(const Scope& scope, const Term& term);
  /// The term as a scalar; a 1 x 1 matrix is its entry.
  Term scalar(const Scope& scope, const Term& term, const std::string& what);
  /// A whole number known beforehand, as indices and degrees have to be.
  long whole_number(const Term& term, const std::string& what);
  /// A lambda over fresh formals with these names; `body` gets terms for them.
  template <class Body>
  Term function(const std::vector<std::string>& names, const Span& span, const Body& body) {
    Formals formals;
    std::vector<Term> terms;
    for (const std::string& name : names) {
      formals.push_back(workshop_.symbol(name, Symbol::Role::bound, Type::scalar()));
      terms.push_back(symbol_term(formals.back(), span));
    }
    return lambda(formals, body(terms), span);
  }
  /// A lambda over these formals; where they are scalars of the case, over fresh ones in their
  /// place.
  Term lambda(const Formals& formals, const Term& body, const Span& span);

  /// A definition node: what `name(arguments)` stands for, with its expansion.
  Term definition(const std::string& name, const Term& expansion, std::vector<Term> arguments,
                  const Span& span);

  Term zero(const Type& type, const Span& span);
  /// Brings two sides to one type without functions; parameters that are not declared are made,
  /// with range [0,1], and appended to `fresh`.
  std::pair<Term, Term> same_type(const Scope& scope, Term left, Term right, const Span& span,
                                  std::vector<ParameterRange>& fresh);

  /// Terms with all checks done; counts them against the limit of one statement.
  Term make(Operation operation, const Type& type, std::vector<Term> children,
            TermNode::Payload payload, const Span& span);

 private:
  Term lifted_sum(std::vector<Term> terms, const std::string& signs, const Span& span);
  Term scalar_product(const Scope& scope, const std::vector<Term>& terms, const std::string& signs,
                      const Span& span);
  Term matrix_product(const std::vector<Term>& factors, const Span& span);

  Workshop& workshop_;
};

/// Whether the term is the number 0.
bool is_zero(const Term& term);

/// A matrix of one entry as that entry.
Term decayed(const Term& term);

}  // namespace patchproof
