#include <algorithm>

#include <patchproof/language/builtin_splines.hpp>
#include <patchproof/language/builtins.hpp>
#include <patchproof/language/case_elaborator.hpp>
#include <patchproof/language/functional.hpp>

namespace patchproof {

namespace {

using syntax::Declarator;

Type point_type(const syntax::Statement& statement) {
  return Type::point(statement.dimension == 0 ? Type::any_dimension : statement.dimension);
}

}  // namespace

CaseElaborator::CaseElaborator(const Library& library, std::string instance,
                               std::vector<Diagnostic>& diagnostics)
    : elaborator_{library, workshop_}, instance_{std::move(instance)}, diagnostics_{diagnostics} {}

void CaseElaborator::declare_number(const std::string& name, int value, const Span& span) {
  scope_.declare(name, number_term(value, span));
}

void CaseElaborator::require_new(const syntax::Name& name) {
  if (const Entity* old = scope_.find_here(name.text)) {
    const Position at = old->declared.source
                            ? position_of(*old->declared.source, old->declared.begin)
                            : Position{};
    throw Fault{name.span, "'" + name.text + "' is declared twice (first on line " +
                               std::to_string(at.line) + ")"};
  }
  if (name.text.find('\'') != std::string::npos)
    throw Fault{name.span, "a name cannot contain ' because that marks derivatives"};
  if (is_builtin(name.text) || name.text == "pi")
    throw Fault{name.span, "'" + name.text + "' has a meaning of its own and cannot be declared"};
  if (elaborator_.library().find(name.text) != nullptr)
    throw Fault{name.span, "'" + name.text + "' is already a definition",
                "see 'patchproof definitions " + name.text + "'"};
  const std::size_t underscore = name.text.rfind('_');
  if (underscore == std::string::npos || underscore == 0) return;
  const Entity* base = scope_.find(name.text.substr(0, underscore));
  if (base == nullptr || base->kind != Entity::Kind::term || !base->term.type().is_function())
    return;
  std::string letters = name.text.substr(underscore + 1);
  for (const std::string& parameter : base->term.type().parameters)
    for (std::size_t at = letters.find(parameter); at != std::string::npos;
         at = letters.find(parameter))
      letters.erase(at, parameter.size());
  if (letters.empty())
    throw Fault{name.span, "'" + name.text + "' already means a derivative of '" +
                               name.text.substr(0, underscore) + "'"};
}

void CaseElaborator::declare_name(const syntax::Name& name, const Term& term) {
  require_new(name);
  scope_.declare(name.text, Entity{Entity::Kind::term, term, nullptr, name.span});
}

void CaseElaborator::mark_faulty(const syntax::Statement& statement) {
  const auto mark = [&](const syntax::Name& name) {
    if (scope_.find_here(name.text) == nullptr)
      scope_.declare(name.text, Entity{Entity::Kind::faulty, {}, nullptr, name.span});
  };
  for (const Declarator& declarator : statement.declarators) mark(declarator.name);
  for (const syntax::ParameterGroup& group : statement.parameters)
    for (const syntax::Name& name : group.names) mark(name);
}

void CaseElaborator::declare_parameters(const syntax::Statement& statement) {
  for (const syntax::ParameterGroup& group : statement.parameters) {
    const Term lower =
        elaborator_.construct().scalar(scope_, elaborator_.expression(*group.range.lower, scope_),
                                       "the end of a range");
    const Term upper =
        elaborator_.construct().scalar(scope_, elaborator_.expression(*group.range.upper, scope_),
                                       "the end of a range");
    if (lower.is_number() && upper.is_number() && lower.number() >= upper.number())
      throw Fault{group.range.span, "the empty range [" + to_text(lower.number()) + ", " +
                                        to_text(upper.number()) + "]",
                  "the lower end comes first, and is smaller than the upper one"};
    for (const syntax::Name& name : group.names) {
      require_new(name);
      const SymbolPointer symbol =
          workshop_.symbol(name.text, Symbol::Role::parameter, Type::scalar());
      declare_name(name, symbol_term(symbol, name.span));
      ranges_.push_back({symbol, lower, upper});
    }
  }
}

Term CaseElaborator::array(const Declarator& declarator, Symbol::Role role, const Type& type) {
  const Span& span = declarator.name.span;
  if (declarator.extents.size() > 2) throw Fault{span, "an array has one or two dimensions"};
  constexpr int most = 400;
  std::vector<int> counts;
  for (const syntax::Interval& interval : declarator.extents) {
    const auto [first, last] = elaborator_.interval(interval, scope_);
    if (first != 0) throw Fault{span, "the indices of an array start at 0, not at " + std::to_string(first)};
    if (last < 0) throw Fault{span, "an array needs at least one entry"};
    if (last >= most)
      throw Fault{span, "an array has at most " + std::to_string(most) +
                            " entries in one direction"};
    counts.push_back(last + 1);
  }
  const bool list = counts.size() == 1;
  std::vector<Term> entries;
  for (int i = 0; i < counts[0]; ++i) {
    for (int j = 0; j < (list ? 1 : counts[1]); ++j) {
      const std::string name = declarator.name.text + "[" + std::to_string(i) +
                               (list ? "" : "," + std::to_string(j)) + "]";
      entries.push_back(symbol_term(workshop_.symbol(name, role, type), span));
    }
  }
  const Type shape = Type::matrix(counts[0], list ? 1 : counts[1], type, list);
  return elaborator_.construct().make(Operation::matrix, shape, std::move(entries), {}, span);
}

void CaseElaborator::declare_symbols(const syntax::Statement& statement) {
  const bool points = statement.kind == syntax::Statement::Kind::point;
  const Type type = points ? point_type(statement) : Type::scalar();
  const auto role = points ? Symbol::Role::point : Symbol::Role::scalar;
  for (const Declarator& declarator : statement.declarators) {
    require_new(declarator.name);
    if (declarator.value && declarator.parameters.empty())
      throw Fault{declarator.name.span, "a " + std::string{points ? "point" : "scalar"} +
                                            " is a free symbol; 'let' gives a value a name",
                  "let " + declarator.name.text + " = ..."};
    Term term;
    if (!declarator.parameters.empty())
      term = declarator.value ? defined_function(declarator)
                              : unknown_function(statement, declarator, type);
    else if (!declarator.extents.empty())
      term = array(declarator, role, type);
    else
      term = symbol_term(workshop_.symbol(declarator.name.text, role, type), declarator.name.span);
    declare_name(declarator.name, term);
  }
}

void CaseElaborator::declare_matrix(const Declarator& declarator) {
  const syntax::Expression& e = *declarator.value;
  require_new(declarator.name);
  if (e.kind != syntax::Expression::Kind::matrix) {
    const Term term = elaborator_.expression(e, scope_);
    if (!term.type().is_matrix())
      throw Fault{e.span, "'" + declarator.name.text + "' is declared as a matrix, and this is a " +
                              to_text(term.type())};
    declare_name(declarator.name, term);
    return;
  }
  // The entries that are given tell what the holes are.
  std::optional<Type> type;
  std::vector<std::vector<Term>> rows;
  for (const auto& row : e.rows) {
    rows.emplace_back();
    for (const auto& entry : row) {
      const bool hole = entry->kind == syntax::Expression::Kind::hole;
      rows.back().push_back(hole ? Term{} : elaborator_.expression(*entry, scope_));
      if (!hole && !type && !is_zero(rows.back().back()))
        type = elaborator_.construct().value(scope_, rows.back().back()).type();
    }
  }
  const Type hole_type = type.value_or(Type::point(Type::any_dimension));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      if (rows[i][j]) continue;
      const std::string name = declarator.name.text + "[" + std::to_string(i) + "," +
                               std::to_string(j) + "]";
      const auto role = hole_type.is_scalar() ? Symbol::Role::scalar : Symbol::Role::point;
      const SymbolPointer symbol = workshop_.symbol(name, role, hole_type);
      holes_.insert(symbol->ordinal);
      rows[i][j] = symbol_term(symbol, e.rows[i][j]->span);
    }
  }
  declare_name(declarator.name, elaborator_.construct().matrix(scope_, std::move(rows), e.span));
}

