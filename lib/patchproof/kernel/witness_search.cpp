#include <algorithm>

#include <patchproof/kernel/witness.hpp>
#include <patchproof/kernel/witness_values.hpp>

namespace patchproof {

namespace {

// Small numbers first; every interval has some of them sooner or later.
std::vector<Rational> candidates(int attempt) {
  static const std::vector<Rational> simple = [] {
    std::vector<Rational> result{0, 1, -1, Rational{1, 2}, 2, -2, Rational{1, 3}, Rational{2, 3},
                                 3, -3, Rational{1, 4}, Rational{3, 4}, Rational{-1, 2}};
    for (int n = 4; n <= 12; ++n) {
      result.push_back(n);
      result.push_back(-n);
      result.push_back(Rational{1, n + 1});
      result.push_back(Rational{n, n + 1});
      result.push_back(Rational{2, 2 * n - 3});
    }
    return result;
  }();
  std::vector<Rational> result = simple;
  const auto shift = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(attempt) % simple.size());
  std::rotate(result.begin(), result.begin() + shift, result.end());
  return result;
}

class Search {
 public:
  Search(const Goal& goal, const WitnessTarget& target, Hypotheses& hypotheses,
         Workspace& workspace, int attempt)
      : goal_{goal},
        target_{target},
        hypotheses_{hypotheses},
        workspace_{workspace},
        attempt_{attempt},
        candidates_{candidates(attempt)},
        known_{static_cast<Variable>(workspace.atoms.size())} {}

  std::optional<Witness> run() {
    for (const Polynomial& p : target_.not_zero) state_.push_back({p, Kind::not_zero});
    for (const Polynomial& p : hypotheses_.facts().not_zero()) state_.push_back({p, Kind::not_zero});
    for (const Polynomial& p : hypotheses_.unsolved()) state_.push_back({p, Kind::zero});
    for (const auto& i : target_.inequalities) add_inequality(i);
    for (const auto& i : hypotheses_.facts().inequalities()) add_inequality(i);
    if (!assign()) return std::nullopt;
    return witness_values(goal_, assigned_, known_, hypotheses_, workspace_, attempt_);
  }

 private:
  enum class Kind { zero, not_zero, at_least_zero, above_zero };
  struct Requirement {
    Polynomial polynomial;
    Kind kind;
  };
  using State = std::vector<Requirement>;

  void add_inequality(const SignFacts::Inequality& i) {
    state_.push_back({i.polynomial, i.strict ? Kind::above_zero : Kind::at_least_zero});
  }

  // Parameters and scalars come first: they occur in the arguments of others.
  std::optional<Variable> next_variable() const {
    std::optional<Variable> best;
    const auto rank = [&](Variable v) {
      const Atom& atom = workspace_.atoms[v];
      const bool scalar = atom.kind == Atom::Kind::symbol && atom.symbol->type.is_scalar();
      return std::tuple{!scalar, atom.symbol->ordinal, v};
    };
    for (const Requirement& requirement : state_)
      for (const Variable v : variables_within(requirement.polynomial, workspace_.atoms))
        if (is_open(v, workspace_.atoms) && (!best || rank(v) < rank(*best))) best = v;
    return best;
  }

  static bool is_order(Kind kind) {
    return kind == Kind::at_least_zero || kind == Kind::above_zero;
  }

  static bool fits(Kind kind, const Rational& value) {
    switch (kind) {
      case Kind::zero: return value == 0;
      case Kind::not_zero: return value != 0;
      case Kind::at_least_zero: return value >= 0;
      default: return value > 0;
    }
  }

  // The state after v = value; empty when some requirement then fails.
  std::optional<State> after(Variable v, const Rational& value) {
    State result;
    std::vector<LinearConstraint> linear;
    for (const Requirement& requirement : state_) {
      Polynomial p = requirement.polynomial;
      if (variables_within(p, workspace_.atoms).contains(v)) {
        const Fraction moved = with_value(p, v, value, hypotheses_, workspace_);
        if (!moved.is_polynomial()) return std::nullopt;
        p = moved.numerator();
      }
      if (p.is_constant()) {
        const Rational c = p.constant();
        if (!fits(requirement.kind, c)) return std::nullopt;
        continue;
      }
      if (is_order(requirement.kind)) {
        const auto constraint = linear_constraint(
            p, requirement.kind == Kind::above_zero ? LinearConstraint::Kind::above_zero
                                                    : LinearConstraint::Kind::at_least_zero);
        if (constraint && linear.size() < 24) linear.push_back(*constraint);
      }
      result.push_back({p, requirement.kind});
    }
    if (!linear.empty() && !small_model(linear, workspace_.budget)) return std::nullopt;
    return result;
  }

  bool assign() {
    const std::optional<Variable> v = next_variable();
    if (!v) return true;
    std::vector<Rational> values = candidates_;
    if (const std::optional<Rational> fitting = model_value(*v)) values.push_back(*fitting);
    if (const auto known = target_.preferred.find(*v); known != target_.preferred.end())
      values.insert(values.begin(), known->second);
    for (const Rational& value : values) {
      if (++tried_ > 4000) return false;
      workspace_.budget.spend(10);
      std::optional<State> next;
      try {
        next = after(*v, value);
      } catch (const std::domain_error&) {
        continue;  // a division by zero: not a place to look at
      }
      if (!next) continue;
      std::swap(state_, *next);
      assigned_.emplace_back(*v, value);
      if (assign()) return true;
      assigned_.pop_back();
      std::swap(state_, *next);
    }
    return false;
  }

  // A value from a common solution of the linear requirements, for narrow or far intervals.
  std::optional<Rational> model_value(Variable v) {
    std::vector<LinearConstraint> linear;
    for (const Requirement& requirement : state_) {
      if (!is_order(requirement.kind) || linear.size() >= 24) continue;
      const auto constraint = linear_constraint(requirement.polynomial,
                                                requirement.kind == Kind::above_zero
                                                    ? LinearConstraint::Kind::above_zero
                                                    : LinearConstraint::Kind::at_least_zero);
      if (constraint) linear.push_back(*constraint);
    }
    const auto model = small_model(linear, workspace_.budget);
    if (!model || !model->contains(v)) return std::nullopt;
    return model->at(v);
  }

  const Goal& goal_;
  const WitnessTarget& target_;
  Hypotheses& hypotheses_;
  Workspace& workspace_;
  int attempt_;
  std::vector<Rational> candidates_;
  /// Variables from here on are made while searching.
  Variable known_;
  State state_;
  std::vector<std::pair<Variable, Rational>> assigned_;
  int tried_ = 0;
};

}  // namespace

std::optional<Witness> find_witness(const Goal& goal, const WitnessTarget& target,
                                    Hypotheses& hypotheses, Workspace& workspace, int attempt) {
  return Search{goal, target, hypotheses, workspace, attempt}.run();
}

}  // namespace patchproof
