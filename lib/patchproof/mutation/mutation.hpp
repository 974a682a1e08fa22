#pragma once

#include <functional>
#include <string>
#include <vector>

#include <patchproof/mutation/rereading.hpp>
#include <patchproof/mutation/site.hpp>

namespace patchproof {

/// One error put into the text, and what became of it.
struct Mutant {
  /// Why nobody notices it.
  enum class Why {
    none,         ///< it is noticed, or not decided
    same,         ///< the changed part is equal to the part as written, whatever the data are
    assumed,      ///< the same, under the assumptions of the case
    data,         ///< both are equal for the numbers of the case only
    independent,  ///< the claims do not depend on it
    untold,       ///< none of this could be shown
  };
  SiteError change;
  /// What is changed.
  Span place;
  Fate fate = Fate::survives;
  Why why = Why::none;
  /// The names of the data that hide it.
  std::vector<std::string> data;
  /// Values of parameters for which the changed declaration differs, as in "u = 1, v = 0"; "" where
  /// none are known.
  std::string differs_at;
};

/// All errors put into one part.
struct SiteMutants {
  Site::Kind kind = Site::Kind::claim;
  std::string name;
  Span span;
  /// How many were not tried, because there are more than are allowed.
  std::size_t left_out = 0;
  std::vector<Mutant> mutants;
  /// Of data that no claim notices: the same for symbols, where all claims hold for these as well,
  /// as in "point V[0..3, 0..3] in R^3".
  std::string for_symbols;
};

/// Other data for a case.
struct BetterData {
  /// "point V[0..3, 0..3] in R^3" or "V[1,1] = (1, 1, 1) in place of (1, 1, 0)".
  std::string words;
  /// Whether numbers give way to symbols.
  bool for_symbols = false;
  /// How many of the errors that the data hide are noticed then; of several changes one after the
  /// other, with those before.
  std::size_t noticed = 0;
  /// Claims that are false then, because they speak of other numbers.
  std::vector<std::string> other_values;
};

/// What the errors in one case came to.
struct CaseMutation {
  /// The name of the case; of the definitions of a file "".
  std::string name;
  std::vector<SiteMutants> sites;
  /// Claims that say nothing about errors: without any change, their verdicts are not those
  /// expected, or not found within the limits.
  std::vector<std::string> wrong;
  std::vector<std::string> undecided;
  /// What is special about the numbers of the case.
  std::vector<std::string> shapes;
  /// How many errors the data hide.
  std::size_t hidden = 0;
  std::vector<BetterData> better;
};

struct MutationOptions {
  /// What one claim may cost, each time it is decided.
  Limits limits;
  Loader load;
  /// How many errors are tried in one claim or declaration.
  std::size_t most = 40;
  /// Claims for which this is false are left alone; declarations and definitions are looked at
  /// only where all claims of the case are wanted. Empty: all.
  std::function<bool(const Case&, const Claim&)> wanted;
  /// Called before a case is looked at.
  std::function<void(const Case&)> progress;
};

/// Puts typical errors into the claims, declarations and definitions of a file, one at a time, and
/// decides the claims of its cases again by the kernel. `cases` are those of the file as read.
std::vector<CaseMutation> mutations_of(const syntax::File& file, const std::vector<Case>& cases,
                                       const MutationOptions& options);

}  // namespace patchproof
