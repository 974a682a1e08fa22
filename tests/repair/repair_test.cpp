#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include <tests/repair/repairs.hpp>

namespace patchproof {

namespace {

using Texts = std::vector<std::string>;

bool contains(const Texts& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

}  // namespace

TEST_CASE("a wrong sign is found, and all instances of a family agree", "[literature]") {
  // The third net of the discrete Coons patch is subtracted.
  const Repairs found = repairs_in_case(
      "  family m in 1..2, n in 1..3\n  point b[0..m, 0..n]\n"
      "  let b1 = discrete_ruled_v(b)\n  let b2 = discrete_ruled_u(b)\n"
      "  let b3 = discrete_bilinear(b)\n"
      "  refute net: bezier(b1 + b2 + b3) == bezier(b) on boundary\n");
  CHECK(found.instances == 6);
  CHECK(texts(found) == Texts{"bezier(b1 + b2 - b3) == bezier(b) on boundary"});
  REQUIRE(found.repairs.size() == 1);
  CHECK(found.repairs[0].evidence == Evidence::both_engines);
  CHECK(found.repairs[0].edits[0].what == "sign");
}

TEST_CASE("a change that is right for one instance only is no repair") {
  // 2 -> 1 is right for n = 1, 2 -> 3 for n = 3, and 2 itself for n = 2.
  const Repairs found =
      repairs_in_case("  family n in 1..3\n  scalar x\n  let a = n*x\n  refute one: a == 2*x\n");
  CHECK(found.instances == 2);
  CHECK(found.outcome == Repairs::Outcome::none);
  CHECK(found.reason == "no change of at most 2 places makes it true");
  CHECK(found.repairs.empty());
}

TEST_CASE("a degree is replaced by the other one", "[literature]") {
  const Repairs found = repairs_in_case(
      "  family m in 1..2, n in 3..3\n  param u, v in [0, 1]\n  point b[0..m, 0..n]\n"
      "  patch p(u, v) = bezier(b)\n"
      "  refute south: p(u,0) == sum(bernstein(n,i,u)*b[i,0], i in 0..m)\n");
  CHECK(texts(found) == Texts{"p(u,0) == sum(bernstein(m,i,u)*b[i,0], i in 0..m)"});
}

TEST_CASE("two changes are tried where no single one is enough", "[literature]") {
  const std::string ruled =
      "  param u, v in [0, 1]\n  curve Q0(u), Q1(u) : C^0\n"
      "  patch S2(u, v) = (1-v)*Q0(u) + v*Q1(u)\n"
      "  refute formula: S2(u,v) == (1-v)*Q0(u) + v*Q0(v)\n";
  const Repairs found = repairs_in_case(ruled);
  CHECK(texts(found) == Texts{"S2(u,v) == (1-v)*Q0(u) + v*Q1(u)"});
  REQUIRE(found.repairs.size() == 1);
  CHECK(found.repairs[0].edits.size() == 2);
  RepairOptions one_change;
  one_change.most_changes = 1;
  const Repairs none = repairs_in_case(ruled, one_change);
  CHECK(none.outcome == Repairs::Outcome::none);
  CHECK(none.reason == "no change of at most 1 place makes it true");
}

TEST_CASE("all repairs of the least size are listed, in the order of the text") {
  const Repairs found = repairs_in_case(
      "  scalar a, b\n  let s = a + b\n  let d = a - b\n  refute tie: s == a - b\n");
  CHECK(texts(found) == Texts{"d == a - b", "s == a + b"});
}

TEST_CASE("what holds under a condition comes after what holds without") {
  const Repairs found = repairs_in_case(
      "  scalar x, y\n  let q = x/x\n  let one = 1\n  refute p: y/y - q == one - x + x + 1\n");
  // The conditions are those of the quotients.
  REQUIRE(found.outcome == Repairs::Outcome::found);
  for (const Repair& repair : found.repairs) CHECK(repair.verdict == Verdict::proved_if);
  const Repairs mixed =
      repairs_in_case("  scalar x\n  let q = x/x\n  let one = 1\n  refute p: q == 2*one\n");
  REQUIRE(mixed.repairs.size() >= 1);
  CHECK(mixed.repairs.back().verdict == Verdict::proved_if);
  CHECK(mixed.repairs.back().conditions == Texts{"x != 0"});
  CHECK(std::is_sorted(mixed.repairs.begin(), mixed.repairs.end(),
                       [](const Repair& a, const Repair& b) {
                         return a.verdict == Verdict::proved && b.verdict != Verdict::proved;
                       }));
}

TEST_CASE("entries of a literal matrix are computed, however many are wrong", "[literature]") {
  const Repairs found = repairs_in_case(
      "  matrix M = [(10,5), (10,-5) ; (30,25), (30,45)]\n"
      "  refute map: transpose(M) == [(10,4), (31,25) ; (11,-5), (30,0)]\n");
  CHECK(texts(found) == Texts{"transpose(M) == [(10,5), (30,25) ; (10,-5), (30,45)]"});
  REQUIRE(found.repairs.size() == 1);
  CHECK(found.repairs[0].edits.size() == 4);
  CHECK(found.repairs[0].edits[0].what == "entry");
}

TEST_CASE("an entry may become an expression, and an expression is changed like any other") {
  CHECK(texts(repairs_in_case("  param u in [0, 1]\n  curve C(u) = (u, u^2 - 1)\n"
                              "  refute value: C(u) == (u, 5)\n")) ==
        Texts{"C(u) == (u, -(1-u)*(u + 1))"});
  CHECK(texts(repairs_in_case("  param u in [0, 1]\n  curve C(u) = (u, u^2 - 1)\n"
                              "  refute value: C(u) == (u, u^2 + 1)\n")) ==
        Texts{"C(u) == (u, u^2 - 1)"});
}

TEST_CASE("a matrix is transposed, a curve reversed, arguments exchanged") {
  const Repairs transposed = repairs_in_case(
      "  scalar a[0..1, 0..1], b[0..1, 0..1]\n  let c = b\n"
      "  refute product: transpose(a*c) == transpose(c)*a\n");
  CHECK(texts(transposed) == Texts{"transpose(transpose(a)*c) == transpose(c)*a",
                                   "transpose(a*c) == transpose(c)*transpose(a)"});
  const Repairs reversed = repairs_in_case(
      "  param u in [0, 1]\n  point b[0..2]\n"
      "  refute back: bezier([b[2], b[1], b[0]])(u) == bezier(b)(u)\n");
  CHECK(contains(texts(reversed), "bezier([b[2], b[1], b[0]])(1-u) == bezier(b)(u)"));
  CHECK(contains(texts(reversed), "bezier([b[2], b[1], b[0]])(u) == bezier(b)(1-u)"));
  const Repairs exchanged = repairs_in_case(
      "  param u, v in [0, 1]\n  curve C1(u), C2(u) : C^0\n"
      "  refute south: ruled(C2, C1)(u, 0) == C1(u)\n");
  CHECK(contains(texts(exchanged), "ruled(C1, C2)(u, 0) == C1(u)"));
}

TEST_CASE("a curve that runs the wrong way is named, as one change") {
  const std::string curves =
      "  param u, v in [0, 1]\n  curve Q0(u) = (3*u, 0), Q1(u) = (3*(1-u), 2)\n"
      "  curve P0(v) = (0, 2*v), P1(v) = (3, 2*v)\n";
  const Repairs corners = repairs_in_case(
      curves +
      "  refute closed: Q0(0) == P0(0), Q0(1) == P1(0), Q1(0) == P0(1), Q1(1) == P1(1)\n");
  REQUIRE(corners.repairs.size() == 1);
  CHECK(corners.repairs[0].reversed == "Q1");
  CHECK(corners.repairs[0].size() == 1);
  CHECK(texts(corners) ==
        Texts{"Q0(0) == P0(0), Q0(1) == P1(0), Q1(1) == P0(1), Q1(0) == P1(1)"});
  const Repairs edges = repairs_in_case(
      curves + "  refute north: coons(Q0, Q1, P0, P1)(u,1) == Q1(u), Q1(0) == P0(1)\n");
  REQUIRE(edges.repairs.size() == 1);
  CHECK(texts(edges) == Texts{"coons(Q0, Q1(1-u), P0, P1)(u,1) == Q1(1-u), Q1(1) == P0(1)"});
  // A derivative would change its sign: such a curve is left alone.
  const Repairs slopes =
      repairs_in_case(curves + "  refute slope: Q1'(0) == (3, 0), Q1(0) == P0(1)\n");
  for (const Repair& repair : slopes.repairs) CHECK(repair.reversed.empty());
}

TEST_CASE("a running index of the claim is a name like others") {
  const Repairs found = repairs_in_case(
      "  family n in 2..3\n  point b[0..n, 0..n]\n  net c[i,j] = b[i,j] for i in 0..n, j in 0..n\n"
      "  refute entry: c[i,j] == b[i,i] for i in 0..n, j in 0..n\n");
  CHECK(contains(texts(found), "c[i,j] == b[i,j]"));
}

TEST_CASE("each false part of a statement is repaired by itself") {
  const Repairs found = repairs_in_case(
      "  scalar a, b\n  let s = a + b\n  let d = a - b\n"
      "  refute both: s + d == 3*a, s == s, s*d == a^2 + b^2\n");
  CHECK(contains(texts(found), "s + d == 2*a, s == s, s*d == a^2 - b^2"));
  for (const Repair& repair : found.repairs) CHECK(repair.edits.size() == 2);
}

TEST_CASE("what would say nothing is not offered") {
  CHECK(repairs_in_case("  scalar a, b\n  refute one: a - b == 0\n").repairs.empty());
  CHECK(repairs_in_case("  scalar a, b\n  refute one: a == b\n").repairs.empty());
  CHECK(repairs_in_case("  refute one: 1 == 2\n").repairs.empty());
  // A zero in front would make anything true.
  CHECK(repairs_in_case("  scalar a\n  refute one: 2*a^5 == 0\n").repairs.empty());
}

TEST_CASE("values that were derived may be used") {
  const Repairs found = repairs_in_case(
      "  point x, p, q\n  derive mid: x from 2*x == p + q gives 1/2*(p + q)\n"
      "  refute value: 2*x - q == -p using mid\n");
  CHECK(contains(texts(found), "2*x - q == p"));
}

TEST_CASE("a claim that is true under contradictory assumptions only is no repair") {
  const Repairs found =
      repairs_in_case("  scalar a, b, c\n  assume sum: a + b == c\n  refute one: a - b == c\n");
  CHECK(texts(found) == Texts{"a + b == c"});
  CHECK(repairs_in_case("  scalar a\n  assume bad: a == 1, a == 2\n  prove one: a == 3\n")
            .printed.empty());
}

TEST_CASE("only equations are repaired", "[reject]") {
  const Repairs order = repairs_in_case("  scalar a\n  refute one: a <= a - 1\n");
  CHECK(order.outcome == Repairs::Outcome::not_tried);
  CHECK(order.reason == "only equations are repaired");
  const Repairs joint = repairs_in_case(
      "  param u, v in [0, 1]\n  patch P(u, v) = (u, v)\n  patch R(u, v) = (u, v)\n"
      "  refute one: C^1 joint of P at v = 1 and R at v = 0\n");
  CHECK(joint.outcome == Repairs::Outcome::not_tried);
  CHECK(joint.reason == "only equations are repaired");
}

TEST_CASE("a minimum is not repaired, equations of integrals are") {
  const std::string functional =
      "  param t in [0, 1]\n  scalar a, q[0..2]\n  curve p(t) = bezier(q)\n"
      "  let L(q) = integral(q_t^2, t in [0, 1])\n";
  const Repairs minimum = repairs_in_case(
      functional + "  refute one: t^2 minimizes L(p) over p where p(0) == 0, p(1) == 1\n");
  CHECK(minimum.outcome == Repairs::Outcome::not_tried);
  CHECK(minimum.reason == "only equations are repaired");
  const Repairs equation =
      repairs_in_case(functional + "  refute one: integral(s^2, s in [0, a]) == a^3/2\n");
  CHECK(contains(texts(equation), "integral(s^2, s in [0, a]) == a^3/3"));
  CHECK(contains(texts(equation), "integral(s^1, s in [0, a]) == a^2/2") == false);
}

TEST_CASE("of a derivation, check shows what is derived", "[reject]") {
  const Repairs found = repairs_in_case("  scalar x\n  derive one: x from x == 1 gives 2\n");
  CHECK(found.printed == "derive one: x from x == 1 gives 2");
  CHECK(found.outcome == Repairs::Outcome::not_tried);
  CHECK(found.reason == "'check' shows what is derived instead");
}

TEST_CASE("a high exponent has neighbours too") {
  CHECK(contains(texts(repairs_in_case("  scalar a\n  let p = a^12\n  refute one: p == a^13\n")),
                 "p == a^12"));
}

TEST_CASE("a statement of thousands of characters is not tried", "[reject]") {
  std::string long_sum = "a";
  while (long_sum.size() < 4000) long_sum += " + a";
  const Repairs found = repairs_in_case("  scalar a\n  refute one: " + long_sum + " == a\n");
  CHECK(found.outcome == Repairs::Outcome::not_tried);
  CHECK(found.reason == "the statement is longer than 4000 characters");
}

TEST_CASE("the search stops at its limit and says so", "[reject]") {
  RepairOptions few;
  few.most_candidates = 10;
  const Repairs stopped =
      repairs_in_case("  scalar a, b\n  refute one: a^5 == b^5 + a*b + 3\n", few);
  CHECK(stopped.outcome == Repairs::Outcome::stopped);
  CHECK(stopped.reason == "stopped after 10 changed statements");
  CHECK(stopped.tried == 10);
}

TEST_CASE("a changed sign or coefficient of a true equation is found again", "[law]") {
  std::mt19937 random{20261};
  for (int round = 0; round < 20; ++round) {
    const auto pick = [&](int low, int high) {
      return std::uniform_int_distribution<int>{low, high}(random);
    };
    std::vector<int> factors;
    std::vector<std::string> signs;
    for (int k = 0; k < 4; ++k) {
      factors.push_back(pick(2, 9));
      signs.emplace_back(pick(0, 1) == 0 ? " + " : " - ");
    }
    const Texts names{"a*b", "b^2", "c", "a"};
    const auto sum = [&] {
      std::string text = "a^3";
      for (std::size_t k = 0; k < names.size(); ++k)
        text += signs[k] + std::to_string(factors[k]) + "*" + names[k];
      return text;
    };
    const std::string right = sum();
    const auto wrong_place = static_cast<std::size_t>(pick(0, 3));
    if (pick(0, 1) == 0)
      signs[wrong_place] = signs[wrong_place] == " + " ? " - " : " + ";
    else
      ++factors[wrong_place];
    const std::string wrong = sum();
    const Repairs found = repairs_in_case("  scalar a, b, c\n  let f = " + right +
                                          "\n  refute one: f == " + wrong + "\n");
    INFO("f == " << wrong);
    CHECK(contains(texts(found), "f == " + right));
    for (const Repair& repair : found.repairs) CHECK(repair.edits.size() == 1);
  }
}

}  // namespace patchproof
