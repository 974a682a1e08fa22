#include <patchproof/kernel/identity.hpp>

#include <patchproof/kernel/enclose.hpp>
#include <patchproof/kernel/integral_signs.hpp>
#include <patchproof/kernel/readable.hpp>

namespace patchproof {

namespace {

// Whether a condition on numbers alone holds; nothing when it depends on symbols.
// A number that is neither certainly zero nor certainly not leaves everything undecided: a condition
// that fails would make the claim mean nothing.
std::optional<bool> holds_for_numbers(Condition::Kind kind, const Polynomial& p, Workspace& w) {
  for (const Variable v : variables_within(p, w.atoms)) {
    const Atom::Kind atom = w.atoms[v].kind;
    if (atom == Atom::Kind::symbol || atom == Atom::Kind::jet || atom == Atom::Kind::slot)
      return std::nullopt;
  }
  const std::optional<int> sign = certain_sign(Fraction{p}, w.atoms, w.budget);
  if (!sign)
    throw OutsideTheory{"it was not decided whether " + to_text(Fraction{p}, w.atoms, w.budget, 200) +
                        " is zero"};
  return kind == Condition::Kind::not_zero ? *sign != 0 : *sign >= 0;
}

// The facts, and that the roots of numbers in the polynomial are positive.
SignFacts facts_about(const Polynomial& p, const SignFacts& facts, const Atoms& atoms) {
  SignFacts result = facts;
  for (const Variable v : p.variables()) {
    const Atom& atom = atoms[v];
    const bool of_number = atom.kind == Atom::Kind::root && atom.arguments.front().is_polynomial() &&
                           atom.arguments.front().numerator().is_constant();
    if (of_number && atom.arguments.front().numerator().constant() > 0)
      result.add_inequality(Polynomial::variable(v), true);
  }
  return result;
}

}  // namespace

void keep_open(const Conditions& conditions, Hypotheses& hypotheses, Workspace& workspace,
               const Span& span, Conditions& result) {
  for (const Condition& condition : conditions) {
    const Fraction reduced = hypotheses.reduced(condition.polynomial);
    const Polynomial p = normal_form(reduced.numerator(), workspace);
    if (condition.kind == Condition::Kind::not_zero) {
      const SignFacts facts = facts_about(p, hypotheses.facts(), workspace.atoms);
      const std::optional<bool> known = holds_for_numbers(condition.kind, p, workspace);
      if (known == true || (!known && facts.never_zero(p, workspace.budget))) continue;
      const bool always_zero = known == false ||
                               (facts.never_negative(p, workspace.budget) &&
                                facts.never_negative(scaled(p, -1), workspace.budget));
      if (always_zero) throw NoValue{"division by zero", span};
      result.insert({condition.kind, primitive(p).polynomial});
    } else {
      if (!reduced.is_polynomial()) throw OutsideTheory{"the sign of a quotient under a square root"};
      const std::optional<bool> known = holds_for_numbers(condition.kind, p, workspace);
      if (known == false) throw NoValue{"the square root of a negative number", span};
      const SignFacts facts = with_signs_of_integrals(hypotheses.facts(), p, workspace);
      if (known != true && !facts.never_negative(p, workspace.budget))
        result.insert({condition.kind, p});
    }
  }
}

namespace {

// A polynomial with the sign of the fraction, where the fraction has a value: the numerator times the
// factors of the denominator whose sign is not known. The denominator is not zero there.
Polynomial sign_polynomial(const Fraction& fraction, const SignFacts& facts, Workspace& workspace) {
  Polynomial result = fraction.numerator();
  for (const auto& [factor, exponent] : fraction.denominator()) {
    if (exponent % 2 == 0 || facts.never_negative(factor, workspace.budget)) continue;
    const bool negative = facts.never_negative(scaled(factor, -1), workspace.budget);
    result = negative ? scaled(result, -1) : product(result, factor, workspace.budget);
  }
  return normal_form(result, workspace);
}

// Zero by itself, or a multiple of an assumed equation that could not be solved.
bool vanishes(const Fraction& d, const Hypotheses& hypotheses, Workspace& w) {
  if (d.is_zero()) return true;
  for (const Polynomial& equation : hypotheses.unsolved())
    if (quotient(d.numerator(), equation, w.budget)) return true;
  return false;
}

// An inequality between numbers alone, where their difference has a certain sign.
std::optional<bool> number_relation(Relation relation, const Fraction& d, Workspace& w) {
  if (relation == Relation::equal || !d.is_polynomial()) return std::nullopt;
  for (const Variable v : variables_within(d.numerator(), w.atoms)) {
    const Atom::Kind atom = w.atoms[v].kind;
    if (atom == Atom::Kind::symbol || atom == Atom::Kind::jet || atom == Atom::Kind::slot)
      return std::nullopt;
  }
  const std::optional<int> sign = certain_sign(d, w.atoms, w.budget);
  if (!sign) return std::nullopt;
  switch (relation) {
    case Relation::not_equal: return *sign != 0;
    case Relation::less: return *sign < 0;
    case Relation::less_equal: return *sign <= 0;
    case Relation::greater: return *sign > 0;
    default: return *sign >= 0;
  }
}

// The polynomial whose sign an order between left and right asks for; `d` is left - right.
SignFacts::Inequality asked_by(Relation relation, const Fraction& d, const SignFacts& facts,
                               Workspace& w) {
  const Polynomial p = sign_polynomial(d, facts, w);
  const bool smaller = relation == Relation::less || relation == Relation::less_equal;
  const bool strict = relation == Relation::less || relation == Relation::greater;
  return {smaller ? scaled(p, -1) : p, strict};
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
    Polynomial squares;  // of the differences: zero only where both sides are equal
    for (std::size_t c = 0; c < left.components.size() && !decided; ++c) {
      const Fraction plain = difference(left.components[c], right.components[c], workspace.budget);
      const Fraction d =
          normal_form(hypotheses.reduced(normal_form(plain, workspace)), workspace);
      bool good = vanishes(d, hypotheses, workspace);
      const std::optional<bool> settled = number_relation(statement.relation, d, workspace);
      std::optional<SignFacts::Inequality> asked;
      SignAnswer answer;
      if (statement.relation == Relation::not_equal) {
        if (!some_never_equal && !settled) {
          answer = hypotheses.facts().apart_from_zero(d.numerator(), workspace.budget);
          if (answer.shown()) result.tree.add(answer.tree);
        }
        some_never_equal = some_never_equal || settled.value_or(answer.shown());
        const bool last = c + 1 == left.components.size();
        squares = sum(squares, product(d.numerator(), d.numerator(), workspace.budget),
                      workspace.budget);
        if (last && c > 0 && !some_never_equal) {
          answer = hypotheses.facts().sign(normal_form(squares, workspace), true, workspace.budget);
          some_never_equal = answer.shown();
          if (some_never_equal) result.tree.add(answer.tree);
        }
        good = some_never_equal || !last;
      } else if (statement.relation != Relation::equal) {
        const SignFacts facts =
            with_signs_of_integrals(hypotheses.facts(), d.numerator(), workspace);
        asked = asked_by(statement.relation, d, facts, workspace);
        if (!settled) answer = facts.sign(asked->polynomial, asked->strict, workspace.budget);
        good = settled.value_or(answer.shown());
        if (good) result.tree.add(answer.tree);
      }
      if (good) continue;
      const bool equation = statement.relation == Relation::equal;
      if (equation || result.outcome == Finding::Outcome::holds) {
        result.statement = k;
        result.component = c;
        result.residual = d;
        result.asked = asked;
        result.sign = answer;
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
