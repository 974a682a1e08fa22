#include <patchproof/report/colour.hpp>

namespace patchproof {

namespace {

std::string with_code(const std::string& text, const std::string& code) {
  return "\x1b[" + code + "m" + text + "\x1b[0m";
}

}  // namespace

std::string coloured(const std::string& text, Outcome outcome) {
  switch (outcome) {
    case Outcome::as_expected:
      return with_code(text, "32");
    case Outcome::unknown:
    case Outcome::vacuous:
      return with_code(text, "33");
    default:
      return with_code(text, "31");
  }
}

std::string bold(const std::string& text) { return with_code(text, "1"); }

}  // namespace patchproof
