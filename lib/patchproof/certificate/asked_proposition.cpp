#include <patchproof/certificate/asked_proposition.hpp>

#include <algorithm>
#include <optional>

#include <patchproof/certificate/derivative_orders.hpp>
#include <patchproof/certificate/scalar_meaning.hpp>
#include <patchproof/certificate/sequents.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

using Symbols = std::map<unsigned, SymbolPointer>;
using Scope = ScalarMeaning::Scope;

const char* sign_of(Relation relation) {
  switch (relation) {
    case Relation::equal: return "=";
    case Relation::not_equal: return "<>";
    case Relation::less: return "<";
    case Relation::less_equal: return "<=";
    case Relation::greater: return ">";
    default: return ">=";
  }
}

Symbols symbols_in(const Term& a, const Term& b) {
  Symbols result = free_symbols(a);
  result.merge(free_symbols(b));
  return result;
}

Symbols symbols_in(const Statement& statement) {
  return symbols_in(statement.left, statement.right);
}

class Asked {
 public:
  Asked(const Sequent& sequent, Scalars& scalars, RocqNames& names, PropositionTable& table)
      : sequent_{sequent}, scalars_{scalars}, names_{names}, table_{table} {
    find_symbols();
    std::map<std::string, std::size_t> levels;
    for (const SymbolPointer& symbol : unknowns_) {
      const RocqVariable& variable = names_.variable(symbol);
      if (levels.try_emplace(variable.name, levels.size()).second)
        types_.push_back(variable.type());
    }
    meaning_.emplace(table_, names_, std::move(levels));
  }

  std::size_t proposition() {
    std::vector<std::size_t> premises;
    for (const SymbolPointer& symbol : unknowns_)
      if (symbol->smoothness > 0 && orders_.of(symbol) > 0) add_smoothness(symbol, premises);
    for (const Assumption& hypothesis : sequent_.hypotheses)
      if (!restricts(hypothesis.statement)) premises.push_back(given(hypothesis.statement));
    const Scope* scope = nullptr;
    std::size_t depth = types_.size();
    for (const SymbolPointer& parameter : parameters_)
      scope = meaning_->with(parameter, depth++, scope);
    std::vector<std::size_t> restrictions;
    for (const ParameterRange& range : sequent_.ranges)
      if (is_one(parameters_, range.parameter)) restrictions.push_back(in_range(range, scope, depth));
    for (const Assumption& hypothesis : sequent_.hypotheses)
      if (restricts(hypothesis.statement))
        restrictions.push_back(related(hypothesis.statement, scope, depth));
    std::size_t result = implied(restrictions, conclusion(scope, depth));
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      result = table_.number_of("forall R", {result});
    result = implied(premises, result);
    for (std::size_t k = types_.size(); k-- > 0;)
      result = table_.number_of("forall " + types_[k], {result});
    return result;
  }

 private:
  static bool is_one(const std::vector<SymbolPointer>& all, const SymbolPointer& symbol) {
    return std::any_of(all.begin(), all.end(),
                       [&](const SymbolPointer& s) { return s->ordinal == symbol->ordinal; });
  }

  // An equation holds for all its parameters; anything else says of which ones the claim speaks.
  static bool restricts(const Statement& statement) {
    return statement.relation != Relation::equal && !parameters_of(statement).empty();
  }

  void find_symbols() {
    Symbols all;
    Symbols spoken_of;
    const auto note = [&](const Statement& statement, bool speaks) {
      const Symbols symbols = symbols_in(statement);
      all.insert(symbols.begin(), symbols.end());
      if (speaks) spoken_of.insert(symbols.begin(), symbols.end());
      orders_.note(statement.left);
      orders_.note(statement.right);
    };
    for (const Statement& statement : sequent_.conclusions) note(statement, true);
    for (const Assumption& hypothesis : sequent_.hypotheses)
      note(hypothesis.statement, hypothesis.statement.relation != Relation::equal);
    // The ends of a range may speak of parameters whose ranges come before.
    for (std::size_t k = sequent_.ranges.size(); k-- > 0;) {
      const ParameterRange& range = sequent_.ranges[k];
      const Symbols symbols = symbols_in(range.lower, range.upper);
      all.insert(symbols.begin(), symbols.end());
      if (spoken_of.contains(range.parameter->ordinal))
        spoken_of.insert(symbols.begin(), symbols.end());
    }
    for (const auto& [ordinal, symbol] : all) {
      names_.add(symbol);
      if (symbol->role != Symbol::Role::parameter)
        unknowns_.push_back(symbol);
      else if (spoken_of.contains(ordinal))
        parameters_.push_back(symbol);
    }
  }