void CaseElaborator::declare_let(const Declarator& declarator) {
  require_new(declarator.name);
  std::vector<bool> functions;
  if (!declarator.parameters.empty())
    functions = functions_among(declarator.parameters, *declarator.value, scope_);
  if (std::find(functions.begin(), functions.end(), true) != functions.end()) {
    require_different(declarator.parameters);
    scope_.declare(declarator.name.text,
                   Entity{Entity::Kind::functional, {}, nullptr, declarator.name.span,
                          std::make_shared<const Functional>(Functional{
                              declarator.parameters, declarator.value, functions, scope_})});
    return;
  }
  declare_name(declarator.name, declarator.parameters.empty()
                                    ? elaborator_.expression(*declarator.value, scope_)
                                    : defined_function(declarator));
}

void CaseElaborator::declare(const syntax::Statement& statement) {
  using Kind = syntax::Statement::Kind;
  switch (statement.kind) {
    case Kind::parameter: declare_parameters(statement); break;
    case Kind::scalar:
    case Kind::point: declare_symbols(statement); break;
    case Kind::curve:
    case Kind::patch:
    case Kind::volume: declare_functions(statement); break;
    case Kind::matrix:
      for (const Declarator& declarator : statement.declarators) declare_matrix(declarator);
      break;
    case Kind::net:
      for (const Declarator& declarator : statement.declarators) {
        require_new(declarator.name);
        if (declarator.file) {
          declare_name(declarator.name, net_from(*declarator.file, scope_, elaborator_));
          continue;
        }
        // The order of the indices in the brackets counts, not that of the spans.
        std::vector<syntax::Binder> binders;
        for (const syntax::Name& index : declarator.parameters) {
          const auto found = std::find_if(
              statement.binders.begin(), statement.binders.end(),
              [&](const syntax::Binder& b) { return b.name.text == index.text; });
          if (found == statement.binders.end())
            throw Fault{index.span, "no span is given for the index '" + index.text + "'",
                        "for " + index.text + " in 0..3"};
          binders.push_back(*found);
        }
        if (binders.size() != statement.binders.size())
          throw Fault{declarator.name.span, "a span is given for something that is not an index"};
        declare_name(declarator.name, net_of(*declarator.value, binders, declarator.name.span,
                                             scope_, elaborator_));
      }
      break;
    case Kind::spline:
      for (const Declarator& declarator : statement.declarators) {
        require_new(declarator.name);
        auto spline = std::make_shared<const Spline>(
            declarator.value ? elaborator_.spline(*declarator.value, scope_)
                             : declared_spline(*statement.spline, scope_, elaborator_));
        scope_.declare(declarator.name.text,
                       Entity{Entity::Kind::spline, {}, std::move(spline), declarator.name.span});
      }
      break;
    case Kind::let:
      for (const Declarator& declarator : statement.declarators) declare_let(declarator);
      break;
    default: break;
  }
}

