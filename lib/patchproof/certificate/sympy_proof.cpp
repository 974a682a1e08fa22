#include <patchproof/certificate/sympy_proof.hpp>

#include <map>

#include <patchproof/certificate/python_lines.hpp>
#include <patchproof/certificate/scalar_nodes.hpp>
#include <patchproof/certificate/sequents.hpp>

namespace patchproof {

namespace {

const std::string margin = "    ";

class ProofWriter {
 public:
  ProofWriter(const SequentProof& proof, Scalars& scalars, PythonText& text)
      : proof_{proof}, scalars_{scalars}, text_{text}, facts_{facts_of(proof.sequent)} {}

  std::string written() {
    for (std::size_t k = 0; k < proof_.not_zero.size(); ++k) add_not_zero(proof_.not_zero[k]);
    for (const ComponentProof& component : proof_.components) add(component);
    return result_;
  }

 private:
  void line(const std::string& text) { result_ += margin + text + "\n"; }
  void remark(const std::string& text) { result_ += python_comment(text, margin); }

  std::string expression(const Term& term) { return text_.of(scalars_.of(term).front()); }
  std::string factor(const Term& term) { return text_.factor(scalars_.of(term).front()); }

  ScalarPointer difference(const Statement& s, std::size_t component, bool turned) {
    const ScalarPointer left = scalars_.of(s.left).at(component);
    const ScalarPointer right = scalars_.of(s.right).at(component);
    return turned ? scalar_pair(Scalar::Kind::difference, right, left)
                  : scalar_pair(Scalar::Kind::difference, left, right);
  }

  // left - right of a hypothesis, made where it is first used.
  std::string assumed(const Instance& instance) {
    const auto [found, is_new] =
        assumed_.try_emplace({instance.hypothesis, instance.component}, assumed_.size() + 1);
    const std::string name = "assumed_" + std::to_string(found->second);
    if (is_new) {
      const Assumption& hypothesis = proof_.sequent.hypotheses.at(instance.hypothesis);
      remark("assumed to be 0" + (hypothesis.label.empty() ? "" : ", " + hypothesis.label) + ":");
      line(name + " = " + text_.of(difference(hypothesis.statement, instance.component, false)));
    }
    return name;
  }

  // The equation, differentiated, at the values of its parameters.
  std::string at(const Instance& instance) {
    std::string result = assumed(instance);
    const Statement& s = proof_.sequent.hypotheses.at(instance.hypothesis).statement;
    const std::vector<SymbolPointer> parameters = parameters_of(s);
    std::string derivatives;
    std::string places;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const std::string name = text_.of(scalar_variable({parameters[k], 0}));
      const int order = k < instance.orders.size() ? instance.orders[k] : 0;
      if (order > 0) derivatives += ", " + name + ", " + std::to_string(order);
      const std::string value = expression(instance.at.at(k));
      if (value != name) places += (places.empty() ? "" : ", ") + name + ": " + value;
    }
    if (!derivatives.empty()) result = "diff(" + result + derivatives + ")";
    return places.empty() ? result : "at(" + result + ", {" + places + "})";
  }

  // Each summand on a line of its own, as a sum that is taken away.
  std::string multiples(const std::vector<Cofactor>& cofactors) {
    std::string result;
    for (const Cofactor& cofactor : cofactors) {
      const std::string equation = at(cofactor.equation);
      const std::string times = factor(cofactor.factor);
      result += "\n" + margin + margin;
      result += times == "(-1)" ? "+ " : times == "1" ? "- " : "- " + times + "*";
      result += equation;
    }
    return result;
  }

  std::string fact_name(std::size_t index) { return "fact_" + std::to_string(index + 1); }

  void define_fact(std::size_t index, const std::vector<Fact>& facts) {
    if (!defined_.insert({index, facts[index].scalar.address()}).second) return;
    line(fact_name(index) + " = " + expression(facts[index].scalar) +
         (facts[index].strict ? "  # > 0" : "  # >= 0"));
  }

