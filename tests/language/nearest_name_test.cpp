#include <catch2/catch.hpp>

#include <patchproof/language/nearest_name.hpp>

namespace patchproof {

TEST_CASE("the nearest name is one insertion, removal, change or swap away", "[language]") {
  const std::vector<std::string> known{"prove", "param", "patch", "point"};
  CHECK(nearest_name("prvoe", known) == "prove");
  CHECK(nearest_name("prov", known) == "prove");
  CHECK(nearest_name("proove", known) == "prove");
  CHECK(nearest_name("pratch", known) == "patch");
  CHECK(nearest_name("paint", known) == "point");
  CHECK(nearest_name("prove", known) == "prove");
}

TEST_CASE("a name far from all others has no nearest one", "[language]") {
  CHECK(nearest_name("curve", {"title", "source"}) == "");
  CHECK(nearest_name("u", {"v"}) == "");
  CHECK(nearest_name("ab", {"cb", "ac"}) == "cb");
  CHECK(nearest_name("", {"a"}) == "");
  CHECK(nearest_name(std::string(10'000'000, 'a'), {std::string(10'000'000, 'a') + "b"}) == "");
}

TEST_CASE("of equally near names the first counts", "[language]") {
  CHECK(nearest_name("rCX", {"rCA", "rCB"}) == "rCA");
  CHECK(nearest_name("boundary_curve", {"boundarie_curv", "boundary_curves"}) == "boundary_curves");
}

TEST_CASE("the question names the nearest name", "[language]") {
  CHECK(did_you_mean("prvoe", {"prove"}) == "did you mean 'prove'?");
  CHECK(did_you_mean("prvoe", {"title"}) == "");
}

}  // namespace patchproof
