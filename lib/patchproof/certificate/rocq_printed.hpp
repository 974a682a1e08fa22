#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchproof/certificate/rocq_syntax.hpp>

namespace patchproof {

/// What `Print` or `Check` has shown of a name.
struct RocqPrinted {
  std::string name;
  /// The body of a definition, the statement of a theorem; null when there is a problem.
  RocqTermPointer term;
  /// The type of a definition, "R -> R"; "" of a theorem.
  std::string type;
  /// Why there is no term: it was not printed, or cannot be read.
  std::string problem;
};

/// What a run of coqc has printed of definitions (`NAME = TERM : TYPE`) and then of theorems
/// (`NAME : STATEMENT`), one for each name; they stand in this order in the output.
std::vector<RocqPrinted> rocq_printed(std::string_view output,
                                      const std::vector<std::string>& definitions,
                                      const std::vector<std::string>& theorems);

}  // namespace patchproof
