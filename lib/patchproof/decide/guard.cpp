#include <patchproof/decide/guard.hpp>

#include <algorithm>
#include <new>
#include <set>

#include <patchproof/kernel/hypotheses.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

Decision guarded(const Limits& limits, const std::function<Decision(Workspace&)>& decision) {
  Decision result;
  try {
    Budget budget{limits};
    Workspace workspace{budget};
    for (;;) {
      try {
        return decision(workspace);
      } catch (const FinerAngles&) {
        budget.spend(1000);
      }
    }
  } catch (const NoValue& error) {
    result.verdict = Verdict::error;
    result.reason = error.what();
    result.span = error.span;
  } catch (const OverBudget& error) {
    result.reason = std::string{"limit: "} + error.what();
  } catch (const std::bad_alloc&) {
    result.reason = "limit: out of memory";
  } catch (const OutsideTheory& error) {
    result.reason = error.what();
  } catch (const TooDeep& error) {
    result.reason = std::string{"limit: "} + error.what();
  } catch (const std::domain_error& error) {
    result.verdict = Verdict::error;
    result.reason = error.what();
  }
  return result;
}

namespace {

std::string in_words(const Condition& condition, Workspace& workspace) {
  const bool not_zero = condition.kind == Condition::Kind::not_zero;
  const Polynomial& p = condition.polynomial;
  // A positive leading sign would read "b - a != 0" where "a != b" is meant.
  std::string text = to_text(Fraction{p}, workspace.atoms, workspace.budget, 300);
  if (not_zero && text.front() == '-')
    text = to_text(Fraction{scaled(p, -1)}, workspace.atoms, workspace.budget, 300);
  return text + (not_zero ? " != 0" : " >= 0");
}

std::vector<std::string> in_order(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

}  // namespace

std::vector<std::string> in_words(const Conditions& conditions, Workspace& workspace) {
  std::vector<std::string> result;
  for (const Condition& condition : conditions) result.push_back(in_words(condition, workspace));
  return in_order(std::move(result));
}

std::vector<std::string> in_words(const Conditions& conditions,
                                  const std::vector<Statement>& statements, Workspace& workspace) {
  std::set<unsigned> named;
  for (const Statement& statement : statements)
    for (const Term& side : {statement.left, statement.right})
      for (const auto& [ordinal, symbol] : free_symbols(side)) named.insert(ordinal);
  std::vector<std::string> result;
  for (const Condition& condition : conditions) {
    std::string others;
    for (const Variable v : variables_within(condition.polynomial, workspace.atoms)) {
      const Atom& atom = workspace.atoms[v];
      if (atom.kind != Atom::Kind::symbol || atom.symbol->role != Symbol::Role::parameter ||
          named.contains(atom.symbol->ordinal))
        continue;
      others += (others.empty() ? " for all " : ", ") + atom.symbol->name;
    }
    result.push_back(in_words(condition, workspace) + others);
  }
  return in_order(std::move(result));
}

std::string component_name(const Type& type, std::size_t component) {
  if (type.is_point()) {
    if (type.dimension == Type::any_dimension || type.dimension == 1) return "";
    return component < 3 ? "." + std::string(1, "xyz"[component])
                         : "[" + std::to_string(component) + "]";
  }
  if (!type.is_matrix()) return "";
  const std::size_t width = type.inner->component_count();
  const std::size_t entry = component / width;
  const auto columns = static_cast<std::size_t>(type.columns);
  const std::string place = type.list ? std::to_string(entry)
                                      : std::to_string(entry / columns) + "," +
                                            std::to_string(entry % columns);
  return "[" + place + "]" + component_name(*type.inner, component % width);
}

}  // namespace patchproof
