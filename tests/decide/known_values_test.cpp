// A derived value is put in place of its symbol; nothing in it is taken for something else.
#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

const std::string derived = "  scalar x, y\n  derive X: x from x == 2*y gives 2*y\n";

}  // namespace

TEST_CASE("a derivative holds everything else fixed, whatever its value") {
  CHECK(verdicts(derived + "  prove plain: diff(x*y, y) == x\n"
                           "  prove right: diff(x*y, y) == 2*y using X\n"
                           "  refute total: diff(x*y, y) == 4*y using X\n") ==
        "X PROVED\nplain PROVED\nright PROVED\ntotal REFUTED\n");
}

TEST_CASE("a derivative by a symbol whose value is known is taken before the value is put in") {
  CHECK(verdicts(derived + "  prove own: diff(x^2, x) == 4*y using X\n"
                           "  refute none: diff(x^2, x) == 0 using X\n"
                           "  prove other: diff(x^2, y) == 0 using X\n"
                           "  refute total: diff(x^2, y) == 8*y using X\n"
                           "  prove second: diff(x^2*y, x, y) == 4*y using X\n") ==
        "X PROVED\nown PROVED\nnone REFUTED\nother PROVED\ntotal REFUTED\nsecond PROVED\n");
}

TEST_CASE("the same with an assumption, which keeps the claim from the grid") {
  CHECK(verdicts("  scalar a, b\n  assume apart: a != b\n" + derived +
                 "  prove right: diff(x*y, y) == 2*y using X\n"
                 "  refute total: diff(x*y, y) == 4*y using X\n") ==
        "X PROVED\nright PROVED\ntotal REFUTED\n");
}

}  // namespace patchproof
