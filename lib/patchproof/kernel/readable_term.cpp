#include <patchproof/kernel/readable_term.hpp>

#include <algorithm>

#include <patchproof/kernel/arrangement.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/readable.hpp>

namespace patchproof {

namespace {

Term combined(Operation operation, const Type& type, std::vector<Term> parts) {
  if (parts.size() == 1) return parts.front();
  return make_term(operation, type, std::move(parts));
}

Term power_of(const Term& base, unsigned exponent) {
  if (exponent == 1) return base;
  return make_term(Operation::power, Type::scalar(), {base}, static_cast<long>(exponent));
}

class Writer {
 public:
  explicit Writer(Workspace& workspace)
      : workspace_{workspace},
        arrangement_{workspace.atoms, workspace.budget,
                     [&workspace](Variable v) { return to_text(v, workspace.atoms); }} {}

  Term scalar(const Fraction& fraction) { return quotient(fraction, Type::scalar()); }

  // The combination of points that every one of the components says, if they say the same.
  std::optional<Term> combination(const std::vector<Fraction>& components, const Type& type) {
    std::optional<Polynomial> whole;
    for (const Fraction& component : components) {
      if (component.denominator() != components.front().denominator()) return std::nullopt;
      const std::optional<Polynomial> of_points = as_points(component.numerator(), type);
      if (!of_points || (whole && !(*of_points == *whole))) return std::nullopt;
      whole = of_points;
    }
    if (whole->is_zero()) return std::nullopt;
    return quotient(Fraction{*whole, components.front().denominator(), workspace_.budget}, type);
  }

 private:
  bool is_point(const Atom& atom, const Type& type) const {
    if (atom.kind != Atom::Kind::symbol && atom.kind != Atom::Kind::jet) return false;
    const Type& own = atom.kind == Atom::Kind::jet ? *atom.symbol->type.inner : atom.symbol->type;
    return own.is_point() && own.dimension == type.dimension;
  }

