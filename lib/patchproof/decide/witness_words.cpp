#include <patchproof/decide/witness_words.hpp>

#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

// A point of any dimension is a tuple of one number: the brackets would say nothing.
std::string value_text(const Term& value) {
  if (value.operation() == Operation::lambda) return value_text(value.child(0));
  if (value.operation() == Operation::tuple && value.children().size() == 1)
    return to_text(value.child(0));
  return to_text(value);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> in_words(const Witness& witness) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const KnownValue& value : witness.values) {
    std::string name = value.symbol->name;
    if (value.symbol->role == Symbol::Role::function) {
      name += "(";
      for (const std::string& parameter : value.symbol->type.parameters)
        name += (name.back() == '(' ? "" : ", ") + parameter;
      name += ")";
    }
    result.emplace_back(name, value_text(value.value));
  }
  return result;
}

}  // namespace patchproof
