#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <patchproof/certificate/rocq_syntax.hpp>
#include <patchproof/certificate/rocq_tokens.hpp>

namespace patchproof {

/// Brackets, binders and exponents within each other beyond this are not read.
inline constexpr int deepest_rocq_term = 500;

/// A term read from the front of a text.
struct RocqReading {
  RocqTermPointer term;
  /// Where the text goes on that does not belong to it.
  std::size_t end = 0;
};

/// Reads a term or a proposition as coqc prints it: the whole text.
///
/// It knows the notations that the statements of certificates use, and no others: forall, fun, ->, /\,
/// \/, ~, =, <>, <, <=, >, >=, chains of two of < and <=, + - * / ^, numbers, 3%nat, application.
/// @throws RocqUnreadable with the place and what was expected
RocqTermPointer rocq_term(std::string_view text);

/// The same for the longest term at the front, up to a sign that cannot continue it.
/// @throws RocqUnreadable
RocqReading rocq_term_at_front(std::string_view text);

/// A type, "nat -> (R -> R) -> R", without brackets that are not needed; and where it ends.
/// @throws RocqUnreadable
std::pair<std::string, std::size_t> rocq_type_at_front(std::string_view text);

}  // namespace patchproof
