#include <patchproof/kernel/readable.hpp>

#include <algorithm>
#include <map>

namespace patchproof {

namespace {

const char* name_of(Atom::Kind kind) {
  switch (kind) {
    case Atom::Kind::sine: return "sin";
    case Atom::Kind::cosine: return "cos";
    case Atom::Kind::exponential: return "exp";
    default: return "sqrt";
  }
}

bool is_parameter(const Atom& atom) {
  if (atom.kind == Atom::Kind::slot) return true;
  return atom.kind == Atom::Kind::symbol && (atom.symbol->role == Symbol::Role::parameter ||
                                             atom.symbol->role == Symbol::Role::bound);
}

class Writer {
 public:
  Writer(const Atoms& atoms, Budget& budget, std::size_t longest)
      : atoms_{atoms}, budget_{budget}, longest_{longest} {}

  // Remembered and cut off: nested functions would be written out again and again.
  const std::string& variable(Variable v) {
    const auto known = names_.find(v);
    if (known != names_.end()) return known->second;
    std::string name = computed_name(v);
    if (name.size() > longest_) name = name.substr(0, longest_) + "…";
    return names_.emplace(v, std::move(name)).first->second;
  }

  std::string fraction(const Fraction& f) {
    const std::string above = polynomial(f.numerator());
    if (f.is_polynomial()) return above;
    std::string below;
    for (const auto& [factor, exponent] : f.denominator()) {
      std::string text = polynomial(factor);
      if (factor.terms().size() > 1 || exponent > 1) text = "(" + text + ")";
      if (exponent > 1) text += "^" + std::to_string(exponent);
      below += (below.empty() ? "" : "*") + text;
    }
    if (f.denominator().size() > 1) below = "(" + below + ")";
    const bool plain = f.numerator().terms().size() == 1;
    return (plain ? above : "(" + above + ")") + "/" + below;
  }

 private:
  std::string computed_name(Variable v) {
    const Atom& atom = atoms_[v];
    const auto with_component = [&](const Type& type, std::string text) {
      if (!type.is_point() || type.dimension == Type::any_dimension) return text;
      return text + (atom.component < 3 ? "." + std::string(1, "xyz"[atom.component])
                                        : "[" + std::to_string(atom.component) + "]");
    };
    switch (atom.kind) {
      case Atom::Kind::symbol: return with_component(atom.symbol->type, atom.symbol->name);
      case Atom::Kind::slot:
        return atom.symbol->type.parameters.at(static_cast<std::size_t>(atom.component));
      case Atom::Kind::pi: return "pi";
      case Atom::Kind::jet: return with_component(*atom.symbol->type.inner, jet(atom));
      case Atom::Kind::running: return "t" + std::to_string(atom.component + 1);
      case Atom::Kind::integral: return integral(atom);
      default:
        return std::string{name_of(atom.kind)} + "(" + fraction(atom.arguments.front()) + ")";
    }
  }

  std::string integral(const Atom& atom) {
    std::string text = "integral(" + fraction(atom.arguments.front());
    for (std::size_t k = 1; k < atom.arguments.size(); ++k) {
      const std::vector<Fraction>& ends =
          atoms_[*variables(atom.arguments[k]).begin()].arguments;
      text += ", " + fraction(atom.arguments[k]) + " in [" + fraction(ends.at(0)) + ", " +
              fraction(ends.at(1)) + "]";
    }
    return text + ")";
  }

  std::string jet(const Atom& atom) {
    std::string text = atom.symbol->name;
    if (atom.orders.size() == 1) {
      text += std::string(static_cast<std::size_t>(atom.orders.front()), '\'');
    } else {
      std::string suffix;
      for (std::size_t k = 0; k < atom.orders.size(); ++k)
        for (int order = 0; order < atom.orders[k]; ++order)
          suffix += atom.symbol->type.parameters[k];
      if (!suffix.empty()) text += "_" + suffix;
    }
    text += "(";
    for (std::size_t k = 0; k < atom.arguments.size(); ++k)
      text += (k > 0 ? ", " : "") + fraction(atom.arguments[k]);
    return text + ")";
  }

  // Declaration order first, so that the numbers of variables never show.
  bool earlier(Variable a, Variable b) {
    if (a == b) return false;
    const Atom& x = atoms_[a];
    const Atom& y = atoms_[b];
    const auto ordinal = [](const Atom& atom) { return atom.symbol ? atom.symbol->ordinal : ~0U; };
    if (ordinal(x) != ordinal(y)) return ordinal(x) < ordinal(y);
    if (x.kind != y.kind) return x.kind < y.kind;
    if (x.component != y.component) return x.component < y.component;
    if (x.orders != y.orders) return x.orders < y.orders;
    return variable(a) < variable(b);
  }

  // Earlier variables and higher powers first.
  bool before(const Monomial& a, const Monomial& b) {
    const auto sorted = [&](const Monomial& m) {
      std::vector<Monomial::Power> powers(m.powers().begin(), m.powers().end());
      std::sort(powers.begin(), powers.end(),
                [&](const auto& x, const auto& y) { return earlier(x.variable, y.variable); });
      return powers;
    };
    const auto x = sorted(a);
    const auto y = sorted(b);
    for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
      if (x[k].variable != y[k].variable) return earlier(x[k].variable, y[k].variable);
      if (x[k].exponent != y[k].exponent) return x[k].exponent > y[k].exponent;
    }
    return x.size() > y.size();
  }

