#include <patchproof/symbolic/polynomial_text.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

#include <patchproof/symbolic/exact_number.hpp>
#include <patchproof/symbolic/polynomial.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using Kind = Atom::Kind;

constexpr std::size_t most_summands = 40;
constexpr int deepest_argument = 3;
constexpr std::string_view ellipsis = "…";

std::string polynomial_text(const ex& polynomial, const Atoms& atoms, int depth);

// Symbols and functions by ordinal, then what is made of numbers and other atoms.
auto rank(unsigned id, const Atoms& atoms) {
  const Atom& atom = atoms.at(id);
  const bool is_named = atom.symbol != nullptr;
  return std::tuple{is_named ? 0 : 1, is_named ? atom.symbol->ordinal : 0U, atom.component,
                    atom.orders, id};
}

// The summands with the largest first, and the powers in each by rank.
std::vector<Summand> in_order(const ex& polynomial, const Atoms& atoms) {
  const std::set<unsigned> found = atoms.occurring(polynomial);
  std::vector<unsigned> ids{found.begin(), found.end()};
  std::sort(ids.begin(), ids.end(),
            [&](unsigned a, unsigned b) { return rank(a, atoms) < rank(b, atoms); });
  std::map<unsigned, unsigned> places;
  for (std::size_t i = 0; i < ids.size(); ++i) places[ids[i]] = static_cast<unsigned>(i);

  std::vector<Summand> result = unordered_summands(polynomial, atoms);
  for (Summand& part : result) {
    for (auto& power : part.powers) power.first = places.at(power.first);
    std::sort(part.powers.begin(), part.powers.end());
  }
  std::sort(result.begin(), result.end(),
            [](const Summand& a, const Summand& b) { return is_larger(a.powers, b.powers); });
  for (Summand& part : result) {
    for (auto& power : part.powers) power.first = ids[power.first];
  }
  return result;
}

std::string component_suffix(const Type& type, int component) {
  const Type& value = type.is_function() && type.inner ? *type.inner : type;
  if (!value.is_point() || value.dimension == Type::any_dimension) return "";
  if (component < 3 && value.dimension <= 3) return std::string{"."} + "xyz"[component];
  return "." + std::to_string(component + 1);
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

// C', C'', C^(4); r_uuv; r_u4_v0 where the letters would be many.
std::string derivative_text(const Atom& atom) {
  const std::string& name = atom.symbol->name;
  if (atom.orders.size() == 1) {
    const int order = atom.orders.front();
    return order <= 3 ? name + repeated("'", order) : name + "^(" + std::to_string(order) + ")";
  }
  std::string indices;
  for (std::size_t i = 0; i < atom.orders.size(); ++i) {
    const std::string& parameter = atom.symbol->type.parameters.at(i);
    const int order = atom.orders[i];
    indices += order <= 3 ? repeated(parameter, order) : parameter + std::to_string(order);
  }
  return indices.empty() ? name : name + "_" + indices;
}

std::string arguments_text(const Atom& atom, const Atoms& atoms, int depth) {
  std::string result;
  for (const ex& argument : atom.arguments) {
    result += (result.empty() ? "" : ", ") + polynomial_text(argument, atoms, depth + 1);
  }
  return result;
}

std::string atom_text(unsigned id, const Atoms& atoms, int depth) {
  const Atom& atom = atoms.at(id);
  switch (atom.kind) {
    case Kind::letter:
      return atom.symbol->name + component_suffix(atom.symbol->type, atom.component);
    case Kind::placeholder:
      return "#" + std::to_string(atom.component + 1);
    case Kind::jet:
      return derivative_text(atom) + "(" + arguments_text(atom, atoms, depth) + ")" +
             component_suffix(atom.symbol->type, atom.component);
    case Kind::pi:
      return "pi";
    case Kind::inverse:
      return "(1/(" + arguments_text(atom, atoms, depth) + "))";
    case Kind::root:
      return "sqrt(" + arguments_text(atom, atoms, depth) + ")";
    case Kind::exponential: {
      const std::string divisor = atom.divisor.is_equal(1) ? "" : "/" + text(atom.divisor);
      return std::string{"exp("} + (atom.imaginary ? "i*" : "") +
             arguments_text(atom, atoms, depth) + divisor + ")";
    }
  }
  return "";
}

std::string summand_text(const Summand& part, const Atoms& atoms, int depth) {
  const bool is_one = part.coefficient.is_equal(1) || part.coefficient.is_equal(-1);
  const GiNaC::numeric size = part.coefficient.is_negative() ? -part.coefficient : part.coefficient;
  std::string result = is_one && !part.powers.empty() ? "" : text(size);
  for (const auto& [id, exponent] : part.powers) {
    result += (result.empty() ? "" : "*") + atom_text(id, atoms, depth);
    if (exponent != 1) result += "^" + std::to_string(exponent);
  }
  return result;
}

std::string polynomial_text(const ex& polynomial, const Atoms& atoms, int depth) {
  if (polynomial.is_zero()) return "0";
  if (depth > deepest_argument) return std::string{ellipsis};
  std::string result;
  std::size_t count = 0;
  for (const Summand& part : in_order(polynomial, atoms)) {
    const bool is_negative = part.coefficient.is_negative();
    if (result.empty()) {
      result += is_negative ? "-" : "";
    } else {
      result += is_negative ? " - " : " + ";
    }
    if (count++ == most_summands) return result + std::string{ellipsis};
    result += summand_text(part, atoms, depth);
  }
  return result;
}

}  // namespace

std::string text(const ex& polynomial, const Atoms& atoms) {
  return polynomial_text(polynomial, atoms, 0);
}

}  // namespace patchproof::symbolic
