#include <patchproof/certificate/term_table.hpp>

#include <stdexcept>

namespace patchproof {

namespace {

using Json = CertificateJson;

const char* name_of(Operation operation) {
  switch (operation) {
    case Operation::number:
      return "number";
    case Operation::pi:
      return "pi";
    case Operation::symbol:
      return "symbol";
    case Operation::tuple:
      return "tuple";
    case Operation::matrix:
      return "matrix";
    case Operation::sum:
      return "sum";
    case Operation::negation:
      return "negation";
    case Operation::product:
      return "product";
    case Operation::quotient:
      return "quotient";
    case Operation::power:
      return "power";
    case Operation::sine:
      return "sine";
    case Operation::cosine:
      return "cosine";
    case Operation::exponential:
      return "exponential";
    case Operation::square_root:
      return "square_root";
    case Operation::lambda:
      return "lambda";
    case Operation::apply:
      return "apply";
    case Operation::derivative:
      return "derivative";
    case Operation::component:
      return "component";
    case Operation::entry:
      return "entry";
    case Operation::slice:
      return "slice";
    case Operation::transpose:
      return "transpose";
    case Operation::matrix_product:
      return "matrix_product";
    case Operation::determinant:
      return "determinant";
    case Operation::dot:
      return "dot";
    case Operation::cross:
      return "cross";
    case Operation::bernstein:
      return "bernstein";
    case Operation::bspline_basis:
      return "bspline_basis";
    case Operation::integral:
      return "integral";
    case Operation::definition:
      return "definition";
  }
  throw std::logic_error{"an operation without a name"};
}

const char* name_of(Symbol::Role role) {
  switch (role) {
    case Symbol::Role::parameter:
      return "parameter";
    case Symbol::Role::scalar:
      return "scalar";
    case Symbol::Role::point:
      return "point";
    case Symbol::Role::function:
      return "function";
    case Symbol::Role::bound:
      return "bound";
  }
  throw std::logic_error{"a role without a name"};
}

Json type_of(const Type& type) {
  switch (type.kind) {
    case Type::Kind::scalar:
      return "scalar";
    case Type::Kind::point:
      if (type.dimension == Type::any_dimension) return Json{{"point", "any"}};
      return Json{{"point", type.dimension}};
    case Type::Kind::function:
      return Json{{"function", type.parameters}, {"to", type_of(*type.inner)}};
    default:
      throw std::logic_error{"a symbol that is a matrix"};
  }
}

}  // namespace

std::size_t TermTable::node(const Term& term) {
  if (!term) throw std::logic_error{"a certificate with an empty term"};
  const auto known = known_.find(term.address());
  if (known != known_.end()) return known->second;
  Json children = Json::array();
  for (const Term& child : term.children()) children.push_back(node(child));
  Json written = node_without_children(term);
  if (!children.empty()) written["children"] = std::move(children);
  const auto [place, fresh] = written_.emplace(written.dump(), nodes_.size());
  if (fresh) nodes_.push_back(std::move(written));
  seen_.push_back(term);
  known_.emplace(term.address(), place->second);
  return place->second;
}

Json TermTable::node_without_children(const Term& term) {
  Json node;
  node["operation"] = name_of(term.operation());
  switch (term.operation()) {
    case Operation::number:
      node["value"] = to_text(term.number());
      break;
    case Operation::symbol:
      node["symbol"] = symbol(term.symbol());
      break;
    case Operation::tuple:
      if (term.type().dimension == Type::any_dimension) node["any_dimension"] = true;
      break;
    case Operation::matrix:
      node["rows"] = term.type().rows;
      node["columns"] = term.type().columns;
      break;
    case Operation::power:
      node["exponent"] = term.exponent();
      break;
    case Operation::lambda:
      node["formals"] = Json::array();
      for (const SymbolPointer& formal : term.formals()) node["formals"].push_back(symbol(formal));
      break;
    case Operation::derivative:
      node["orders"] = term.indices();
      break;
    case Operation::component:
    case Operation::entry:
    case Operation::slice:
      node["indices"] = term.indices();
      break;
    case Operation::bernstein:
      node["degree"] = term.indices().at(0);
      node["index"] = term.indices().at(1);
      break;
    case Operation::bspline_basis: {
      const BasisFunction& function = term.basis_function();
      node["degree"] = function.degree;
      node["index"] = function.index;
      node["span"] = function.span;
      node["knots"] = Json::array();
      for (const Rational& knot : function.knots) node["knots"].push_back(to_text(knot));
      break;
    }
    case Operation::definition:
      node["name"] = term.name();
      break;
    default:
      break;
  }
  return node;
}

std::size_t TermTable::symbol(const SymbolPointer& symbol) {
  const auto [place, fresh] = symbol_indices_.emplace(symbol->ordinal, symbols_.size());
  if (fresh) {
    symbols_.push_back(symbol);
    return place->second;
  }
  const Symbol& known = *symbols_[place->second];
  if (known.role != symbol->role || !(known.type == symbol->type))
    throw std::logic_error{"the symbols '" + known.name + "' and '" + symbol->name +
                           "' have the same ordinal"};
  return place->second;
}

Json TermTable::symbols() const {
  Json result = Json::array();
  for (const SymbolPointer& symbol : symbols_) {
    Json entry{{"name", symbol->name},
               {"role", name_of(symbol->role)},
               {"type", type_of(symbol->type)},
               {"ordinal", symbol->ordinal}};
    if (symbol->role == Symbol::Role::function) entry["smoothness"] = symbol->smoothness;
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace patchproof
