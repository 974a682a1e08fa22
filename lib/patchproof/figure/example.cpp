// First pleasant values are tried as they are. Where they break an assumption, its equations are
// solved, and what they leave open comes as near to these values as it can.
#include <patchproof/figure/example.hpp>

#include <algorithm>
#include <map>

#include <patchproof/figure/example_values.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/witness_values.hpp>
#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

bool is_written(const Assumption& assumption, const Case& given) {
  return std::any_of(given.assumptions.begin(), given.assumptions.end(),
                     [&](const WrittenAssumption& written) {
                       const Span& span = assumption.statement.span;
                       return span.begin >= written.span.begin && span.end <= written.span.end;
                     });
}

// An inequality for parameters, u > 0, says where a claim holds and nothing of what is drawn.
bool restricts_parameters(const Statement& statement) {
  if (statement.relation == Relation::equal) return false;
  std::map<unsigned, SymbolPointer> symbols = free_symbols(statement.left);
  symbols.merge(free_symbols(statement.right));
  const auto is = [](Symbol::Role role) {
    return [role](const auto& symbol) { return symbol.second->role == role; };
  };
  return std::any_of(symbols.begin(), symbols.end(), is(Symbol::Role::parameter)) &&
         std::none_of(symbols.begin(), symbols.end(), is(Symbol::Role::function));
}

const Goal& goal_of(const Claim& claim) {
  if (const auto* derive = std::get_if<DeriveClaim>(&claim.kind)) return derive->goal.goal;
  if (const auto* least = std::get_if<MinimumClaim>(&claim.kind)) return least->goal.goal;
  return std::get<IdentityClaim>(claim.kind).goal;
}

// A claim of a family within the instance: "[m=1,i=0]" belongs to "[m=1]".
bool belongs(const std::string& instance, const std::string& outer) {
  if (outer.empty() || instance == outer) return true;
  return instance.starts_with(outer.substr(0, outer.size() - 1) + ",");
}

void take_over(const std::vector<KnownValue>& solution, std::vector<KnownValue>& derived) {
  std::map<unsigned, SymbolPointer> named;
  for (const KnownValue& known : derived) {
    named.emplace(known.symbol->ordinal, known.symbol);
    named.merge(free_symbols(known.value));
  }
  // Two derivations may express symbols by each other.
  for (const KnownValue& known : solution)
    if (named.contains(known.symbol->ordinal)) return;
  derived.insert(derived.end(), solution.begin(), solution.end());
}

/// One of the three copies of an example.
class Copy {
 public:
  /// `sign` is that of the scalars.
  Copy(const std::vector<SymbolPointer>& symbols, const ExampleValues& wanted, int sign,
       std::size_t coordinate, const CaseFacts& facts, Workspace& workspace)
      : symbols_{symbols},
        wanted_{wanted},
        sign_{sign},
        coordinate_{coordinate},
        workspace_{workspace} {
    goal_.assumptions = facts.assumptions;
    goal_.ranges = facts.ranges;
    goal_.known = facts.derived;
    for (const SymbolPointer& symbol : symbols)
      goal_.statements.push_back({symbol_term(symbol), Relation::equal, symbol_term(symbol), {}});
  }

  std::optional<std::vector<KnownValue>> values() {
    std::vector<KnownValue> plain;
    for (const SymbolPointer& symbol : symbols_) plain.push_back({symbol, pleasant(symbol)});
    if (goal_.assumptions.empty() || is_good({plain})) return plain;
    const std::optional<Witness> fitted = fitted_values();
    if (fitted && is_good(*fitted)) return fitted->values;
    return std::nullopt;
  }

 private:
  bool is_good(const Witness& witness) {
    return checked(goal_, witness, workspace_.budget).consistent;
  }

  // Which coordinates a value of the type has here.
  std::vector<std::size_t> coordinates(const Type& type) const {
    if (type.is_scalar()) return {0};
    if (type.dimension == Type::any_dimension) return {coordinate_};
    // There are three coordinates; what has more is not drawn, but may have to have values.
    std::vector<std::size_t> result;
    for (int k = 0; k < type.dimension; ++k) result.push_back(static_cast<std::size_t>(k % 3));
    return result;
  }

  std::vector<Variable> slots(const SymbolPointer& symbol) {
    std::vector<Variable> result;
    for (std::size_t k = 0; k < symbol->type.parameters.size(); ++k)
      result.push_back(workspace_.atoms.slot(symbol, static_cast<int>(k)));
    return result;
  }

  std::vector<Polynomial> components(const SymbolPointer& symbol) {
    std::vector<Polynomial> result;
    const std::array<Polynomial, 3> all =
        wanted_.function(symbol, slots(symbol), workspace_.budget);
    for (const std::size_t k : coordinates(*symbol->type.inner)) result.push_back(all[k]);
    return result;
  }

  Point constant(const SymbolPointer& symbol) const {
    return Rational{symbol->type.is_scalar() ? sign_ : 1} * wanted_.constant(symbol);
  }

  Term pleasant(const SymbolPointer& symbol) {
    if (symbol->role == Symbol::Role::function)
      return polynomial_function(components(symbol), symbol->type, slots(symbol));
    const Point all = constant(symbol);
    std::vector<Term> parts;
    for (const std::size_t k : coordinates(symbol->type)) parts.push_back(number_term(all[k]));
    return symbol->type.is_scalar() ? parts.front()
                                    : make_term(Operation::tuple, symbol->type, std::move(parts));
  }

