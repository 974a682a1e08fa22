#include <recheck/proof_reader.hpp>

namespace recheck {

namespace {

// Indices that say where in a sequent something belongs are judged with the proof: they are only
// kept from being absurd here.
class ProofReader {
 public:
  ProofReader(const Certificate& certificate, const Limits& limits)
      : certificate_{certificate}, limits_{limits} {}

  Proof proof(const Place& place) const {
    place.require_members({"sequent", "components", "not_zero", "divisors"});
    Proof result;
    result.sequent = sequent_of(place["sequent"], certificate_);
    for (const Place& entry : place["components"].items())
      result.components.push_back(component(entry));
    for (const Place& entry : place["not_zero"].items()) result.not_zero.push_back(not_zero(entry));
    for (const Place& entry : place["divisors"].items()) result.divisors.push_back(divisor(entry));
    return result;
  }

  Refutation refutation(const Place& place) const {
    place.require_members({"sequent", "values", "conclusion", "component"});
    Refutation result;
    result.sequent = sequent_of(place["sequent"], certificate_);
    for (const Place& entry : place["values"].items()) value(entry, result.values);
    result.conclusion = index(place["conclusion"]);
    result.component = index(place["component"]);
    return result;
  }

 private:
  std::size_t index(const Place& place) const { return place.whole(limits_.nodes); }
  NodeIndex scalar(const Place& place) const { return scalar_at(place, certificate_); }

  ComponentProof component(const Place& place) const {
    place.require_members({"conclusion", "component", "?equation", "?sign", "?negative"});
    ComponentProof result;
    result.conclusion = index(place["conclusion"]);
    result.component = index(place["component"]);
    if (place.has("equation") == place.has("sign"))
      place.fail("a component is shown either by an 'equation' or by a 'sign'");
    if (place.has("equation")) result.equation = cofactors(place["equation"]);
    if (place.has("sign")) result.sign = sign(place["sign"], 0);
    result.negative = place.has("negative") && place["negative"].truth();
    return result;
  }

  NonZero not_zero(const Place& place) const {
    place.require_members({"scalar", "?hypothesis", "?sign", "?negative"});
    NonZero result;
    result.scalar = scalar(place["scalar"]);
    if (place.has("hypothesis") == place.has("sign"))
      place.fail("a scalar is not zero either by a 'hypothesis' or by a 'sign'");
    if (place.has("hypothesis")) result.hypothesis = index(place["hypothesis"]);
    if (place.has("sign")) result.sign = sign(place["sign"], 0);
    result.negative = place.has("negative") && place["negative"].truth();
    return result;
  }

  Divisor divisor(const Place& place) const {
    place.require_members({"factor", "product"});
    Divisor result{scalar(place["factor"]), {}};
    for (const Place& entry : place["product"].items()) result.product.push_back(index(entry));
    return result;
  }

  std::vector<Cofactor> cofactors(const Place& place) const {
    std::vector<Cofactor> result;
    for (const Place& entry : place.items()) {
      entry.require_members({"hypothesis", "component", "at", "factor"});
      Cofactor cofactor;
      cofactor.hypothesis = index(entry["hypothesis"]);
      cofactor.component = index(entry["component"]);
      cofactor.factor = scalar(entry["factor"]);
      std::set<SymbolIndex> parameters;
      for (const Place& at : entry["at"].items()) {
        cofactor.at.push_back(value_at(at));
        if (!parameters.insert(cofactor.at.back().parameter).second)
          at["parameter"].fail("this parameter has a value already");
      }
      result.push_back(std::move(cofactor));
    }
    return result;
  }

  Cofactor::At value_at(const Place& place) const {
    place.require_members({"parameter", "value", "?order"});
    Cofactor::At result;
    result.parameter = place["parameter"].whole(certificate_.symbols.size());
    if (certificate_.symbols[result.parameter].role != Symbol::Role::parameter)
      place["parameter"].fail("this is no parameter");
    result.value = scalar(place["value"]);
    if (place.has("order")) result.order = place["order"].whole(limits_.order);
    return result;
  }

  Combination combination(const Place& place) const {
    place.require_members({"summands", "cofactors"});
    Combination result;
    for (const Place& entry : place["summands"].items()) {
      entry.require_members({"coefficient", "squares", "facts"});
      Combination::Summand summand;
      summand.coefficient = entry["coefficient"].number();
      if (summand.coefficient <= 0) entry["coefficient"].fail("a positive number is needed here");
      for (const Place& square : entry["squares"].items())
        summand.squares.push_back(scalar(square));
      for (const Place& fact : entry["facts"].items()) {
        fact.require_members({"fact", "exponent"});
        summand.facts.emplace_back(index(fact["fact"]), fact["exponent"].whole(limits_.exponent));
        if (summand.facts.back().second == 0) fact["exponent"].fail("0 is no exponent here");
      }
      result.summands.push_back(std::move(summand));
    }
    result.cofactors = cofactors(place["cofactors"]);
    return result;
  }

  SignProof sign(const Place& place, std::size_t depth) const {
    if (depth > limits_.depth) place.fail("there are too many cases within cases");
    place.require_members({"steps", "?end", "?cut"});
    SignProof result;
    for (const Place& entry : place["steps"].items()) {
      entry.require_members({"fact", "strict", "why"});
      result.steps.push_back(
          {scalar(entry["fact"]), entry["strict"].truth(), combination(entry["why"])});
    }
    if (place.has("end") == place.has("cut"))
      place.fail("a sign is shown either by its 'end' or by a 'cut'");
    if (place.has("end")) {
      result.end = combination(place["end"]);
      return result;
    }
    const Place cut = place["cut"];
    cut.require_members({"at", "cases"});
    result.cut = scalar(cut["at"]);
    for (const Place& entry : cut["cases"].items()) result.cases.push_back(sign(entry, depth + 1));
    if (result.cases.size() != 2) cut["cases"].fail("a cut has two cases");
    return result;
  }

  void value(const Place& place, std::map<SymbolIndex, NodeIndex>& values) const {
    place.require_members({"symbol", "value"});
    const SymbolIndex symbol = place["symbol"].whole(certificate_.symbols.size());
    const NodeIndex node = place["value"].whole(certificate_.nodes.size());
    if (!(certificate_.nodes[node].type == certificate_.symbols[symbol].type))
      place.fail("the value of '" + certificate_.symbols[symbol].name + "' has another type");
    if (!certificate_.free_symbols[node].empty() || certificate_.nodes[node].has_any_coordinate)
      place["value"].fail("a value without symbols is needed here");
    if (!values.emplace(symbol, node).second)
      place["symbol"].fail("this symbol has a value already");
  }

  const Certificate& certificate_;
  const Limits& limits_;
};

}  // namespace

Proof proof_of(const Place& place, const Certificate& certificate, const Limits& limits) {
  return ProofReader{certificate, limits}.proof(place);
}

Refutation refutation_of(const Place& place, const Certificate& certificate, const Limits& limits) {
  return ProofReader{certificate, limits}.refutation(place);
}

}  // namespace recheck
