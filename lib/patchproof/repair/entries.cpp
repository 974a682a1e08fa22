#include <patchproof/repair/entries.hpp>

#include <algorithm>

#include <patchproof/decide/shown.hpp>
#include <patchproof/decide/trial.hpp>

namespace patchproof {

namespace {

using syntax::Expression;
using Kind = Expression::Kind;

bool is_literal(const Expression& e) { return e.kind == Kind::tuple || e.kind == Kind::matrix; }

bool is_numeral(const Expression& e) {
  if (e.kind == Kind::number) return true;
  const bool made_of_numbers =
      e.kind == Kind::sum || e.kind == Kind::product || e.kind == Kind::negation;
  return made_of_numbers && std::all_of(e.operands.begin(), e.operands.end(),
                                        [](const auto& o) { return o->kind == Kind::number; });
}

/// Compares a literal with a value of the same type, entry by entry.
class Comparison {
 public:
  Comparison(const Goal& goal, const Limits& limits, Entries& result)
      : goal_{goal}, limits_{limits}, trial_{limits}, result_{result} {}

  void compare(const Expression& literal, const Term& own, const Term& value) {
    const Type& type = value.type();
    if (literal.kind == Kind::tuple && type.is_point() &&
        literal.operands.size() == static_cast<std::size_t>(type.dimension)) {
      for (int k = 0; k < type.dimension; ++k)
        compare(*literal.operands[static_cast<std::size_t>(k)],
                part(own, Operation::component, {k}), part(value, Operation::component, {k}));
    } else if (literal.kind == Kind::matrix && type.is_matrix()) {
      // A list may be written as a row.
      int cell = 0;
      for (const auto& row : literal.rows)
        for (const auto& entry : row) {
          const Indices place{cell / type.columns, cell % type.columns};
          compare(*entry, part(own, Operation::entry, place), part(value, Operation::entry, place));
          ++cell;
        }
    } else {
      compare_entry(literal, own, value);
    }
  }

  bool others_differ() const { return others_differ_; }

 private:
  static Term part(const Term& whole, Operation operation, const Indices& place) {
    const Type type = operation == Operation::entry ? *whole.type().inner : Type::scalar();
    return make_term(operation, type, {whole}, place, whole.span());
  }

  void compare_entry(const Expression& literal, const Term& own, const Term& value) {
    Goal goal = goal_;
    goal.statements = {{own, Relation::equal, value, literal.span}};
    const bool agrees = trial_.may_hold(goal);
    if (!is_numeral(literal) || !value.type().is_scalar()) {
      others_differ_ = others_differ_ || !agrees;
      return;
    }
    result_.determined.push_back(literal.span);
    if (!agrees)
      result_.corrections.push_back({Line::begin_of(literal.span), Line::end_of(literal.span),
                                     normal_form_in_words(value, limits_), "entry"});
  }

  const Goal& goal_;
  const Limits& limits_;
  Trial trial_;
  Entries& result_;
  bool others_differ_ = false;
};

std::size_t cells(const Expression& literal) {
  return literal.kind == Kind::tuple ? 1 : literal.rows.size() * literal.rows.front().size();
}

std::size_t cells(const Type& type) {
  if (type.is_matrix())
    return static_cast<std::size_t>(type.rows) * static_cast<std::size_t>(type.columns);
  return type.is_point() ? 1 : 0;
}

}  // namespace

Entries entries_of(const Line& line, const Claim& claim, const Limits& limits) {
  Entries result;
  const syntax::Comparison& comparison = line.proposition.comparisons.front();
  const auto* identity = std::get_if<IdentityClaim>(&claim.kind);
  if (identity == nullptr || comparison.on_boundary || comparison.operands.size() != 2)
    return result;
  const Goal& goal = identity->goal;
  if (goal.statements.size() != 1) return result;
  const Expression& left = *comparison.operands[0];
  const Expression& right = *comparison.operands[1];
  if (is_literal(left) == is_literal(right)) return result;
  const Statement& statement = goal.statements.front();
  const Expression& literal = is_literal(left) ? left : right;
  const Term& own = is_literal(left) ? statement.left : statement.right;
  const Term& value = is_literal(left) ? statement.right : statement.left;
  if (cells(literal) != cells(value.type())) return result;
  try {
    Comparison entries{goal, limits, result};
    entries.compare(literal, own, value);
    if (entries.others_differ()) result.corrections.clear();
    return result;
  } catch (const TooDeep&) {
    return {};
  }
}

}  // namespace patchproof
