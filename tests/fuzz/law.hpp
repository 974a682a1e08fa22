#pragma once

#include <cstdlib>
#include <iostream>
#include <string>

namespace patchproof::fuzz {

/// Ends the run: libFuzzer keeps the input.
[[noreturn]] inline void violated(const std::string& law, const std::string& text) {
  std::cerr << "violated: " << law << "\n" << text << "\n";
  std::abort();
}

}  // namespace patchproof::fuzz
