// Fuzz target of the second checker: whatever the text, it ends well, soon, and the same way twice.

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include <recheck/place.hpp>
#include <recheck/recheck.hpp>

namespace {

recheck::Limits small_limits() {
  recheck::Limits limits;
  limits.bytes = 100'000;
  limits.nodes = 500;
  limits.symbols = 100;
  limits.extent = 50;
  limits.order = 8;
  limits.exponent = 100;
  limits.terms = 2'000;
  limits.kept = 50'000;
  limits.atoms = 500;
  limits.depth = 5;
  limits.steps = 200'000;
  return limits;
}

std::string judged(const std::string& text) {
  std::string result;
  try {
    for (const recheck::Outcome& outcome : recheck::outcomes_of(text, small_limits()))
      result += std::to_string(static_cast<int>(outcome.kind)) + outcome.reason + "\n";
  } catch (const recheck::Unreadable& error) {
    result = error.what();
  }
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (judged(text) != judged(text)) {
    std::cerr << "violated: the same text is judged the same way\n" << text << "\n";
    std::abort();
  }
  return 0;
}
