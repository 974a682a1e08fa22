#include <patchproof/certificate/rocq_sequent.hpp>

#include <algorithm>

#include <patchproof/certificate/sequents.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

std::string symbol_of(Relation relation) {
  switch (relation) {
    case Relation::equal: return " = ";
    case Relation::not_equal: return " <> ";
    case Relation::less: return " < ";
    case Relation::less_equal: return " <= ";
    case Relation::greater: return " > ";
    default: return " >= ";
  }
}

// How often is differentiated in all, by derivatives within derivatives.
int derivative_order(const Term& term, std::map<const TermNode*, int>& known) {
  const auto found = known.find(term.address());
  if (found != known.end()) return found->second;
  int order = 0;
  if (term.operation() == Operation::derivative)
    for (const int k : term.indices()) order += k;
  int inner = 0;
  for (const Term& child : term.children())
    inner = std::max(inner, derivative_order(child, known));
  return known[term.address()] = order + inner;
}

std::string smooth_word(std::size_t arity) {
  return arity == 1 ? "smooth" : "smooth" + std::to_string(arity);
}

bool is_equation(const Statement& statement) { return statement.relation == Relation::equal; }

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string result;
  for (const std::string& part : parts) result += (result.empty() ? "" : between) + part;
  return result;
}

}  // namespace

std::string rocq_part(const std::string& proof, std::size_t index, std::size_t count) {
  std::string result = proof;
  for (std::size_t k = 0; k < index; ++k) result = "(proj2 " + result + ")";
  return index + 1 < count ? "(proj1 " + result + ")" : result;
}

std::string RocqStatement::text() const {
  std::string result;
  if (!quantified.empty()) result += "  forall (" + joined(quantified, ") (") + "),\n";
  for (const Premise& premise : smoothness) result += "  " + premise.text + " ->\n";
  for (const Premise& premise : hypotheses) result += "  " + premise.text + " ->\n";
  if (!parameters.empty()) result += "  forall " + joined(parameters, " ") + " : R,\n";
  for (const Premise& premise : restrictions) result += "  " + premise.text + " ->\n";
  return result + "  " + conclusion;
}

RocqSequent::RocqSequent(const Sequent& sequent, Scalars& scalars, RocqNames& names, RocqText& text)
    : sequent_{sequent}, scalars_{scalars}, names_{names}, text_{text} {
  collect();
  std::vector<std::string> listed;
  for (const SymbolPointer& symbol : symbols_) {
    const RocqVariable& variable = names_.variable(symbol);
    const std::string quantified = variable.name + " : " + variable.type();
    if (std::find(listed.begin(), listed.end(), quantified) == listed.end())
      listed.push_back(quantified);
    if (!is_differentiated(symbol)) continue;
    for (std::size_t c = 0; c < symbol->type.component_count(); ++c)
      statement_.smoothness.push_back(
          {"Smooth" + std::to_string(statement_.smoothness.size() + 1),
           smooth_word(variable.arity) + " " + std::to_string(smoothness(symbol)) + " " +
               [&] {
                 const std::string name = names_.text({symbol, c});
                 return name.find(' ') == std::string::npos ? name : "(" + name + ")";
               }()});
  }
  statement_.quantified = std::move(listed);
  for (const SymbolPointer& parameter : parameters_)
    statement_.parameters.push_back(names_.variable(parameter).name);
  for (const ParameterRange& range : sequent_.ranges)
    if (!range_name(range.parameter).empty())
      statement_.restrictions.push_back({range_name(range.parameter), range_text(range)});
  for (std::size_t k = 0; k < sequent_.hypotheses.size(); ++k)
    (is_restriction(k) ? statement_.restrictions : statement_.hypotheses)
        .push_back({hypothesis_name(k), hypothesis_text(k)});
  std::vector<std::string> conclusions;
  for (const Statement& conclusion : sequent_.conclusions) {
    // Of an inequality between points or matrices one component is enough.
    const std::string one = relation_text(conclusion);
    const bool either = conclusion.relation == Relation::not_equal &&
                        component_count(conclusion) > 1 && sequent_.conclusions.size() > 1;
    conclusions.push_back(either ? "(" + one + ")" : one);
  }
  statement_.conclusion = joined(conclusions, " /\\\n  ");
}

void RocqSequent::collect() {
  std::map<unsigned, SymbolPointer> all;
  std::map<unsigned, SymbolPointer> own;
  std::set<const TermNode*> seen;
  const auto note = [&](const Statement& statement, bool of_conclusion) {
    for (const Term& side : {statement.left, statement.right}) {
      const std::map<unsigned, SymbolPointer> symbols = free_symbols(side);
      all.insert(symbols.begin(), symbols.end());
      if (of_conclusion) own.insert(symbols.begin(), symbols.end());
      note_derivatives(side, seen);
    }
  };
  for (const Assumption& hypothesis : sequent_.hypotheses)
    note(hypothesis.statement, !is_equation(hypothesis.statement));
  for (const Statement& conclusion : sequent_.conclusions) note(conclusion, true);
  // The ends of a range may speak of other parameters, whose ranges come before.
  for (auto range = sequent_.ranges.rbegin(); range != sequent_.ranges.rend(); ++range)
    for (const Term& end : {range->lower, range->upper}) {
      const std::map<unsigned, SymbolPointer> symbols = free_symbols(end);
      all.insert(symbols.begin(), symbols.end());
      if (own.contains(range->parameter->ordinal)) own.insert(symbols.begin(), symbols.end());
    }
  for (const auto& [ordinal, symbol] : all) {
    names_.add(symbol);
    if (symbol->role != Symbol::Role::parameter)
      symbols_.push_back(symbol);
    else if (own.contains(ordinal))
      parameters_.push_back(symbol);
  }
}

