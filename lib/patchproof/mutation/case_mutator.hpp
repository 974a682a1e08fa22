#pragma once

#include <set>
#include <string>
#include <vector>

#include <patchproof/mutation/data.hpp>
#include <patchproof/mutation/mutation.hpp>

namespace patchproof {

/// One case under mutation: what its claims are without any change, and what they notice.
class CaseMutator {
 public:
  /// The case and the file must outlive this.
  CaseMutator(const syntax::File& file, const syntax::Case& written, const Case& given,
              const MutationOptions& options);

  /// Decides the claims as written, and says which of them cannot notice anything.
  void look_at_claims(CaseMutation& result);

  /// Whether the claims of this label are to be looked at; every claim of the case.
  bool wants(const std::string& label) const;
  bool wants_everything() const;

  /// The errors of the case itself.
  std::vector<SiteMutants> sites() const;

  /// What the claims make of an error.
  Fate fate(const Site& site, const SiteError& error) const;
  /// Fills in why an error that survives is not noticed.
  void explain(Site::Kind kind, Mutant& mutant) const;

  /// Whether an error is noticed with other changes of the text as well; `noticing` are the claims
  /// that hold after these.
  bool notices(const Mutant& mutant, const std::vector<Edit>& other,
               const std::set<std::string>& noticing) const;
  /// The claims that have the verdict expected after changes; empty when the text has mistakes.
  std::set<std::string> holding(const std::vector<Edit>& edits) const;

  const std::vector<Data>& data() const { return data_; }
  const std::set<std::string>& observers() const { return observers_; }
  /// The change of the text that puts symbols in the place of the numbers.
  static Edit for_symbols(const Data& data);

 private:
  Verdict compared(const SiteError& error, std::vector<Edit> edits) const;
  bool differs(const SiteError& error, const std::vector<Edit>& edits) const;
  void name_data(Mutant& mutant) const;
  void find_general();

  const syntax::Case& written_;
  const Case& given_;
  const MutationOptions& options_;
  Rereading text_;
  std::vector<Data> data_;
  /// Claims that have the verdict expected without any change.
  std::set<std::string> observers_;
  /// The case for symbols, as far as it has a meaning, and the claims that hold in it.
  std::vector<Edit> general_;
  std::set<std::string> general_observers_;
  /// Takes the assumptions away.
  std::vector<Edit> unassumed_;
};

}  // namespace patchproof
