#include <patchproof/certificate/rocq_file.hpp>

#include <catch2/catch.hpp>

#include <tests/certificate/small_case.hpp>

namespace patchproof {
namespace {

// Why the only claim, which has a certificate, has no theorem; "" when it has one.
std::string why_no_theorem(const std::string& statements) {
  const CertifiedCase all = certified_case("case t\n" + statements + "end\n");
  return rocq_file(all.given, all.certificates).theorems.at(0).why_not;
}

}  // namespace

TEST_CASE("an unknown function at an argument that has to be reduced has no theorem") {
  const std::string given = "  scalar a, b\n  param s in [a, b]\n  assume a != b\n  curve C(t)\n";
  CHECK(why_no_theorem(given + "  prove p: C(a + (b-a)*((s-a)/(b-a))) == C(s)\n") ==
        "an unknown function at a quotient");
  // Through a function of the case.
  CHECK(why_no_theorem(given + "  param t in [0, 1]\n  curve K(t) = C((1-t)*a + t*b)\n"
                               "  prove p: K((s-a)/(b-a)) == C(s)\n") ==
        "an unknown function at a quotient");
  CHECK(why_no_theorem(given + "  prove p: C(s/2 + s/2) == C(s)\n") == "");
  CHECK(why_no_theorem(given + "  prove p: (s-a)/(b-a)*C(s) == C(s)*(s-a)/(b-a)\n") == "");
}

TEST_CASE("an integral of an unknown function has no theorem") {
  const std::string given = "  param u in [0, 1]\n  scalar w\n  scalar f(u) : C^1\n";
  CHECK(why_no_theorem(given + "  prove p: integral(f'(u), u in [0, 1]) == f(1) - f(0)\n") ==
        "an integral of an unknown function");
  CHECK(why_no_theorem(given + "  prove p: integral(f(1)*u, u in [0, 1]) == f(1)/2\n") == "");
  CHECK(why_no_theorem(given + "  prove p: integral(w*u, u in [0, 1]) == w/2\n") == "");
}

TEST_CASE("square roots are not told apart in a counterexample") {
  CHECK(why_no_theorem("  param t in [0, 1]\n  refute p: t*sqrt(2) == t\n") ==
        "a square root in a counterexample");
  CHECK(why_no_theorem("  param t in [0, 1]\n  prove p: t*sqrt(2)*sqrt(2) == 2*t\n") == "");
}

}  // namespace patchproof
