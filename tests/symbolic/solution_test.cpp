#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include <patchproof/symbolic/second_opinion.hpp>
#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

// The bilinearly blended Coons patch of a bicubic Bézier patch, and that patch.
struct Bicubic {
  Declarations declare;
  Term u = declare.parameter("u");
  Term v = declare.parameter("v");
  std::vector<Term> V;
  Term bezier;
  Term coons;

  Bicubic() {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        V.push_back(declare.point("V[" + std::to_string(i) + "," + std::to_string(j) + "]", 3));
      }
    }
    Term sum = 0 * V[0];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) sum = sum + bernstein(3, i, u) * bernstein(3, j, v) * at(i, j);
    }
    bezier = lambda({u, v}, sum);
    const auto b = [&](const Term& x, const Term& y) { return terms::at(bezier, {x, y}); };
    const Term zero = number(0);
    const Term one = number(1);
    coons =
        lambda({u, v}, (1 - v) * b(u, zero) + v * b(u, one) + (1 - u) * b(zero, v) + u * b(one, v) -
                           (1 - u) * (1 - v) * b(zero, zero) - u * (1 - v) * b(one, zero) -
                           (1 - u) * v * b(zero, one) - u * v * b(one, one));
  }

  const Term& at(int i, int j) const { return V[static_cast<std::size_t>(4 * i + j)]; }
};

SecondOpinion judged(const SolveGoal& goal, const std::vector<KnownValue>& solution,
                     const std::vector<SymbolPointer>& free = {}) {
  return second_opinion_on_solution(goal, solution, free, Limits{});
}

}  // namespace

TEST_CASE("the twist of the Coons patch determines the inner control point") {
  const Bicubic b;
  const auto twist = [&](const Term& patch) {
    return at(derivative(patch, {1, 1}), {number(0), number(0)});
  };
  const SolveGoal goal{terms::goal({equation(twist(b.bezier), twist(b.coons))}),
                       {b.at(1, 1).symbol()}};
  const Term corner = number(0);
  const auto slope = [&](Indices orders) {
    return at(derivative(b.coons, std::move(orders)), {corner, corner});
  };
  const Term right = b.at(0, 0) + slope({1, 0}) / 3 + slope({0, 1}) / 3 + slope({1, 1}) / 9;
  CHECK(judged(goal, {{b.at(1, 1).symbol(), right}}).answer == Answer::holds);
  const Term no_twist = b.at(0, 0) + slope({1, 0}) / 3 + slope({0, 1}) / 3;
  const SecondOpinion wrong = judged(goal, {{b.at(1, 1).symbol(), no_twist}});
  CHECK(wrong.answer == Answer::fails);
  CHECK(wrong.normal_form ==
        "-5*V[0,0].x + 3*V[0,1].x + 2*V[0,3].x + 3*V[1,0].x - 3*V[1,3].x + 2*V[3,0].x - "
        "3*V[3,1].x + V[3,3].x");
}

TEST_CASE("a patch with the boundary and the shape of the Coons patch is the Coons patch") {
  const Bicubic b;
  const SolveGoal goal{
      terms::goal({equation(at(b.bezier, {b.u, b.v}), at(b.coons, {b.u, b.v}))}),
      {b.at(1, 1).symbol(), b.at(1, 2).symbol(), b.at(2, 1).symbol(), b.at(2, 2).symbol()}};
  std::vector<KnownValue> solution;
  for (const int i : {1, 2}) {
    for (const int j : {1, 2}) {
      const auto weight = [](int k) { return number(k, 3); };
      const Term value =
          weight(3 - j) * b.at(i, 0) + weight(j) * b.at(i, 3) + weight(3 - i) * b.at(0, j) +
          weight(i) * b.at(3, j) - weight(3 - i) * weight(3 - j) * b.at(0, 0) -
          weight(i) * weight(3 - j) * b.at(3, 0) - weight(3 - i) * weight(j) * b.at(0, 3) -
          weight(i) * weight(j) * b.at(3, 3);
      solution.push_back({b.at(i, j).symbol(), value});
    }
  }
  CHECK(judged(goal, solution).answer == Answer::holds);
  std::swap(solution[0].value, solution[1].value);
  CHECK(judged(goal, solution).answer == Answer::fails);
}

TEST_CASE("a solution that leaves another one is not unique unless the rest is free") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term x = declare.scalar("x");
  const Term y = declare.scalar("y");
  const Term a = declare.scalar("a");
  const SolveGoal goal{terms::goal({equation(u * (x + y), a * u)}), {x.symbol(), y.symbol()}};
  const std::vector<KnownValue> special{{x.symbol(), a}, {y.symbol(), number(0)}};
  const SecondOpinion not_unique = judged(goal, special);
  CHECK(not_unique.answer == Answer::fails);
  CHECK(not_unique.reason == "the solution is not unique: another value of y is possible");
  CHECK(not_unique.normal_form.empty());
  const std::vector<KnownValue> general{{x.symbol(), a - y}};
  CHECK(judged(goal, general, {y.symbol()}).answer == Answer::holds);
  CHECK(judged(goal, special, {y.symbol()}).answer == Answer::fails);
  CHECK(judged(goal, {{x.symbol(), a - y}, {y.symbol(), y}}, {y.symbol()}).answer == Answer::holds);
}

