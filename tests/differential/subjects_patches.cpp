#include "subjects.hpp"

namespace patchproof::differential {
namespace {

const Node u = scalar_name("u");
const Node v = scalar_name("v");
const Node zero = number(0);
const Node one = number(1);

Node between(const Node& a, const Node& b, const Node& t) {
  return sum({product({difference(one, t), a}), product({t, b})});
}

Node at(const std::string& curve, const Node& parameter, Type type = Type::point) {
  return apply(function_name(curve), {parameter}, type);
}

Node slope(const std::string& curve, const Node& parameter) {
  return apply(function_name(curve), {parameter}, Type::point, "u");
}

/// Cubic with values p, q and slopes m, n, by powers.
Node hermite(const Node& p, const Node& q, const Node& m, const Node& n, const Node& t) {
  const Node square = power(t, 2), cube = power(t, 3);
  const Node quadratic =
      sum({product({number(3), difference(q, p)}), product({number(-2), m}), negative(n)});
  const Node cubic = sum({product({number(2), difference(p, q)}), m, n});
  return sum({p, product({t, m}), product({square, quadratic}), product({cube, cubic})});
}

/// The same by its Bézier points.
Node hermite_by_bezier(const Node& p, const Node& q, const Node& m, const Node& n, const Node& t) {
  const Node third = quotient(one, number(3));
  const Node net =
      matrix(1, {p, sum({p, product({third, m})}), difference(q, product({third, n})), q});
  return apply(call("bezier", {net}, Type::function), {t}, Type::point);
}

/// Unknown curves in u and in v, of the names given.
void declare_curves(Draft& draft, const std::vector<std::string>& in_u,
                    const std::vector<std::string>& in_v) {
  for (const std::string& name : in_u) declare_unknown(draft, {name, {"u"}, Type::point, 1, {}});
  for (const std::string& name : in_v) declare_unknown(draft, {name, {"v"}, Type::point, 1, {}});
}

/// A claim about one of the derivatives of the function declared last.
Example about_last(Choices& choices, const std::string& name, Draft draft, bool holds) {
  std::swap(draft.functions.front(), draft.functions.back());
  Draft alone = draft;
  alone.functions.resize(1);
  const Node application = random_application(choices, alone);
  const Node node = choices.once_in(3) ? sum({product({random_number(choices), application}),
                                              random_application(choices, draft)})
                                       : application;
  return example_of(choices, name, draft, {node, node}, holds);
}

Draft square_draft() {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  return draft;
}

}  // namespace

Example coons_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = square_draft();
  declare_curves(draft, {"C1", "C2"}, {"D1", "D2"});
  const std::vector<Node> boundary{function_name("C1"), function_name("C2"), function_name("D1"),
                                   function_name("D2")};
  if (choices.once_in(3)) {
    // Blended with 3t^2 - 2t^3 and what is left to 1.
    const auto step = [](const Node& t) {
      return product({power(t, 2), difference(number(3), product({number(2), t}))});
    };
    const Node f = step(u), g = step(v);
    DeclaredFunction blended{"r", {"u", "v"}, Type::point, 2, {}};
    const Node of_corners = between(between(at("C1", zero), at("C1", one), f),
                                    between(at("C2", zero), at("C2", one), f), g);
    blended.alternatives = {
        {"", sum({between(at("C1", u), at("C2", u), g), between(at("D1", v), at("D2", v), f),
                  negative(of_corners)})}};
    declare_defined(draft, blended, call("partially_bicubic_coons", boundary, Type::function));
    return about_last(choices, name, draft, holds);
  }
  const Node corners = between(between(at("C1", zero), at("C1", one), u),
                               between(at("C2", zero), at("C2", one), u), v);
  const Node across_v = between(at("C1", u), at("C2", u), v);
  const Node across_u = between(at("D1", v), at("D2", v), u);
  DeclaredFunction patch{"r", {"u", "v"}, Type::point, 2, {}};
  patch.alternatives = {
      {"", sum({across_v, across_u, negative(corners)})},
      {"", sum({across_v,
                product({difference(one, u),
                         difference(at("D1", v), between(at("C1", zero), at("C2", zero), v))}),
                product({u, difference(at("D2", v), between(at("C1", one), at("C2", one), v))})})},
      {"u", sum({between(slope("C1", u), slope("C2", u), v), at("D2", v), negative(at("D1", v)),
                 between(difference(at("C1", zero), at("C1", one)),
                         difference(at("C2", zero), at("C2", one)), v)})},
  };
  declare_defined(
      draft, patch,
      call("coons",
           {function_name("C1"), function_name("C2"), function_name("D1"), function_name("D2")},
           Type::function));
  return about_last(choices, name, draft, holds);
}

