#pragma once

#include <memory>
#include <vector>

#include <patchproof/claims/claim.hpp>
#include <patchproof/language/library.hpp>
#include <patchproof/language/scope.hpp>

namespace patchproof {

/// A claim of a case that can be read with other propositions in the place of its own: everything
/// above it is declared, for each instance of the case.
///
/// The case, the claim and the library must outlive the reader. The case is one without mistakes.
class ClaimReader {
 public:
  ClaimReader(const syntax::Case& written, const syntax::Statement& claim, const Library& library);
  ~ClaimReader();
  ClaimReader(const ClaimReader&) = delete;
  ClaimReader& operator=(const ClaimReader&) = delete;

  /// How many instances the case has; 1 without a family.
  std::size_t instances() const;

  /// What the claim would be with this proposition, in one instance of the case: a `for` makes
  /// several claims of it. Empty when the proposition has no meaning there.
  std::vector<Claim> read(std::size_t instance, const syntax::Proposition& proposition);

  /// The claims above this one, of all instances: the derivations it may use are among them.
  std::vector<Claim> above();

  /// The names declared above the claim.
  const Scope& scope(std::size_t instance);

 private:
  struct Place;
  Place& place(std::size_t instance);

  const syntax::Case& written_;
  const syntax::Statement& claim_;
  std::vector<std::unique_ptr<Place>> places_;
};

}  // namespace patchproof
