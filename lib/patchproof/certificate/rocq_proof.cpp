#include <patchproof/certificate/rocq_proof.hpp>

#include <algorithm>

#include <patchproof/certificate/rocq_log.hpp>
#include <patchproof/certificate/scalar_nodes.hpp>
#include <patchproof/certificate/scalar_obstacle.hpp>
#include <patchproof/certificate/sequents.hpp>

namespace patchproof {

namespace {

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string result;
  for (std::size_t k = 0; k < parts.size(); ++k) result += (k == 0 ? "" : between) + parts[k];
  return result;
}

// A proof of P1 /\ (P2 /\ … True).
std::string conjunction(const std::vector<std::string>& proofs) {
  std::string result = "I";
  for (std::size_t k = proofs.size(); k-- > 0;) result = "(conj " + proofs[k] + " " + result + ")";
  return result;
}

constexpr const char* computed = "vm_cast_no_check (eq_refl true)";

class ProofWriter {
 public:
  ProofWriter(const SequentProof& proof, RocqSequent& sequent, Scalars& scalars, RocqNames& names,
              RocqText& text)
      : proof_{proof},
        sequent_{sequent},
        scalars_{scalars},
        names_{names},
        instances_{proof, sequent, scalars, text, twin_} {}

  std::string written() {
    add_facts();
    for (std::size_t k = 0; k < proof_.not_zero.size(); ++k) add_not_zero(k);
    add_reasons();
    const std::vector<std::string> components = component_proofs();
    std::string body;
    if (components.size() == 1)
      body = "  " + components.front();
    else
      for (std::size_t k = 0; k < components.size(); ++k)
        body += std::string{k + 1 < components.size() ? "  split.\n  { " : "  { "} + components[k] +
                (k + 1 < components.size() ? " }\n" : " }");
    return head() + signs_ + equations_ + body;
  }

 private:
  // Everything the theorems ask for, once and for all.
  std::string head() const {
    std::string result = sequent_.introductions();
    std::vector<std::string> functions;
    for (const Coordinate& function : twin_.functions()) {
      std::string call = names_.text(function);
      for (std::size_t k = 0; k < function.symbol->type.parameters.size(); ++k)
        call += " (nth " + std::to_string(k) + " l 0)";
      functions.push_back("fun l => " + call);
    }
    std::vector<std::string> variables;
    for (const Coordinate& variable : twin_.variables()) variables.push_back(names_.text(variable));
    result += "  pose (Phi := " + rocq_list(functions) + " : list (list R -> R)).\n";
    result += "  pose (sigma := " + rocq_list(variables) + " : list R).\n";
    result += instances_.script();
    std::vector<std::string> smoothness;
    std::vector<std::string> smooth_proofs;
    for (const Coordinate& function : twin_.functions()) {
      const bool smooth = sequent_.is_differentiated(function.symbol);
      smoothness.push_back(smooth ? "Smooth " +
                                        std::to_string(function.symbol->type.parameters.size()) +
                                        " " + std::to_string(sequent_.smoothness(function.symbol))
                                  : "Smooth 0 0");
      smooth_proofs.push_back(smooth ? sequent_.smoothness_name(function) : "I");
    }
    result += "  pose (smoothness := " + rocq_list(smoothness) + " : list (nat * nat)).\n";
    result += "  assert (HypSmooth : smooth_all smoothness Phi) by exact " +
              conjunction(smooth_proofs) + ".\n";
    std::vector<std::string> equations;
    std::vector<std::string> equation_proofs;
    for (const auto& [pair, proof] : instances_.equations()) {
      equations.push_back(pair);
      equation_proofs.push_back(proof);
    }
    result += "  pose (hypotheses := " + rocq_list(equations) + " : list (term * term)).\n";
    result += "  assert (HypEqual : all_equal Phi sigma hypotheses) by exact " +
              conjunction(equation_proofs) + ".\n";
    result += "  pose (facts := " + rocq_list(facts_) + " : list (term * bool)).\n";
    result += "  assert (HypFacts : all_signs Phi sigma facts) by exact " +
              conjunction(fact_proofs_) + ".\n";
    return result;
  }

