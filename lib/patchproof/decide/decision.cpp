#include <patchproof/decide/decision.hpp>

#include <algorithm>

namespace patchproof {

std::string to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved:
      return "PROVED";
    case Verdict::proved_if:
      return "PROVED IF";
    case Verdict::refuted:
      return "REFUTED";
    case Verdict::vacuous:
      return "VACUOUS";
    case Verdict::underdetermined:
      return "UNDERDETERMINED";
    case Verdict::inconsistent:
      return "INCONSISTENT";
    case Verdict::unknown:
      return "UNKNOWN";
    case Verdict::error:
      return "ERROR";
    default:
      return "INTERNAL";
  }
}

std::string to_text(Evidence evidence) {
  switch (evidence) {
    case Evidence::kernel:
      return "kernel";
    case Evidence::both_engines:
      return "both engines";
    case Evidence::certified:
      return "certified";
    default:
      return "none";
  }
}

Limits limits_of_second_opinion(const Limits& limits, Engines engines) {
  // Some four milliseconds.
  constexpr std::uint64_t cheap = 200'000;
  Limits result = limits;
  if (engines == Engines::usual)
    result.steps = limits.steps == 0 ? cheap : std::min(limits.steps, cheap);
  return result;
}

}  // namespace patchproof
