#pragma once

#include <optional>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/certificate/farkas.hpp>
#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// Finds proofs of signs from facts: sums of products of facts and squares, by Farkas' lemma for what
/// is linear, by Bernstein coefficients over boxes of parameters, which are cut where needed, and by
/// completing squares.
///
/// A heuristic; what it finds is the proof.
class SignSearch {
 public:
  /// The facts in the order of `facts_of`; those that are no polynomials are zero here.
  SignSearch(std::vector<SignedPolynomial> facts, Workspace& workspace);

  /// A proof that goal + (multiples of equations, given as cofactors) has the sign; the cofactors
  /// are put where the goal is shown.
  std::optional<SignProof> proof(const SignedPolynomial& goal, const std::vector<Cofactor>& cofactors);

 private:
  struct Bounds {
    Variable variable = 0;
    Rational low;
    Rational high;
    /// fact `lower` is low_scale * (variable - low), fact `upper` high_scale * (high - variable).
    std::size_t lower = 0;
    std::size_t upper = 0;
    Rational low_scale;
    Rational high_scale;
  };
  using Summands = std::vector<Summand>;

  std::optional<SignProof> search(const SignedPolynomial& goal,
                                  const std::vector<Cofactor>& cofactors, unsigned cuts);
  std::optional<SignProof> cut(const SignedPolynomial& goal, const std::vector<Cofactor>& cofactors,
                               unsigned cuts);
  std::optional<SignProof> half(const SignedPolynomial& goal, const std::vector<Cofactor>& cofactors,
                                unsigned cuts, const Bounds& bounds, bool upper_half);
  std::optional<Summands> summands(const SignedPolynomial& goal);
  std::optional<Summands> never_negative(const Polynomial& p, unsigned depth);
  std::optional<Summands> as_product(const Polynomial& p);
  std::optional<Summands> term_by_term(const Polynomial& p);
  std::optional<Summands> linear(const SignedPolynomial& goal);
  std::optional<Summands> in_bernstein_basis(const Polynomial& p, unsigned depth);
  std::optional<Summands> without_square(const Polynomial& p, unsigned depth);
  std::optional<Summands> completed_square(const Polynomial& p, unsigned depth);
  std::optional<Bounds> bounds(Variable variable) const;
  bool is_strict(const Summands& summands) const;

  std::vector<SignedPolynomial> facts_;
  Workspace& workspace_;
  std::size_t work_ = 0;
};

}  // namespace patchproof
