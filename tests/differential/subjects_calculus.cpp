#include "rewriting.hpp"
#include "subjects.hpp"

namespace patchproof::differential {
namespace {

/// F without what cannot be differentiated by the rules of this generator.
Node with_value_at(const Node& node, const std::string& variable, const Node& value) {
  return replaced(node,
                  [&](const std::string& name) { return name == variable ? value : nullptr; });
}

}  // namespace

Example integral_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  declare_scalars(draft, {"a", "b"});
  const Node f = random_scalar(choices, draft, 2);
  const Node g = random_scalar(choices, draft, 2);
  const Node low = choices.once_in(2) ? number(0) : scalar_name("a");
  const Node high = choices.once_in(2) ? number(1) : scalar_name("b");
  const Node whole = integral(f, "u", low, high);
  switch (choices.below(5)) {
    case 0:
      return example_of(choices, name, draft, {whole, whole}, holds);
    case 1: {
      const Node slope = derivative_written_out(f, "u", draft);
      return example_of(choices, name, draft,
                        {integral(slope, "u", low, high),
                         difference(with_value_at(f, "u", high), with_value_at(f, "u", low))},
                        holds);
    }
    case 2:
      return example_of(choices, name, draft,
                        {integral(integral(f, "v", number(0), number(1)), "u", low, high),
                         integral(integral(f, "u", low, high), "v", number(0), number(1))},
                        holds);
    case 3: {
      // By parts.
      const Node fg = product({f, g});
      const Node df = derivative_written_out(f, "u", draft);
      const Node dg = derivative_written_out(g, "u", draft);
      return example_of(choices, name, draft,
                        {integral(product({f, dg}), "u", low, high),
                         sum({with_value_at(fg, "u", high), negative(with_value_at(fg, "u", low)),
                              negative(integral(product({df, g}), "u", low, high))})},
                        holds);
    }
    default: {
      const long n = 1 + static_cast<long>(choices.below(5));
      const long i = static_cast<long>(choices.below(static_cast<std::uint64_t>(n) + 1));
      const Node basis = call("bernstein", {number(n), number(i), scalar_name("u")}, Type::scalar);
      return example_of(
          choices, name, draft,
          {product({number(n + 1), g, integral(basis, "u", number(0), number(1))}), g}, holds);
    }
  }
}

Example unknown_function_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  declare_scalars(draft, {"a"});
  if (choices.once_in(3)) {
    declare_unknown(draft, {"f", {"u"}, Type::scalar, 2, {}});
    declare_unknown(draft, {"g", {"v"}, Type::scalar, 1, {}});
  } else {
    declare_points(draft, {"P"});
    declare_unknown(draft, {"C", {"u"}, Type::point, 2, {}});
    if (choices.once_in(2)) declare_unknown(draft, {"r", {"u", "v"}, Type::point, 2, {}});
  }
  Node node = random_point(choices, draft, 2);
  if (choices.once_in(2)) {
    const std::string variable = choices.one_of(draft.parameters);
    node = call("diff", {node, scalar_name(variable)}, node->type);
  }
  return example_of(choices, name, draft, {node, node}, holds);
}

}  // namespace patchproof::differential
