#include <algorithm>

#include <patchproof/language/elaborator.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

constexpr int deepest_expansion = 60;

std::string in_words(const syntax::FormalType& type) {
  using Kind = syntax::FormalType::Kind;
  switch (type.kind) {
    case Kind::scalar: return "scalar";
    case Kind::scalar_function: return "scalar function";
    case Kind::point: return "point";
    case Kind::curve: return "curve";
    case Kind::patch: return "patch";
    case Kind::volume: return "volume";
    case Kind::net: return "net";
    case Kind::matrix: return "matrix";
    case Kind::list: return "list of points";
    default: return "spline";
  }
}

std::vector<std::string> names_of(const std::vector<syntax::Name>& names) {
  std::vector<std::string> result;
  for (const syntax::Name& name : names) result.push_back(name.text);
  return result;
}

}  // namespace

// A curve or patch given as an expression in parameters, like b(u,0), is the function of them. The
// parameter meant is the one that has the wanted name where the expression stands; an expression
// in a single parameter of another name is a curve all the same.
Term Elaborator::as_function(const syntax::Formal& formal, const Term& given, const Scope& scope) {
  std::vector<std::string> wanted = names_of(formal.type.parameters);
  if (wanted.empty()) wanted = {"t"};
  if (given.type().is_function()) {
    if (given.type().parameters.size() != wanted.size())
      throw Fault{given.span(), "a " + to_text(given.type()) + " where a " +
                                    in_words(formal.type) + " is needed"};
    if (given.type().parameters == wanted) return given;
    // The definition speaks of its parameters by its own names.
    return construct_.function(wanted, given.span(), [&](const std::vector<Term>& formals) {
      return construct_.apply(given, formals, given.span());
    });
  }
  std::vector<SymbolPointer> parameters;
  for (const auto& [ordinal, symbol] : free_symbols(given))
    if (symbol->role == Symbol::Role::parameter || symbol->role == Symbol::Role::bound)
      parameters.push_back(symbol);
  Formals formals;
  for (const std::string& name : wanted) {
    const Entity* entity = scope.find(name);
    if (entity == nullptr || entity->kind != Entity::Kind::term ||
        entity->term.operation() != Operation::symbol)
      continue;
    const SymbolPointer& symbol = entity->term.symbol();
    const bool occurs =
        std::any_of(parameters.begin(), parameters.end(),
                    [&](const SymbolPointer& p) { return p->ordinal == symbol->ordinal; });
    if (occurs) formals.push_back(symbol);
  }
  if (formals.empty() && parameters.empty())
    return construct_.function(wanted, given.span(), [&](const std::vector<Term>&) { return given; });
  if (formals.empty() && wanted.size() == 1 && parameters.size() == 1) formals = {parameters.front()};
  if (formals.size() != wanted.size())
    throw Fault{given.span(),
                "it is not clear which parameter" + std::string{wanted.size() > 1 ? "s" : ""} +
                    " this " + in_words(formal.type) + " runs over",
                wanted.size() == 1
                    ? "it should depend on '" + wanted.front() + "'; or declare it: 'curve C(" +
                          wanted.front() + ") = ...'"
                : wanted.size() == 2 ? "declare it as a patch: 'patch p(u, v) = ...'"
                                     : "declare it as a volume: 'volume F(u, v, w) = ...'"};
  const Term function = construct_.lambda(formals, given, given.span());
  if (function.type().parameters == wanted) return function;
  return construct_.function(wanted, given.span(), [&](const std::vector<Term>& at) {
    return construct_.apply(function, at, given.span());
  });
}

// A matrix of one row or one column as a list.
Term Elaborator::as_list(const Term& given) {
  const Type& type = given.type();
  if (type.list) return given;
  std::vector<Term> entries;
  for (int k = 0; k < type.rows * type.columns; ++k)
    entries.push_back(construct_.entry(given, {k}, given.span()));
  return construct_.list(std::move(entries), given.span());
}

Term Elaborator::argument(const syntax::Formal& formal, const Term& given, const Scope& scope) {
  using Kind = syntax::FormalType::Kind;
  const std::string what = "argument '" + formal.name.text + "'";
  const auto wrong = [&]() -> Term {
    throw Fault{given.span(), what + " has to be a " + in_words(formal.type) + ", not a " +
                                  to_text(given.type())};
  };
  switch (formal.type.kind) {
    case Kind::scalar: return construct_.scalar(scope, given, what);
    case Kind::point: {
      const Term value = decayed(construct_.value(scope, given));
      return value.type().is_matrix() ? wrong() : value;
    }
    case Kind::scalar_function:
    case Kind::curve:
    case Kind::patch:
    case Kind::volume: {
      const Term plain = given.type().is_matrix() ? decayed(given) : given;
      if (plain.type().is_matrix()) return wrong();
      const Term function = as_function(formal, plain, scope);
      const bool scalar_needed = formal.type.kind == Kind::scalar_function;
      if (scalar_needed && !function.type().inner->is_scalar()) return wrong();
      if (function.type().inner->is_matrix()) return wrong();
      return function;
    }
    case Kind::list: {
      const Type& type = given.type();
      return type.is_matrix() && (type.rows == 1 || type.columns == 1) ? as_list(given) : wrong();
    }
    default: return given.type().is_matrix() && !given.type().list ? given : wrong();
  }
}