  // Each component of a point replaced by its first one, which then stands for the point; empty
  // unless there is exactly one point in each term.
  std::optional<Polynomial> as_points(const Polynomial& polynomial, const Type& type) {
    std::vector<Polynomial::Term> terms;
    for (const auto& term : polynomial.terms()) {
      Monomial result;
      int points = 0;
      for (const auto& power : term.monomial.powers()) {
        Atom atom = workspace_.atoms[power.variable];
        const bool point = is_point(atom, type);
        points += point ? static_cast<int>(power.exponent) : 0;
        atom.component = point ? 0 : atom.component;
        result = result * Monomial{point ? workspace_.atoms.variable(atom) : power.variable,
                                   power.exponent};
      }
      if (points != 1) return std::nullopt;
      terms.push_back({result, term.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
  }

  Term variable(Variable v, const Type& wanted) {
    // A copy: writing the arguments may make new atoms.
    const Atom atom = workspace_.atoms[v];
    switch (atom.kind) {
      case Atom::Kind::sine: return elementary(Operation::sine, atom);
      case Atom::Kind::cosine: return elementary(Operation::cosine, atom);
      case Atom::Kind::exponential: return elementary(Operation::exponential, atom);
      case Atom::Kind::root: return elementary(Operation::square_root, atom);
      case Atom::Kind::symbol:
      case Atom::Kind::jet: break;
      default: return scalar_term(Fraction{Polynomial::variable(v)}, workspace_.atoms);
    }
    const Term all = whole(atom);
    if (!all.type().is_point() || (wanted.is_point() && is_point(atom, wanted))) return all;
    return make_term(Operation::component, Type::scalar(), {all}, Indices{atom.component});
  }

  Term elementary(Operation operation, const Atom& atom) {
    return make_term(operation, Type::scalar(), {scalar(atom.arguments.front())});
  }

  // As `whole_term`, with arguments in the order a person writes.
  Term whole(const Atom& atom) {
    const Term plain = whole_term(atom, workspace_.atoms);
    if (atom.kind == Atom::Kind::symbol) return plain;
    std::vector<Term> children{plain.child(0)};
    for (const Fraction& argument : atom.arguments) children.push_back(scalar(argument));
    return make_term(Operation::apply, plain.type(), std::move(children));
  }

  void append_powers(const Monomial& monomial, const Type& type, std::vector<Term>& factors) {
    std::vector<Term> points;
    for (const auto& power : arrangement_.powers(monomial)) {
      const Term base = variable(power.variable, type);
      (base.type().is_point() ? points : factors)
          .push_back(power_of(base, static_cast<unsigned>(power.exponent)));
    }
    factors.insert(factors.end(), points.begin(), points.end());
  }

  static Term signed_product(bool negative, const Rational& number, std::vector<Term> factors,
                             const Type& type) {
    if (number != 1 || factors.empty()) factors.insert(factors.begin(), number_term(number));
    const Term result = combined(Operation::product, type, std::move(factors));
    return negative ? make_term(Operation::negation, type, {result}) : result;
  }

  std::vector<Term> expanded(const Polynomial& polynomial, const Type& type) {
    std::vector<Term> result;
    for (const auto& term : arrangement_.terms(polynomial)) {
      std::vector<Term> factors;
      append_powers(term.monomial, type, factors);
      result.push_back(signed_product(term.coefficient < 0, abs(term.coefficient),
                                      std::move(factors), type));
    }
    return result;
  }

  Term polynomial(const Polynomial& p, const Type& type) {
    if (p.is_constant()) return number_term(p.constant());
    const std::vector<Arrangement::Group> groups = arrangement_.groups(p);
    std::vector<Term> summands;
    for (const auto& [unknowns, coefficient] : groups) {
      workspace_.budget.spend(1);
      if (unknowns.is_one() && groups.size() > 1 && coefficient.terms().size() > 1) {
        for (Term& term : expanded(coefficient, type)) summands.push_back(std::move(term));
        continue;
      }
      const Arrangement::Factored f = arrangement_.factored(coefficient);
      std::vector<Term> factors;
      for (const auto& [factor, exponent] : f.factors) {
        // Terms in their own order would put -u before 1.
        const Term v = variable(*factor.variables().begin(), Type::scalar());
        const Term base = factor.terms().size() == 1
                              ? v
                              : make_term(Operation::sum, Type::scalar(),
                                          {number_term(1), make_term(Operation::negation,
                                                                     Type::scalar(), {v})});
        factors.push_back(power_of(base, exponent));
      }
      if (!f.rest.is_constant())
        factors.push_back(
            combined(Operation::sum, Type::scalar(), expanded(f.rest, Type::scalar())));
      append_powers(unknowns, type, factors);
      summands.push_back(signed_product(f.negative, f.number, std::move(factors), type));
    }
    return combined(Operation::sum, type, std::move(summands));
  }

  Term quotient(const Fraction& fraction, const Type& type) {
    const Term above = polynomial(fraction.numerator(), type);
    if (fraction.is_polynomial()) return above;
    std::vector<Term> below;
    for (const auto& [factor, exponent] : fraction.denominator())
      below.push_back(power_of(polynomial(factor, Type::scalar()), static_cast<unsigned>(exponent)));
    return make_term(Operation::quotient, type,
                     {above, combined(Operation::product, Type::scalar(), std::move(below))});
  }

  Workspace& workspace_;
  Arrangement arrangement_;
};

}  // namespace

std::optional<Term> readable_term(const Value& value, const Type& type, Workspace& workspace) {
  Writer writer{workspace};
  if (type.is_scalar()) return writer.scalar(value.components.front());
  if (type.is_matrix()) {
    const std::size_t size = type.inner->component_count();
    std::vector<Term> entries;
    for (std::size_t k = 0; k + size <= value.components.size(); k += size) {
      const auto begin = value.components.begin() + static_cast<std::ptrdiff_t>(k);
      const auto entry = readable_term(
          Value{{begin, begin + static_cast<std::ptrdiff_t>(size)}, {}}, *type.inner, workspace);
      if (!entry) return std::nullopt;
      entries.push_back(*entry);
    }
    return make_term(Operation::matrix, type, std::move(entries));
  }
  if (const auto combination = writer.combination(value.components, type)) return combination;
  // Numbers stand for a point of any dimension as witnesses have them, in dimension one.
  const bool numbers = std::all_of(
      value.components.begin(), value.components.end(),
      [](const Fraction& f) { return f.is_polynomial() && f.numerator().is_constant(); });
  if (type.dimension == Type::any_dimension && !numbers) return std::nullopt;
  std::vector<Term> coordinates;
  for (const Fraction& component : value.components)
    coordinates.push_back(writer.scalar(component));
  return make_term(Operation::tuple, type, std::move(coordinates));
}

}  // namespace patchproof
