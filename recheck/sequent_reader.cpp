#include <recheck/proof_reader.hpp>

namespace recheck {

NodeIndex term_at(const Place& place, const Certificate& certificate) {
  const NodeIndex node = place.whole(certificate.nodes.size());
  if (certificate.nodes[node].type.is_function()) place.fail("a value is needed here");
  for (const SymbolIndex symbol : certificate.free_symbols[node])
    if (certificate.symbols[symbol].role == Symbol::Role::bound)
      place.fail("the bound symbol '" + certificate.symbols[symbol].name +
                 "' stands outside of its function");
  return node;
}

NodeIndex scalar_at(const Place& place, const Certificate& certificate) {
  const NodeIndex node = term_at(place, certificate);
  if (!certificate.nodes[node].type.is_scalar()) place.fail("a scalar is needed here");
  return node;
}

namespace {

// Proofs may speak of whichever coordinate they are about. In a statement it would not be clear
// whether one coordinate is meant or all.
NodeIndex side_at(const Place& place, const Certificate& certificate) {
  const NodeIndex node = term_at(place, certificate);
  if (certificate.nodes[node].has_any_coordinate)
    place.fail("a coordinate of a point of any dimension stands in a statement");
  return node;
}

Statement statement_of(const Place& place, const Certificate& certificate) {
  Statement result;
  result.left = side_at(place["left"], certificate);
  result.right = side_at(place["right"], certificate);
  result.relation =
      static_cast<Relation>(place["relation"].one_of({"==", "!=", "<", "<=", ">", ">="}));
  const Type& type = certificate.nodes[result.left].type;
  if (!(type == certificate.nodes[result.right].type)) place.fail("sides of different types");
  const bool order = result.relation != Relation::equal && result.relation != Relation::not_equal;
  if (order && !type.is_scalar()) place.fail("only scalars are in an order");
  return result;
}

Range range_of(const Place& place, const Certificate& certificate) {
  place.require_members({"parameter", "lower", "upper"});
  Range result;
  result.parameter = place["parameter"].whole(certificate.symbols.size());
  if (certificate.symbols[result.parameter].role != Symbol::Role::parameter)
    place["parameter"].fail("this is no parameter");
  result.lower = side_at(place["lower"], certificate);
  result.upper = side_at(place["upper"], certificate);
  for (const NodeIndex end : {result.lower, result.upper})
    if (!certificate.nodes[end].type.is_scalar()) place.fail("the ends of a range are scalars");
  return result;
}

}  // namespace

Sequent sequent_of(const Place& place, const Certificate& certificate) {
  place.require_members({"hypotheses", "ranges", "conclusions"});
  Sequent result;
  for (const Place& hypothesis : place["hypotheses"].items()) {
    hypothesis.require_members({"label", "left", "relation", "right"});
    hypothesis["label"].text();
    result.hypotheses.push_back(statement_of(hypothesis, certificate));
  }
  std::set<SymbolIndex> parameters;
  for (const Place& range : place["ranges"].items()) {
    result.ranges.push_back(range_of(range, certificate));
    if (!parameters.insert(result.ranges.back().parameter).second)
      range["parameter"].fail("this parameter has a range already");
  }
  for (const Place& conclusion : place["conclusions"].items()) {
    conclusion.require_members({"left", "relation", "right"});
    result.conclusions.push_back(statement_of(conclusion, certificate));
  }
  if (result.conclusions.empty()) place["conclusions"].fail("there is no conclusion");
  return result;
}

}  // namespace recheck
