#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/term/binding.hpp>
#include <patchproof/term/latex_name.hpp>
#include <patchproof/term/latex_text.hpp>

namespace patchproof {

/// Writes one term; see `to_latex`.
class LatexWriter {
 public:
  explicit LatexWriter(const LatexNames& names) : names_{names} {}
  std::string of(const Term& term);
  std::vector<std::string> summands(const Term& function_or_value);

 private:
  struct Factor {
    std::string text;
    bool is_number = false;
    bool is_one = false;
  };
  const std::string* name_of(const Term& term) const { return names_.name_of(term); }
  bool is_name(const Term& term) const { return name_of(term) || has_plain_name(term); }
  // A product of matrices that is one value, of which the entry is taken.
  static bool is_single(const Term& matrix);
  Binding binding_of(const Term& term) const;
  std::string within(const Term& term, Binding least);
  std::string list(const std::vector<Term>& terms, std::size_t first = 0);
  // A function that only applies another one to its own parameters is that function.
  std::string as_argument(const Term& term);
  std::string unnamed(const Term& term);
  std::string sum(const Term& term);
  // Juxtaposition; a dot where two digits or two matrices would meet.
  std::string product(const Term& term);
  void collect_factors(const Term& function_or_value, std::vector<Factor>& factors);
  std::string quotient(const Term& term);
  std::string elementary_argument(const Term& argument);
  std::string infix(const Term& term, const std::string& sign);
  bool is_expression(const Term& function) const;
  // An expression at values of its parameters: with these in their places.
  static Term at_arguments(const Term& term);
  std::string apply(const Term& term);
  std::string derivative(const Term& term);
  std::string parameter_text(const std::string& name) const;
  std::string derivative_fraction(const Term& base, const Indices& orders, int total);
  const Term* call_of_formals(const Term& function) const;
  static bool is_letter_name(const std::string& name);
  std::optional<LatexName> symbol_name(const Term& term) const;
  std::string component(const Term& term);
  std::string index(const Term& matrix, const Indices& indices);
  std::string slice(const Term& term);
  std::string matrix(const Term& term);
  std::string determinant(const Term& term);
  std::string basis_function(const Term& term);
  std::string integral(const Term& term);
  std::string definition(const Term& term);
  static std::string words(const std::string& name);

  std::string lambda(const Term& term);
  bool rename_formals(const Term& lambda);

  const LatexNames& names_;
  /// Bound variables that are written by another letter.
  std::map<unsigned, std::string> renamed_;
};

/// In brackets, which grow with what is tall.
std::string latex_bracketed(const std::string& text);

/// What a superscript can be put on: in brackets where it has one already.
std::string latex_base(const std::string& text);

/// The text with an index; in brackets where it has one already.
std::string latex_subscript(const std::string& text, const std::string& index);

}  // namespace patchproof
