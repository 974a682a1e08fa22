#include <patchproof/certificate/rocq_instances.hpp>

#include <patchproof/certificate/sequents.hpp>

namespace patchproof {

namespace {

std::string bracketed(const std::string& text) {
  return text.find(' ') == std::string::npos || text.front() == '(' ? text : "(" + text + ")";
}

}  // namespace

std::string rocq_list(const std::vector<std::string>& parts) {
  std::string result = "[";
  for (std::size_t k = 0; k < parts.size(); ++k) result += (k == 0 ? "" : ";\n      ") + parts[k];
  return result + "]";
}

RocqInstances::RocqInstances(const SequentProof& proof, RocqSequent& sequent, Scalars& scalars,
                             RocqText& text, RocqTwin& twin)
    : sequent_{sequent}, scalars_{scalars}, text_{text}, twin_{twin} {
  for (const ComponentProof& component : proof.components) {
    if (const auto* equation = std::get_if<EquationProof>(&component.why))
      for (const Cofactor& cofactor : equation->cofactors) place_of(cofactor.equation);
    else
      find(std::get<SignProof>(component.why));
  }
  for (const NonZero& item : proof.not_zero)
    if (item.sign) find(*item.sign);
}

void RocqInstances::find(const SignProof& proof) {
  const auto note = [&](const Combination& combination) {
    for (const Cofactor& cofactor : combination.cofactors) place_of(cofactor.equation);
  };
  for (const SignProof::Step& step : proof.steps) note(step.why);
  if (const auto* last = std::get_if<Combination>(&proof.end)) return note(*last);
  for (const SignProof& one : std::get<SignProof::Cut>(proof.end).cases) find(one);
}

// Each hypothesis at each place once.
std::string RocqInstances::name_at(const Instance& instance, const Key& key) {
  const auto [found, is_new] = names_.try_emplace(key);
  if (!is_new) return found->second;
  found->second = "HypAt" + std::to_string(names_.size());
  std::string call = sequent_.hypothesis_name(instance.hypothesis);
  for (const std::string& at : key.second) call += " " + bracketed(at);
  script_ += "  pose proof (" + call + ") as " + found->second + ".\n";
  const Statement& statement = sequent_.sequent().hypotheses[instance.hypothesis].statement;
  for (const SymbolPointer& parameter : parameters_of(statement))
    for (const ParameterRange& range : sequent_.sequent().ranges)
      if (range.parameter->ordinal == parameter->ordinal)
        script_ += "  specialize (" + found->second + " ltac:(in_range)).\n";
  for (std::size_t k = 0; k < sequent_.guards_of(instance.hypothesis).size(); ++k)
    script_ += "  specialize (" + found->second + " ltac:(assumption)).\n";
  return found->second;
}

// An equation for each component that is used.
std::size_t RocqInstances::place_of(const Instance& instance) {
  for (const int order : instance.orders)
    if (order > 0) throw NotScalar{"hypotheses that are differentiated"};
  Key key{instance.hypothesis, {}};
  std::string twins;
  for (const Term& at : instance.at) {
    key.second.push_back(text_.of(scalars_.of(at).front()));
    twins += (twins.empty() ? "" : "; ") + twin_.of(scalars_.of(at).front());
  }
  const std::string name = name_at(instance, key);
  key.second.push_back("component " + std::to_string(instance.component));
  const auto [place, is_new] = places_.try_emplace(key, equations_.size());
  if (!is_new) return place->second;
  const Statement& statement = sequent_.sequent().hypotheses[instance.hypothesis].statement;
  const std::vector<SymbolPointer> parameters = parameters_of(statement);
  const auto [left, right] = sequent_.sides(statement, instance.component);
  const auto at_place = [&](const ScalarPointer& side) {
    if (parameters.empty()) return twin_.of(side);
    return "(App " + twin_.lambda(parameters, side) + " [" + twins + "])";
  };
  std::string pair = "(" + at_place(left) + ",\n       " + at_place(right) + ")";
  equations_.emplace_back(std::move(pair),
                          rocq_part(name, instance.component, component_count(statement)));
  return place->second;
}

// All places are known since the beginning.
std::string RocqInstances::cofactors(const std::vector<Cofactor>& list) {
  std::vector<std::string> result(equations_.size(), "Int 0");
  for (const Cofactor& cofactor : list)
    result[place_of(cofactor.equation)] = twin_.of(scalars_.of(cofactor.factor).front());
  while (!result.empty() && result.back() == "Int 0") result.pop_back();
  return rocq_list(result);
}

}  // namespace patchproof
