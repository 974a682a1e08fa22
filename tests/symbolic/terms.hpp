#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <patchproof/symbolic/second_opinion.hpp>
#include <patchproof/term/term.hpp>

/// Short ways to write terms in tests of this engine, typed as the language would type them.
namespace patchproof::terms {

using Answer = SecondOpinion::Answer;
using Role = Symbol::Role;

/// Symbols in the order they were declared.
class Declarations {
 public:
  SymbolPointer operator()(const std::string& name, Role role, Type type = Type::scalar()) {
    return std::make_shared<const Symbol>(Symbol{name, role, std::move(type), 4, next_++});
  }
  Term parameter(const std::string& name) { return symbol_term((*this)(name, Role::parameter)); }
  Term scalar(const std::string& name) { return symbol_term((*this)(name, Role::scalar)); }
  Term point(const std::string& name, int dimension = 0) {
    return symbol_term((*this)(name, Role::point, Type::point(dimension)));
  }
  Term curve(const std::string& name, const std::string& parameter, int dimension = 0) {
    return symbol_term(
        (*this)(name, Role::function, Type::function({parameter}, Type::point(dimension))));
  }
  Term scalar_function(const std::string& name, std::vector<std::string> parameters) {
    return symbol_term(
        (*this)(name, Role::function, Type::function(std::move(parameters), Type::scalar())));
  }

 private:
  unsigned next_ = 1;
};

inline Term number(long numerator, long denominator = 1) {
  return number_term(Rational{numerator, denominator});
}
inline Term pi() { return make_term(Operation::pi, Type::scalar(), {}); }

inline Term operator+(const Term& a, const Term& b) {
  return make_term(Operation::sum, a.type(), {a, b});
}
inline Term operator-(const Term& a) { return make_term(Operation::negation, a.type(), {a}); }
inline Term operator-(const Term& a, const Term& b) { return a + (-b); }
inline Term operator*(const Term& a, const Term& b) {
  return make_term(Operation::product, a.type().is_scalar() ? b.type() : a.type(), {a, b});
}
inline Term operator/(const Term& a, const Term& b) {
  return make_term(Operation::quotient, a.type(), {a, b});
}
inline Term operator+(long a, const Term& b) { return number(a) + b; }
inline Term operator+(const Term& a, long b) { return a + number(b); }
inline Term operator-(long a, const Term& b) { return number(a) - b; }
inline Term operator-(const Term& a, long b) { return a - number(b); }
inline Term operator*(long a, const Term& b) { return number(a) * b; }
inline Term operator/(const Term& a, long b) { return a / number(b); }
inline Term operator/(long a, const Term& b) { return number(a) / b; }

inline Term power(const Term& base, long exponent) {
  return make_term(Operation::power, Type::scalar(), {base}, exponent);
}
inline Term scalar_operation(Operation operation, const Term& child) {
  return make_term(operation, Type::scalar(), {child});
}
inline Term sin(const Term& x) { return scalar_operation(Operation::sine, x); }
inline Term cos(const Term& x) { return scalar_operation(Operation::cosine, x); }
inline Term exp(const Term& x) { return scalar_operation(Operation::exponential, x); }
inline Term sqrt(const Term& x) { return scalar_operation(Operation::square_root, x); }

inline Term lambda(const std::vector<Term>& formals, const Term& body) {
  Formals symbols;
  std::vector<std::string> names;
  for (const Term& formal : formals) {
    symbols.push_back(formal.symbol());
    names.push_back(formal.symbol()->name);
  }
  return make_term(Operation::lambda, Type::function(names, body.type()), {body}, symbols);
}
inline Term at(const Term& function, const std::vector<Term>& arguments) {
  std::vector<Term> children{function};
  children.insert(children.end(), arguments.begin(), arguments.end());
  return make_term(Operation::apply, *function.type().inner, children);
}
inline Term derivative(const Term& function, Indices orders) {
  return make_term(Operation::derivative, function.type(), {function}, std::move(orders));
}
inline Term point(const std::vector<Term>& coordinates) {
  return make_term(Operation::tuple, Type::point(static_cast<int>(coordinates.size())),
                   coordinates);
}
inline Term matrix(int rows, int columns, const std::vector<Term>& entries) {
  return make_term(Operation::matrix, Type::matrix(rows, columns, entries.front().type()), entries);
}
inline Term times(const Term& a, const Term& b) {
  const Type& entry = a.type().inner->is_scalar() ? *b.type().inner : *a.type().inner;
  return make_term(Operation::matrix_product, Type::matrix(a.type().rows, b.type().columns, entry),
                   {a, b});
}
inline Term component(const Term& value, int k) {
  return make_term(Operation::component, Type::scalar(), {value}, Indices{k});
}
inline Term bernstein(int n, int i, const Term& t) {
  return make_term(Operation::bernstein, Type::scalar(), {t}, Indices{n, i});
}
inline Term basis(BasisFunction function, const Term& t) {
  return make_term(Operation::bspline_basis, Type::scalar(), {t}, std::move(function));
}

inline Statement equation(const Term& left, const Term& right) {
  return {left, Relation::equal, right, {}};
}
inline Goal goal(std::vector<Statement> statements, const std::vector<Statement>& assumed = {}) {
  Goal result{std::move(statements), {}, {}, {}};
  for (const Statement& statement : assumed) result.assumptions.push_back({"", statement});
  return result;
}
inline SecondOpinion opinion(const Goal& goal) { return second_opinion(goal, Limits{}); }
inline SecondOpinion opinion(const Term& left, const Term& right,
                             const std::vector<Statement>& assumed = {}) {
  return opinion(goal({equation(left, right)}, assumed));
}
inline bool holds(const Term& left, const Term& right, const std::vector<Statement>& assumed = {}) {
  return opinion(left, right, assumed).answer == Answer::holds;
}
inline bool fails(const Term& left, const Term& right, const std::vector<Statement>& assumed = {}) {
  return opinion(left, right, assumed).answer == Answer::fails;
}
inline std::string reason(const Term& left, const Term& right,
                          const std::vector<Statement>& assumed = {}) {
  return opinion(left, right, assumed).reason;
}
inline std::string difference(const Term& left, const Term& right,
                              const std::vector<Statement>& assumed = {}) {
  return opinion(left, right, assumed).normal_form;
}

}  // namespace patchproof::terms
