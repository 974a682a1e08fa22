#include <patchproof/certificate/array_entry.hpp>
#include <patchproof/certificate/rocq_names.hpp>

#include <array>
#include <cctype>
#include <stdexcept>

namespace patchproof {

namespace {

// Words of Rocq, of the real numbers and of the support library that statements and proofs use.
const std::set<std::string>& words() {
  static const std::set<std::string> all{
      "as", "at", "cofix", "else", "end", "exists", "exists2", "fix", "for", "forall", "fun", "if",
      "IF", "in", "let", "match", "mod", "Prop", "return", "Set", "then", "Type", "using", "where",
      "with", "by", "SProp", "Int", "Var", "Add", "Sub", "Mul", "Opp", "Div", "Pow", "Bernstein",
      "App", "Integral", "Sqrt", "Lam", "Deriv", "Unknown", "Done", "Step", "Split", "R", "I", "Bern",
      "binom", "Derive", "RInt", "D_u", "D_v", "D_1", "D_2", "D_3", "sqrt", "smooth", "pow", "nat",
      "nth", "equation", "sign", "positive", "nonnegative", "different", "at_most", "less", "conj",
      "proj1", "proj2", "eq_refl", "true", "false", "Phi", "sigma", "claim", "certified", "True",
      "False", "Q", "Z", "list", "term", "fn", "S", "O", "smooth_all", "IZR", "not", "Rlt", "Rle"};
  return all;
}

}  // namespace

std::string rocq_identifier(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) {
      constexpr std::array digits{'0', '1', '2', '3', '4', '5', '6', '7',
                                  '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};
      result += {'x', digits[byte / 16], digits[byte % 16]};
    } else {
      result += std::isalnum(byte) || c == '_' || c == '\'' ? c : '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  const bool good = !result.empty() && (std::isalpha(static_cast<unsigned char>(result.front())) ||
                                        result.front() == '_');
  return good ? result : "x" + result;
}

std::string RocqVariable::type() const {
  std::string result;
  for (std::size_t k = 0; k < indices; ++k) result += "nat -> ";
  for (std::size_t k = 0; k < arity; ++k) result += "R -> ";
  return result + "R";
}

std::string RocqNames::fresh(const std::string& wanted) {
  std::string name = rocq_identifier(wanted);
  // The proofs call their hypotheses Hyp1, Hyp2, ….
  if (name.rfind("Hyp", 0) == 0) name = "x" + name;
  const std::string stem = name;
  for (int k = 2; words().contains(name) || taken_.contains(name); ++k)
    name = stem + "_" + std::to_string(k);
  taken_.insert(name);
  return name;
}

void RocqNames::add(const SymbolPointer& symbol) {
  if (places_.contains(symbol->ordinal)) return;
  const Type& type = symbol->type;
  const Type& value = type.is_function() ? *type.inner : type;
  const bool coordinates = value.component_count() > 1;
  RocqVariable variable{symbol->name, coordinates ? 1U : 0U,
                        type.is_function() ? type.parameters.size() : 0, symbol->role};
  Place place;
  const std::optional<ArrayEntry> entry = array_entry(symbol->name);
  if (entry) {
    variable.name = entry->array;
    variable.indices += entry->indices.size();
    // Only entries of one shape are one array.
    const std::string key = entry->array + " " + variable.type();
    const auto [found, is_new] = arrays_.try_emplace(key, variables_.size());
    std::vector<unsigned> cell{static_cast<unsigned>(found->second)};
    cell.insert(cell.end(), entry->indices.begin(), entry->indices.end());
    if (used_.insert(cell).second) {
      if (is_new) {
        variable.name = fresh(variable.name);
        variables_.push_back(variable);
      }
      places_.emplace(symbol->ordinal, Place{found->second, entry->indices});
      return;
    }
    variable.indices -= entry->indices.size();
  }
  variable.name = fresh(symbol->name);
  place.variable = variables_.size();
  variables_.push_back(variable);
  places_.emplace(symbol->ordinal, place);
}

std::string RocqNames::text(const Coordinate& coordinate) const {
  const Place& place = place_of(coordinate.symbol);
  const RocqVariable& variable = variables_[place.variable];
  std::string result = variable.name;
  for (const unsigned index : place.indices) result += " " + std::to_string(index) + "%nat";
  if (variable.indices > place.indices.size())
    result += " " + std::to_string(coordinate.index) + "%nat";
  return result;
}

const RocqVariable& RocqNames::variable(const SymbolPointer& symbol) const {
  return variables_.at(place_of(symbol).variable);
}

const std::vector<unsigned>& RocqNames::indices(const SymbolPointer& symbol) const {
  return place_of(symbol).indices;
}

const RocqNames::Place& RocqNames::place_of(const SymbolPointer& symbol) const {
  const auto found = places_.find(symbol->ordinal);
  if (found == places_.end()) throw std::logic_error{"nothing quantifies over " + symbol->name};
  return found->second;
}

}  // namespace patchproof
