#include <patchproof/certificate/rocq_file.hpp>

#include <patchproof/certificate/rocq_layout.hpp>
#include <patchproof/certificate/rocq_proof.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

// A comment must not be closed by what is quoted in it.
std::string comment(std::string text) {
  for (std::size_t at = text.find("*)"); at != std::string::npos; at = text.find("*)", at))
    text.replace(at, 2, "* )");
  for (std::size_t at = text.find("(*"); at != std::string::npos; at = text.find("(*", at))
    text.replace(at, 2, "( *");
  // A quotation mark opens a string inside comments too.
  for (char& c : text)
    if (c == '"') c = '\'';
  return "(* " + text + " *)\n";
}

class FileWriter {
 public:
  explicit FileWriter(const Case& given) : given_{given}, scalars_{named(given)}, text_{names_} {}

  RocqFile written(const std::vector<Certificate>& certificates) {
    RocqFile result;
    std::string theorems;
    for (const Certificate& certificate : certificates) {
      RocqTheorem theorem{certificate.claim, {}, {}, ""};
      try {
        theorems += written(certificate, theorem);
      } catch (const NotScalar& reason) {
        theorem.theorems.clear();
        theorem.statements.clear();
        theorem.why_not = reason.what();
      }
      result.theorems.push_back(std::move(theorem));
    }
    result.text =
        comment("case " + given_.name + (given_.title.empty() ? "" : ": " + given_.title));
    for (const Source& source : given_.sources)
      result.text +=
          comment("source: " + source.work + (source.section.empty() ? "" : ", " + source.section) +
                  (source.page.empty() ? "" : ", p. " + source.page));
    result.text += comment("written by patchproof " + std::string{version});
    for (const RocqDefinition& definition : text_.definitions()) {
      result.definitions.push_back(definition.name);
      result.body += definition.text + "\n\n";
    }
    result.body += theorems + understood(result) + together(result.theorems);
    result.text += rocq_head + result.body;
    if (!theorems.empty())
      result.text += std::string{"Print Assumptions "} + rocq_theorems_together + ".\n";
    return result;
  }

 private:
  // Shows what Rocq has made of the text. Nothing may be left out for its depth.
  static std::string understood(const RocqFile& file) {
    std::string prints;
    std::string checks;
    for (const RocqTheorem& theorem : file.theorems)
      for (std::size_t k = 0; k < theorem.theorems.size(); ++k) {
        prints += "Print " + theorem.statements[k] + ".\n";
        checks += "Check " + theorem.theorems[k] + ".\n";
      }
    if (prints.empty()) return "";
    std::string definitions;
    for (const std::string& name : file.definitions) definitions += "Print " + name + ".\n";
    return comment("what Rocq has understood") +
           "Set Printing Depth 100000.\nSet Printing Width 200.\n" + definitions + prints + checks +
           "\n";
  }

  // Their assumptions are asked for at once: each time it takes as long as many proofs.
  static std::string together(const std::vector<RocqTheorem>& theorems) {
    std::string all;
    for (const RocqTheorem& theorem : theorems)
      for (const std::string& name : theorem.theorems) all += (all.empty() ? "" : ",\n  ") + name;
    if (all.empty()) return "";
    return std::string{"Definition "} + rocq_theorems_together + " :=\n  (" + all + ").\n";
  }

  static std::vector<std::pair<std::string, Term>> named(const Case& given) {
    std::vector<std::pair<std::string, Term>> result;
    for (const Declaration& declaration : given.declarations) {
      const Operation operation = declaration.term.operation();
      if (declaration.given || operation == Operation::symbol || operation == Operation::number)
        continue;
      result.emplace_back(declaration.name, declaration.term);
    }
    return result;
  }

  std::string written(const Certificate& certificate, RocqTheorem& theorem) {
    const std::string label = certificate.claim.substr(given_.name.size() + 1);
    std::string result = comment(certificate.claim + ": " + certificate.statement);
    if (const auto* refutation = std::get_if<Refutation>(&certificate.content)) {
      RocqSequent sequent{refutation->sequent, scalars_, names_, text_};
      const std::string proof = rocq_refutation(*refutation, sequent, scalars_, names_, text_);
      return result + theorem_text(label, "", sequent, "~ ", proof, theorem);
    }
    const auto& proofs = std::get<std::vector<SequentProof>>(certificate.content);
    for (std::size_t k = 0; k < proofs.size(); ++k) {
      RocqSequent sequent{proofs[k].sequent, scalars_, names_, text_};
      const std::string proof = rocq_proof(proofs[k], sequent, scalars_, names_, text_);
      const std::string suffix = proofs.size() == 1 ? "" : k == 0 ? "_unique" : "_solution";
      result += theorem_text(label, suffix, sequent, "", proof, theorem);
    }
    return result;
  }

  // coqc takes seconds for each further part of such a size.
  static constexpr std::size_t longest_proof = 400'000;

  std::string theorem_text(const std::string& label, const std::string& suffix,
                           const RocqSequent& sequent, const std::string& sign,
                           const std::string& proof, RocqTheorem& theorem) {
    if (proof.size() > longest_proof) throw NotScalar{"a proof that is too long when written out"};
    const std::string claim = names_.fresh("claim_" + label + suffix);
    const std::string name = names_.fresh("certified_" + label + suffix);
    theorem.theorems.push_back(name);
    theorem.statements.push_back(claim);
    const std::string statement = with_short_lines("Definition " + claim + " : Prop :=\n" +
                                                   sequent.statement().text() + ".\n");
    return statement + "Theorem " + name + " : " + sign + claim + ".\nProof.\n" + proof +
           "\nQed.\n\n";
  }

  const Case& given_;
  Scalars scalars_;
  RocqNames names_;
  RocqText text_;
};

}  // namespace

RocqFile rocq_file(const Case& given, const std::vector<Certificate>& certificates) {
  return FileWriter{given}.written(certificates);
}

}  // namespace patchproof
