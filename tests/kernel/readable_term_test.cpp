#include <patchproof/kernel/readable_term.hpp>

#include <catch2/catch.hpp>
#include <optional>

#include <patchproof/decide/guard.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/term/plain_text.hpp>
#include <tests/derivation/random_terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

struct Written {
  std::optional<Term> term;
  /// The first component as the kernel writes values.
  std::string text;
};

Written written(const Term& term) {
  Written result;
  guarded(Limits{}, [&](Workspace& workspace) {
    Evaluator evaluator{workspace};
    const Value& value = evaluator.value(term);
    result.term = readable_term(value, term.type(), workspace);
    result.text = to_text(value.components.front(), workspace.atoms, workspace.budget);
    return Decision{};
  });
  return result;
}

std::string text(const Term& term) {
  const std::optional<Term> result = written(term).term;
  return result ? to_text(*result) : "none";
}

// Values have more spaces and brackets than terms.
std::string bare(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '(' || c == ')'; });
  return text;
}

struct Letters {
  Declarations declare;
  Term u = declare.parameter("u");
  Term v = declare.parameter("v");
  Term a = declare.scalar("a");
  Term b = declare.scalar("b");
  Term f = declare.scalar_function("f", {"t"});
  Term P = declare.point("P", 2);
  Term Q = declare.point("Q", 2);
  Term R = declare.point("R");
};

}  // namespace

TEST_CASE("a value written as a term is equal to the term it came from", "[law]") {
  const Letters l;
  int held = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    TermDrawer draw{seed, {l.u, l.a, l.b}, {l.f}, {l.P, l.Q}};
    const int kind = draw.below(4);
    const Term term = kind == 0 ? draw.point_of(3) : kind == 1 ? draw.matrix_of(3) : draw.scalar(3);
    const std::optional<Term> readable = written(term).term;
    INFO(seed << ": " << to_text(term));
    if (!readable) {
      CHECK(decided_equation(term, term) == "ERROR none");
      continue;
    }
    INFO(to_text(*readable));
    CHECK(decided_equation(term, *readable) == "holds");
    ++held;
  }
  CHECK(held >= 190);
}

TEST_CASE("terms have the order in which values are written", "[law]") {
  const Letters l;
  int compared = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    TermDrawer draw{seed, {l.u, l.v, l.a, l.b}};
    const Written result = written(draw.scalar(3));
    // Inside of functions numbers have another order.
    const bool has_functions = result.text.find("sin") != std::string::npos ||
                               result.text.find("cos") != std::string::npos;
    if (!result.term || has_functions) continue;
    INFO(seed);
    CHECK(bare(to_text(*result.term, 2000)) == bare(result.text));
    ++compared;
  }
  CHECK(compared >= 150);
}

TEST_CASE("polynomials are collected by the unknowns, powers of u and 1-u taken out") {
  const Letters l;
  CHECK(text(number(0) * l.a) == "0");
  CHECK(text(l.b + l.a) == "a + b");
  CHECK(text(l.a - l.u * l.a) == "(1 - u)*a");
  CHECK(text(2 * (l.u * l.b) - 2 * (power(l.u, 2) * l.b) + l.a) == "a + 2*u*(1 - u)*b");
  CHECK(text(l.a / 3 - l.b) == "1/3*a - b");
  CHECK(text((l.a + l.b) / (l.a - l.b)) == "(a + b)/(a - b)");
}

TEST_CASE("a point is a combination of points where it is one, else a tuple") {
  const Letters l;
  CHECK(text((1 - l.u) * l.P + l.u * l.Q) == "(1 - u)*P + u*Q");
  CHECK(text(l.P - l.P) == "(0, 0)");
  CHECK(text(l.P + point({number(1), l.a})) == "(P.x + 1, a + P.y)");
  CHECK(text(2 * l.R) == "2*R");
  CHECK(text(l.P / l.a) == "P/a");
}

TEST_CASE("a matrix has its entries") {
  const Letters l;
  CHECK(text(times(matrix(1, 2, {1 - l.u, l.u}), matrix(2, 1, {l.P, l.Q}))) == "[(1 - u)*P + u*Q]");
  CHECK(text(matrix(2, 1, {l.a + l.a, l.a - l.a})) == "[2*a ; 0]");
}
