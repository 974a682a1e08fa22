#include <algorithm>

#include <patchproof/claims/joint.hpp>
#include <patchproof/language/case_elaborator.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

// Whether two ends of ranges are the same number or the same symbol.
bool same_end(const Term& a, const Term& b) {
  if (a.is_number() && b.is_number()) return a.number() == b.number();
  return a.operation() == Operation::symbol && b.operation() == Operation::symbol &&
         a.symbol()->ordinal == b.symbol()->ordinal;
}

}  // namespace

std::pair<Term, Term> CaseElaborator::range_of(const std::string& parameter) const {
  for (const ParameterRange& range : ranges_)
    if (range.parameter->name == parameter) return {range.lower, range.upper};
  return {number_term(0), number_term(1)};
}

// The edges are compared parameter by parameter, so they have to run over the same interval.
void CaseElaborator::require_equal_ranges(const JointEdge& first, const JointEdge& second,
                                          const Span& span) const {
  const auto along = [](const JointEdge& edge) {
    std::vector<std::string> names = edge.function.type().parameters;
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(edge.crossing));
    return names;
  };
  const std::vector<std::string> a = along(first);
  const std::vector<std::string> b = along(second);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto [a_low, a_high] = range_of(a[k]);
    const auto [b_low, b_high] = range_of(b[k]);
    if (!same_end(a_low, b_low) || !same_end(a_high, b_high))
      throw Fault{span, "the edges run over different ranges of '" + a[k] + "' and '" + b[k] + "'",
                  "reparametrise one of the patches"};
  }
}

void CaseElaborator::add_joint(const syntax::Joint& joint, const Scope& scope, Goal& goal) {
  constexpr int highest = 20;
  if (joint.order > highest) throw Fault{joint.span, "the order of a joint is at most 20"};
  Construction& construct = elaborator_.construct();
  const auto edge_of = [&](const syntax::Edge& edge) {
    JointEdge result;
    result.function = elaborator_.name(edge.patch.text, edge.patch.span, scope);
    if (!result.function.type().is_function())
      throw Fault{edge.patch.span, "'" + edge.patch.text + "' is a " +
                                       to_text(result.function.type()) + ", not a curve or patch"};
    const auto& names = result.function.type().parameters;
    const auto place = std::find(names.begin(), names.end(), edge.parameter.text);
    if (place == names.end())
      throw Fault{edge.parameter.span, "'" + edge.parameter.text + "' is not a parameter of '" +
                                           edge.patch.text + "', a " +
                                           to_text(result.function.type()),
                  did_you_mean(edge.parameter.text, names)};
    result.crossing = static_cast<std::size_t>(place - names.begin());
    result.value =
        construct.scalar(scope, elaborator_.expression(*edge.value, scope), "the place of an edge");
    const auto [lower, upper] = range_of(edge.parameter.text);
    if (!same_end(lower, result.value) && !same_end(upper, result.value))
      throw Fault{edge.value->span,
                  "an edge of '" + edge.patch.text + "' lies at an end of the range of '" +
                      edge.parameter.text + "'",
                  "'" + edge.parameter.text + "' runs over [" + to_text(lower, 40) + ", " +
                      to_text(upper, 40) + "]"};
    result.at_end = same_end(upper, result.value);
    return result;
  };
  const JointEdge first = edge_of(joint.first);
  const JointEdge second = edge_of(joint.second);
  const Type& a = first.function.type();
  const Type& b = second.function.type();
  if (a.parameters.size() != b.parameters.size())
    throw Fault{joint.span, "a " + to_text(a) + " cannot be joined to a " + to_text(b)};
  if (!(*a.inner == *b.inner))
    throw Fault{joint.span, "the two sides of a joint have values of one type, and these are a " +
                                to_text(*a.inner) + " and a " + to_text(*b.inner)};
  require_equal_ranges(first, second, joint.span);
  std::vector<Term> along;
  for (std::size_t k = 0; k < a.parameters.size(); ++k) {
    if (k == first.crossing) continue;
    const std::string& name = a.parameters[k];
    const Entity* entity = scope.find(name);
    if (entity != nullptr && entity->kind == Entity::Kind::term &&
        entity->term.operation() == Operation::symbol &&
        entity->term.symbol()->role == Symbol::Role::parameter) {
      along.push_back(entity->term);
      continue;
    }
    const SymbolPointer symbol = workshop_.symbol(name, Symbol::Role::parameter, Type::scalar());
    goal.ranges.push_back({symbol, number_term(0), number_term(1)});
    along.push_back(symbol_term(symbol, joint.span));
  }
  for (Statement& s : joint_equations(first, second, joint.order, along, joint.span))
    goal.statements.push_back(std::move(s));
}

}  // namespace patchproof
