#include <patchproof/certificate/rocq_log.hpp>

namespace patchproof {

namespace {

std::string rational(const Rational& q) {
  return "(" + numerator(q).str() + " # " +
         denominator(q).str() + ")";
}

std::string combination(const Combination& combination, Scalars& scalars, RocqTwin& twin,
                        RocqInstances& instances) {
  std::vector<std::string> summands;
  for (const Summand& summand : combination.summands) {
    std::vector<std::string> squares;
    for (const Term& square : summand.squares)
      squares.push_back(twin.of(scalars.of(square).front()));
    std::vector<std::string> facts;
    for (const auto& [fact, exponent] : summand.facts)
      facts.push_back("Factor " + std::to_string(fact) + " " + std::to_string(exponent));
    summands.push_back("Summand " + rational(summand.coefficient) + " " + rocq_list(squares) + " " +
                       rocq_list(facts));
  }
  return "(Sum " + rocq_list(summands) + " " + instances.cofactors(combination.cofactors) + ")";
}

}  // namespace

std::string rocq_log(const SignProof& proof, Scalars& scalars, RocqTwin& twin,
                     RocqInstances& instances) {
  std::string result;
  std::string brackets;
  for (const SignProof::Step& step : proof.steps) {
    result += "(Step " + twin.of(scalars.of(step.fact).front()) + " " +
              (step.strict ? "true " : "false ") +
              combination(step.why, scalars, twin, instances) + "\n      ";
    brackets += ")";
  }
  if (const auto* last = std::get_if<Combination>(&proof.end)) {
    result += "(Done " + combination(*last, scalars, twin, instances) + ")";
  } else {
    const auto& cut = std::get<SignProof::Cut>(proof.end);
    result += "(Split " + twin.of(scalars.of(cut.at).front());
    for (const SignProof& one : cut.cases)
      result += "\n      " + rocq_log(one, scalars, twin, instances);
    result += ")";
  }
  return result + brackets;
}

}  // namespace patchproof