// Whether derivatives of unknown functions occur is asked of their terms: a derivative stands around a
// function or around something in which the function stands.
int RocqSequent::smoothness(const SymbolPointer& function) const {
  const auto needed = differentiated_.find(function->ordinal);
  return needed == differentiated_.end() ? 0 : std::max(function->smoothness, needed->second);
}

void RocqSequent::note_derivatives(const Term& term, std::set<const TermNode*>& seen) {
  if (!seen.insert(term.address()).second) return;
  if (term.operation() == Operation::derivative)
    for (const auto& [ordinal, symbol] : free_symbols(term))
      if (symbol->role == Symbol::Role::function) {
        int& order = differentiated_[ordinal];
        order = std::max(order, derivative_order(term, orders_));
      }
  for (const Term& child : term.children()) note_derivatives(child, seen);
}

bool RocqSequent::is_differentiated(const SymbolPointer& function) const {
  return differentiated_.contains(function->ordinal) && function->smoothness > 0;
}

bool RocqSequent::is_restriction(std::size_t hypothesis) const {
  const Statement& statement = sequent_.hypotheses[hypothesis].statement;
  return !is_equation(statement) && !parameters_of(statement).empty();
}

std::string RocqSequent::hypothesis_name(std::size_t hypothesis) const {
  return "Hyp" + std::to_string(hypothesis + 1);
}

std::string RocqSequent::range_name(const SymbolPointer& parameter) const {
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    if (parameters_[k]->ordinal == parameter->ordinal) return "HypRange" + std::to_string(k + 1);
  return "";
}

std::string RocqSequent::smoothness_name(const Coordinate& function) const {
  std::size_t number = 1;
  for (const SymbolPointer& symbol : symbols_) {
    if (!is_differentiated(symbol)) continue;
    if (symbol->ordinal == function.symbol->ordinal)
      return "Smooth" + std::to_string(number + function.index);
    number += symbol->type.component_count();
  }
  throw NotScalar{"a function that is not assumed to be smooth"};
}

std::string RocqSequent::introductions() const {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const SymbolPointer& symbol : symbols_)
    if (seen.insert(names_.variable(symbol).name).second)
      names.push_back(names_.variable(symbol).name);
  for (const auto& premise : statement_.smoothness) names.push_back(premise.name);
  for (const auto& premise : statement_.hypotheses) names.push_back(premise.name);
  for (const std::string& parameter : statement_.parameters) names.push_back(parameter);
  for (const auto& premise : statement_.restrictions) names.push_back(premise.name);
  return names.empty() ? "" : "  intros " + joined(names, " ") + ".\n";
}

std::vector<std::size_t> RocqSequent::guards_of(std::size_t hypothesis) const {
  std::vector<std::size_t> result;
  const std::vector<SymbolPointer> own = parameters_of(sequent_.hypotheses[hypothesis].statement);
  for (std::size_t k = 0; k < sequent_.hypotheses.size(); ++k) {
    if (!is_restriction(k)) continue;
    const std::vector<SymbolPointer> named = parameters_of(sequent_.hypotheses[k].statement);
    const bool shared = std::any_of(named.begin(), named.end(), [&](const SymbolPointer& p) {
      return std::any_of(own.begin(), own.end(),
                         [&](const SymbolPointer& q) { return p->ordinal == q->ordinal; });
    });
    if (shared) result.push_back(k);
  }
  return result;
}

std::pair<ScalarPointer, ScalarPointer> RocqSequent::sides(const Statement& statement,
                                                           std::size_t component) {
  return {scalars_.of(statement.left).at(component), scalars_.of(statement.right).at(component)};
}

std::string RocqSequent::relation_text(const Statement& statement) {
  std::vector<std::string> parts;
  for (std::size_t c = 0; c < component_count(statement); ++c) {
    const auto [left, right] = sides(statement, c);
    // The left side gets its names first, whatever the compiler.
    const std::string first = text_.of(left);
    parts.push_back(first + symbol_of(statement.relation) + text_.of(right));
  }
  return joined(parts, statement.relation == Relation::not_equal ? " \\/\n  " : " /\\\n  ");
}

std::string RocqSequent::range_text(const ParameterRange& range) {
  const auto end = [&](const Term& term) { return text_.of(scalars_.of(term).front()); };
  const std::string lower = end(range.lower);
  return lower + " <= " + names_.variable(range.parameter).name + " <= " + end(range.upper);
}

std::string RocqSequent::hypothesis_text(std::size_t hypothesis) {
  const Statement& statement = sequent_.hypotheses[hypothesis].statement;
  const std::string relation = relation_text(statement);
  const std::vector<SymbolPointer> parameters = parameters_of(statement);
  if (!is_equation(statement) || parameters.empty()) return "(" + relation + ")";
  std::string result = "(forall";
  for (const SymbolPointer& parameter : parameters) result += " " + names_.variable(parameter).name;
  result += " : R, ";
  for (const SymbolPointer& parameter : parameters)
    for (const ParameterRange& range : sequent_.ranges)
      if (range.parameter->ordinal == parameter->ordinal) result += range_text(range) + " -> ";
  for (const std::size_t guard : guards_of(hypothesis)) {
    const Statement& s = sequent_.hypotheses[guard].statement;
    if (parameters_of(s).size() > parameters.size())
      throw NotScalar{"an equation on a part of the ranges that depends on other parameters"};
    result += "(" + relation_text(s) + ") -> ";
  }
  return result + relation + ")";
}

}  // namespace patchproof
