#include <patchproof/mutation/vocabulary.hpp>

namespace patchproof {

namespace {

void add(const syntax::Binder& binder, Vocabulary& result) {
  result.names.insert(binder.name.text);
}

void add_parameter(const syntax::Name& name, Vocabulary& result) {
  result.names.insert(name.text);
  result.parameters.insert(name.text);
}

void add(const syntax::Statement& s, Vocabulary& result) {
  using Kind = syntax::Statement::Kind;
  for (const syntax::ParameterGroup& group : s.parameters)
    for (const syntax::Name& name : group.names) add_parameter(name, result);
  for (const syntax::Binder& binder : s.binders) add(binder, result);
  for (const syntax::Binder& binder : s.clauses.binders) add(binder, result);
  for (const syntax::Declarator& d : s.declarators) {
    result.names.insert(d.name.text);
    const bool is_net = s.kind == Kind::matrix || s.kind == Kind::net || d.extents.size() == 2;
    if (is_net) result.nets.insert(d.name.text);
    for (const syntax::Name& name : d.parameters) {
      if (s.kind == Kind::net)
        result.names.insert(name.text);
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
  std::vector<std::string> result;
  for (const std::string& other : names)
    if (differ_in_one(name, other)) result.push_back(other);
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
    result.names.insert(formal.name.text);
    if (formal.type.kind == Kind::net || formal.type.kind == Kind::matrix)
      result.nets.insert(formal.name.text);
    for (const syntax::Name& name : formal.type.parameters) add_parameter(name, result);
  }
  for (const syntax::Name& name : written.result.parameters) add_parameter(name, result);
  for (const syntax::Statement& statement : written.statements) add(statement, result);
  return result;
}

}  // namespace patchproof
