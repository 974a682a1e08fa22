#pragma once

#include <string>
#include <vector>

#include <patchproof/mutation/data.hpp>
#include <patchproof/mutation/typical_errors.hpp>

namespace patchproof {

/// An error together with what it would have to be compared with.
struct SiteError {
  TypicalError error;
  /// A statement that says that the changed part is equal to the part as written; it stands behind
  /// the place `comparison_at`. "" where there is none.
  std::string comparison;
  std::size_t comparison_at = 0;
};

/// A part of a text in which an error may be.
struct Site {
  enum class Kind {
    claim,        ///< the statement of a claim
    declaration,  ///< what a name of the case is defined as
    data,         ///< a declaration that holds numbers only
    definition,   ///< a definition of the file
  };
  Kind kind = Kind::claim;
  /// The label of the claim, as in "south" or "south.corrected"; the name declared.
  std::string name;
  /// What is written there.
  Span span;
  /// All errors that are looked for.
  std::vector<SiteError> errors;
};

/// The parts of a case, in the order of the text: true equations, declarations, data. The label of
/// the comparisons is the fresh word.
std::vector<Site> sites_of(const syntax::Case& written, const std::string& fresh);

/// The part of a definition: its value, and the names it gives.
Site site_of(const syntax::Definition& definition);

/// The errors in the order in which they are tried when not all of them are: the kinds take turns,
/// in data the entries.
std::vector<SiteError> in_turns(const std::vector<SiteError>& errors);

}  // namespace patchproof
