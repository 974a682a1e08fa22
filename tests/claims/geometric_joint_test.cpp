#include <patchproof/claims/geometric_joint.hpp>

#include <catch2/catch.hpp>

#include <patchproof/term/plain_text.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

SymbolPointer symbol(const std::string& name, const Type& type, unsigned ordinal) {
  const auto role = type.is_function() ? Symbol::Role::function : Symbol::Role::parameter;
  return std::make_shared<const Symbol>(Symbol{name, role, type, 9, ordinal});
}

std::string text(const std::vector<Statement>& statements) {
  std::string result;
  for (const Statement& s : statements)
    result += to_text(s.left) + (s.relation == Relation::greater ? " > " : " == ") +
              to_text(s.right) + "\n";
  return result;
}

JointEdge edge(const std::string& name, const Type& type, unsigned ordinal, std::size_t crossing,
               bool at_end) {
  return {symbol_term(symbol(name, type, ordinal)), crossing, number_term(at_end ? 1 : 0), at_end};
}

const Type curve = Type::function({"t"}, Type::point(3));
const Type patch = Type::function({"u", "v"}, Type::point(3));
const Term u = symbol_term(symbol("u", Type::scalar(), 3));
const Term a = symbol_term(symbol("a", Type::scalar(), 4));
const Term b = symbol_term(symbol("b", Type::scalar(), 5));

}  // namespace

TEST_CASE("a G^1 joint says that the tangent planes agree and the second patch goes on") {
  const JointEdge p = edge("P", patch, 1, 1, true);
  const JointEdge r = edge("R", patch, 2, 1, false);
  CHECK(text(geometric_joint(p, r, 0, {u}, {}, {})) == "P(u, 1) == R(u, 0)\n");
  CHECK(text(geometric_joint(p, r, 1, {u}, {a, b}, {})) ==
        "P(u, 1) == R(u, 0)\nR_v(u, 0) == a*P_v(u, 1) + b*P_u(u, 1)\na > 0\n");
  CHECK(text(geometric_joint(p, r, 1, {u}, {}, {})) ==
        "P(u, 1) == R(u, 0)\n"
        "dot(cross(P_u(u, 1), P_v(u, 1)), R_v(u, 0)) == 0\n"
        "dot(cross(P_u(u, 1), P_v(u, 1)), cross(P_u(u, 1), R_v(u, 0))) > 0\n");
}

TEST_CASE("where a side is left backwards its derivatives across are turned round") {
  const JointEdge p = edge("P", patch, 1, 1, false);
  const JointEdge r = edge("R", patch, 2, 0, true);
  CHECK(text(geometric_joint(p, r, 2, {u}, {a, b, a, b}, {})) ==
        "P(u, 0) == R(1, u)\n-R_u(1, u) == a*(-P_v(u, 0)) + b*P_u(u, 0)\na > 0\n"
        "R_uu(1, u) == a*a*P_vv(u, 0) + 2*a*b*(-P_uv(u, 0)) + b*b*P_uu(u, 0) + a*(-P_v(u, 0)) + "
        "b*P_u(u, 0)\n");
}

TEST_CASE("curves have no direction along the edge") {
  const JointEdge p = edge("p", curve, 1, 0, true);
  const JointEdge q = edge("q", curve, 2, 0, false);
  CHECK(connecting_function_count(p, 2) == 2);
  CHECK(text(geometric_joint(p, q, 2, {}, {a, b}, {})) ==
        "p(1) == q(0)\nq'(0) == a*p'(1)\na > 0\nq''(0) == a*a*p''(1) + b*p'(1)\n");
  CHECK(text(geometric_joint(p, q, 1, {}, {}, {})) ==
        "p(1) == q(0)\ncross(p'(1), q'(0)) == (0, 0, 0)\ndot(p'(1), q'(0)) > 0\n");
}

TEST_CASE("show says how smooth a joint is, and what the next order lacks") {
  const auto shown = [](const std::string& statements) {
    std::string text;
    const auto results = results_of("case t\nparam u, v, t in [0, 1]\n" + statements + "end\n");
    for (const ShownResult& s : results.at(0).shown) text += s.value + "\n";
    return text;
  };
  CHECK(shown(R"~(
  curve p(t) = (t, t^2)
  curve same(t) = p(1 + t)
  curve faster(t) = p(1 + 2*t)
  curve other(t) = (1 + t, 1 + 2*t + 3*t^2)
  curve apart(t) = (2 + t, 1)
  curve back(t) = p(1 - t)
  curve unknown(t) in R^2 : C^2
  assume meet: unknown(0) == p(1), unknown'(0) == p'(1), unknown''(0) == p''(1)
  show joint of p at t = 1 and same at t = 0
  show joint of p at t = 1 and faster at t = 0
  show joint of p at t = 1 and other at t = 0
  show joint of p at t = 1 and apart at t = 0
  show joint of p at t = 1 and back at t = 0
  show joint of p at t = 1 and unknown at t = 0
)~") == "C^infinity: one polynomial, G^2\n"
        "C^0, G^2; not C^1: left - right = -1 in .x\n"
        "C^1, G^1; not C^2: left - right = -4 in .y; not G^2: left - right = 100\n"
        "not C^0: left - right = -1 in .x\n"
        "C^0, G^0; not C^1: left - right = 2 in .x; not G^1: no alpha > 0, as -5 is not positive\n"
        "C^2, G^2; C^3 is not decided: a derivative of order 3 of 'unknown', which is only assumed "
        "C^2\n");
  CHECK(shown(R"~(
  scalar k
  point a[0..1], b[0..1]
  patch P(u, v) = (u, v, u*v^3)
  patch R(u, v) = (u, 1 + v, u*(1 + 3*v + 3*v^2))
  patch any(u, v) = bezier([a[0], b[0] ; a[1], b[1]])
  patch wave(u, v) = (u, v, sin(v))
  patch next(u, v) = (u, 1 + v, sin(1 + v))
  show joint of P at v = 1 and R at v = 0
  show joint of any at v = 1 and any at v = 1
  show joint of wave at v = 1 and next at v = 0
)~") == "C^2, G^2; not C^3: left - right = 6*u in .z\n"
        "C^0; not C^1: left - right = -2*(1-u)*a[0] - 2*u*a[1] + 2*(1-u)*b[0] + 2*u*b[1]\n"
        "C^12 at least, G^2\n");
}

}  // namespace patchproof
