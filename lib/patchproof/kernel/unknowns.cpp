#include <patchproof/kernel/unknowns.hpp>

#include <algorithm>

#include <patchproof/kernel/identity.hpp>

namespace patchproof {

namespace {

// Whether the variable is a parameter, or its value depends on one.
bool depends_on_parameter(Variable variable, const Atoms& atoms) {
  for (const Variable v : variables_within(Polynomial::variable(variable), atoms)) {
    const Atom& atom = atoms[v];
    if (atom.kind == Atom::Kind::symbol && (atom.symbol->role == Symbol::Role::parameter ||
                                            atom.symbol->role == Symbol::Role::bound))
      return true;
  }
  return false;
}

class Collector {
 public:
  Collector(const std::vector<Variable>& unknowns, const Atoms& atoms)
      : unknowns_{unknowns}, atoms_{atoms} {}

  // Adds an equation for each monomial in what depends on parameters.
  void add(const Polynomial& equation, std::vector<LinearEquation>& result) {
    std::map<Monomial, std::vector<Polynomial::Term>> parts;
    for (const auto& term : equation.terms()) {
      Monomial inside;
      Monomial outside;
      for (const auto& p : term.monomial.powers()) {
        const bool apart = depends(p.variable);
        if (apart) require_independent(p.variable);
        Monomial& part = apart ? inside : outside;
        part = part * Monomial{p.variable, p.exponent};
      }
      parts[inside].push_back({outside, term.coefficient});
    }
    for (auto& [inside, terms] : parts)
      result.push_back(linear(Polynomial::from_terms(std::move(terms))));
  }

 private:
  bool depends(Variable v) {
    const auto [place, fresh] = depends_.try_emplace(v, false);
    if (fresh) place->second = depends_on_parameter(v, atoms_);
    return place->second;
  }

  // Powers of parameters, and sines, cosines and exponentials of them, are independent over an
  // interval (Ax, 1971), so their coefficients vanish one by one. Nothing of the kind is known of
  // unknown functions and of roots.
  void require_independent(Variable v) const {
    const Atom& atom = atoms_[v];
    if (atom.kind == Atom::Kind::symbol) return;
    bool elementary = atom.kind == Atom::Kind::sine || atom.kind == Atom::Kind::cosine ||
                      atom.kind == Atom::Kind::exponential;
    for (const Fraction& argument : atom.arguments) {
      elementary = elementary && argument.is_polynomial();
      for (const Variable inner : variables(argument)) {
        const Atom& a = atoms_[inner];
        elementary = elementary && (a.kind == Atom::Kind::pi ||
                                    (a.kind == Atom::Kind::symbol &&
                                     a.symbol->role == Symbol::Role::parameter));
      }
    }
    if (!elementary)
      throw OutsideTheory{
          "the equations hold for all parameters, and contain functions of them that may depend on "
          "each other"};
  }

  // A point of any dimension stands for its coordinates all at once and cannot be divided by.
  void require_scalar(const Polynomial& coefficient) const {
    // Also inside integrals, which are as much a point as their integrand.
    for (const Variable v : variables_within(coefficient, atoms_)) {
      const Atom& atom = atoms_[v];
      if (atom.kind != Atom::Kind::symbol && atom.kind != Atom::Kind::jet) continue;
      const Type& type = atom.kind == Atom::Kind::jet ? *atom.symbol->type.inner : atom.symbol->type;
      if (type.is_point() && type.dimension == Type::any_dimension)
        throw OutsideTheory{
            "an unknown number times a point of any dimension: declare the dimension, 'in R^3'"};
    }
  }

  LinearEquation linear(const Polynomial& equation) {
    LinearEquation result{std::vector<Fraction>(unknowns_.size()), {}};
    std::vector<std::vector<Polynomial::Term>> parts(unknowns_.size() + 1);
    for (const auto& term : equation.terms()) {
      std::size_t place = unknowns_.size();
      Monomial rest = term.monomial;
      for (const auto& p : term.monomial.powers()) {
        const auto found = std::find(unknowns_.begin(), unknowns_.end(), p.variable);
        if (found == unknowns_.end()) {
          require_free_of_unknowns(p.variable);
          continue;
        }
        if (p.exponent > 1 || place != unknowns_.size())
          throw OutsideTheory{"the equations are not linear in the unknowns"};
        place = static_cast<std::size_t>(found - unknowns_.begin());
        rest = rest.without(p.variable);
      }
      parts[place].push_back({rest, term.coefficient});
    }
    for (std::size_t k = 0; k < unknowns_.size(); ++k)
    {
      const Polynomial coefficient = Polynomial::from_terms(std::move(parts[k]));
      require_scalar(coefficient);
      result.coefficients[k] = coefficient;
    }
    result.right = scaled(Polynomial::from_terms(std::move(parts.back())), -1);
    return result;
  }

  void require_free_of_unknowns(Variable v) const {
    const std::set<Variable> within = variables_within(Polynomial::variable(v), atoms_);
    for (const Variable unknown : unknowns_)
      if (within.contains(unknown))
        throw OutsideTheory{"an unknown occurs in the argument of a function"};
  }

  const std::vector<Variable>& unknowns_;
  const Atoms& atoms_;
  std::map<Variable, bool> depends_;
};

}  // namespace

UnknownSystem solved_system(const std::vector<Statement>& equations,
                            const std::vector<Variable>& unknowns, Evaluator& evaluator,
                            Hypotheses& hypotheses, Workspace& workspace) {
  UnknownSystem result;
  result.unknowns = unknowns;
  Collector collector{unknowns, workspace.atoms};
  std::vector<LinearEquation> rows;
  for (const Statement& equation : equations) {
    const Value& left = evaluator.value(equation.left);
    const Value& right = evaluator.value(equation.right);
    keep_open(left.conditions, hypotheses, workspace, equation.span, result.conditions);
    keep_open(right.conditions, hypotheses, workspace, equation.span, result.conditions);
    for (std::size_t c = 0; c < left.components.size(); ++c) {
      const Fraction plain = normal_form(
          difference(left.components[c], right.components[c], workspace.budget), workspace);
      const Polynomial whole = normal_form(hypotheses.reduced(plain), workspace).numerator();
      hypotheses.require_proper_ranges(whole);
      hypotheses.require_unrestricted(whole);
      collector.add(whole, rows);
    }
  }
  result.solution = solution(std::move(rows), unknowns.size(), workspace.budget);
  return result;
}

}  // namespace patchproof
