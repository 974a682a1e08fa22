#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <patchproof/certificate/rocq_sequent.hpp>

namespace patchproof {

/// The hypotheses of a sequent at the places where a proof uses them: each becomes an equation
/// between two terms of the support library, which the proof script shows first.
class RocqInstances {
 public:
  /// @throws NotScalar when a hypothesis is used in a way that is not written
  RocqInstances(const SequentProof& proof, RocqSequent& sequent, Scalars& scalars, RocqText& text,
                RocqTwin& twin);

  /// The script that takes the hypotheses to these places.
  const std::string& script() const { return script_; }
  /// Pairs of terms, and proofs that they are equal.
  const std::vector<std::pair<std::string, std::string>>& equations() const { return equations_; }
  /// The factors in the order of the equations, as a list of terms.
  std::string cofactors(const std::vector<Cofactor>& list);

 private:
  using Key = std::pair<std::size_t, std::vector<std::string>>;

  void find(const SignProof& proof);
  std::size_t place_of(const Instance& instance);
  std::string name_at(const Instance& instance, const Key& key);

  RocqSequent& sequent_;
  Scalars& scalars_;
  RocqText& text_;
  RocqTwin& twin_;
  std::map<Key, std::string> names_;
  std::map<Key, std::size_t> places_;
  std::vector<std::pair<std::string, std::string>> equations_;
  std::string script_;
};

/// "[a;\n b]"
std::string rocq_list(const std::vector<std::string>& parts);

}  // namespace patchproof
