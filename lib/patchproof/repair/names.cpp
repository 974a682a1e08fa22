#include <patchproof/repair/names.hpp>

#include <algorithm>

#include <patchproof/language/spline.hpp>

namespace patchproof {

namespace {

const std::string number = "number";

std::string kind_of(const Type& type) {
  if (type.is_scalar()) return "scalar";
  if (type.is_point()) return "point";
  if (type.is_matrix()) return "matrix of " + kind_of(*type.inner);
  return "function of " + std::to_string(type.parameters.size()) + " to " + kind_of(*type.inner);
}

std::string kind_of(const Entity& entity) {
  if (entity.kind == Entity::Kind::faulty) return "";
  if (entity.kind == Entity::Kind::functional)
    return "functional of " + std::to_string(entity.functional->formals.size());
  if (entity.kind == Entity::Kind::spline)
    return "spline in " + std::to_string(entity.spline->degrees.size());
  return entity.term.is_number() ? number : kind_of(entity.term.type());
}

std::string kind_of(const syntax::Definition& definition) {
  std::string result = "definition";
  for (const syntax::Formal& formal : definition.formals)
    result += " " + std::to_string(static_cast<int>(formal.type.kind));
  return result + " to " + std::to_string(static_cast<int>(definition.result.kind));
}

const std::vector<std::string> waves{"cos", "sin"};

const std::vector<std::string> matrix_builtins{
    "transpose",  "row",            "column",         "net",     "sum",   "product",
    "bezier_net", "bezier_weights", "control_points", "weights", "knots", "greville"};

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string Names::kind(const std::string& name) const {
  if (const Entity* entity = scope_.find(name)) return kind_of(*entity);
  if (const syntax::Definition* definition = library_.find(name)) return kind_of(*definition);
  return holds(waves, name) ? "wave" : "";
}

std::vector<std::string> Names::others(const std::string& name,
                                       const std::vector<std::string>& running) const {
  const std::string own = holds(running, name) ? number : kind(name);
  if (own.empty()) return {};
  std::vector<std::string> all = scope_.names();
  all.insert(all.end(), library_.names().begin(), library_.names().end());
  all.insert(all.end(), waves.begin(), waves.end());
  std::vector<std::string> result;
  for (const std::string& other : all)
    if (kind(other) == own) result.push_back(other);
  if (own == number) result.insert(result.end(), running.begin(), running.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  result.erase(std::remove(result.begin(), result.end(), name), result.end());
  return result;
}

const Type* Names::type(const std::string& name) const {
  const Entity* entity = scope_.find(name);
  return entity != nullptr && entity->kind == Entity::Kind::term ? &entity->term.type() : nullptr;
}

bool Names::may_make_matrix(const std::string& name) const {
  if (const syntax::Definition* definition = library_.find(name)) {
    using Kind = syntax::FormalType::Kind;
    const Kind kind = definition->result.kind;
    return kind == Kind::net || kind == Kind::matrix || kind == Kind::list;
  }
  return holds(matrix_builtins, name);
}

bool Names::is_parameter(const std::string& name) const {
  const Entity* entity = scope_.find(name);
  return entity != nullptr && entity->kind == Entity::Kind::term &&
         entity->term.operation() == Operation::symbol &&
         entity->term.symbol()->role == Symbol::Role::parameter;
}

}  // namespace patchproof
