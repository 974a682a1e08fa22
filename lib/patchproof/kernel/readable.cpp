#include <patchproof/kernel/readable.hpp>

#include <map>

#include <patchproof/kernel/arrangement.hpp>

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

class Writer {
 public:
  Writer(const Atoms& atoms, Budget& budget, std::size_t longest)
      : atoms_{atoms},
        longest_{longest},
        arrangement_{atoms, budget, [this](Variable v) { return variable(v); }} {}
  // The arrangement asks this very writer for names.
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

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

  std::string monomial(const Monomial& m) {
    std::string text;
    for (const auto& p : arrangement_.powers(m)) {
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
    std::string text;
    for (const auto& term : arrangement_.terms(p)) {
      if (text.size() > longest_) return text + " + …";
      append(text, term.coefficient < 0,
             times(abs(term.coefficient), monomial(term.monomial)));
    }
    return text.empty() ? "0" : text;
  }

  // u^a * (1-u)^b * (rest)
  std::string factors(const Arrangement::Factored& factored) {
    std::string text;
    for (const auto& [factor, exponent] : factored.factors) {
      const std::string name = factor.terms().size() == 1
                                   ? expanded(factor)
                                   : "(1-" + variable(*factor.variables().begin()) + ")";
      text += (text.empty() ? "" : "*") + name;
      if (exponent > 1) text += "^" + std::to_string(exponent);
    }
    if (factored.rest.is_constant()) return text;
    const std::string rest = expanded(factored.rest);
    return text + (text.empty() ? "" : "*") +
           (factored.rest.terms().size() > 1 ? "(" + rest + ")" : rest);
  }

  std::string polynomial(const Polynomial& p) {
    if (p.is_constant()) return to_text(p.constant());
    const std::vector<Arrangement::Group> groups = arrangement_.groups(p);
    std::string text;
    for (const auto& [unknowns, coefficient] : groups) {
      if (text.size() > longest_) return text + " + …";
      const std::string name = monomial(unknowns);
      if (unknowns.is_one() && groups.size() > 1 && coefficient.terms().size() > 1) {
        const std::string rest = expanded(coefficient);
        append(text, rest.front() == '-', rest.front() == '-' ? rest.substr(1) : rest);
        continue;
      }
      const Arrangement::Factored f = arrangement_.factored(coefficient);
      const std::string rest = factors(f);
      append(text, f.negative,
             times(f.number, rest.empty() || name.empty() ? rest + name : rest + "*" + name));
    }
    return text;
  }

  const Atoms& atoms_;
  std::size_t longest_;
  Arrangement arrangement_;
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