TEST_CASE("equations that hold for all parameters determine more than one unknown") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term x = declare.scalar("x");
  const Term y = declare.scalar("y");
  const Term f = declare.scalar_function("f", {"u"});
  const SolveGoal goal{
      terms::goal({equation(x * at(f, {u}) + y * sin(u), 2 * at(f, {u}) + 3 * sin(u))}),
      {x.symbol(), y.symbol()}};
  CHECK(judged(goal, {{x.symbol(), number(2)}, {y.symbol(), number(3)}}).answer == Answer::holds);
  CHECK(judged(goal, {{x.symbol(), number(3)}, {y.symbol(), number(2)}}).answer == Answer::fails);
  const SolveGoal at_zero{
      terms::goal({equation(x * at(f, {number(0)}) + y * sin(number(0)), 2 * at(f, {number(0)}))}),
      {x.symbol(), y.symbol()}};
  CHECK(judged(at_zero, {{x.symbol(), number(2)}, {y.symbol(), number(3)}}).reason ==
        "the solution is not unique: another value of y is possible");
}

TEST_CASE("a system with symbolic coefficients is solved uniquely by Cramer's rule") {
  Declarations declare;
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  const Term c = declare.scalar("c");
  const Term d = declare.scalar("d");
  const Term x = declare.scalar("x");
  const Term y = declare.scalar("y");
  const SolveGoal goal{
      terms::goal({equation(a * x + b * y, number(1)), equation(c * x + d * y, number(0))}),
      {x.symbol(), y.symbol()}};
  const Term det = a * d - b * c;
  CHECK(judged(goal, {{x.symbol(), d / det}, {y.symbol(), -c / det}}).answer == Answer::holds);
  const SolveGoal dependent{
      terms::goal({equation(a * x + b * y, a), equation(c * a * x + c * b * y, c * a)}),
      {x.symbol(), y.symbol()}};
  CHECK(judged(dependent, {{x.symbol(), number(1)}, {y.symbol(), number(0)}}).reason ==
        "the solution is not unique: another value of y is possible");
}

TEST_CASE("equations that are not linear in the unknowns leave no answer") {
  Declarations declare;
  const Term x = declare.scalar("x");
  const Term f = declare.scalar_function("f", {"u"});
  const SolveGoal square{terms::goal({equation(x * x, number(0))}), {x.symbol()}};
  CHECK(judged(square, {{x.symbol(), number(0)}}).reason ==
        "an equation that is not linear in the unknowns");
  const SolveGoal inside{terms::goal({equation(at(f, {x}), at(f, {number(0)}))}), {x.symbol()}};
  CHECK(judged(inside, {{x.symbol(), number(0)}}).reason ==
        "an equation that is not linear in the unknowns");
}

TEST_CASE("an equation with roots that may be related leaves no answer") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term x = declare.scalar("x");
  const Term y = declare.scalar("y");
  // For positive u all x = y are solutions.
  const SolveGoal goal{terms::goal({equation(x * sqrt(u * u), y * u)}), {x.symbol(), y.symbol()}};
  CHECK(judged(goal, {{x.symbol(), number(0)}, {y.symbol(), number(0)}}).reason ==
        "an equation whose parts may be related");
}

TEST_CASE("a solution may rest on assumptions and earlier values") {
  Declarations declare;
  const Term x = declare.point("x", 2);
  const Term P = declare.point("P", 2);
  const Term Q = declare.point("Q", 2);
  SolveGoal goal{terms::goal({equation(2 * x, P + Q)}, {equation(P, Q)}), {x.symbol()}};
  CHECK(judged(goal, {{x.symbol(), Q}}).answer == Answer::holds);
  // The assumption may speak of the unknown; it still is what the equation determines.
  const SolveGoal about{terms::goal({equation(2 * x, 2 * P)}, {equation(x, P)}), {x.symbol()}};
  CHECK(judged(about, {{x.symbol(), P}}).answer == Answer::holds);
  goal.goal.assumptions.clear();
  CHECK(judged(goal, {{x.symbol(), Q}}).answer == Answer::fails);
  goal.goal.known = {{P.symbol(), 3 * Q}, {x.symbol(), Q}};
  CHECK(judged(goal, {{x.symbol(), 2 * Q}}).answer == Answer::holds);
}