Example ruled_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = square_draft();
  DeclaredFunction patch{"r", {"u", "v"}, Type::point, 2, {}};
  const auto pair = [](const std::string& construction, const std::string& a,
                       const std::string& b) {
    return call(construction, {function_name(a), function_name(b)}, Type::function);
  };
  switch (choices.below(5)) {
    case 0:
      declare_curves(draft, {"C", "D"}, {});
      patch.alternatives = {
          {"", between(at("C", u), at("D", u), v)},
          {"", sum({at("C", u), product({v, difference(at("D", u), at("C", u))})})},
          {"v", difference(at("D", u), at("C", u))},
          {"u", between(slope("C", u), slope("D", u), v)}};
      declare_defined(draft, patch, pair("ruled", "C", "D"));
      break;
    case 1:
      declare_curves(draft, {}, {"C", "D"});
      patch.alternatives = {{"", between(at("C", v), at("D", v), u)},
                            {"u", difference(at("D", v), at("C", v))}};
      declare_defined(draft, patch, pair("ruled_in_u", "C", "D"));
      break;
    case 2: {
      declare_scalars(draft, {"a", "b"});
      assume_different(draft, scalar_name("a"), scalar_name("b"));
      declare_curves(draft, {"C", "D"}, {});
      const Node length = difference(scalar_name("b"), scalar_name("a"));
      const Node from_a = quotient(difference(v, scalar_name("a")), length);
      patch.alternatives = {
          {"", between(at("C", u), at("D", u), from_a)},
          {"v", quotient(difference(at("D", u), at("C", u)), length)},
          {"", quotient(sum({product({difference(scalar_name("b"), v), at("C", u)}),
                             product({difference(v, scalar_name("a")), at("D", u)})}),
                        length)}};
      declare_defined(
          draft, patch,
          call("ruled_over",
               {function_name("C"), function_name("D"), scalar_name("a"), scalar_name("b")},
               Type::function));
      break;
    }
    case 3:
      declare_curves(draft, {"C"}, {"D"});
      patch.alternatives = {{"", sum({at("C", u), at("D", v)})}, {"u", slope("C", u)}};
      declare_defined(draft, patch, pair("translation_surface", "C", "D"));
      break;
    default: {
      declare_points(draft, {"P", "Q", "R", "S"});
      const Node p = point_name("P"), q = point_name("Q"), r = point_name("R"), s = point_name("S");
      patch.alternatives = {{"", between(between(p, q, u), between(r, s, u), v)},
                            {"", apply(call("bezier", {matrix(2, {p, r, q, s})}, Type::function),
                                       {u, v}, Type::point)},
                            {"u", between(difference(q, p), difference(s, r), v)},
                            {"uv", sum({p, negative(q), negative(r), s})},
                            {"uu", product({zero, p})}};
      declare_defined(draft, patch, call("bilinear", {p, q, r, s}, Type::function));
    }
  }
  return about_last(choices, name, draft, holds);
}

Example hermite_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = square_draft();
  if (choices.once_in(2)) {
    declare_points(draft, {"P", "Q", "m", "n"});
    const Node p = point_name("P"), q = point_name("Q"), m = point_name("m"), n = point_name("n");
    DeclaredFunction curve{"C", {"u"}, Type::point, 2, {}};
    curve.alternatives = {{"", hermite(p, q, m, n, u)},
                          {"", hermite_by_bezier(p, q, m, n, u)},
                          {"", hermite(q, p, negative(n), negative(m), difference(one, u))}};
    declare_defined(draft, curve, call("hermite_curve", {p, q, m, n}, Type::function));
    return about_last(choices, name, draft, holds);
  }
  declare_curves(draft, {"C", "D", "S", "T"}, {});
  DeclaredFunction patch{"r", {"u", "v"}, Type::point, 2, {}};
  patch.alternatives = {
      {"", hermite(at("C", u), at("D", u), at("S", u), at("T", u), v)},
      {"", hermite_by_bezier(at("C", u), at("D", u), at("S", u), at("T", u), v)},
      {"u", hermite(slope("C", u), slope("D", u), slope("S", u), slope("T", u), v)}};
  declare_defined(
      draft, patch,
      call("hermite_loft",
           {function_name("C"), function_name("D"), function_name("S"), function_name("T")},
           Type::function));
  return about_last(choices, name, draft, holds);
}

Example bicubic_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft = square_draft();
  DeclaredFunction patch{"r", {"u", "v"}, Type::point, 2, {}};
  const bool ferguson = choices.once_in(2);
  // Row k of the matrix of 16 vectors; what a Ferguson patch does not have is 0.
  const auto vector = [&](std::size_t i, std::size_t j) {
    if (!ferguson) return element_of(draft, "G", i, j);
    if (i >= 2 && j >= 2) return zero;
    return element_of(draft, i >= 2 ? "A" : j >= 2 ? "B" : "P", i % 2, j % 2);
  };
  if (ferguson)
    for (const std::string array : {"P", "A", "B"}) declare_array(draft, array, 2, 2, Type::point);
  else
    declare_array(draft, "G", 4, 4, Type::point);
  std::vector<Node> rows, entries;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool last = ferguson && i >= 2;
    const Node cubic =
        hermite(vector(i, 0), vector(i, 1), last ? product({zero, vector(0, 0)}) : vector(i, 2),
                last ? product({zero, vector(0, 0)}) : vector(i, 3), v);
    rows.push_back(cubic);
    for (std::size_t j = 0; j < 4; ++j) entries.push_back(vector(i, j));
  }
  patch.alternatives = {{"", hermite(rows[0], rows[1], rows[2], rows[3], u)},
                        {"", hermite_by_bezier(rows[0], rows[1], rows[2], rows[3], u)},
                        {"", apply(call("bicubic_hermite", {matrix(4, entries)}, Type::function),
                                   {u, v}, Type::point)}};
  declare_defined(
      draft, patch,
      ferguson
          ? call("ferguson", {matrix_name("P"), matrix_name("A"), matrix_name("B")}, Type::function)
          : call("bicubic_hermite", {matrix_name("G")}, Type::function));
  return about_last(choices, name, draft, holds);
}

}  // namespace patchproof::differential
