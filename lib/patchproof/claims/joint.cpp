#include <patchproof/claims/joint.hpp>

namespace patchproof {

Term edge_derivative(const JointEdge& edge, int across, int beside, bool reversed,
                     const std::vector<Term>& along, const Span& span) {
  const Type& type = edge.function.type();
  Term function = edge.function;
  if (across > 0 || beside > 0) {
    Indices orders(type.parameters.size(), beside);
    orders[edge.crossing] = across;
    function = make_term(Operation::derivative, type, {function}, orders, span);
  }
  std::vector<Term> children{function};
  auto next = along.begin();
  for (std::size_t k = 0; k < type.parameters.size(); ++k)
    children.push_back(k == edge.crossing ? edge.value : *next++);
  const Term value = make_term(Operation::apply, *type.inner, std::move(children), {}, span);
  const bool negative = reversed && across % 2 == 1;
  return negative ? make_term(Operation::negation, value.type(), {value}, {}, span) : value;
}

std::vector<Statement> joint_equations(const JointEdge& first, const JointEdge& second, int order,
                                       const std::vector<Term>& along, const Span& span) {
  std::vector<Statement> result;
  for (int k = 0; k <= order; ++k)
    result.push_back({edge_derivative(first, k, 0, !first.at_end, along, span), Relation::equal,
                      edge_derivative(second, k, 0, second.at_end, along, span), span});
  return result;
}

}  // namespace patchproof
