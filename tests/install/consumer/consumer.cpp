#include <cstdio>

#include <patchproof/language/prelude.hpp>
#include <patchproof/symbolic/second_opinion.hpp>
#include <patchproof/version.hpp>

/// Prints the version of the installed library. Calls both the plain part of the library and the
/// one that stands on GiNaC, so that a library missing from the link line is noticed.
int main() {
  const patchproof::SecondOpinion opinion =
      patchproof::second_opinion(patchproof::Goal{}, patchproof::Limits{});
  if (patchproof::prelude_files().empty()) return 1;
  if (opinion.answer == patchproof::SecondOpinion::Answer::fails) return 1;
  std::printf("%.*s\n", static_cast<int>(patchproof::version.size()), patchproof::version.data());
}