  void define_given_facts(const Combination& why, std::size_t given) {
    for (const Summand& summand : why.summands)
      for (const auto& [index, exponent] : summand.facts)
        if (index < given) define_fact(index, facts_);
  }

  std::string summand(const Summand& item) {
    std::string result;
    const auto times = [&](const std::string& part) {
      result += (result.empty() ? "" : "*") + part;
    };
    if (item.coefficient != 1 || (item.squares.empty() && item.facts.empty()))
      times(text_.factor(scalar_number(item.coefficient)));
    for (const auto& [index, exponent] : item.facts)
      times(fact_name(index) + (exponent == 1 ? "" : "**" + std::to_string(exponent)));
    for (const Term& square : item.squares) times(factor(square) + "**2");
    return "\n" + margin + margin + "- " + result;
  }

  // goal = sum of the summands and of the multiples.
  void yield_zero(const std::string& goal, const Combination* why,
                  const std::vector<Cofactor>& cofactors) {
    std::string parts;
    if (why)
      for (const Summand& item : why->summands) parts += summand(item);
    parts += multiples(cofactors);
    if (parts.empty()) return line("yield is_zero(" + goal + ")");
    line("yield is_zero(\n" + margin + margin + goal + parts + "\n" + margin + ")");
  }

  void add_sign(const std::string& goal, bool strict, const SignProof& proof,
                std::vector<Fact> facts) {
    for (const SignProof::Step& step : proof.steps) {
      define_given_facts(step.why, facts_.size());
      facts.push_back({step.fact, step.strict});
      line(fact_name(facts.size() - 1) + " = " + expression(step.fact));
      remark(step.strict ? "it is > 0:" : "it is >= 0:");
      yield_zero(fact_name(facts.size() - 1), &step.why, step.why.cofactors);
    }
    if (const auto* last = std::get_if<Combination>(&proof.end)) {
      define_given_facts(*last, facts_.size());
      remark(strict ? "a sum of parts that are >= 0, one of them > 0:"
                    : "a sum of parts that are >= 0:");
      return yield_zero(goal, last, last->cofactors);
    }
    const auto& cut = std::get<SignProof::Cut>(proof.end);
    const std::string at = expression(cut.at);
    for (std::size_t k = 0; k < cut.cases.size(); ++k) {
      std::vector<Fact> own = facts;
      own.push_back({cut.at, false});
      remark(k == 0 ? "where this is >= 0:" : "and where this is >= 0:");
      line(fact_name(facts.size()) + " = " + (k == 0 ? at : "-(" + at + ")"));
      add_sign(goal, strict, cut.cases[k], own);
    }
  }

  void add_not_zero(const NonZero& item) {
    remark(item.hypothesis ? "a divisor that is assumed not to be 0: " + expression(item.scalar)
                           : "a divisor that is not 0: " + expression(item.scalar));
    if (!item.sign) return;
    const std::string scalar = factor(item.scalar);
    add_sign(item.negative ? "-" + scalar : expression(item.scalar), true, *item.sign, facts_);
  }

  void add(const ComponentProof& component) {
    const Statement& s = proof_.sequent.conclusions.at(component.conclusion);
    if (const auto* equation = std::get_if<EquationProof>(&component.why)) {
      const std::string goal = text_.of(difference(s, component.component, false));
      return yield_zero(goal, nullptr, equation->cofactors);
    }
    const bool turned = s.relation == Relation::less || s.relation == Relation::less_equal ||
                        (s.relation == Relation::not_equal && component.negative);
    const bool strict = s.relation != Relation::less_equal && s.relation != Relation::greater_equal;
    add_sign(text_.of(difference(s, component.component, turned)), strict,
             std::get<SignProof>(component.why), facts_);
  }

  const SequentProof& proof_;
  Scalars& scalars_;
  PythonText& text_;
  std::vector<Fact> facts_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> assumed_;
  std::set<std::pair<std::size_t, const TermNode*>> defined_;
  std::string result_;
};

}  // namespace

std::string sympy_proof(const SequentProof& proof, Scalars& scalars, PythonText& text) {
  return ProofWriter{proof, scalars, text}.written();
}

}  // namespace patchproof
