#include <patchproof/certificate/array_entry.hpp>
#include <patchproof/certificate/python_names.hpp>
#include <patchproof/certificate/rocq_names.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// Words of Python and of what stands at the top of a script.
const std::set<std::string>& words() {
  static const std::set<std::string> all{
      "Add", "CLAIMS", "Dummy", "False", "Function", "Integral", "None", "QQ", "Rational", "S",
      "Symbol", "True", "all", "and", "any", "array", "as", "assert", "async", "at", "await",
      "bernstein", "binomial", "bool", "break", "cache", "cancel", "claim", "class", "continue",
      "def", "del", "derivative", "dict", "diff", "differs", "elif", "else", "everything",
      "except", "expand", "failed", "field", "finally", "for", "fraction", "from", "getattr",
      "global", "holds", "if", "import", "in", "int", "integral", "integrate", "is",
      "is_not_negative", "is_positive", "is_zero", "isinstance", "key", "label", "lambda", "len",
      "list", "map", "max", "nonlocal", "not", "operator", "or", "parts", "pass", "place",
      "print", "product", "raise", "range", "reduce", "return", "set", "simplify", "sorted",
      "sqrt", "str", "sum", "super", "sys", "tidy", "together", "try", "tuple", "type", "unknown",
      "values", "while", "with", "yield", "zip"};
  return all;
}

// Names that the checks of claims give to what they use.
bool is_local(const std::string& name) {
  return name.rfind("fact_", 0) == 0 || name.rfind("assumed_", 0) == 0 ||
         name.rfind("claim_", 0) == 0;
}

std::string in_brackets(const std::vector<unsigned>& indices) {
  std::string result;
  for (const unsigned index : indices) result += (result.empty() ? "" : ", ") + std::to_string(index);
  return result;
}

}  // namespace

std::string python_identifier(const std::string& name) {
  std::string result;
  for (const char c : rocq_identifier(name))
    result += c == '\'' ? std::string{"_prime"} : std::string{c};
  return result;
}

std::string PythonNames::name_not_taken(const std::string& wanted, bool global) const {
  std::string stem = python_identifier(wanted);
  if (global && is_local(stem)) stem = "x_" + stem;
  std::string name = stem;
  for (int k = 2; is_taken(name) || (global && formals_.contains(name)); ++k)
    name = stem + "_" + std::to_string(k);
  return name;
}

std::string PythonNames::fresh(const std::string& wanted) {
  const bool of_claim = wanted.rfind("claim_", 0) == 0;
  const std::string name = name_not_taken(wanted, !of_claim);
  taken_.insert(name);
  return name;
}

bool PythonNames::is_taken(const std::string& name) const {
  return words().contains(name) || taken_.contains(name);
}

const PythonNames::Place& PythonNames::place_of(const SymbolPointer& symbol) {
  const auto found = places_.find(symbol->ordinal);
  if (found != places_.end()) return found->second;
  const Type& type = symbol->type;
  const Type& value = type.is_function() ? *type.inner : type;
  Place place{variables_.size(), {}, value.component_count() > 1};
  Variable variable{"", type.is_function() ? type.parameters.size() : 0, {}, symbol->ordinal};
  std::string wanted = symbol->name;
  if (const auto entry = array_entry(symbol->name)) {
    wanted = entry->array;
    // Only entries of one shape are one array.
    const std::string key = wanted + " " + std::to_string(entry->indices.size()) + " " +
                            std::to_string(variable.arity) + " " +
                            std::to_string(value.component_count());
    const auto [known, is_new] = arrays_.try_emplace(key, variables_.size());
    std::vector<unsigned> cell{static_cast<unsigned>(known->second)};
    cell.insert(cell.end(), entry->indices.begin(), entry->indices.end());
    if (used_.insert(cell).second) {
      place.variable = known->second;
      place.indices = entry->indices;
    } else {
      wanted = symbol->name;
    }
  }
  if (place.variable == variables_.size()) {
    // A symbol may have the name of a formal parameter: that one is only chosen when it is not used.
    variable.name = name_not_taken(wanted, false);
    if (is_local(variable.name)) variable.name = name_not_taken("x_" + variable.name, false);
    taken_.insert(variable.name);
    if (symbol->role == Symbol::Role::parameter) parameters_.insert(variable.name);
    variable.sizes.assign(place.indices.size(), 1);
    if (place.coordinates) variable.sizes.push_back(static_cast<unsigned>(value.component_count()));
    variables_.push_back(variable);
  }
  Variable& own = variables_[place.variable];
  for (std::size_t k = 0; k < place.indices.size(); ++k)
    own.sizes[k] = std::max(own.sizes[k], place.indices[k] + 1);
  return places_.emplace(symbol->ordinal, std::move(place)).first->second;
}

std::string PythonNames::text(const Coordinate& coordinate) {
  const Place& place = place_of(coordinate.symbol);
  std::vector<unsigned> indices = place.indices;
  if (place.coordinates) indices.push_back(static_cast<unsigned>(coordinate.index));
  const std::string& name = variables_[place.variable].name;
  return indices.empty() ? name : name + "[" + in_brackets(indices) + "]";
}

const std::string& PythonNames::stem(const SymbolPointer& symbol) {
  return variables_[place_of(symbol).variable].name;
}

std::string PythonNames::declarations() const {
  std::vector<Variable> ordered = variables_;
  std::sort(ordered.begin(), ordered.end(),
            [](const Variable& a, const Variable& b) { return a.ordinal < b.ordinal; });
  std::string result;
  for (const Variable& variable : ordered) {
    const std::string quoted = "\"" + variable.name + "\"";
    std::string made = variable.arity == 0
                           ? "Symbol(" + quoted + ")"
                           : "unknown(" + quoted + ", " + std::to_string(variable.arity) + ")";
    if (!variable.sizes.empty())
      made = variable.arity == 0
                 ? "array(" + quoted + ", " + in_brackets(variable.sizes) + ")"
                 : "array(" + quoted + ", " + in_brackets(variable.sizes) +
                       ", arity=" + std::to_string(variable.arity) + ")";
    result += variable.name + " = " + made + "\n";
  }
  return result;
}

}  // namespace patchproof
