#pragma once

#include <exception>
#include <string>

#include <patchproof/language/diagnostic.hpp>

namespace patchproof {

/// Thrown while a statement is checked: it cannot be given a meaning. The statement is then left
/// out, and the names it would have declared are marked as faulty.
class Fault : public std::exception {
 public:
  Fault(const Span& span, std::string message, std::string help = "")
      : diagnostic{span, std::move(message), std::move(help)} {}
  const char* what() const noexcept override { return diagnostic.message.c_str(); }

  Diagnostic diagnostic;
};

/// Thrown when something depends on a name whose declaration was already reported as wrong: no
/// second message is wanted.
class FollowUp : public std::exception {};

}  // namespace patchproof
