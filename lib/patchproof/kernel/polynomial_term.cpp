#include <patchproof/kernel/polynomial_term.hpp>

#include <functional>

namespace patchproof {

namespace {

Term scalar_operation(Operation operation, std::vector<Term> children,
                      TermNode::Payload payload = {}) {
  return make_term(operation, Type::scalar(), std::move(children), std::move(payload));
}

// Sum or product of any number of terms of one type.
Term folded(Operation operation, const Type& type, std::vector<Term> parts, int neutral) {
  if (parts.empty()) return number_term(neutral);
  if (parts.size() == 1) return parts.front();
  return make_term(operation, type, std::move(parts));
}

using VariableTerm = std::function<Term(Variable)>;

Term monomial_term(const Polynomial::Term& term, const VariableTerm& of) {
  std::vector<Term> factors;
  if (term.coefficient != 1 || term.monomial.is_one()) factors.push_back(number_term(term.coefficient));
  for (const auto& p : term.monomial.powers()) {
    const Term base = of(p.variable);
    factors.push_back(p.exponent == 1 ? base
                                      : scalar_operation(Operation::power, {base},
                                                         static_cast<long>(p.exponent)));
  }
  return folded(Operation::product, Type::scalar(), std::move(factors), 1);
}

Term polynomial_as_term(const Polynomial& polynomial, const VariableTerm& of) {
  std::vector<Term> parts;
  for (const auto& term : polynomial.terms()) parts.push_back(monomial_term(term, of));
  return folded(Operation::sum, Type::scalar(), std::move(parts), 0);
}

// The variable of an integral as a bound symbol; it is bound by the nearest integral around it.
SymbolPointer running_symbol(const Atom& atom) {
  return std::make_shared<const Symbol>(
      Symbol{"t" + std::to_string(atom.component + 1), Symbol::Role::bound, Type::scalar(), 0,
             ~0U - 1000 - static_cast<unsigned>(atom.component)});
}

Term integral_term(const Atom& atom, const Atoms& atoms) {
  Formals formals;
  std::vector<std::string> names;
  std::vector<Term> children{Term{}};
  for (std::size_t k = 1; k < atom.arguments.size(); ++k) {
    const Atom& running = atoms[*variables(atom.arguments[k]).begin()];
    formals.push_back(running_symbol(running));
    names.push_back(formals.back()->name);
    for (const Fraction& end : running.arguments) children.push_back(scalar_term(end, atoms));
  }
  children.front() = make_term(Operation::lambda, Type::function(names, Type::scalar()),
                               {scalar_term(atom.arguments.front(), atoms)}, formals);
  return make_term(Operation::integral, Type::scalar(), std::move(children));
}

Term variable_term(Variable variable, const Atoms& atoms) {
  const Atom& atom = atoms[variable];
  const auto elementary = [&](Operation operation) {
    return scalar_operation(operation, {scalar_term(atom.arguments.front(), atoms)});
  };
  switch (atom.kind) {
    case Atom::Kind::pi: return scalar_operation(Operation::pi, {});
    case Atom::Kind::sine: return elementary(Operation::sine);
    case Atom::Kind::cosine: return elementary(Operation::cosine);
    case Atom::Kind::exponential: return elementary(Operation::exponential);
    case Atom::Kind::root: return elementary(Operation::square_root);
    case Atom::Kind::running: return symbol_term(running_symbol(atom));
    case Atom::Kind::integral: return integral_term(atom, atoms);
    case Atom::Kind::slot: throw std::logic_error{"a formal argument outside its function"};
    default: break;
  }
  const Term whole = whole_term(atom, atoms);
  if (!whole.type().is_point()) return whole;
  return scalar_operation(Operation::component, {whole}, Indices{atom.component});
}

bool is_any_point(const Atom& atom) {
  const Type& type = atom.kind == Atom::Kind::jet ? *atom.symbol->type.inner : atom.symbol->type;
  return type.is_point() && type.dimension == Type::any_dimension;
}

// A combination of points of any dimension: scalar coefficients times whole points.
std::optional<Term> combination(const Fraction& fraction, const Type& type, const Atoms& atoms) {
  std::map<Variable, std::vector<Polynomial::Term>> parts;
  for (const auto& term : fraction.numerator().terms()) {
    std::optional<Variable> point;
    for (const auto& p : term.monomial.powers()) {
      const Atom& atom = atoms[p.variable];
      if (atom.kind != Atom::Kind::symbol && atom.kind != Atom::Kind::jet) continue;
      if (!is_any_point(atom)) continue;
      if (point || p.exponent != 1) return std::nullopt;
      point = p.variable;
    }
    if (!point) return std::nullopt;
    parts[*point].push_back({term.monomial.without(*point), term.coefficient});
  }
  std::vector<Term> summands;
  for (auto& [variable, terms] : parts) {
    const Fraction::Factors& below = fraction.denominator();
    Budget budget{Limits{}};
    const Fraction coefficient{Polynomial::from_terms(std::move(terms)), below, budget};
    summands.push_back(make_term(Operation::product, type,
                                 {scalar_term(coefficient, atoms), whole_term(atoms[variable], atoms)}));
  }
  if (summands.empty()) return make_term(Operation::tuple, type, {number_term(0)});
  return folded(Operation::sum, type, std::move(summands), 0);
}

}  // namespace

Term whole_term(const Atom& atom, const Atoms& atoms) {
  const Term symbol = symbol_term(atom.symbol);
  if (atom.kind == Atom::Kind::symbol) return symbol;
  bool plain = true;
  for (const int order : atom.orders) plain = plain && order == 0;
  std::vector<Term> children;
  children.push_back(plain ? symbol
                           : make_term(Operation::derivative, symbol.type(), {symbol},
                                       Indices(atom.orders.begin(), atom.orders.end())));
  for (const Fraction& argument : atom.arguments) children.push_back(scalar_term(argument, atoms));
  return make_term(Operation::apply, *atom.symbol->type.inner, std::move(children));
}

Term scalar_term(const Fraction& fraction, const Atoms& atoms) {
  const VariableTerm of = [&](Variable v) { return variable_term(v, atoms); };
  Term result = polynomial_as_term(fraction.numerator(), of);
  for (const auto& [factor, exponent] : fraction.denominator()) {
    Term below = polynomial_as_term(factor, of);
    if (exponent > 1)
      below = scalar_operation(Operation::power, {below}, static_cast<long>(exponent));
    result = scalar_operation(Operation::quotient, {result, below});
  }
  return result;
}

std::optional<Term> value_term(const std::vector<Fraction>& components, const Type& type,
                               const Atoms& atoms) {
  if (type.is_scalar()) return scalar_term(components.front(), atoms);
  if (type.dimension == Type::any_dimension) return combination(components.front(), type, atoms);
  std::vector<Term> coordinates;
  for (const Fraction& component : components) coordinates.push_back(scalar_term(component, atoms));
  return make_term(Operation::tuple, type, std::move(coordinates));
}

Term polynomial_function(const std::vector<Polynomial>& components, const Type& type,
                         const std::vector<Variable>& variables) {
  Formals formals;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    // Ordinals of bound symbols made here count down from the top: they meet no declared ones.
    formals.push_back(std::make_shared<const Symbol>(
        Symbol{type.parameters.at(k), Symbol::Role::bound, Type::scalar(), 0,
               ~0U - static_cast<unsigned>(k)}));
  }
  const VariableTerm of = [&](Variable v) {
    for (std::size_t k = 0; k < variables.size(); ++k)
      if (variables[k] == v) return symbol_term(formals[k]);
    throw std::logic_error{"a variable that is not a parameter of the function"};
  };
  std::vector<Term> coordinates;
  for (const Polynomial& component : components)
    coordinates.push_back(polynomial_as_term(component, of));
  const Term body = type.inner->is_point()
                        ? make_term(Operation::tuple, *type.inner, std::move(coordinates))
                        : coordinates.front();
  return make_term(Operation::lambda, type, {body}, formals);
}

}  // namespace patchproof
