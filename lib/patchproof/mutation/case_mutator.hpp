#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <patchproof/mutation/data.hpp>
#include <patchproof/mutation/mutation.hpp>

namespace patchproof {

/// What becomes of the errors of a part: of at most so many that have a meaning.
SiteMutants mutants_of(const Site& site, std::size_t most,
                       const std::function<Mutant(const SiteError&)>& mutant_of);

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

  /// What the claims come to after changes: "" for one with the verdict expected, for others what
  /// they are off by. Claims that are not decided are left out; all, when the text has mistakes.
  using Findings = std::map<std::string, std::string>;
  Findings findings(std::vector<Edit> edits) const;
  Findings findings(std::vector<Edit> edits, const Mutant& mutant) const;

  const std::vector<Data>& data() const { return data_; }
  const std::set<std::string>& observers() const { return observers_; }
  /// The change of the text that puts symbols in the place of the numbers.
  static Edit for_symbols(const Data& data);

 private:
  bool observes(const std::string& label) const;
  Decision compared(const SiteError& error, std::vector<Edit> edits) const;
  std::set<std::string> holding(const std::vector<Edit>& edits) const;
  bool differs(const SiteError& error, const std::vector<Edit>& edits) const;
  void name_data(Mutant& mutant) const;
  /// Fills in the declaration for symbols of data that no claim notices.
  void generalise(SiteMutants& site) const;
  bool is_noticed_in_general(const SiteError& error) const;
  void explain_by_comparison(Site::Kind kind, Mutant& mutant) const;
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
