#include "rewriting.hpp"
#include "subjects.hpp"

namespace patchproof::differential {
namespace {

Draft plane_draft() {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  declare_scalars(draft, {"a", "b", "c"});
  return draft;
}

Equation same_twice(const Node& node) { return {node, node}; }

}  // namespace

Example ring_example(Choices& choices, const std::string& name, bool holds) {
  const Draft draft = plane_draft();
  return example_of(choices, name, draft, same_twice(random_scalar(choices, draft, 3)), holds);
}

Example points_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = plane_draft();
  declare_points(draft, {"P", "Q"});
  declare_array(draft, "d", 2, choices.once_in(2) ? 2 : 0, Type::point);
  return example_of(choices, name, draft, same_twice(random_point(choices, draft, 3)), holds);
}

Example space_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u"});
  declare_points_in_space(draft, {"P", "Q", "R"});
  const auto point = [&] {
    return random_point(choices, draft, static_cast<unsigned>(choices.below(2)));
  };
  const Node a = point(), b = point(), c = point();
  const auto dot = [](const Node& x, const Node& y) { return call("dot", {x, y}, Type::scalar); };
  const auto cross = [](const Node& x, const Node& y) {
    return call("cross", {x, y}, Type::point);
  };
  const auto det = [](const Node& x, const Node& y, const Node& z) {
    return call("det", {x, y, z}, Type::scalar);
  };
  const std::vector<Equation> identities{
      {cross(a, b), negative(cross(b, a))},
      {dot(a, cross(b, c)), det(a, b, c)},
      {det(a, b, c), det(b, c, a)},
      {dot(a, cross(a, b)), number(0)},
      {cross(a, cross(b, c)), difference(product({dot(a, c), b}), product({dot(a, b), c}))},
      {dot(cross(a, b), cross(b, c)),
       difference(product({dot(a, b), dot(b, c)}), product({dot(a, c), dot(b, b)}))},
      {sum({cross(a, cross(b, c)), cross(b, cross(c, a))}), negative(cross(c, cross(a, b)))},
      {cross(sum({a, b}), c), sum({cross(a, c), cross(b, c)})},
      {dot(difference(a, b), sum({a, b})), difference(dot(a, a), dot(b, b))},
  };
  return example_of(choices, name, draft, choices.one_of(identities), holds);
}

Example matrix_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = plane_draft();
  const std::size_t n = 2 + choices.below(2);
  declare_array(draft, "m", n, n, Type::scalar);
  const Node m = matrix_name("m");
  const auto random_matrix = [&] {
    std::vector<Node> entries;
    for (std::size_t i = 0; i < n * n; ++i)
      entries.push_back(random_scalar(choices, draft, choices.once_in(4) ? 1 : 0));
    return matrix(n, entries);
  };
  const Node a = random_matrix();
  const Node b = choices.once_in(2) ? m : random_matrix();
  const Node c = random_matrix();
  const auto transpose = [](const Node& x) { return call("transpose", {x}, Type::matrix); };
  const auto det = [](const Node& x) { return call("det", {x}, Type::scalar); };
  const std::vector<Equation> identities{
      {product({product({a, b}), c}), product({a, product({b, c})})},
      {transpose(product({a, b})), product({transpose(b), transpose(a)})},
      {det(product({a, b})), product({det(a), det(b)})},
      {det(transpose(a)), det(a)},
      {product({a, sum({b, c})}), sum({product({a, b}), product({a, c})})},
      {product({difference(a, b), c}), difference(product({a, c}), product({b, c}))},
      {det(product({number(2), a})), product({number(n == 2 ? 4 : 8), det(a)})},
      {sum({transpose(a), transpose(b)}), transpose(sum({b, a}))},
  };
  return example_of(choices, name, draft, choices.one_of(identities), holds);
}

Example quotient_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = plane_draft();
  declare_points(draft, {"P", "Q"});
  assume_different(draft, scalar_name("a"), scalar_name("b"));
  draft.divisors.push_back(sum({number(1), scalar_name("u")}));
  draft.divisors.push_back(
      sum({number(2), negative(product({scalar_name("u"), scalar_name("v")}))}));
  const Node node =
      choices.once_in(2) ? random_point(choices, draft, 2) : random_scalar(choices, draft, 2);
  const Node divided = quotient(node, choices.one_of(draft.divisors));
  return example_of(choices, name, draft, same_twice(divided), holds);
}

Example assumption_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u"});
  declare_scalars(draft, {"a", "b"});
  const std::vector<Node> free = draft.scalars;
  declare_scalars(draft, {"x", "y"});
  declare_points(draft, {"P", "Q", "R"});
  const auto term = [&](const std::string& of) {
    return product({random_number(choices), scalar_name(of)});
  };
  // Linear equations of which each is solved for a name that the others do not contain.
  const Node x = choices.once_in(2) ? sum({term("a"), term("b")})
                                    : sum({term("b"), negative(random_number(choices))});
  const Node y = sum({term("a"), scalar_name("x")});
  const Node r = sum({product({random_number(choices), point_name("P")}),
                      product({random_number(choices), point_name("Q")})});
  const auto assume = [&](const Node& unknown, const Node& value) {
    const Node factor = random_number(choices);
    draft.declarations.push_back(
        "assume e" + unknown->text + ": " +
        (choices.once_in(2) ? case_text(unknown) + " == " + case_text(value)
                            : case_text(product({factor, difference(value, unknown)})) + " == 0"));
    draft.python.push_back(unknown->text + " = " + python_text(value));
    draft.environment.values[unknown->text] = meaning(value, draft.environment);
    draft.assumed.emplace_back(unknown->text, value);
  };
  assume(scalar_name("x"), x);
  if (choices.once_in(2)) assume(scalar_name("y"), y);
  if (choices.once_in(2)) assume(point_name("R"), r);
  const Node node =
      choices.once_in(2) ? random_point(choices, draft, 2) : random_scalar(choices, draft, 3);
  return example_of(choices, name, draft, same_twice(node), holds);
}

}  // namespace patchproof::differential
