#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("a product over running indices multiplies all of them", "[law]") {
  CHECK(verdicts(R"~(
  param t in [0, 1]
  scalar a[0..3]
  prove factorial: product(i, i in 1..5) == 120
  prove one_factor: product(a[i], i in 2..2) == a[2]
  prove two_indices: product(t - a[i] + j, i in 0..1, j in 0..1)
                     == (t - a[0])*(t - a[0] + 1)*(t - a[1])*(t - a[1] + 1)
  prove quotients: product((t - a[k])/(a[3] - a[k]), k in 0..1)
                   == (t - a[0])/(a[3] - a[0])*(t - a[1])/(a[3] - a[1])
  refute sum: product(a[i], i in 0..1) == a[0] + a[1]
)~") == "factorial PROVED\none_factor PROVED\ntwo_indices PROVED\n"
          "quotients PROVED IF {a[0] - a[3] != 0} {a[1] - a[3] != 0}\nsum REFUTED\n");
}

TEST_CASE("a volume is differentiated and evaluated like a patch", "[law]") {
  CHECK(verdicts(R"~(
  param u, v, w in [0, 1]
  volume F(u, v, w) : C^3
  volume G(u, v, w) = F(v, w, u)
  prove mixed: F_uvw(0,0,0) == diff(F, w, v, u)(0,0,0)
  prove chain: G_u(u,v,w) == F_w(v,w,u), G_v(u,v,w) == F_u(v,w,u)
  prove face: G(1,v,w) == F(v,w,1)
  refute exchanged: G_u(u,v,w) == F_u(v,w,u)
  refute same: F == G
)~") == "mixed PROVED\nchain PROVED\nface PROVED\nexchanged REFUTED\nsame REFUTED\n");
}

}  // namespace patchproof
