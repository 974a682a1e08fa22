#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include <patchproof/certificate/scalar.hpp>
#include <patchproof/term/latex_text.hpp>

namespace patchproof {

/// The term has a part that scalars have no word for, or it is too large.
class NotScalar : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The components of terms as scalars, and those of functions as functions to the real numbers.
class Scalars {
 public:
  /// Functions, matrices and values of the case that are to be called by their names.
  explicit Scalars(std::vector<std::pair<std::string, Term>> named);

  /// Entries of a matrix come row by row, coordinates of a point in order.
  /// @throws NotScalar
  const std::vector<ScalarPointer>& of(const Term& term);

  /// One for each component of a value of the function.
  /// @throws NotScalar
  const std::vector<ScalarFunctionPointer>& functions_of(const Term& term);

 private:
  std::vector<ScalarPointer> compute(const Term& term);
  std::vector<ScalarFunctionPointer> compute_functions(const Term& term);
  std::vector<ScalarPointer> pointwise(const Term& term);
  std::vector<ScalarPointer> vector_operation(const Term& term);
  std::vector<ScalarPointer> matrix_product(const Term& term);
  std::vector<ScalarPointer> applied(const Term& term);
  std::vector<ScalarPointer> integrals(const Term& term);
  /// The name of the case, or of the definition of the prelude that the term is a use of.
  const std::string* name_of(const Term& term) const;

  LatexNames names_;
  std::unordered_map<const TermNode*, std::vector<ScalarPointer>> values_;
  std::unordered_map<const TermNode*, std::vector<ScalarFunctionPointer>> functions_;
  /// Keeps the terms alive whose addresses are keys.
  std::vector<Term> seen_;
};

}  // namespace patchproof
