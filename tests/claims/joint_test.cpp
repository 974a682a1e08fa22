#include <patchproof/claims/joint.hpp>

#include <catch2/catch.hpp>

#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

SymbolPointer symbol(const std::string& name, const Type& type, unsigned ordinal) {
  const auto role = type.is_function() ? Symbol::Role::function : Symbol::Role::parameter;
  return std::make_shared<const Symbol>(Symbol{name, role, type, 9, ordinal});
}

std::string text(const std::vector<Statement>& statements) {
  std::string result;
  for (const Statement& s : statements) {
    CHECK(s.relation == Relation::equal);
    result += to_text(s.left) + " == " + to_text(s.right) + "\n";
  }
  return result;
}

const Type curve = Type::function({"t"}, Type::point(3));
const Type patch = Type::function({"u", "v"}, Type::point(3));

}  // namespace

TEST_CASE("the joint of two curves is the equality of derivatives at their ends") {
  const Term p = symbol_term(symbol("p", curve, 1));
  const Term q = symbol_term(symbol("q", curve, 2));
  CHECK(text(joint_equations({p, 0, number_term(1), true}, {q, 0, number_term(0), false}, 2, {},
                             {})) == "p(1) == q(0)\np'(1) == q'(0)\np''(1) == q''(0)\n");
  CHECK(text(joint_equations({p, 0, number_term(1), true}, {q, 0, number_term(0), false}, 0, {},
                             {})) == "p(1) == q(0)\n");
}

TEST_CASE("a side that is left backwards has its odd derivatives negated") {
  const Term p = symbol_term(symbol("p", curve, 1));
  const Term q = symbol_term(symbol("q", curve, 2));
  CHECK(text(joint_equations({p, 0, number_term(0), false}, {q, 0, number_term(0), false}, 3, {},
                             {})) ==
        "p(0) == q(0)\n-p'(0) == q'(0)\np''(0) == q''(0)\n-p'''(0) == q'''(0)\n");
  CHECK(text(joint_equations({p, 0, number_term(1), true}, {q, 0, number_term(1), true}, 1, {},
                             {})) == "p(1) == q(1)\np'(1) == -q'(1)\n");
  CHECK(text(joint_equations({p, 0, number_term(0), false}, {q, 0, number_term(1), true}, 1, {},
                             {})) == "p(0) == q(1)\n-p'(0) == -q'(1)\n");
}

TEST_CASE("patches are compared along the edge, with derivatives across it") {
  const Term p = symbol_term(symbol("P", patch, 1));
  const Term r = symbol_term(symbol("R", patch, 2));
  const Term u = symbol_term(symbol("u", Type::scalar(), 3));
  CHECK(text(joint_equations({p, 1, number_term(1), true}, {r, 1, number_term(0), false}, 1, {u},
                             {})) == "P(u, 1) == R(u, 0)\nP_v(u, 1) == R_v(u, 0)\n");
  CHECK(text(joint_equations({p, 0, number_term(1), true}, {r, 1, number_term(0), false}, 1, {u},
                             {})) == "P(1, u) == R(u, 0)\nP_u(1, u) == R_v(u, 0)\n");
}

}  // namespace patchproof
