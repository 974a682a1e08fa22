#include <patchproof/mutation/vocabulary.hpp>

#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

void add(const syntax::Binder& binder, Vocabulary& result) {
  result.names.emplace(binder.name.text, "index");
}

void add_parameter(const syntax::Name& name, Vocabulary& result) {
  result.names.emplace(name.text, "parameter");
  result.parameters.insert(name.text);
}

void add(const syntax::Statement& s, Vocabulary& result) {
  using Kind = syntax::Statement::Kind;
  for (const syntax::ParameterGroup& group : s.parameters)
    for (const syntax::Name& name : group.names) add_parameter(name, result);
  for (const syntax::Binder& binder : s.binders) add(binder, result);
  for (const syntax::Binder& binder : s.clauses.binders) add(binder, result);
  for (const syntax::Declarator& d : s.declarators) {
    const bool is_net = s.kind == Kind::matrix || s.kind == Kind::net || d.extents.size() == 2;
    result.names.emplace(d.name.text, is_net ? "net" : as_text(s.keyword));
    if (is_net) result.nets.insert(d.name.text);
    for (const syntax::Name& name : d.parameters) {
      if (s.kind == Kind::net)
        result.names.emplace(name.text, "index");
      else
        add_parameter(name, result);
    }
  }
}

bool differ_in_one(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  std::size_t count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k] ? 1 : 0;
  return count == 1;
}

}  // namespace

std::vector<std::string> Vocabulary::similar(const std::string& name) const {
  const auto own = names.find(name);
  if (own == names.end()) return {};
  std::vector<std::string> before;
  std::vector<std::string> after;
  for (const auto& [other, kind] : names)
    if (kind == own->second && differ_in_one(name, other))
      (other < name ? before : after).push_back(other);
  std::vector<std::string> result;
  if (!before.empty()) result.push_back(before.back());
  if (!after.empty()) result.push_back(after.front());
  return result;
}

Vocabulary vocabulary_of(const syntax::Case& written) {
  Vocabulary result;
  for (const syntax::Statement& statement : written.statements) add(statement, result);
  return result;
}

Vocabulary vocabulary_of(const syntax::Definition& written) {
  Vocabulary result;
  for (const syntax::Formal& formal : written.formals) {
    using Kind = syntax::FormalType::Kind;
    result.names.emplace(formal.name.text, "formal");
    if (formal.type.kind == Kind::net || formal.type.kind == Kind::matrix)
      result.nets.insert(formal.name.text);
    for (const syntax::Name& name : formal.type.parameters) add_parameter(name, result);
  }
  for (const syntax::Name& name : written.result.parameters) add_parameter(name, result);
  for (const syntax::Statement& statement : written.statements) add(statement, result);
  return result;
}

}  // namespace patchproof
