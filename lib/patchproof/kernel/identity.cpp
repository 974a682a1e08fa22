#include <patchproof/kernel/identity.hpp>

namespace patchproof {

void keep_open(const Conditions& conditions, Hypotheses& hypotheses, Workspace& workspace,
               const Span& span, Conditions& result) {
  for (const Condition& condition : conditions) {
    const Fraction reduced = hypotheses.reduced(condition.polynomial);
    const Polynomial p = normal_form(reduced.numerator(), workspace);
    if (condition.kind == Condition::Kind::not_zero) {
      if (p.is_zero()) throw NoValue{"division by zero", span};
      if (!hypotheses.facts().never_zero(p, workspace.budget))
        result.insert({condition.kind, primitive(p).polynomial});
    } else {
      if (!reduced.is_polynomial()) throw OutsideTheory{"the sign of a quotient under a square root"};
      if (p.is_constant() && p.constant() < 0)
        throw NoValue{"the square root of a negative number", span};
      if (!hypotheses.facts().never_negative(p, workspace.budget))
        result.insert({condition.kind, p});
    }
  }
}

namespace {

// numerator * denominator has the sign of the fraction, where the fraction has a value.
Polynomial sign_polynomial(const Fraction& fraction, Workspace& workspace) {
  return normal_form(product(fraction.numerator(), expanded(fraction.denominator(), workspace.budget),
                             workspace.budget),
                     workspace);
}

// Zero by itself, or a multiple of an assumed equation that could not be solved.
bool vanishes(const Fraction& d, const Hypotheses& hypotheses, Workspace& w) {
  if (d.is_zero()) return true;
  for (const Polynomial& equation : hypotheses.unsolved())
    if (quotient(d.numerator(), equation, w.budget)) return true;
  return false;
}

bool order_holds(Relation relation, const Fraction& d, const SignFacts& facts, Workspace& w) {
  const Polynomial p = sign_polynomial(d, w);
  const Polynomial minus = scaled(p, -1);
  switch (relation) {
    case Relation::less: return facts.always_positive(minus, w.budget);
    case Relation::less_equal: return facts.never_negative(minus, w.budget);
    case Relation::greater: return facts.always_positive(p, w.budget);
    default: return facts.never_negative(p, w.budget);
  }
}

}  // namespace

Finding finding(const Goal& goal, Evaluator& evaluator, Hypotheses& hypotheses,
                Workspace& workspace) {
  Finding result;
  keep_open(hypotheses.conditions(), hypotheses, workspace, {}, result.conditions);
  bool decided = false;
  for (std::size_t k = 0; k < goal.statements.size() && !decided; ++k) {
    const Statement& statement = goal.statements[k];
    const Value& left = evaluator.value(statement.left);
    const Value& right = evaluator.value(statement.right);
    keep_open(left.conditions, hypotheses, workspace, statement.span, result.conditions);
    keep_open(right.conditions, hypotheses, workspace, statement.span, result.conditions);
    bool some_never_equal = false;
    for (std::size_t c = 0; c < left.components.size() && !decided; ++c) {
      const Fraction plain = difference(left.components[c], right.components[c], workspace.budget);
      const Fraction d =
          normal_form(hypotheses.reduced(normal_form(plain, workspace)), workspace);
      bool good = vanishes(d, hypotheses, workspace);
      if (statement.relation == Relation::not_equal) {
        some_never_equal =
            some_never_equal || hypotheses.facts().never_zero(d.numerator(), workspace.budget);
        good = some_never_equal || c + 1 < left.components.size();
      } else if (statement.relation != Relation::equal) {
        good = order_holds(statement.relation, d, hypotheses.facts(), workspace);
      }
      if (good) continue;
      const bool equation = statement.relation == Relation::equal;
      if (equation || result.outcome == Finding::Outcome::holds) {
        result.statement = k;
        result.component = c;
        result.residual = d;
        result.outcome = equation ? Finding::Outcome::fails : Finding::Outcome::open;
      }
      decided = equation;
    }
  }
  // The substitutions above may have met conditions of their own.
  keep_open(hypotheses.conditions(), hypotheses, workspace, {}, result.conditions);
  return result;
}

}  // namespace patchproof
