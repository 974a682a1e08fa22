#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchproof/claims/verification.hpp>

namespace patchproof {

/// The languages a document can be written in. Mathematics is the same in all of them.
enum class Language { english, czech, slovak, slovenian, russian };

/// Everything a document says in words. Mathematics and what the author wrote is none of it.
enum class Word {
  // headings
  book_title,
  given,
  definitions,
  assumptions,
  claim,
  derivation,
  erratum,
  errata,
  printed,
  corrected,
  note,
  verdicts,
  subject,
  count,
  total,
  source,
  section,
  example_values,
  assumed_later,
  page,
  by_machine,
  // what is given: one, and several
  point,
  points,
  scalar,
  scalars,
  parameter,
  parameters,
  curve,
  curves,
  patch,
  patches,
  volume,
  volumes,
  function,
  functions,
  matrix,
  matrices,
  // connecting words
  by_definition,
  we_compute,
  it_must_hold,
  hence,
  check,
  counterexample,
  variation,
  find,
  such_that,
  says_the_author,
  no_solution,
  left_open,
  minimizes,
  where,
  using_results,
  under_conditions,
  difference,
  left_side,
  right_side,
  all_others_zero,
  any_values,
  assumptions_used,
  free_unknowns,
  reason,
  expected,
  further_instances,
  // reasons of single steps
  reason_definition,
  reason_derivative,
  reason_arithmetic,
  reason_assumption,
  reason_derived,
  reason_collected,
  reason_value,
  reason_integration,
  // verdicts and what they rest on
  proved,
  proved_if,
  refuted,
  vacuous,
  underdetermined,
  inconsistent,
  unknown,
  error,
  internal,
  both_engines,
  kernel_only,
  certified,
  last = certified,
};

/// How many words there are.
inline constexpr std::size_t word_count = static_cast<std::size_t>(Word::last) + 1;

/// The word in the language, as plain text: UTF-8, no LaTeX.
const std::string& word(Word word, Language language);

/// The codes of the languages: "en", "cs", "sk", "sl", "ru".
const std::vector<std::string>& language_codes();

/// The language with this code; none where there is no such language.
std::optional<Language> language_of(std::string_view code);

std::string code_of(Language language);

/// What the LaTeX package babel calls the language: "english", "czech", …
std::string babel_name(Language language);

/// The verdict in one word, as in "proved".
Word word_of(Verdict verdict);

/// The verdict an author expects of a claim.
Word word_of(Expectation expectation);

}  // namespace patchproof