Term Elaborator::definition_call(const syntax::Definition& definition,
                                 const syntax::Expression& call, const Scope& scope) {
  if (call.arguments.size() != definition.formals.size()) {
    std::string usage = definition.name.text + "(";
    for (const syntax::Formal& formal : definition.formals)
      usage += (usage.back() == '(' ? "" : ", ") + formal.name.text;
    throw Fault{call.span, "'" + definition.name.text + "' takes " +
                               std::to_string(definition.formals.size()) + " argument" +
                               (definition.formals.size() == 1 ? "" : "s") + ", not " +
                               std::to_string(call.arguments.size()),
                usage + ")"};
  }
  Scope inside;
  std::vector<Term> arguments;
  for (std::size_t k = 0; k < definition.formals.size(); ++k) {
    const syntax::Formal& formal = definition.formals[k];
    const syntax::Argument& given = call.arguments[k];
    if (!given.value) throw Fault{call.span, "a running index is not an argument of a definition"};
    if (formal.type.kind == syntax::FormalType::Kind::spline) {
      inside.declare(formal.name.text,
                     Entity{Entity::Kind::spline,
                            {},
                            std::make_shared<const Spline>(spline(*given.value, scope)),
                            {}});
      continue;
    }
    arguments.push_back(argument(formal, expression(*given.value, scope), scope));
    inside.declare(formal.name.text, arguments.back());
  }
  return expanded(definition, inside, std::move(arguments), call.span);
}

Term Elaborator::expanded(const syntax::Definition& definition, Scope& inside,
                          std::vector<Term> arguments, const Span& span) {
  if (workshop_.expansion_depth >= deepest_expansion)
    throw Fault{span, "definitions are nested more than " + std::to_string(deepest_expansion) +
                          " deep"};
  struct Depth {
    explicit Depth(int& d) : depth{d} { ++depth; }
    ~Depth() { --depth; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    int& depth;
  } depth{workshop_.expansion_depth};
  try {
    const std::vector<std::string> parameters = names_of(definition.result.parameters);
    Formals formals;
    for (const std::string& name : parameters) {
      formals.push_back(workshop_.symbol(name, Symbol::Role::bound, Type::scalar()));
      inside.declare(name, symbol_term(formals.back(), span));
    }
    for (const syntax::Statement& statement : definition.statements) {
      if (statement.kind != syntax::Statement::Kind::let) continue;
      for (const syntax::Declarator& local : statement.declarators)
        inside.declare(local.name.text, expression(*local.value, inside));
    }
    Term value = expression(*definition.value, inside);
    if (formals.empty()) {
      const bool column = value.type().is_matrix() && value.type().columns == 1;
      if (definition.result.kind == syntax::FormalType::Kind::list && column) value = as_list(value);
      return construct_.definition(definition.name.text, value, arguments, span);
    }
    if (value.type().is_function()) {
      std::vector<Term> at;
      for (const SymbolPointer& formal : formals) at.push_back(symbol_term(formal, span));
      value = construct_.apply(value, std::move(at), span);
    }
    const Term function = construct_.lambda(formals, decayed(value), span);
    return construct_.definition(definition.name.text, function, std::move(arguments), span);
  } catch (const Fault& fault) {
    const std::string prefix = "in '" + definition.name.text + "': ";
    const bool nested = fault.diagnostic.message.compare(0, 4, "in '") == 0;
    throw Fault{span, nested ? fault.diagnostic.message : prefix + fault.diagnostic.message,
                fault.diagnostic.help};
  }
}

// H03 alone, where H03(t) is defined for scalars, is the function t -> H03(t).
Term Elaborator::definition_as_function(const syntax::Definition& definition, const Span& span) {
  using Kind = syntax::FormalType::Kind;
  if (definition.formals.empty()) {
    Scope inside;
    return expanded(definition, inside, {}, span);
  }
  std::vector<std::string> names;
  for (const syntax::Formal& formal : definition.formals) {
    if (formal.type.kind != Kind::scalar || !definition.result.parameters.empty())
      throw Fault{span, "'" + definition.name.text + "' needs arguments"};
    names.push_back(formal.name.text);
  }
  return construct_.function(names, span, [&](const std::vector<Term>& formals) {
    Scope inside;
    for (std::size_t k = 0; k < names.size(); ++k) inside.declare(names[k], formals[k]);
    return expanded(definition, inside, formals, span);
  });
}

}  // namespace patchproof
