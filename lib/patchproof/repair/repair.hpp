#pragma once

#include <functional>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>
#include <patchproof/language/library.hpp>
#include <patchproof/repair/edit.hpp>

namespace patchproof {

/// A changed statement that is true, in all instances of its family.
struct Repair {
  std::vector<Edit> edits;
  /// The statement after the changes, in one line.
  std::string text;
  /// `proved` or `proved_if`.
  Verdict verdict = Verdict::proved;
  Evidence evidence = Evidence::none;
  std::vector<std::string> conditions;
  /// The curve that is taken backwards everywhere, which counts as one change; "" for others.
  std::string reversed;

  /// How many changes a person would count.
  std::size_t size() const { return reversed.empty() ? edits.size() : 1; }
};

/// What became of the search for a false statement.
struct Repairs {
  enum class Outcome {
    found,      ///< all repairs of the least size are listed
    none,       ///< there is none of the size allowed
    stopped,    ///< the limit was reached before one was found
    not_tried,  ///< this kind of statement is not repaired
    internal,   ///< a fault of this program
  };
  /// "coons.bilinear.formula", without instance; for an erratum the claim that is printed.
  std::string id;
  /// The statement as written.
  Span statement;
  /// The same in one line.
  std::string printed;
  /// How many claims it stands for.
  std::size_t instances = 1;
  Outcome outcome = Outcome::none;
  /// Why there are none.
  std::string reason;
  /// All with equally many changes; those that hold without conditions first.
  std::vector<Repair> repairs;
  /// False when the limit was reached: there may be more repairs of this size.
  bool complete = true;
  /// How many changed statements were looked at.
  std::size_t tried = 0;
};

struct RepairOptions {
  Engines engines = Engines::both;
  /// How many changes are tried together. Entries of a literal matrix that can be computed may be
  /// more.
  std::size_t most_changes = 2;
  /// How many changed statements are looked at, for one false statement.
  std::size_t most_candidates = 20'000;
  /// Claims for which this is false are left alone. Empty: none.
  std::function<bool(const Case&, const Claim&)> wanted;
};

/// Looks for repairs of every false equation of a case: the smallest changes of what is written
/// that make it true. Every repair has been decided like any other claim.
///
/// `written` is the text of `given`, and the library what its definitions are from.
std::vector<Repairs> repairs_of(const syntax::Case& written, const Case& given,
                                const Library& library, const RepairOptions& options);

}  // namespace patchproof
