#include "subjects.hpp"
#include "written_out.hpp"

namespace patchproof::differential {
namespace {

const Node u = scalar_name("u");
const Node v = scalar_name("v");
const Node t = scalar_name("t");

/// The B-spline basis function i over one interval of knots, by the recursion of Cox and de Boor.
PlainPolynomial basis(const std::vector<Rational>& knots, std::size_t span, std::size_t i,
                      unsigned degree, const PlainPolynomial& x) {
  if (degree == 0) return plain_number(i == span ? 1 : 0);
  PlainPolynomial result;
  const auto add = [&](std::size_t of, const Rational& zero, const Rational& length) {
    // (x - zero)/length; an interval without length counts for nothing.
    if (length == 0) return;
    const PlainPolynomial factor = product(plain_number(1 / length), sum(x, plain_number(-zero)));
    result = sum(result, product(factor, basis(knots, span, of, degree - 1, x)));
  };
  add(i, knots[i], knots[i + degree] - knots[i]);
  add(i + 1, knots[i + degree + 1], knots[i + 1] - knots[i + degree + 1]);
  return result;
}

std::string listed(const std::vector<Rational>& knots, bool python) {
  std::string result;
  for (const Rational& knot : knots) {
    const std::string text = to_text(knot);
    result += (result.empty() ? "" : ", ") + (python ? "Rational('" + text + "')" : text);
  }
  return "[" + result + "]";
}

}  // namespace

/// The Coons patch of the edges of a Bézier patch, and the Bézier patch of its discrete Coons net.
Example discrete_coons_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  const std::size_t m = 1 + choices.below(3), n = 1 + choices.below(3);
  declare_array(draft, "b", m + 1, n + 1, Type::point);
  const Node net = matrix_name("b");
  const auto edge = [](const Node& x, const Node& y) {
    return apply(function_name("r"), {x, y}, Type::point);
  };
  declare_defined(draft, {"r", {"u", "v"}, Type::point, 2, {}},
                  call("bezier", {net}, Type::function));
  const Node coons = call("discrete_coons", {net}, Type::matrix);
  DeclaredFunction patch{"p", {"u", "v"}, Type::point, 2, {}};
  patch.alternatives = {
      {"", apply(call("bezier", {coons}, Type::function), {u, v}, Type::point)},
      {"", apply(call("bezier", {call("elevated_net", {coons, number(1), number(1)}, Type::matrix)},
                      Type::function),
                 {u, v}, Type::point)}};
  declare_defined(
      draft, patch,
      call("coons",
           {edge(u, number(0)), edge(u, number(1)), edge(number(0), v), edge(number(1), v)},
           Type::function));
  const Node application = [&] {
    Draft alone = draft;
    alone.functions = {patch};
    return random_application(choices, alone);
  }();
  const Node node =
      choices.once_in(3) ? sum({application, random_application(choices, draft)}) : application;
  return example_of(choices, name, draft, {node, node}, holds);
}

/// A segment of a B-spline curve over random knots, and what it is by the basis functions.
Example spline_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"t"});
  const auto degree = static_cast<unsigned>(1 + choices.below(3));
  const std::size_t intervals = 1 + choices.below(3);
  const bool clamped = choices.once_in(2);
  std::vector<Rational> knots{Rational{0}};
  const auto go_on = [&](bool stay) {
    knots.push_back(stay ? knots.back() : Rational{knots.back() + 1 + choices.below(3)});
  };
  for (unsigned k = 0; k < degree; ++k) go_on(clamped);
  for (std::size_t k = 0; k < intervals; ++k) go_on(false);
  for (unsigned k = 0; k < degree; ++k) go_on(clamped);
  const std::size_t count = knots.size() - degree - 1;
  declare_array(draft, "d", count, 0, Type::point);
  const std::string degree_text = std::to_string(degree);
  draft.declarations.push_back("spline T = bspline(d, degree " + degree_text + ", knots " +
                               listed(knots, false) + ")");
  draft.python.push_back("T = bspline(d, " + degree_text + ", " + listed(knots, true) + ")");

  PlainSpline spline;
  std::vector<Node> pieces;
  for (std::size_t k = 0; k < intervals; ++k) {
    const std::size_t span = degree + k;
    const Rational length = knots[span + 1] - knots[span];
    const auto over = [&](const std::string& parameter) {
      return sum(plain_number(knots[span]),
                 product(plain_number(length), plain_variable(parameter)));
    };
    std::vector<Node> terms;
    Value body = value_of_number(0);
    for (std::size_t i = span - degree; i <= span; ++i) {
      const Node point = element_of(draft, "d", i);
      terms.push_back(product({written_out(basis(knots, span, i, degree, over("t"))), point}));
      const Value factor{1, 1, {{basis(knots, span, i, degree, over(formal(0)))}}};
      body = plus(body, times(factor, meaning(point, draft.environment)));
    }
    spline.breaks.push_back(knots[span]);
    spline.pieces.push_back({1, body});
    pieces.push_back(sum(terms));
  }
  spline.breaks.push_back(knots[degree + intervals]);
  draft.environment.splines["T"] = spline;

  const std::size_t k = choices.below(intervals);
  const auto segment = [](const Node& of, std::size_t index) {
    return call("segment", {of, number(static_cast<long>(index))}, Type::function);
  };
  const Node whole = matrix_name("T");
  const Node middle = rational((spline.breaks[k] + spline.breaks[k + 1]) / 2);
  const Node inserted = call("insert_knot", {whole, middle}, Type::matrix);
  const Node elevated = call("elevate_degree", {whole}, Type::matrix);
  const Node twice = product({number(2), t});
  DeclaredFunction curve{"C", {"t"}, Type::point, 2, {}};
  curve.alternatives = {
      {"", pieces[k]},
      {"", apply(segment(inserted, k), {twice}, Type::point)},
      {"", apply(segment(inserted, k + 1), {difference(twice, number(1))}, Type::point)},
      {"", apply(segment(elevated, k), {t}, Type::point)}};
  declare_defined(draft, curve, segment(whole, k));
  const Node node =
      choices.once_in(3) ? random_point(choices, draft, 1) : random_application(choices, draft);
  return example_of(choices, name, draft, {node, node}, holds);
}

}  // namespace patchproof::differential