  void add_smoothness(const SymbolPointer& function, std::vector<std::size_t>& premises) {
    const std::size_t arity = function->type.parameters.size();
    const std::string word = (arity == 1 ? "smooth " : "smooth" + std::to_string(arity) + " ") +
                             std::to_string(std::max(function->smoothness, orders_.of(function)));
    for (std::size_t c = 0; c < function->type.component_count(); ++c)
      premises.push_back(table_.number_of(word, {meaning_->free({function, c})}));
  }

  std::size_t implied(const std::vector<std::size_t>& premises, std::size_t conclusion) {
    for (std::size_t k = premises.size(); k-- > 0;)
      conclusion = table_.number_of("->", {premises[k], conclusion});
    return conclusion;
  }

  std::size_t joined(const char* sign, const std::vector<std::size_t>& parts) {
    std::size_t result = parts.back();
    for (std::size_t k = parts.size() - 1; k-- > 0;)
      result = table_.number_of(sign, {parts[k], result});
    return result;
  }

  // One for each pair of components.
  std::vector<std::size_t> relations(const Statement& statement, const Scope* scope,
                                     std::size_t depth) {
    std::vector<std::size_t> result;
    for (std::size_t c = 0; c < component_count(statement); ++c)
      result.push_back(table_.number_of(
          sign_of(statement.relation),
          {meaning_->of(scalars_.of(statement.left).at(c), scope, depth),
           meaning_->of(scalars_.of(statement.right).at(c), scope, depth)}));
    return result;
  }

  // Points differ when one coordinate does.
  std::size_t related(const Statement& statement, const Scope* scope, std::size_t depth) {
    return joined(statement.relation == Relation::not_equal ? "\\/" : "/\\",
                  relations(statement, scope, depth));
  }

  std::size_t in_range(const ParameterRange& range, const Scope* scope, std::size_t depth) {
    const auto value = [&](const Term& term) {
      return meaning_->of(scalars_.of(term).front(), scope, depth);
    };
    const std::size_t parameter = value(symbol_term(range.parameter));
    return table_.number_of("/\\", {table_.number_of("<=", {value(range.lower), parameter}),
                                    table_.number_of("<=", {parameter, value(range.upper)})});
  }

  // A premise: for all its parameters in their ranges, where the restrictions on them hold.
  std::size_t given(const Statement& statement) {
    const std::vector<SymbolPointer> own = parameters_of(statement);
    const Scope* scope = nullptr;
    std::size_t depth = types_.size();
    for (const SymbolPointer& parameter : own) scope = meaning_->with(parameter, depth++, scope);
    std::vector<std::size_t> restrictions;
    for (const SymbolPointer& parameter : own)
      for (const ParameterRange& range : sequent_.ranges)
        if (range.parameter->ordinal == parameter->ordinal)
          restrictions.push_back(in_range(range, scope, depth));
    for (const Assumption& hypothesis : sequent_.hypotheses) {
      if (!restricts(hypothesis.statement)) continue;
      const std::vector<SymbolPointer> others = parameters_of(hypothesis.statement);
      const bool about_own = std::any_of(others.begin(), others.end(), [&](const SymbolPointer& p) {
        return is_one(own, p);
      });
      if (about_own) restrictions.push_back(related(hypothesis.statement, scope, depth));
    }
    std::size_t result = implied(restrictions, related(statement, scope, depth));
    for (std::size_t k = 0; k < own.size(); ++k) result = table_.number_of("forall R", {result});
    return result;
  }

  std::size_t conclusion(const Scope* scope, std::size_t depth) {
    std::vector<std::size_t> parts;
    for (const Statement& statement : sequent_.conclusions) {
      if (statement.relation == Relation::not_equal) {
        parts.push_back(related(statement, scope, depth));
        continue;
      }
      const std::vector<std::size_t> components = relations(statement, scope, depth);
      parts.insert(parts.end(), components.begin(), components.end());
    }
    if (parts.empty()) throw NotScalar{"a claim without a conclusion"};
    return joined("/\\", parts);
  }

  const Sequent& sequent_;
  Scalars& scalars_;
  RocqNames& names_;
  PropositionTable& table_;
  DerivativeOrders orders_;
  /// By the order of declaration; without parameters.
  std::vector<SymbolPointer> unknowns_;
  /// Those that conclusions and restrictions speak of.
  std::vector<SymbolPointer> parameters_;
  std::vector<std::string> types_;
  std::optional<ScalarMeaning> meaning_;
};

}  // namespace

std::size_t asked_proposition(const Sequent& sequent, Scalars& scalars, RocqNames& names,
                              PropositionTable& table) {
  return Asked{sequent, scalars, names, table}.proposition();
}

}  // namespace patchproof