void CaseElaborator::assume(const syntax::Statement& statement, Case& result) {
  const std::string label = statement.label ? statement.label->text : "";
  const std::vector<syntax::Binder>& binders = statement.clauses.binders;
  const std::size_t first = assumptions_.size();
  for (const std::vector<int>& values :
       elaborator_.combinations(binders, scope_, most_instances)) {
    Goal goal = goal_of(statement.proposition, Elaborator::bound(scope_, binders, values));
    for (const Statement& s : goal.statements) assumptions_.push_back({label, s});
    ranges_.insert(ranges_.end(), goal.ranges.begin() + static_cast<std::ptrdiff_t>(ranges_.size()),
                   goal.ranges.end());
  }
  const bool of_first_instance = std::none_of(
      result.assumptions.begin(), result.assumptions.end(),
      [&](const WrittenAssumption& a) { return a.span.begin == statement.span.begin; });
  if (of_first_instance)
    result.assumptions.push_back({label, first, assumptions_.size() - first, statement.span,
                                  statement.note.value_or("")});
}

void CaseElaborator::statement(const syntax::Statement& statement, Case& result) {
  using Kind = syntax::Statement::Kind;
  workshop_.start_statement();
  try {
    switch (statement.kind) {
      case Kind::prove:
      case Kind::refute:
      case Kind::open:
      case Kind::derive:
      case Kind::erratum: claim(statement, result); break;
      case Kind::assume: assume(statement, result); break;
      case Kind::show: show(statement, result); break;
      default:
        declare(statement);
        record(statement, result);
        break;
    }
  } catch (const Fault& fault) {
    diagnostics_.push_back(fault.diagnostic);
    mark_faulty(statement);
  } catch (const FollowUp&) {
    mark_faulty(statement);
  }
}

}  // namespace patchproof
