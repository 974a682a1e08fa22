#include <patchproof/certificate/sympy_script.hpp>

#include <patchproof/certificate/python_lines.hpp>
#include <patchproof/certificate/sympy_helpers.hpp>
#include <patchproof/certificate/sympy_proof.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

class ScriptWriter {
 public:
  explicit ScriptWriter(const Case& given) : given_{given}, scalars_{named(given)}, text_{names_} {}

  std::string written(const std::vector<Certificate>& certificates) {
    std::string checks;
    std::string table;
    for (const Certificate& certificate : certificates) {
      const std::string label = certificate.claim.substr(given_.name.size() + 1);
      const std::string said = python_comment(certificate.claim + ":", "") +
                               python_comment(certificate.statement, "");
      try {
        const std::string check = body(certificate);
        const std::string name = names_.fresh("claim_" + label);
        checks += "\n\n" + said + "def " + name + "():\n" + python_lines(check);
        table += "    \"" + label + "\": " + name + ",\n";
      } catch (const NotScalar& reason) {
        checks += "\n\n" + said + python_comment("not written: " + std::string{reason.what()}, "");
      }
    }
    return head() + symbols() + checks + "\n\nCLAIMS = {\n" + table + "}\n" + tail;
  }

 private:
  static constexpr const char* tail = R"py(
failed = 0
open_claims = 0
for label, claim in CLAIMS.items():
    unsettled.clear()
    if all(list(claim())):
        print(label + ": holds")
    elif unsettled:
        print(label + ": not settled by SymPy")
        open_claims += 1
    else:
        print(label + ": FAILS")
        failed += 1
sys.exit(1 if failed else 2 if open_claims else 0)
)py";

  std::string head() const {
    std::string result = "#!/usr/bin/env python3\n";
    result += python_comment("case " + given_.name + (given_.title.empty() ? "" : ": " + given_.title), "");
    for (const Source& source : given_.sources)
      result += python_comment("source: " + source.work +
                                   (source.section.empty() ? "" : ", " + source.section) +
                                   (source.page.empty() ? "" : ", p. " + source.page),
                               "");
    result += python_comment("written by patchproof " + std::string{version}, "");
    return result + std::string{sympy_helpers()};
  }

  std::string symbols() const {
    std::string result;
    const std::string declarations = names_.declarations();
    if (!declarations.empty()) result += "\n\n# The symbols of the case.\n" + declarations;
    if (!text_.definitions().empty()) result += "\n\n# What the case has a name for.\n";
    bool first = true;
    for (const std::string& definition : text_.definitions()) {
      result += (first ? "" : "\n") + python_lines(definition);
      first = false;
    }
    return result;
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

  std::string body(const Certificate& certificate) {
    if (const auto* refutation = std::get_if<Refutation>(&certificate.content))
      return python_comment("It is false:", "    ") + sympy_refutation(*refutation, scalars_, text_);
    std::string result;
    const auto& proofs = std::get<std::vector<SequentProof>>(certificate.content);
    for (std::size_t k = 0; k < proofs.size(); ++k) {
      if (proofs.size() > 1)
        result += python_comment(k == 0 ? "The equations give the values:"
                                        : "The values satisfy the equations:",
                                 "    ");
      result += sympy_proof(proofs[k], scalars_, text_);
    }
    // Nothing to be shown is shown.
    return result.find("yield ") == std::string::npos ? result + "    yield True\n" : result;
  }

  const Case& given_;
  Scalars scalars_;
  PythonNames names_;
  PythonText text_;
};

}  // namespace

std::string sympy_script(const Case& given, const std::vector<Certificate>& certificates) {
  return ScriptWriter{given}.written(certificates);
}

}  // namespace patchproof
