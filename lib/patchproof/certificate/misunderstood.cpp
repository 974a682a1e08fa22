#include <patchproof/certificate/misunderstood.hpp>

#include <algorithm>
#include <map>

#include <patchproof/certificate/asked_proposition.hpp>
#include <patchproof/certificate/proposition_difference.hpp>
#include <patchproof/certificate/rocq_file.hpp>
#include <patchproof/certificate/rocq_meaning.hpp>
#include <patchproof/certificate/rocq_printed.hpp>
#include <patchproof/certificate/rocq_tokens.hpp>

namespace patchproof {

namespace {

std::vector<const Sequent*> sequents_in(const Certificate& certificate) {
  if (const auto* refutation = std::get_if<Refutation>(&certificate.content))
    return {&refutation->sequent};
  std::vector<const Sequent*> result;
  for (const SequentProof& proof : std::get<std::vector<SequentProof>>(certificate.content))
    result.push_back(&proof.sequent);
  return result;
}

// The names of the outermost binders, and of those behind premises; "_" where there is none.
std::vector<std::string> names_in(const RocqTermPointer& statement) {
  std::vector<std::string> result;
  for (const RocqTerm* at = statement.get();; at = at->parts.back().get()) {
    if (at->kind == RocqTerm::Kind::forall)
      for (const RocqBinder& binder : at->binders) result.push_back(binder.name);
    else if (at->kind == RocqTerm::Kind::implication)
      result.insert(result.end(),
                    static_cast<std::size_t>(std::count_if(
                        at->parts.begin(), at->parts.end(),
                        [](const RocqTermPointer& part) { return is_type(*part); })),
                    "_");
    else
      return result;
  }
}

class Comparison {
 public:
  Comparison(const RocqFile& file, const std::string& output) {
    std::vector<std::string> definitions = file.definitions;
    std::vector<std::string> theorems;
    for (const RocqTheorem& theorem : file.theorems) {
      definitions.insert(definitions.end(), theorem.statements.begin(), theorem.statements.end());
      theorems.insert(theorems.end(), theorem.theorems.begin(), theorem.theorems.end());
    }
    for (RocqPrinted& printed : rocq_printed(output, definitions, theorems))
      printed_.emplace(printed.name, std::move(printed));
    for (const std::string& name : file.definitions)
      meaning_.define(name, printed_.at(name).term, printed_.at(name).problem);
  }

  /// What is wrong with a claim; "" when nothing is. All have to be looked at, in their order.
  std::string difference(const Certificate& certificate, const RocqTheorem& theorem) {
    const bool refuted = std::holds_alternative<Refutation>(certificate.content);
    const std::vector<const Sequent*> sequents = sequents_in(certificate);
    std::string result;
    for (std::size_t k = 0; k < sequents.size(); ++k) {
      std::size_t asked = 0;
      try {
        asked = asked_proposition(*sequents[k], scalars_, names_, table_);
      } catch (const NotScalar& reason) {
        if (result.empty() && k < theorem.theorems.size()) result = reason.what();
        continue;
      }
      if (!result.empty() || k >= theorem.theorems.size()) continue;
      result = of_theorem(theorem.theorems[k], theorem.statements[k], refuted);
      if (result.empty()) result = of_statement(theorem.statements[k], asked);
    }
    return result;
  }

 private:
  // It has to be the statement itself, or its negation.
  std::string of_theorem(const std::string& name, const std::string& statement, bool refuted) const {
    const RocqPrinted& printed = printed_.at(name);
    if (!printed.term) return printed.problem;
    const RocqTerm* term = printed.term.get();
    const bool negation = term->kind == RocqTerm::Kind::negation;
    if (negation) term = term->parts[0].get();
    if (negation == refuted && term->kind == RocqTerm::Kind::name && term->name == statement)
      return "";
    return name + " shows something else than " + (refuted ? "~ " : "") + statement;
  }

  std::string of_statement(const std::string& name, std::size_t asked) {
    const RocqPrinted& printed = printed_.at(name);
    if (!printed.term) return printed.problem;
    if (printed.type != "Prop") return name + " is no proposition";
    try {
      return proposition_difference(table_, meaning_.of_proposition(printed.term), asked,
                                    names_in(printed.term));
    } catch (const RocqUnreadable& error) {
      return name + " cannot be compared: " + error.what();
    }
  }

  PropositionTable table_;
  RocqMeaning meaning_{table_};
  /// Without names: everything is to be unfolded.
  Scalars scalars_{{}};
  RocqNames names_;
  std::map<std::string, RocqPrinted> printed_;
};

}  // namespace

std::vector<Misunderstanding> misunderstood(const Case& given,
                                            const std::vector<Certificate>& certificates,
                                            const std::string& printed) {
  const RocqFile file = rocq_file(given, certificates);
  Comparison comparison{file, printed};
  std::vector<Misunderstanding> result;
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    const std::string what = comparison.difference(certificates[k], file.theorems[k]);
    if (!what.empty()) result.push_back({certificates[k].claim, what});
  }
  return result;
}

}  // namespace patchproof
