#include <patchproof/grid/grid_proof.hpp>

#include <algorithm>
#include <optional>

#include <patchproof/grid/grid_run.hpp>
#include <patchproof/grid/tape_builder.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

using Step = Tape::Step;

// Every value of the parameters is allowed, and there is one.
bool is_plain(const Goal& goal) {
  const auto is_number = [](const Term& term) { return term.is_number(); };
  return goal.assumptions.empty() &&
         std::all_of(goal.ranges.begin(), goal.ranges.end(),
                     [&](const ParameterRange& range) {
                       return is_number(range.lower) && is_number(range.upper) &&
                              range.lower.number() < range.upper.number();
                     }) &&
         std::all_of(goal.statements.begin(), goal.statements.end(),
                     [](const Statement& s) { return s.relation == Relation::equal; });
}

GridRanges ranges_of(const Goal& goal, const TapeBuilder& builder) {
  GridRanges ranges;
  for (const ParameterRange& range : goal.ranges)
    if (const auto found = builder.variables().find(range.parameter->ordinal);
        found != builder.variables().end())
      ranges[found->second] = {range.lower.number(), range.upper.number() - range.lower.number()};
  return ranges;
}

Term point_of(const Type& type, std::vector<Term> coordinates) {
  if (type.is_scalar()) return coordinates.front();
  return make_term(Operation::tuple, type, std::move(coordinates));
}

// Everything that does not matter is zero; a parameter that does not is where its range begins.
std::vector<KnownValue> values_at(const GridDifference& difference, const Goal& goal,
                                  const TapeBuilder& builder) {
  std::map<unsigned, Rational> starts;
  for (const ParameterRange& range : goal.ranges)
    starts.emplace(range.parameter->ordinal, range.lower.number());
  std::map<unsigned, SymbolPointer> symbols = free_symbols(goal);
  for (const KnownValue& known : goal.known) symbols.erase(known.symbol->ordinal);
  std::vector<KnownValue> values;
  for (const auto& [ordinal, symbol] : symbols) {
    std::vector<Rational> coordinates(symbol->type.component_count());
    const auto variable = builder.variables().find(ordinal);
    const auto first = builder.symbols().find(ordinal);
    if (variable != builder.variables().end()) {
      coordinates.front() = difference.point[variable->second];
    } else if (first != builder.symbols().end()) {
      for (std::uint32_t k = 0; k < coordinates.size(); ++k)
        if (difference.symbol == first->second + k) coordinates[k] = 1;
    } else if (const auto start = starts.find(ordinal); start != starts.end()) {
      coordinates.front() = start->second;
    }
    std::vector<Term> terms;
    for (const Rational& coordinate : coordinates) terms.push_back(number_term(coordinate));
    values.push_back({symbol, point_of(symbol->type, std::move(terms))});
  }
  return values;
}

std::optional<GridAnswer> attempt(const Goal& goal, bool scalars_are_variables, Budget& budget) {
  using Kind = GridAnswer::Kind;
  try {
    Tape tape;
    TapeBuilder builder{tape, goal.known, scalars_are_variables};
    std::vector<Step> differences;
    for (const Statement& statement : goal.statements) {
      const std::vector<Step> left = builder.components(statement.left);
      const std::vector<Step> right = builder.components(statement.right);
      if (left.size() != right.size()) return GridAnswer{};
      for (std::size_t k = 0; k < left.size(); ++k)
        differences.push_back(tape.difference(left[k], right[k]));
    }
    budget.spend(tape.entries().size());
    const GridRanges ranges = ranges_of(goal, builder);
    // One point is enough for most of what is false.
    std::optional<GridDifference> difference =
        difference_at_a_point(tape, differences, ranges, budget);
    if (!difference) {
      if (are_zero(tape, differences, budget)) return GridAnswer{Kind::holds};
      difference = difference_from_zero(tape, differences, ranges, budget);
    }
    if (!difference) return GridAnswer{};
    return GridAnswer{Kind::differs, values_at(*difference, goal, builder)};
  } catch (const Declined&) {
    return std::nullopt;
  }
}

}  // namespace

GridAnswer answer_on_grid(const Goal& goal, Budget& budget) {
  if (!is_plain(goal)) return {};
  if (const std::optional<GridAnswer> answer = attempt(goal, false, budget)) return *answer;
  return attempt(goal, true, budget).value_or(GridAnswer{});
}

bool holds_on_grid(const Goal& goal, Budget& budget) {
  return answer_on_grid(goal, budget).kind == GridAnswer::Kind::holds;
}

}  // namespace patchproof
