#include <algorithm>

#include <patchproof/language/case_elaborator.hpp>
#include <patchproof/language/kind_words.hpp>

namespace patchproof {

namespace {

// What is written there, with single spaces, and without the word it begins with.
std::string one_line(const Span& span) {
  std::string result;
  for (std::size_t k = span.begin; k < span.end; ++k) {
    const char c = span.source->text[k];
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  return result.substr(result.find(' ') + 1);
}

}  // namespace

void require_different(const std::vector<syntax::Name>& parameters) {
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (std::size_t earlier = 0; earlier < k; ++earlier)
      if (parameters[earlier].text == parameters[k].text)
        throw Fault{parameters[k].span,
                    "the parameter '" + parameters[k].text + "' occurs twice"};
}

Formals CaseElaborator::formals_of(const std::vector<syntax::Name>& names, Scope& inner) {
  Formals formals;
  require_different(names);
  for (const syntax::Name& name : names) {
    const Entity* entity = scope_.find(name.text);
    const bool parameter = entity != nullptr && entity->kind == Entity::Kind::term &&
                           entity->term.operation() == Operation::symbol &&
                           entity->term.symbol()->role == Symbol::Role::parameter;
    formals.push_back(parameter ? entity->term.symbol()
                                : workshop_.symbol(name.text, Symbol::Role::bound, Type::scalar()));
    inner.declare(name.text, symbol_term(formals.back(), name.span));
  }
  return formals;
}

Term CaseElaborator::unknown_function(const syntax::Statement& statement,
                                      const syntax::Declarator& declarator, const Type& value) {
  require_different(declarator.parameters);
  std::vector<std::string> names;
  for (const syntax::Name& name : declarator.parameters) names.push_back(name.text);
  const int smoothness = statement.smoothness ? statement.smoothness->order : 0;
  return symbol_term(workshop_.symbol(declarator.name.text, Symbol::Role::function,
                                      Type::function(names, value), smoothness),
                     declarator.name.span);
}

// `patch p(u,v) : degree (3,3)`: a Bézier patch of unknown control points p[i,j].
Term CaseElaborator::degree_function(const syntax::Statement& statement,
                                     const syntax::Declarator& declarator, const Type& value) {
  const Span& span = declarator.name.span;
  constexpr int highest = 60;
  if (statement.degrees.size() != declarator.parameters.size())
    throw Fault{span, "one degree is needed for each parameter"};
  std::vector<int> degrees = statement.degrees;
  for (const int degree : degrees)
    if (degree < 0 || degree > highest)
      throw Fault{span, "a degree has to lie between 0 and " + std::to_string(highest)};
  require_different(declarator.parameters);
  Construction& construct = elaborator_.construct();
  std::vector<std::string> names;
  for (const syntax::Name& name : declarator.parameters) names.push_back(name.text);
  return construct.function(names, span, [&](const std::vector<Term>& t) {
    const auto basis = [&](std::size_t k, int i) {
      return construct.make(Operation::bernstein, Type::scalar(), {t[k]}, Indices{degrees[k], i},
                            span);
    };
    std::vector<Term> parts;
    for (int i = 0; i <= degrees[0]; ++i) {
      for (int j = 0; j <= (degrees.size() > 1 ? degrees[1] : 0); ++j) {
        const std::string name = declarator.name.text + "[" + std::to_string(i) +
                                 (degrees.size() > 1 ? "," + std::to_string(j) : "") + "]";
        const auto role = value.is_point() ? Symbol::Role::point : Symbol::Role::scalar;
        std::vector<Term> factors{basis(0, i)};
        if (degrees.size() > 1) factors.push_back(basis(1, j));
        factors.push_back(symbol_term(workshop_.symbol(name, role, value), span));
        const std::string signs(factors.size(), '*');
        parts.push_back(construct.product(scope_, std::move(factors), signs, span));
      }
    }
    const std::string signs(parts.size(), '+');
    return construct.sum(scope_, std::move(parts), signs, span);
  });
}

Term CaseElaborator::defined_function(const syntax::Declarator& declarator) {
  Scope inner{&scope_};
  const Formals formals = formals_of(declarator.parameters, inner);
  Term value = elaborator_.expression(*declarator.value, inner);
  Construction& construct = elaborator_.construct();
  if (value.type().is_function()) {
    if (value.type().parameters.size() != formals.size())
      throw Fault{declarator.value->span, "'" + declarator.name.text + "' has " +
                                              std::to_string(formals.size()) +
                                              " parameters, and this is a " + to_text(value.type())};
    std::vector<Term> at;
    for (const SymbolPointer& formal : formals) at.push_back(symbol_term(formal, value.span()));
    value = construct.apply(value, std::move(at), declarator.value->span);
  }
  value = decayed(value);
  if (value.type().is_matrix())
    throw Fault{declarator.value->span, "a function has scalars or points as values, not a " +
                                            to_text(value.type())};
  return construct.lambda(formals, value, declarator.name.span);
}

void CaseElaborator::declare_functions(const syntax::Statement& statement) {
  const Type value =
      Type::point(statement.dimension == 0 ? Type::any_dimension : statement.dimension);
  const bool curve = statement.kind == syntax::Statement::Kind::curve;
  const bool patch = statement.kind == syntax::Statement::Kind::patch;
  for (const syntax::Declarator& declarator : statement.declarators) {
    require_new(declarator.name);
    const std::size_t expected = curve ? 1 : patch ? 2 : 3;
    if (declarator.parameters.size() != expected)
      throw Fault{declarator.name.span, curve   ? "a curve has one parameter, as in C(u)"
                                        : patch ? "a patch has two parameters, as in r(u, v)"
                                                : "a volume has three parameters, as in F(u, v, w)"};
    const Term term = declarator.value ? defined_function(declarator)
                      : !statement.degrees.empty()
                          ? degree_function(statement, declarator, value)
                          : unknown_function(statement, declarator, value);
    if (declarator.value && statement.dimension > 0 && !(*term.type().inner == value))
      throw Fault{declarator.name.span, "the value of '" + declarator.name.text + "' is a " +
                                            to_text(*term.type().inner)};
    declare_name(declarator.name, term);
  }
}

void CaseElaborator::record(const syntax::Statement& statement, Case& result) const {
  const std::string instance = instance_.empty() ? "" : "[" + instance_ + "]";
  const auto add = [&](const syntax::Name& name, bool given) {
    const Entity* entity = scope_.find_here(name.text);
    if (entity == nullptr || entity->kind != Entity::Kind::term) return;
    result.declarations.push_back({name.text, std::string{text_of(statement.kind)}, instance,
                                   entity->term, given, name.span});
  };
  bool is_term = true;
  for (const syntax::Declarator& declarator : statement.declarators) {
    add(declarator.name, !declarator.value && !declarator.file && !statement.spline);
    const Entity* entity = scope_.find_here(declarator.name.text);
    is_term = is_term && (entity == nullptr || entity->kind == Entity::Kind::term);
  }
  if (is_term) return record_parameters(statement, result);
  const std::string written = one_line(statement.span);
  if (std::find(result.written.begin(), result.written.end(), written) == result.written.end())
    result.written.push_back(written);
}

void CaseElaborator::record_parameters(const syntax::Statement& statement, Case& result) const {
  const std::string instance = instance_.empty() ? "" : "[" + instance_ + "]";
  for (const syntax::ParameterGroup& group : statement.parameters)
    for (const syntax::Name& name : group.names)
      if (const Entity* entity = scope_.find_here(name.text))
        result.declarations.push_back({name.text, std::string{text_of(statement.kind)}, instance,
                                       entity->term, true, name.span});
}

}  // namespace patchproof
