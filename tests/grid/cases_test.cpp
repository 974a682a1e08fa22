// What the grid proves of cases/ is compared with fractions in atoms, the other half of the kernel.
#include <catch2/catch.hpp>
#include <tests/cases/case_files.hpp>

#include <patchproof/decide/decide.hpp>
#include <patchproof/grid/grid_proof.hpp>
#include <patchproof/kernel/identity.hpp>
#include <patchproof/kernel/witness.hpp>
#include <patchproof/language/reader.hpp>

namespace patchproof {

namespace {

bool holds_in_fractions(const Goal& goal, Budget& budget) {
  Workspace workspace{budget};
  Evaluator evaluator{workspace, goal.known};
  Hypotheses hypotheses{goal, {}, evaluator, workspace};
  const Finding found = finding(goal, evaluator, hypotheses, workspace);
  return found.outcome == Finding::Outcome::holds && found.conditions.empty();
}

Goal goal_of(const std::string& statements) {
  const ReadFile read = read_cases(
      std::make_shared<const SourceText>(SourceText{"a.proof", "case c\n" + statements + "end\n"}),
      Limits{}, [](const std::string&) { return std::nullopt; });
  return std::get<IdentityClaim>(read.cases.at(0).claims.back().kind).goal;
}

}  // namespace

TEST_CASE("what the grid proves of the cases holds in fractions as well") {
  std::size_t proved = 0;
  for (const SourceText& file : test::sampled_case_files()) {
    const ReadFile read =
        read_cases(std::make_shared<const SourceText>(file), Limits{}, test::case_loader());
    for (const Case& given : read.cases)
      for (const Claim& claim : given.claims) {
        const auto* identity = std::get_if<IdentityClaim>(&claim.kind);
        if (identity == nullptr) continue;
        Budget budget{Limits{}};
        if (!holds_on_grid(identity->goal, budget)) continue;
        ++proved;
        INFO(given.name << "." << claim.label << claim.instance);
        CHECK(claim.expectation == Expectation::prove);
        CHECK(holds_in_fractions(identity->goal, budget));
      }
  }
  CHECK(proved >= (test::sanitized ? 100 : 3000));
}

TEST_CASE("formal parameters mean the same in functions inside of functions") {
  Budget budget{Limits{}};
  const auto holds = [&](const std::string& statement) {
    return holds_on_grid(goal_of("  param u, v in [0, 1]\n  scalar x, y\n"
                                 "  patch r(u,v) = diff(u^2*v, v)\n"
                                 "  let f(u) = u + diff(u^3, u)\n"
                                 "  derive X: x from x == 3*y gives 3*y\n  prove p: " +
                                 statement + "\n"),
                         budget);
  };
  CHECK(holds("r(1/2,v) == 1/4"));
  CHECK(!holds("r(1/2,v) == u^2"));
  CHECK(holds("r(v,u) == v^2"));
  CHECK(!holds("r(v,u) == u^2"));
  CHECK(holds("f(2*v) == 2*v + 12*v^2"));
  CHECK(holds("diff(diff(x^2*y^3, y)*y, x) == 6*x*y^3"));
  CHECK(holds("r_u(u,v) == 2*u"));
  CHECK(holds("diff(u^3*v^2, u, 2, v) == 12*u*v"));
  CHECK(!holds("diff(u^3*v^2, u, 2, v) == 6*u*v"));
}

TEST_CASE("products of points and of matrices on the grid") {
  Budget budget{Limits{}};
  const auto holds = [&](const std::string& statement) {
    return holds_on_grid(
        goal_of("  param u, v in [0, 1]\n  scalar a, b\n  matrix M = [1, u; v, 2]\n"
                "  matrix N = [a, b; 3, u]\n  prove p: " +
                statement + "\n"),
        budget);
  };
  CHECK(holds("cross((u, v, 1), (v, u, 2)) == (2*v - u, v - 2*u, u^2 - v^2)"));
  CHECK(!holds("cross((u, v, 1), (v, u, 2)) == (2*v + u, v + 2*u, u^2 + v^2)"));
  CHECK(!holds("cross((u, v, 1), (v, u, 2)) == (u - 2*v, 2*u - v, v^2 - u^2)"));
  CHECK(holds("dot((u, v, 1), (v, u, 2)) == 2*u*v + 2"));
  CHECK(holds("M*N == [a + 3*u, b + u^2; a*v + 6, b*v + 2*u]"));
  CHECK(!holds("M*N == [a + 3*u, a*v + 6; b + u^2, b*v + 2*u]"));
  CHECK(holds("transpose(M*N) == transpose(N)*transpose(M)"));
  CHECK(!holds("transpose(M*N) == transpose(M)*transpose(N)"));
  CHECK(holds("M[0,1] == u"));
  CHECK(!holds("M[1,0] == u"));
}

TEST_CASE("functions of functions of functions do not take for ever") {
  std::string statements = "  param u in [0, 1]\n  let f0(t) = t\n";
  for (int k = 1; k <= 60; ++k) {
    const std::string before = "f" + std::to_string(k - 1);
    statements +=
        "  let f" + std::to_string(k) + "(t) = " + before + "(0*t) + " + before + "(1 - t)\n";
  }
  const Goal goal = goal_of(statements + "  prove p: f60(u) == f60(u)\n");
  Budget budget{Limits{}};
  // Whether or not it is declined, there is an answer.
  holds_on_grid(goal, budget);
  SUCCEED();
}

TEST_CASE("where the sides differ there are values for which they do", "[law]") {
  const std::string declared =
      "  param u in [2, 5], v in [0, 1]\n  scalar a, b\n  point P, Q\n  point R in R^3\n"
      "  point V[0..3, 0..3]\n  patch r(u,v) = bezier(V)\n";
  for (const std::string statement :
       {"u == v", "a == b", "a*u + b == b", "P == Q", "u*P + (1 - u)*Q == P", "R == (1, 0, 0)*a",
        "R == R + (0, 0, 1)*(u - 2)*(u - 3)", "r(0,1) == V[0,1]", "diff(r, u, u, v, v) == 0*P",
        "r(v, u) == r(u, v)", "a^2 == b^2 + 1", "a*b == a + b",
        // Zero where the grid looks first: a third and a half of the ranges.
        "(u - 3)*P == 0*P", "(2*v - 1)*(u - 3)*(u - 2) == 0", "(u - 3)*(2*v - 1)*r(u,v) == 0*P"}) {
    INFO(statement);
    const Goal goal = goal_of(declared + "  prove p: " + statement + "\n");
    Budget budget{Limits{}};
    const GridAnswer answer = answer_on_grid(goal, budget);
    REQUIRE(answer.kind == GridAnswer::Kind::differs);
    const WitnessCheck check = checked(goal, Witness{answer.values}, budget);
    CHECK(check.consistent);
    CHECK(check.refutes);
  }
}

TEST_CASE("what is false is refuted, though its difference would take too long to write down") {
  // The edges of a Coons patch of degree 30, and one corner that is taken twice.
  const Goal goal = goal_of(
      "  param u, v in [0, 1]\n  point V[0..30, 0..30]\n  patch b(u,v) = bezier(V)\n"
      "  patch r(u,v) = coons(b(u,0), b(u,1), b(0,v), b(1,v))\n"
      "  patch q(u,v) = bezier(discrete_coons(V))\n  prove p: r(u,v) == q(u,v) + u*v*V[0,0]\n");
  const Decision decision = decided(goal, Limits{}, Engines::kernel);
  CHECK(decision.verdict == Verdict::refuted);
  CHECK(decision.residual.empty());
  CHECK(decision.witness.left != decision.witness.right);
}

TEST_CASE("goals with assumptions are not for the grid") {
  Budget budget{Limits{}};
  CHECK(holds_on_grid(goal_of("  scalar a, b\n  prove p: a + b == b + a\n"), budget));
  CHECK(!holds_on_grid(goal_of("  scalar a, b\n  assume h: a == b\n  prove p: a + b == b + a\n"),
                       budget));
  CHECK(!holds_on_grid(goal_of("  scalar a, b\n  param t in [a, b]\n  prove p: a + t == t + a\n"),
                       budget));
  CHECK(!holds_on_grid(goal_of("  scalar a\n  prove p: a/a == 1\n"), budget));
  CHECK(!holds_on_grid(goal_of("  scalar a\n  prove p: a^2 >= 0\n"), budget));
  CHECK(!holds_on_grid(goal_of("  scalar a, b\n  prove p: a*b == b*a + 1\n"), budget));
  CHECK(holds_on_grid(goal_of("  scalar a, b\n  prove p: a*b == b*a\n"), budget));
}

}  // namespace patchproof
