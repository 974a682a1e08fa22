#include <patchproof/symbolic/substitution.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <patchproof/symbolic/derivation.hpp>
#include <patchproof/symbolic/elements.hpp>
#include <patchproof/symbolic/exponentials.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using Kind = Atom::Kind;

}  // namespace

Substitution::Substitution(Ring& ring, Replacements replacements)
    : ring_{ring}, replacements_{std::move(replacements)}, images_{replacements_.atoms} {}

bool Substitution::is_affected(unsigned id) {
  const auto known = affected_.find(id);
  if (known != affected_.end()) return known->second;
  const std::set<unsigned>& within = ring_.atoms().within(id);
  const bool result = std::any_of(within.begin(), within.end(), [&](unsigned inner) {
    const Atom& atom = ring_.atoms().at(inner);
    return replacements_.atoms.contains(inner) ||
           (atom.kind == Kind::jet &&
            replacements_.functions.contains({atom.symbol->ordinal, atom.component}));
  });
  return affected_[id] = result;
}

const ex& Substitution::image(unsigned id) {
  const auto known = images_.find(id);
  if (known != images_.end()) return known->second;
  const ex result = new_image(ring_.atoms().at(id));
  return images_.emplace(id, result).first->second;
}

ex Substitution::image_of_jet(const Atom& atom, const FunctionValue& function) {
  ex value = function.value;
  for (std::size_t i = 0; i < atom.orders.size(); ++i) {
    value = derivative(ring_, value, function.formals.at(i), atom.orders[i]);
  }
  Replacements arguments;
  for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
    arguments.atoms[function.formals.at(i)] = (*this)(atom.arguments[i]);
  }
  return Substitution{ring_, std::move(arguments)}(value);
}

ex Substitution::new_image(const Atom& atom) {
  switch (atom.kind) {
    case Kind::jet: {
      const auto function = replacements_.functions.find({atom.symbol->ordinal, atom.component});
      if (function != replacements_.functions.end()) return image_of_jet(atom, function->second);
      GiNaC::exvector arguments;
      for (const ex& argument : atom.arguments) arguments.push_back((*this)(argument));
      return jet(ring_, atom.symbol, atom.component, atom.orders, arguments);
    }
    case Kind::inverse:
      return inverse(ring_, (*this)(atom.arguments.front()));
    case Kind::root:
      return square_root(ring_, (*this)(atom.arguments.front()));
    case Kind::exponential: {
      const ex unit = atom.imaginary ? ex{GiNaC::I} : ex{1};
      const ex argument = (*this)(atom.arguments.front());
      return exponential(ring_, ring_.product(argument, unit / atom.divisor));
    }
    case Kind::letter:
    case Kind::placeholder:
    case Kind::pi:
      break;
  }
  throw std::logic_error{"an atom without arguments has no image"};
}

ex Substitution::operator()(const ex& polynomial) {
  const auto affected = [this](unsigned id) { return is_affected(id); };
  const std::set<unsigned> ids = ring_.atoms().occurring(polynomial);
  if (std::none_of(ids.begin(), ids.end(), affected)) return polynomial;
  std::map<std::pair<unsigned, long>, ex> powers_of_images;
  GiNaC::exvector parts;
  for (const auto& [powers, coefficient] : coefficients(polynomial, ring_.atoms(), affected)) {
    ex part = coefficient;
    for (const auto& power : powers) {
      auto found = powers_of_images.find(power);
      if (found == powers_of_images.end()) {
        const ex value = whole_power(ring_, image(power.first), power.second);
        found = powers_of_images.emplace(power, value).first;
      }
      part = ring_.product(part, found->second);
    }
    parts.push_back(part);
  }
  return ring_.sum(parts);
}

}  // namespace patchproof::symbolic
