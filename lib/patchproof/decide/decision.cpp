#include <patchproof/decide/decision.hpp>

namespace patchproof {

std::string to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved: return "PROVED";
    case Verdict::proved_if: return "PROVED IF";
    case Verdict::refuted: return "REFUTED";
    case Verdict::vacuous: return "VACUOUS";
    case Verdict::underdetermined: return "UNDERDETERMINED";
    case Verdict::inconsistent: return "INCONSISTENT";
    case Verdict::unknown: return "UNKNOWN";
    case Verdict::error: return "ERROR";
    default: return "INTERNAL";
  }
}

std::string to_text(Evidence evidence) {
  switch (evidence) {
    case Evidence::kernel: return "kernel";
    case Evidence::both_engines: return "both engines";
    case Evidence::certified: return "certified";
    default: return "none";
  }
}

}  // namespace patchproof
