#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("a claim over its budget is unknown, and the next one is decided") {
  const std::string lines = verdicts(R"~(
  limit steps 1000
  scalar x, y, z, w
  prove long: (x + y + z + w)^30 == (w + z + y + x)^30
  prove short: x + y == y + x
)~");
  CHECK(lines.rfind("long UNKNOWN (limit: ", 0) == 0);
  CHECK(lines.find("\nshort PROVED\n") != std::string::npos);
}

TEST_CASE("each budget has its reason") {
  const std::string huge = "  prove p: (x + y + z + w)^60 == (w + z + y + x)^60\n";
  const std::string symbols = "  scalar x, y, z, w\n";
  CHECK(verdicts("  limit terms 100\n" + symbols + huge).rfind("p UNKNOWN (limit: ", 0) == 0);
  CHECK(verdicts("  limit time 1 ms\n" + symbols + huge).rfind("p UNKNOWN (limit: ", 0) == 0);
  CHECK(verdicts("  limit steps 5000\n" + symbols + huge).rfind("p UNKNOWN (limit: ", 0) == 0);
}

TEST_CASE("a derivation over its budget is unknown as well") {
  const std::string lines = verdicts(R"~(
  limit steps 200
  scalar x, a, b, c
  derive d: x from x == (a + b + c)^20
  prove p: x == 0 using d
)~");
  CHECK(lines.rfind("d UNKNOWN (limit: ", 0) == 0);
  CHECK(lines.find("p UNKNOWN (it uses 'd', which is not derived)") != std::string::npos);
}

TEST_CASE("a budget that is just enough changes nothing") {
  const std::string statements = "  scalar x, y\n  prove p: (x + y)^3 == (y + x)^3\n";
  CHECK(verdicts("  limit steps 100000\n" + statements) == "p PROVED\n");
  CHECK(verdicts("  limit memory 64 MB\n" + statements) == "p PROVED\n");
}

}  // namespace patchproof
