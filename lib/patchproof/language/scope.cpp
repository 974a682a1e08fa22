#include <patchproof/language/scope.hpp>

namespace patchproof {

const Entity* Scope::find(const std::string& name) const {
  for (const Scope* scope = this; scope != nullptr; scope = scope->outer_)
    if (const Entity* entity = scope->find_here(name)) return entity;
  return nullptr;
}

const Entity* Scope::find_here(const std::string& name) const {
  const auto found = entities_.find(name);
  return found == entities_.end() ? nullptr : &found->second;
}

void Scope::declare(const std::string& name, Entity entity) {
  entities_.insert_or_assign(name, std::move(entity));
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> result;
  for (const Scope* scope = this; scope != nullptr; scope = scope->outer_)
    for (const auto& [name, entity] : scope->entities_) result.push_back(name);
  return result;
}

SymbolPointer Workshop::symbol(const std::string& name, Symbol::Role role, const Type& type,
                               int smoothness) {
  return std::make_shared<const Symbol>(Symbol{name, role, type, smoothness, ordinals_++});
}

void Workshop::count_term(const Span& span) {
  if (++terms_ > most_terms_of_a_statement)
    throw Fault{span, "this statement expands to more than " +
                          std::to_string(most_terms_of_a_statement) + " terms"};
}

}  // namespace patchproof