  // Facts of parameters that the conclusions do not have are no facts here: a true one in their
  // place.
  void add_facts() {
    const Sequent& sequent = sequent_.sequent();
    const std::vector<Fact> all = facts_of(sequent);
    std::size_t number = 0;
    const auto add = [&](const std::string& proof) {
      const Fact& fact = all[number++];
      facts_.push_back("(" + twin_.of(scalars_.of(fact.scalar).front()) + ", " +
                       (fact.strict ? "true" : "false") + ")");
      fact_proofs_.push_back(proof);
    };
    const auto add_none = [&] {
      ++number;
      facts_.emplace_back("(Int 0, false)");
      fact_proofs_.emplace_back("(Rle_refl 0)");
    };
    for (const ParameterRange& range : sequent.ranges) {
      const std::string name = sequent_.range_name(range.parameter);
      for (const char* part : {"proj1", "proj2"}) {
        if (name.empty())
          add_none();
        else
          add("(le_difference _ _ (" + std::string{part} + " " + name + "))");
      }
    }
    for (std::size_t k = 0; k < sequent.hypotheses.size(); ++k) {
      const Relation relation = sequent.hypotheses[k].statement.relation;
      if (relation == Relation::equal || relation == Relation::not_equal) continue;
      const bool strict = relation == Relation::less || relation == Relation::greater;
      const bool turned = relation == Relation::greater || relation == Relation::greater_equal;
      const std::string proof =
          turned ? "(Rge_le _ _ " + sequent_.hypothesis_name(k) + ")" : sequent_.hypothesis_name(k);
      const std::string strict_proof =
          turned ? "(Rgt_lt _ _ " + sequent_.hypothesis_name(k) + ")" : sequent_.hypothesis_name(k);
      add(strict ? "(lt_difference _ _ " + strict_proof + ")"
                 : "(le_difference _ _ " + proof + ")");
    }
  }

  // A goal of the theorem about signs, as a script.
  std::string sign_script(const std::string& goal, bool strict, const SignProof& proof) {
    return std::string{"refine ("} + (strict ? "positive" : "nonnegative") +
           " Phi sigma smoothness @n hypotheses nonzero reasons facts\n    " + goal + "\n    " +
           rocq_log(proof, scalars_, twin_, instances_) +
           "\n    HypSmooth eq_refl HypEqual HypNonzero HypFacts _). " + computed + ".";
  }

  // Signs of divisors are shown before anything is known not to vanish.
  void add_not_zero(std::size_t index) {
    const NonZero& item = proof_.not_zero[index];
    if (item.hypothesis) {
      const Statement& s = sequent_.sequent().hypotheses[*item.hypothesis].statement;
      const auto [left, right] = sequent_.sides(s, 0);
      nonzero_.push_back(twin_.of(scalar_pair(Scalar::Kind::difference, left, right)));
      nonzero_proofs_.push_back("(Rminus_eq_contra _ _ " +
                                sequent_.hypothesis_name(*item.hypothesis) + ")");
      return;
    }
    const std::string scalar = twin_.of(scalars_.of(item.scalar).front());
    const std::string name = "HypSign" + std::to_string(index + 1);
    const std::string goal = item.negative ? "(Opp " + scalar + ")" : scalar;
    signs_ += "  assert (" + name + " : 0 < denote Phi sigma " + goal +
              ").\n  { refine (positive " + "Phi sigma smoothness @n hypotheses [] [] facts\n    " +
              goal + "\n    " + rocq_log(*item.sign, scalars_, twin_, instances_) +
              "\n    HypSmooth eq_refl HypEqual I HypFacts _). " + computed + ". }\n";
    nonzero_.push_back(scalar);
    nonzero_proofs_.push_back(
        std::string{item.negative ? "(nonzero_of_negative _ " : "(nonzero_of_positive _ "} + name +
        ")");
  }

  void add_reasons() {
    std::vector<std::string> reasons;
    for (const Divisor& divisor : proof_.divisors) {
      std::string numbers;
      for (const std::size_t k : divisor.product)
        numbers += (numbers.empty() ? "" : "; ") + std::to_string(k) + "%nat";
      reasons.push_back("Reason " + twin_.of(scalars_.of(divisor.factor).front()) + " [" + numbers +
                        "] []");
    }
    signs_ += "  pose (nonzero := " + rocq_list(nonzero_) + " : list term).\n";
    signs_ += "  assert (HypNonzero : all_nonzero Phi sigma nonzero) by exact " +
              conjunction(nonzero_proofs_) + ".\n";
    signs_ += "  pose (reasons := " + rocq_list(reasons) + " : list reason).\n";
  }

