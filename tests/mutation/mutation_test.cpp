#include <algorithm>
#include <catch2/catch.hpp>

#include <tests/mutation/mutations.hpp>

namespace patchproof {

namespace {

using Texts = std::vector<std::string>;
using Why = Mutant::Why;

bool contains(const Texts& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

// The twist of a Coons patch, as numbers.
std::string twist_of(const std::string& net) {
  return "  param u, v in [0, 1]\n  matrix V = " + net +
         "\n  patch b(u,v) = bezier(V)\n"
         "  prove twist: b_uv(0,0) == V[1,1] - V[1,0] - V[0,1] + V[0,0]\n";
}

const std::string bent = "[(1,0,0), (0,1,1) ; (1,0,2), (2,3,7)]";
const std::string symmetric = "[(1,0,0), (0,1,1) ; (0,1,1), (2,3,7)]";

}  // namespace

TEST_CASE("with points in general position every wrong sign of a twist is noticed", "[law]") {
  const SiteMutants twist = part(mutations_in_case(twist_of(bent)), "twist");
  CHECK(twist.mutants.size() >= 20);
  CHECK(words(twist, Fate::survives, Why::data).empty());
  CHECK(words(twist, Fate::survives, Why::independent).empty());
  CHECK(contains(words(twist, Fate::noticed), "sign of V[1,0]"));
  CHECK(contains(words(twist, Fate::noticed), "V[1,1] left out"));
}

TEST_CASE("exchanged indices are not noticed in symmetric data, which is said") {
  const CaseMutation of = mutations_in_case(twist_of(symmetric));
  const Texts hidden = words(part(of, "twist"), Fate::survives, Why::data);
  CHECK(contains(hidden, "1 -> 0 in V[1,0]") == false);
  CHECK(contains(hidden, "1 and 0 exchanged in V[1,0]"));
  CHECK(contains(hidden, "0 and 1 exchanged in V[0,1]"));
  CHECK(part(of, "twist").mutants.front().place.source->name == "a.proof");
  CHECK(of.shapes == Texts{"the points of V are in one plane", "V is symmetric: V[i,j] = V[j,i]"});
  REQUIRE(of.better.size() == 1);
  CHECK(of.better[0].words == "point V[0..1, 0..1] in R^3");
  CHECK(of.better[0].for_symbols);
  CHECK(of.better[0].noticed == of.hidden);
  // The twist stays the same when u and v are exchanged, whatever the net is.
  CHECK(words(part(of, "b"), Fate::survives, Why::independent) ==
        Texts{"V -> transpose(V) in bezier(V)"});
}

TEST_CASE("what says the same is told apart from what nobody notices") {
  const CaseMutation of = mutations_in_case(
      "  point P, Q in R^3\n  scalar x\n  assume one: x == 1\n"
      "  prove product: dot(P, Q) == x*dot(Q, P)\n");
  const SiteMutants product = part(of, "product");
  CHECK(words(product, Fate::survives, Why::same) ==
        Texts{"P and Q exchanged in dot(P, Q)", "Q and P exchanged in dot(Q, P)"});
  CHECK(words(product, Fate::survives, Why::data).empty());
  const CaseMutation assumed = mutations_in_case(
      "  scalar a1, a2\n  assume equal: a1 == a2\n  prove sum: a1 + 1 == 1 + a1\n");
  CHECK(words(part(assumed, "sum"), Fate::survives, Why::assumed) == Texts{"a1 -> a2", "a1 -> a2"});
}

TEST_CASE("the same on both sides is no error that data could show") {
  const CaseMutation of = mutations_in_case("  let a1 = 2\n  let a2 = 2\n  prove same: a1 == a2\n");
  CHECK(part(of, "same").mutants.empty());
}

TEST_CASE("a declaration that no claim looks at differs somewhere, and where is said") {
  const CaseMutation of = mutations_in_case(
      "  param u, v in [0, 1]\n  curve C1(u), C2(u)\n  patch r(u,v) = ruled(C1, C2)\n"
      "  prove south: r(u,0) == C1(u)\n");
  const SiteMutants r = part(of, "r");
  CHECK(words(r, Fate::noticed) ==
        Texts{"C1 -> C2 in ruled(C1, C2)", "C1 and C2 exchanged in ruled(C1, C2)"});
  CHECK(words(r, Fate::survives, Why::independent) == Texts{"C2 -> C1 in ruled(C1, C2)"});
  CHECK(r.mutants.back().differs_at == "u = 0, v = 1");
}

TEST_CASE("an error in a definition is noticed by the claims of any case of the file") {
  const std::string definition = "define line(A, B : point) : curve(t)\n  = (1-t)*A + t*B\nend\n";
  const std::string start = "case first\n  point A, B\n  prove start: line(A, B)(0) == A\nend\n";
  const std::string end = "case second\n  point A, B\n  prove end_point: line(A, B)(1) == B\nend\n";
  const std::vector<CaseMutation> one = mutations_in(definition + start);
  REQUIRE(one.size() == 2);
  CHECK(one[0].name.empty());
  CHECK(contains(words(part(one[0], "line"), Fate::survives, Why::independent), "t*B left out"));
  const std::vector<CaseMutation> both = mutations_in(definition + start + end);
  REQUIRE(both.size() == 3);
  CHECK(contains(words(part(both[0], "line"), Fate::noticed), "t*B left out"));
}

TEST_CASE("a claim that uses a derivation notices errors in it") {
  const CaseMutation of = mutations_in_case(
      "  scalar x, y\n  derive X: x from x == 2*y\n  prove double: x - y == y using X\n");
  CHECK(contains(words(part(of, "X"), Fate::noticed), "2 -> 3"));
}

TEST_CASE("data that no claim depends on can be symbols") {
  const CaseMutation of = mutations_in_case(twist_of(bent));
  CHECK(part(of, "V").for_symbols == "point V[0..1, 0..1] in R^3");
  const CaseMutation needed = mutations_in_case("  let k = 3\n  prove nine: k^2 == 9\n");
  CHECK(part(needed, "k").for_symbols.empty());
  CHECK(words(part(needed, "k"), Fate::noticed) == Texts{"k: 3 -> 4"});
}

TEST_CASE("one changed number that leaves the claims true is found") {
  const CaseMutation of =
      mutations_in_case("  let x = 0\n  let y = 2\n  prove sum: x + y == y + x, y == 2\n");
  REQUIRE(of.better.size() == 1);
  CHECK(of.hidden > 0);
  CHECK(of.better[0].words == "scalar x");
  const CaseMutation small =
      mutations_in_case("  let x = 0\n  let y = 2\n  prove sum: x + y == y + x, y == 2, x < 5\n");
  REQUIRE(small.better.size() == 1);
  CHECK(small.better[0].words == "x = 1 in place of 0");
  CHECK(small.better[0].other_values.empty());
}

TEST_CASE("curves that have to meet get another corner together") {
  const CaseMutation of = mutations_in_case(
      "  param u, v in [0, 1]\n  curve C1(u) = (u, 0)\n  curve C2(u) = (u, 1)\n"
      "  curve D1(v) = (0, v)\n  curve D2(v) = (1, v)\n"
      "  patch P(u,v) = (1-v)*C1(u) + v*C2(u) + (1-u)*D1(v) + u*D2(v)\n"
      "    - (1-u)*(1-v)*C1(0) - u*(1-v)*C1(1) - (1-u)*v*C2(0) - u*v*C2(1)\n"
      "  prove edges: P(u,0) == C1(u), P(u,1) == C2(u), P(0,v) == D1(v), P(1,v) == D2(v)\n");
  CHECK(contains(words(part(of, "P"), Fate::survives, Why::data), "(1-u)*(1-v)*C1(0) left out"));
  REQUIRE(!of.better.empty());
  CHECK(of.better[0].words ==
        "C1 = (u, 1-u) in place of (u, 0) and D1 = (0, v + 1-v) in place of (0, v)");
  CHECK(of.better[0].other_values.empty());
}

TEST_CASE("what is not decided within the limits counts as neither") {
  MutationOptions options;
  options.limits.terms = 10;
  const CaseMutation of = mutations_in_case(
      "  scalar a, b, c\n  prove power: (a + b + c)^9/a == (a + b + c)^8*(a + b + c)/a\n  prove "
      "one: a == a\n",
      options);
  CHECK(of.undecided == Texts{"power"});
  CHECK(of.wrong.empty());
  const SiteMutants one = part(of, "one");
  CHECK(words(one, Fate::undecided).empty());
}

TEST_CASE("claims that are wrong without any change are named, and notice nothing") {
  const CaseMutation of = mutations_in_case("  scalar a\n  let k = 2\n  prove wrong: k*a == 3*a\n");
  CHECK(of.wrong == Texts{"wrong"});
  CHECK(words(part(of, "k"), Fate::noticed).empty());
}

TEST_CASE("no more errors are tried than are allowed, and how many are left is said") {
  MutationOptions options;
  options.most = 3;
  const SiteMutants twist = part(mutations_in_case(twist_of(bent), options), "twist");
  CHECK(twist.mutants.size() == 3);
  CHECK(twist.left_out > 10);
}

TEST_CASE("cases, claims and errors in the order of the text, the same each time", "[law]") {
  const auto all = [] {
    Texts result;
    for (const SiteMutants& site : mutations_in_case(twist_of(symmetric)).sites)
      for (const Mutant& m : site.mutants)
        result.push_back(std::to_string(m.place.begin) + m.change.error.words);
    return result;
  };
  const Texts first = all();
  CHECK(first.size() > 30);
  CHECK(first == all());
  const CaseMutation of = mutations_in_case(twist_of(symmetric));
  std::size_t before = 0;
  for (const SiteMutants& site : of.sites)
    for (const Mutant& m : site.mutants) {
      CHECK(m.place.begin >= before);
      before = m.place.begin;
    }
}

}  // namespace patchproof