  std::optional<Witness> fitted_values() {
    Evaluator evaluator{workspace_, goal_.known};
    const std::vector<bool> all(goal_.assumptions.size(), true);
    Hypotheses hypotheses{goal_, all, evaluator, workspace_};
    Assignment assigned;
    const auto assign = [&](Variable variable, const Rational& value) {
      Fraction left = hypotheses.reduced(Polynomial::variable(variable));
      for (const auto& [v, chosen] : assigned)
        left = with_value(left, v, chosen, hypotheses, workspace_);
      const bool open = left.is_polynomial() && left.numerator() == Polynomial::variable(variable);
      if (open) assigned.emplace_back(variable, value);
    };
    for (const SymbolPointer& symbol : symbols_) {
      if (symbol->role == Symbol::Role::function) continue;
      const Point value = constant(symbol);
      const std::vector<std::size_t> its = coordinates(symbol->type);
      for (std::size_t k = 0; k < its.size(); ++k)
        assign(workspace_.atoms.symbol(symbol, static_cast<int>(k)), value[its[k]]);
    }
    // All ends before all that lies between: the ends are what assumptions speak of.
    for (const std::vector<Rational>& places :
         {std::vector<Rational>{0, 1}, std::vector<Rational>{{1, 3}, {2, 3}}})
      for (const SymbolPointer& symbol : symbols_)
        if (symbol->role == Symbol::Role::function) assign_places(symbol, places, assign);
    return witness_values(goal_, assigned, static_cast<Variable>(workspace_.atoms.size()),
                          hypotheses, workspace_, 0);
  }

  template <typename Assign>
  void assign_places(const SymbolPointer& symbol, const std::vector<Rational>& places,
                     const Assign& assign) {
    const std::vector<Polynomial> wanted = components(symbol);
    const std::vector<Variable> variables = slots(symbol);
    if (variables.size() > 2) return;
    for (const Rational& first : places) {
      for (const Rational& second : variables.size() == 2 ? places : std::vector<Rational>{0}) {
        std::map<Variable, Rational> at{{variables[0], first}};
        if (variables.size() == 2) at.emplace(variables[1], second);
        std::vector<Fraction> arguments{first};
        if (variables.size() == 2) arguments.emplace_back(second);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
          const Atom jet{Atom::Kind::jet, symbol, static_cast<int>(k),
                         std::vector<int>(variables.size(), 0), arguments};
          assign(workspace_.atoms.variable(jet), *number_at(wanted[k], at, workspace_));
        }
      }
    }
  }

  const std::vector<SymbolPointer>& symbols_;
  const ExampleValues& wanted_;
  int sign_;
  std::size_t coordinate_;
  Workspace& workspace_;
  Goal goal_;
};

// All but points of any dimension have to have one value.
bool are_copies(const Example& example) {
  const auto has_dimension = [](const Type& type) {
    const Type& value = type.is_function() ? *type.inner : type;
    return !value.is_point() || value.dimension != Type::any_dimension;
  };
  for (std::size_t k = 0; k < example.values[0].size(); ++k) {
    const KnownValue& first = example.values[0][k];
    if (!has_dimension(first.symbol->type)) continue;
    for (const std::vector<KnownValue>& values : example.values)
      if (to_text(values[k].value) != to_text(first.value)) return false;
  }
  return true;
}

}  // namespace

CaseFacts facts_of(const CaseResult& result, const std::string& instance) {
  CaseFacts facts;
  for (const ClaimResult& claim : result.claims) {
    if (!belongs(claim.claim.instance, instance)) continue;
    if (!claim.decision.solution.empty()) take_over(claim.decision.solution, facts.derived);
  }
  const Goal* last = nullptr;
  for (const Claim& claim : result.verified.claims)
    if (belongs(claim.instance, instance)) last = &goal_of(claim);
  for (const Shown& shown : result.verified.shown)
    if (last == nullptr && shown.joint) last = &shown.joint->given;
  if (last == nullptr) return facts;
  facts.ranges = last->ranges;
  for (const Assumption& assumption : last->assumptions)
    if (is_written(assumption, result.verified) && !restricts_parameters(assumption.statement))
      facts.assumptions.push_back(assumption);
  return facts;
}

std::optional<Example> example_of(const std::vector<Term>& terms, const CaseFacts& facts,
                                  Workspace& workspace) {
  std::map<unsigned, SymbolPointer> found;
  for (const Term& term : terms) found.merge(free_symbols(term));
  for (const KnownValue& known : facts.derived) found.merge(free_symbols(known.value));
  for (const Assumption& assumption : facts.assumptions)
    for (const Term& side : {assumption.statement.left, assumption.statement.right})
      found.merge(free_symbols(side));
  for (const ParameterRange& range : facts.ranges)
    for (const Term& end : {range.lower, range.upper}) found.merge(free_symbols(end));
  // Functions are drawn over their parameters, which keep their names inside them.
  std::erase_if(found,
                [](const auto& symbol) { return symbol.second->role == Symbol::Role::parameter; });
  for (const KnownValue& known : facts.derived) found.erase(known.symbol->ordinal);
  std::vector<SymbolPointer> symbols;
  Example example;
  for (const auto& [ordinal, symbol] : found) {
    symbols.push_back(symbol);
    const std::string base = base_of(symbol->name);
    if (std::find(example.names.begin(), example.names.end(), base) == example.names.end())
      example.names.push_back(base);
  }
  const ExampleValues wanted{symbols, terms};
  // Some cases assume of a number that it is negative.
  for (const int sign : {1, -1}) {
    bool complete = true;
    for (std::size_t coordinate = 0; coordinate < 3 && complete; ++coordinate) {
      const auto values = Copy{symbols, wanted, sign, coordinate, facts, workspace}.values();
      complete = values.has_value();
      if (complete) example.values[coordinate] = *values;
    }
    if (complete && are_copies(example)) return example;
  }
  return std::nullopt;
}

}  // namespace patchproof
