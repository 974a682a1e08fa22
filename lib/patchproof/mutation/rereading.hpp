#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>
#include <patchproof/language/reader.hpp>
#include <patchproof/language/syntax.hpp>
#include <patchproof/repair/edit.hpp>

namespace patchproof {

/// What becomes of a changed case.
enum class Fate {
  noticed,      ///< a claim has another verdict than its author expects, or has none
  meaningless,  ///< the changed text has mistakes, so it is no error that could stay
  survives,     ///< all claims have the verdicts their author expects
  undecided,    ///< a claim was not decided within the limits, and none is noticed to be wrong
  internal,     ///< a fault of this program
};

/// One case of a file, to be read and decided again with changes of its text.
class Rereading {
 public:
  /// All other cases of the file are taken away; definitions and includes stay.
  Rereading(const syntax::File& file, const syntax::Case& kept, const Limits& limits,
            const Loader& load);

  /// The case with these changes, which do not overlap; empty when the text then has mistakes.
  std::optional<Case> read(std::vector<Edit> edits) const;

  /// A word that is nowhere in the file.
  const std::string& fresh_word() const { return fresh_; }

 private:
  std::shared_ptr<const SourceText> source_;
  Limits limits_;
  Loader load_;
  std::string fresh_;
};

/// Which claims are looked at.
using ClaimFilter = std::function<bool(const Claim&)>;

/// The results of these claims, by the kernel, one after the other until `enough` is true of one.
std::vector<ClaimResult> results_of(const Case& read, const ClaimFilter& wanted,
                                    const std::function<bool(const ClaimResult&)>& enough);

/// What becomes of a case when only these claims are looked at.
Fate fate_of(const std::optional<Case>& read, const ClaimFilter& wanted);

/// Label and instance: "south[i=0]".
std::string name_of(const Claim& claim);

}  // namespace patchproof
