#include <catch2/catch.hpp>

#include <patchproof/language/parser.hpp>
#include <patchproof/mutation/data.hpp>

namespace patchproof {

namespace {

using Texts = std::vector<std::string>;

std::vector<Data> data_in(const std::string& statements) {
  const auto source =
      std::make_shared<const SourceText>(SourceText{"", "case a\n" + statements + "end\n"});
  const Parsed parsed = parse(source);
  REQUIRE(parsed.diagnostics.empty());
  static std::vector<Parsed> kept;
  kept.push_back(parsed);
  return data_of(kept.back().file.cases.front());
}

Texts shape_in(const std::string& value) {
  const std::vector<Data> data = data_in("  matrix V = " + value + "\n");
  REQUIRE(data.size() == 1);
  return data.front().shape;
}

std::string symbols_in(const std::string& declaration) {
  const std::vector<Data> data = data_in("  " + declaration + "\n");
  return data.empty() ? "no data" : data.front().for_symbols;
}

}  // namespace

TEST_CASE("what hides errors is said of a net: planes, lines, symmetry, no twist, zeros") {
  CHECK(shape_in("[(0,0,1), (0,1,1) ; (1,0,1), (2,3,1)]") ==
        Texts{"the points of V are in one plane: all z are 1"});
  CHECK(shape_in("[(1,0,1), (0,1,2) ; (1,1,4), (2,3,7)]") == Texts{});
  CHECK(shape_in("[1, 2 ; 2, 5]") == Texts{"V is symmetric: V[i,j] = V[j,i]"});
  CHECK(shape_in("[1, 2 ; 3, 4]") == Texts{"V has no twist: its cells are parallelograms"});
  CHECK(shape_in("[0, 1 ; 3, 5]") == Texts{"V[0,0] is zero"});
  CHECK(shape_in("[(1,1), (2,2), (4,4)]") == Texts{"the points of V are on one line"});
  CHECK(shape_in("[3, 1, 3]") == Texts{"V is the same read backwards"});
  CHECK(shape_in("[2, 2 ; 2, 2]") == Texts{"all entries of V are the same"});
  CHECK(shape_in("[0, 0 ; 0, 0]") == Texts{"all of V is zero"});
  CHECK(shape_in("[7]") == Texts{});
}

TEST_CASE("numbers give way to symbols of the same kind") {
  CHECK(symbols_in("matrix V = [(0,0,1), (0,1,1) ; (1,0,1), (2,3,1)]") ==
        "point V[0..1, 0..1] in R^3");
  CHECK(symbols_in("matrix L = [1/2, -3, 2^2]") == "scalar L[0..2]");
  CHECK(symbols_in("let k = 3") == "scalar k");
  CHECK(symbols_in("let P = (1, 2)") == "point P in R^2");
  CHECK(symbols_in("curve C(u) = (u, u^2)") == "curve C(u) in R^2 : C^9");
  CHECK(symbols_in("patch r(u,v) = (u, v, 2*sin(u))") == "patch r(u, v) in R^3 : C^9");
  CHECK(symbols_in("scalar f(t) = 1 - t") == "scalar f(t) : C^9");
}

TEST_CASE("what rests on names is no data") {
  CHECK(symbols_in("let k = 3*x") == "no data");
  CHECK(symbols_in("matrix V = [1, a]") == "no data");
  CHECK(symbols_in("matrix V = [1, ?]") == "no data");
  CHECK(symbols_in("curve C(u) = (u, f(u))") == "no data");
  CHECK(symbols_in("let k = 1/0") == "no data");
}

}  // namespace patchproof
