#pragma once

#include <verify/case_work.hpp>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace patchproof {

struct CoqcCheck {
  /// Where the files of the cases are, and the support library.
  std::string folder;
  /// How many coqc may run at a time.
  std::size_t jobs = 1;
  /// Longest time for a file.
  std::chrono::seconds longest{300};
  /// Writes the file of a case again; whether that succeeded.
  std::function<bool(const CaseWork&)> rewrite;
};

/// Lets coqc check the cases, small ones several at a time, and notes what it says of each. A
/// theorem that it does not accept is left out, and the rest of the case tried again.
/// @returns what makes the whole impossible; "" when all is well.
std::string check_with_coqc(const CoqcCheck& how, std::vector<CaseWork>& works);

}  // namespace patchproof
