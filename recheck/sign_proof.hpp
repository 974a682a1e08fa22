#pragma once

#include <recheck/divisors.hpp>
#include <recheck/premises.hpp>

namespace recheck {

/// A multiple of an equation, as the proof says: the product, which is zero, with its divisors.
Fact multiple_of(const Cofactor& cofactor, const Premises& premises, Evaluator& evaluator);

/// Follows proofs of signs.
class SignChecker {
 public:
  SignChecker(const Premises& premises, const Divisors& divisors, Evaluator& evaluator)
      : premises_{premises},
        divisors_{divisors},
        evaluator_{evaluator},
        field_{evaluator.field()} {}

  /// Requires that the proof shows that the scalar is not negative, or positive.
  /// @throws Rejection, with the part of the proof that fails
  void require(const SignProof& proof, const Quotient& goal, bool strict) const {
    follow(proof, goal, strict, premises_.facts(), "");
  }

 private:
  void follow(const SignProof& proof, const Quotient& goal, bool strict, std::vector<Fact> facts,
              const std::string& path) const;
  void require(const Combination& why, const Quotient& goal, bool strict,
               const std::vector<Fact>& facts) const;
  /// The summand, and whether it is positive.
  Fact value(const Combination::Summand& summand, const std::vector<Fact>& facts) const;

  const Premises& premises_;
  const Divisors& divisors_;
  Evaluator& evaluator_;
  Field& field_;
};

}  // namespace recheck
