#include <patchproof/language/claim_reader.hpp>

#include <patchproof/language/case_elaborator.hpp>

namespace patchproof {

/// One instance of the case, read down to the claim.
struct ClaimReader::Place {
  Place(const Library& library, const CaseInstance& of)
      : instance{of}, elaborator{library, of.text, diagnostics} {}

  CaseInstance instance;
  std::vector<Diagnostic> diagnostics;
  CaseElaborator elaborator;
  Case above;
  bool read = false;
};

ClaimReader::ClaimReader(const syntax::Case& written, const syntax::Statement& claim,
                         const Library& library)
    : written_{written}, claim_{claim} {
  for (const CaseInstance& instance : instances_of(written, library))
    places_.push_back(std::make_unique<Place>(library, instance));
}

ClaimReader::~ClaimReader() = default;

std::size_t ClaimReader::instances() const { return places_.size(); }

ClaimReader::Place& ClaimReader::place(std::size_t instance) {
  Place& result = *places_.at(instance);
  if (result.read) return result;
  result.read = true;
  for (const auto& [name, value] : result.instance.values)
    result.elaborator.declare_number(name.text, value, name.span);
  for (const syntax::Statement& statement : written_.statements) {
    if (statement.span.begin == claim_.span.begin) break;
    if (has_meaning(statement.kind)) result.elaborator.statement(statement, result.above);
  }
  return result;
}

std::vector<Claim> ClaimReader::read(std::size_t instance, const syntax::Proposition& proposition) {
  Place& at = place(instance);
  syntax::Statement statement = claim_;
  statement.kind = syntax::Statement::Kind::prove;
  statement.proposition = proposition;
  Case result;
  at.diagnostics.clear();
  at.elaborator.statement(statement, result);
  if (!at.diagnostics.empty()) return {};
  return std::move(result.claims);
}

std::vector<Claim> ClaimReader::above() {
  std::vector<Claim> result;
  for (std::size_t k = 0; k < instances(); ++k) {
    const std::vector<Claim>& claims = place(k).above.claims;
    result.insert(result.end(), claims.begin(), claims.end());
  }
  return result;
}

const Scope& ClaimReader::scope(std::size_t instance) { return place(instance).elaborator.scope(); }

}  // namespace patchproof