  std::vector<std::string> component_proofs() {
    std::vector<std::string> result;
    std::vector<std::string> goals;
    const bool together = are_checked_together();
    for (const ComponentProof& component : proof_.components) {
      const Statement& s = sequent_.sequent().conclusions[component.conclusion];
      const auto [left, right] = sequent_.sides(s, component.component);
      const auto* equation = std::get_if<EquationProof>(&component.why);
      if (equation == nullptr) {
        result.push_back(order_script(s, component, left, right));
        continue;
      }
      for (const ScalarPointer& side : {left, right})
        if (const std::string obstacle = obstacle_in_equation(side); !obstacle.empty())
          throw NotScalar{obstacle};
      const std::string cofactors = instances_.cofactors(equation->cofactors);
      const std::string left_twin = twin_.of(left);
      const std::string right_twin = twin_.of(right);
      if (!together) {
        result.push_back(
            "refine (equation Phi sigma smoothness @n hypotheses nonzero reasons\n    " +
            cofactors + "\n    " + left_twin + "\n    " + right_twin +
            "\n    HypSmooth eq_refl HypEqual HypNonzero _). " + computed + ".");
        continue;
      }
      std::string proof = "HypGoals";
      for (std::size_t k = 0; k < goals.size(); ++k) proof = "(proj2 " + proof + ")";
      result.push_back("exact (proj1 " + proof + ").");
      goals.push_back("(" + cofactors + ", (" + left_twin + ",\n     " + right_twin + "))");
    }
    if (!goals.empty())
      equations_ =
          "  pose proof (equations Phi sigma smoothness @n hypotheses nonzero reasons\n    [" +
          joined(goals, ";\n    ") + "]\n    HypSmooth eq_refl HypEqual HypNonzero ltac:(" +
          computed + ")) as HypGoals.\n";
    return result;
  }

  // Then what the hypotheses are worth is worked out once for all equations; but coqc takes longer
  // to see that the statement follows.
  bool are_checked_together() const {
    std::size_t equations = 0;
    std::size_t cofactors = 0;
    for (const ComponentProof& component : proof_.components)
      if (const auto* equation = std::get_if<EquationProof>(&component.why)) {
        ++equations;
        cofactors += equation->cofactors.size();
      }
    return equations > 1 && cofactors >= 8 * equations;
  }

  std::string order_script(const Statement& s, const ComponentProof& component,
                           const ScalarPointer& left, const ScalarPointer& right) {
    const auto difference = [&](const ScalarPointer& a, const ScalarPointer& b) {
      return twin_.of(scalar_pair(Scalar::Kind::difference, a, b));
    };
    const SignProof& proof = std::get<SignProof>(component.why);
    switch (s.relation) {
      case Relation::less:
        return "apply lt_from_difference. " + sign_script(difference(right, left), true, proof);
      case Relation::greater:
        return "apply gt_from_difference. " + sign_script(difference(left, right), true, proof);
      case Relation::less_equal:
        return "apply le_from_difference. " + sign_script(difference(right, left), false, proof);
      case Relation::greater_equal:
        return "apply ge_from_difference. " + sign_script(difference(left, right), false, proof);
      default: {
        std::string way;
        const std::size_t count = component_count(s);
        for (std::size_t k = 0; k < component.component; ++k) way += "right. ";
        if (component.component + 1 < count) way += "left. ";
        const std::string lemma =
            component.negative ? "apply different_of_less. " : "apply different_of_greater. ";
        return way + lemma +
               sign_script(component.negative ? difference(right, left) : difference(left, right),
                           true, proof);
      }
    }
  }

  const SequentProof& proof_;
  RocqSequent& sequent_;
  Scalars& scalars_;
  RocqNames& names_;
  RocqTwin twin_;
  RocqInstances instances_;
  std::vector<std::string> facts_;
  std::vector<std::string> fact_proofs_;
  std::vector<std::string> nonzero_;
  std::vector<std::string> nonzero_proofs_;
  std::string signs_;
  std::string equations_;

 public:
  std::size_t variable_count() const { return twin_.variables().size(); }
};

std::string with_count(std::string text, std::size_t count) {
  for (std::size_t at = text.find("@n"); at != std::string::npos; at = text.find("@n", at))
    text.replace(at, 2, std::to_string(count));
  return text;
}

}  // namespace

std::string rocq_proof(const SequentProof& proof, RocqSequent& sequent, Scalars& scalars,
                       RocqNames& names, RocqText& text) {
  ProofWriter writer{proof, sequent, scalars, names, text};
  const std::string result = writer.written();
  return with_count(result, writer.variable_count());
}

}  // namespace patchproof
