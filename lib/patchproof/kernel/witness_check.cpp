#include <patchproof/kernel/enclose.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/kernel/witness.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

using Images = std::map<unsigned, Term>;

// An exact value for a person: the number, or the closed form with its first digits.
std::string shown(const Fraction& value, const Workspace& workspace) {
  const std::string exact = to_text(value, workspace.atoms, workspace.budget, 300);
  if (value.is_polynomial() && value.numerator().is_constant()) return exact;
  const std::optional<Enclosure> interval = enclosure(value, workspace.atoms, 64, workspace.budget);
  return interval ? exact + " = " + to_decimal(*interval, 12) : exact;
}

std::optional<bool> holds(Relation relation, const std::optional<int>& sign) {
  if (!sign) return std::nullopt;
  switch (relation) {
    case Relation::equal: return *sign == 0;
    case Relation::not_equal: return *sign != 0;
    case Relation::less: return *sign < 0;
    case Relation::less_equal: return *sign <= 0;
    case Relation::greater: return *sign > 0;
    default: return *sign >= 0;
  }
}

class Checker {
 public:
  Checker(const Goal& goal, const Witness& witness, Workspace& workspace)
      : goal_{goal}, workspace_{workspace}, images_{images_of(witness)}, evaluator_{workspace, known()} {
    for (const auto& [ordinal, value] : images_) functions_and_scalars_.emplace(ordinal, value);
    for (const ParameterRange& range : goal.ranges)
      functions_and_scalars_.erase(range.parameter->ordinal);
  }

  WitnessCheck run() {
    WitnessCheck result;
    result.why_not = inconsistency();
    result.consistent = result.why_not.empty();
    if (!result.consistent) return result;
    for (std::size_t k = 0; k < goal_.statements.size(); ++k) {
      const Statement& statement = goal_.statements[k];
      const std::vector<Fraction> left = values(statement.left, images_);
      const std::vector<Fraction> right = values(statement.right, images_);
      std::optional<std::size_t> first_difference;
      bool all_equal = true;
      for (std::size_t c = 0; c < left.size(); ++c) {
        const std::optional<int> sign = sign_of(left[c], right[c]);
        if (statement.relation == Relation::not_equal) {
          all_equal = all_equal && sign == 0;
          continue;
        }
        if (holds(statement.relation, sign) == false && !first_difference) first_difference = c;
      }
      if (statement.relation == Relation::not_equal && all_equal) first_difference = 0;
      if (!first_difference) continue;
      result.refutes = true;
      result.statement = k;
      result.component = *first_difference;
      result.left = shown(left[*first_difference], workspace_);
      result.right = shown(right[*first_difference], workspace_);
      return result;
    }
    return result;
  }

 private:
  static Images images_of(const Witness& witness) {
    Images result;
    for (const KnownValue& v : witness.values) result.emplace(v.symbol->ordinal, v.value);
    return result;
  }

  std::vector<KnownValue> known() const {
    std::vector<KnownValue> result;
    for (const KnownValue& k : goal_.known)
      result.push_back({k.symbol, replaced(k.value, images_)});
    return result;
  }

  std::vector<Fraction> values(const Term& term, const Images& images) {
    return evaluator_.value(replaced(term, images)).components;
  }

  std::optional<int> sign_of(const Fraction& left, const Fraction& right) {
    const Fraction d =
        normal_form(difference(left, right, workspace_.budget), workspace_);
    return certain_sign(d, workspace_.atoms, workspace_.budget);
  }

  std::string inconsistency() {
    for (const ParameterRange& range : goal_.ranges) {
      if (!images_.contains(range.parameter->ordinal)) continue;
      const Fraction at = values(symbol_term(range.parameter), images_).front();
      const std::optional<int> low = sign_of(at, values(range.lower, images_).front());
      const std::optional<int> high = sign_of(values(range.upper, images_).front(), at);
      if (!low || !high || *low < 0 || *high < 0)
        return "'" + range.parameter->name + "' leaves its range";
    }
    for (const Assumption& assumption : goal_.assumptions) {
      const bool good = assumption.statement.relation == Relation::equal
                            ? equation_holds(assumption.statement)
                            : inequality_holds(assumption.statement);
      if (!good)
        return assumption.label.empty() ? "an assumption fails"
                                        : "assumption '" + assumption.label + "' fails";
    }
    return "";
  }

  // Equations are assumed for all parameters, so the parameters stay symbols.
  bool equation_holds(const Statement& statement) {
    const std::vector<Fraction> left = values(statement.left, functions_and_scalars_);
    const std::vector<Fraction> right = values(statement.right, functions_and_scalars_);
    for (std::size_t c = 0; c < left.size(); ++c)
      if (!normal_form(difference(left[c], right[c], workspace_.budget), workspace_).is_zero())
        return false;
    return true;
  }

  // Inequalities restrict the parameters they name; but one that speaks of an unknown function is
  // about the whole function, and has to hold for all parameters.
  bool inequality_holds(const Statement& statement) {
    bool about_functions = false;
    for (const Term& side : {statement.left, statement.right})
      for (const auto& [ordinal, symbol] : free_symbols(side))
        about_functions = about_functions || symbol->role == Symbol::Role::function;
    const Images& images = about_functions ? functions_and_scalars_ : images_;
    const std::vector<Fraction> left = values(statement.left, images);
    const std::vector<Fraction> right = values(statement.right, images);
    bool some_differ = false;
    for (std::size_t c = 0; c < left.size(); ++c) {
      const std::optional<bool> good = holds(statement.relation, sign_of(left[c], right[c]));
      if (statement.relation == Relation::not_equal)
        some_differ = some_differ || good == true;
      else if (good != true)
        return false;
    }
    return statement.relation != Relation::not_equal || some_differ;
  }

  const Goal& goal_;
  Workspace& workspace_;
  Images images_;
  Images functions_and_scalars_;
  Evaluator evaluator_;
};

}  // namespace

WitnessCheck checked(const Goal& goal, const Witness& witness, Budget& budget) {
  Workspace workspace{budget};
  for (;;) {
    try {
      return Checker{goal, witness, workspace}.run();
    } catch (const FinerAngles&) {
      continue;
    } catch (const NoValue& error) {
      return {false, false, 0, 0, "", "", error.what()};
    } catch (const OutsideTheory& error) {
      return {false, false, 0, 0, "", "", error.what()};
    }
  }
}

}  // namespace patchproof
