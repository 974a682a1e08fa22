#include <algorithm>

#include <patchproof/claims/geometric_joint.hpp>
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

JointEdge CaseElaborator::edge_of(const syntax::Edge& edge, const Scope& scope) {
  JointEdge result;
  result.function = elaborator_.name(edge.patch.text, edge.patch.span, scope);
  const Type& type = result.function.type();
  if (!type.is_function())
    throw Fault{edge.patch.span,
                "'" + edge.patch.text + "' is a " + to_text(type) + ", not a curve or patch"};
  const auto& names = type.parameters;
  const auto place = std::find(names.begin(), names.end(), edge.parameter.text);
  if (place == names.end())
    throw Fault{edge.parameter.span,
                "'" + edge.parameter.text + "' is not a parameter of '" + edge.patch.text +
                    "', a " + to_text(type),
                did_you_mean(edge.parameter.text, names)};
  result.crossing = static_cast<std::size_t>(place - names.begin());
  result.value = elaborator_.construct().scalar(scope, elaborator_.expression(*edge.value, scope),
                                                "the place of an edge");
  const auto [lower, upper] = range_of(edge.parameter.text);
  if (!same_end(lower, result.value) && !same_end(upper, result.value))
    throw Fault{edge.value->span,
                "an edge of '" + edge.patch.text + "' lies at an end of the range of '" +
                    edge.parameter.text + "'",
                "'" + edge.parameter.text + "' runs over [" + to_text(lower, 40) + ", " +
                    to_text(upper, 40) + "]"};
  result.at_end = same_end(upper, result.value);
  return result;
}

// The two sides, and terms for the parameters along the edge: those of the case, where it has them.
JointQuestion CaseElaborator::joint_of(const syntax::Joint& joint, const Scope& scope,
                                       const Goal& given) {
  JointQuestion result{
      edge_of(joint.first, scope), edge_of(joint.second, scope), {}, given, joint.span};
  const Type& a = result.first.function.type();
  const Type& b = result.second.function.type();
  if (a.parameters.size() != b.parameters.size())
    throw Fault{joint.span, "a " + to_text(a) + " cannot be joined to a " + to_text(b)};
  if (!(*a.inner == *b.inner))
    throw Fault{joint.span, "the two sides of a joint have values of one type, and these are a " +
                                to_text(*a.inner) + " and a " + to_text(*b.inner)};
  require_equal_ranges(result.first, result.second, joint.span);
  for (std::size_t k = 0; k < a.parameters.size(); ++k) {
    if (k == result.first.crossing) continue;
    const std::string& name = a.parameters[k];
    const Entity* entity = scope.find(name);
    if (entity != nullptr && entity->kind == Entity::Kind::term &&
        entity->term.operation() == Operation::symbol &&
        entity->term.symbol()->role == Symbol::Role::parameter) {
      result.along.push_back(entity->term);
      continue;
    }
    const SymbolPointer symbol = workshop_.symbol(name, Symbol::Role::parameter, Type::scalar());
    result.given.ranges.push_back({symbol, number_term(0), number_term(1)});
    result.along.push_back(symbol_term(symbol, joint.span));
  }
  return result;
}

std::vector<Term> CaseElaborator::connecting_functions(const syntax::Joint& joint,
                                                       const JointQuestion& question,
                                                       const Scope& scope) {
  std::vector<Term> result;
  if (joint.functions.empty()) {
    const auto why = why_not_geometric(question.first);
    if (joint.order > 0 && why)
      throw Fault{
          joint.span, *why,
          "give the functions: 'with alpha, gamma'; or declare the dimension: 'point V[0..3] "
          "in R^3'"};
    return result;
  }
  const bool curve = question.first.function.type().parameters.size() == 1;
  const std::size_t needed = connecting_function_count(question.first, joint.order);
  if (joint.functions.size() != needed)
    throw Fault{joint.functions.front()->span,
                "a G^" + std::to_string(joint.order) + " joint of " +
                    (curve ? "curves" : "patches") + " has " + std::to_string(needed) +
                    (needed == 1 ? " connecting function, not " : " connecting functions, not ") +
                    std::to_string(joint.functions.size()),
                joint.order == 0 ? "leave 'with' out"
                : curve          ? "alpha of order 1, then beta of order 2"
                                 : "alpha, gamma of order 1, then beta, delta of order 2"};
  for (const syntax::ExpressionPointer& e : joint.functions) {
    Term function = elaborator_.expression(*e, scope);
    const bool applies =
        function.type().is_function() && function.type().parameters.size() == question.along.size();
    if (applies) function = elaborator_.construct().apply(function, question.along, e->span);
    result.push_back(elaborator_.construct().scalar(scope, function, "a connecting function"));
  }
  return result;
}

void CaseElaborator::add_joint(const syntax::Joint& joint, const Scope& scope, Goal& goal) {
  constexpr int highest = 20;
  if (!joint.geometric && joint.order > highest)
    throw Fault{joint.span, "the order of a joint is at most 20"};
  if (joint.geometric && joint.order > highest_geometric_order)
    throw Fault{joint.span, "the order of a G^k joint is at most 2",
                "higher orders can be written out as equations"};
  const JointQuestion question = joint_of(joint, scope, goal);
  if (joint.geometric && question.first.function.type().parameters.size() > 2)
    throw Fault{joint.span, "a G^k joint is one of curves or patches, not of volumes",
                "'C^k joint' goes with volumes too"};
  joined_.emplace_back(joint.first.patch.text, joint.second.patch.text);
  goal.ranges = question.given.ranges;
  const std::vector<Statement> statements =
      joint.geometric
          ? geometric_joint(question.first, question.second, joint.order, question.along,
                            connecting_functions(joint, question, scope), joint.span)
          : joint_equations(question.first, question.second, joint.order, question.along,
                            joint.span);
  goal.statements.insert(goal.statements.end(), statements.begin(), statements.end());
}

void CaseElaborator::show(const syntax::Statement& statement, Case& result) {
  Shown shown{statement.span, instance_, {}, std::nullopt};
  if (statement.shown_joint) {
    Goal given;
    given.ranges = ranges_;
    given.assumptions = assumptions_;
    shown.joint = joint_of(*statement.shown_joint, scope_, given);
  } else {
    shown.term = elaborator_.expression(*statement.shown, scope_);
  }
  result.shown.push_back(std::move(shown));
}

}  // namespace patchproof