  std::string monomial(const Monomial& m) {
    std::vector<Monomial::Power> powers(m.powers().begin(), m.powers().end());
    std::sort(powers.begin(), powers.end(),
              [&](const auto& x, const auto& y) { return earlier(x.variable, y.variable); });
    std::string text;
    for (const auto& p : powers) {
      text += (text.empty() ? "" : "*") + variable(p.variable);
      if (p.exponent > 1) text += "^" + std::to_string(p.exponent);
    }
    return text;
  }

  // "+ text" or "- text" appended to a sum.
  static void append(std::string& total, bool negative, const std::string& text) {
    if (total.empty())
      total = negative ? "-" + text : text;
    else
      total += (negative ? " - " : " + ") + text;
  }

  static std::string times(const Rational& factor, const std::string& rest) {
    if (rest.empty()) return to_text(factor);
    return factor == 1 ? rest : to_text(factor) + "*" + rest;
  }

  // The terms one after the other, nothing taken out.
  std::string expanded(const Polynomial& p) {
    std::vector<Polynomial::Term> terms = p.terms();
    std::sort(terms.begin(), terms.end(), [&](const auto& a, const auto& b) {
      return before(a.monomial, b.monomial);
    });
    std::string text;
    for (const auto& term : terms) {
      if (text.size() > longest_) return text + " + …";
      append(text, term.coefficient < 0,
             times(abs(term.coefficient), monomial(term.monomial)));
    }
    return text.empty() ? "0" : text;
  }

  // A coefficient in the parameters: number * u^a * (1-u)^b * (rest).
  struct Factored {
    bool negative = false;
    Rational number = 1;
    std::string rest;
  };
  Factored factored(const Polynomial& coefficient) {
    Factored result;
    Polynomial rest = coefficient;
    for (const Variable v : ordered(coefficient.variables())) {
      const Polynomial x = Polynomial::variable(v);
      const Polynomial one_minus = Polynomial::from_terms({{Monomial{}, 1}, {Monomial{v}, -1}});
      take_out(rest, x, variable(v), result.rest);
      take_out(rest, one_minus, "(1-" + variable(v) + ")", result.rest);
    }
    std::vector<Polynomial::Term> terms = rest.terms();
    std::sort(terms.begin(), terms.end(), [&](const auto& a, const auto& b) {
      return before(a.monomial, b.monomial);
    });
    result.number = content(rest);
    result.negative = terms.front().coefficient < 0;
    rest = scaled(rest, (result.negative ? -1 : 1) / result.number);
    if (!rest.is_constant()) {
      std::string text = expanded(rest);
      if (terms.size() > 1) text = "(" + text + ")";
      result.rest += (result.rest.empty() ? "" : "*") + text;
    }
    return result;
  }

  void take_out(Polynomial& rest, const Polynomial& factor, const std::string& name,
                std::string& text) {
    unsigned exponent = 0;
    while (std::optional<Polynomial> shorter = quotient(rest, factor, budget_)) {
      rest = std::move(*shorter);
      ++exponent;
    }
    if (exponent == 0) return;
    text += (text.empty() ? "" : "*") + name;
    if (exponent > 1) text += "^" + std::to_string(exponent);
  }

  std::vector<Variable> ordered(const std::set<Variable>& variables) {
    std::vector<Variable> result(variables.begin(), variables.end());
    std::sort(result.begin(), result.end(), [&](Variable a, Variable b) { return earlier(a, b); });
    return result;
  }

  std::string polynomial(const Polynomial& p) {
    if (p.is_constant()) return to_text(p.constant());
    std::vector<std::pair<Monomial, std::vector<Polynomial::Term>>> groups;
    std::map<Monomial, std::size_t> places;
    for (const auto& term : p.terms()) {
      Monomial unknowns;
      Monomial parameters;
      for (const auto& power : term.monomial.powers()) {
        Monomial& part = is_parameter(atoms_[power.variable]) ? parameters : unknowns;
        part = part * Monomial{power.variable, power.exponent};
      }
      const auto [place, fresh] = places.try_emplace(unknowns, groups.size());
      if (fresh) groups.push_back({unknowns, {}});
      groups[place->second].second.push_back({parameters, term.coefficient});
    }
    std::sort(groups.begin(), groups.end(),
              [&](const auto& a, const auto& b) { return before(a.first, b.first); });
    std::string text;
    for (auto& [unknowns, terms] : groups) {
      if (text.size() > longest_) return text + " + …";
      const Polynomial coefficient = Polynomial::from_terms(std::move(terms));
      const std::string name = monomial(unknowns);
      if (unknowns.is_one() && groups.size() > 1 && coefficient.terms().size() > 1) {
        const std::string rest = expanded(coefficient);
        append(text, rest.front() == '-', rest.front() == '-' ? rest.substr(1) : rest);
        continue;
      }
      const Factored f = factored(coefficient);
      append(text, f.negative,
             times(f.number, f.rest.empty() || name.empty() ? f.rest + name : f.rest + "*" + name));
    }
    return text;
  }

  const Atoms& atoms_;
  Budget& budget_;
  std::size_t longest_;
  std::map<Variable, std::string> names_;
};

}  // namespace

std::string to_text(Variable variable, const Atoms& atoms) {
  Budget budget{Limits{}};
  return Writer{atoms, budget, 2000}.variable(variable);
}

std::string to_text(const Fraction& fraction, const Atoms& atoms, Budget& budget,
                    std::size_t longest) {
  return Writer{atoms, budget, longest}.fraction(fraction);
}

}  // namespace patchproof
