#include "rewriting.hpp"
#include "subjects.hpp"

namespace patchproof::differential {

/// A division by something that vanishes somewhere, with no assumption about it: what is true is
/// true only under a condition.
Example condition_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  declare_scalars(draft, {"a", "b", "c"});
  declare_points(draft, {"P", "Q"});
  const Node a = scalar_name("a"), b = scalar_name("b"), u = scalar_name("u");
  const std::vector<Node> vanishing{difference(a, b),
                                    a,
                                    u,
                                    difference(product({number(2), u}), number(1)),
                                    difference(u, scalar_name("v")),
                                    sum({product({a, b}), number(1)}),
                                    difference(power(a, 2), power(b, 2)),
                                    difference(u, number("1/18446744073709551617"))};
  draft.divisors.push_back(choices.one_of(vanishing));
  const Node by = draft.divisors.front();
  const Node node =
      choices.once_in(2) ? random_point(choices, draft, 1) : random_scalar(choices, draft, 2);
  // The divisor is there in any case, and perhaps on one side only.
  const Node cancelled = quotient(product({by, node}), by);
  const Equation equation = choices.once_in(2) ? Equation{quotient(node, by), quotient(node, by)}
                                               : Equation{cancelled, node};
  Example example = example_of(choices, name, draft, equation, holds);
  example.conditional = true;
  return example;
}

/// What follows from linear inequalities: sums of what is not negative, with factors that are not.
Example linear_inequality_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u"});
  declare_scalars(draft, {"a", "b", "c"});
  const Node a = scalar_name("a"), b = scalar_name("b"), c = scalar_name("c");
  draft.declarations.push_back("assume order: 0 <= a, a < b, b <= c");
  // These take every value, one without the others, at least 0; the second is never 0.
  const std::vector<Node> free{a, difference(b, a), difference(c, b), scalar_name("u")};
  const std::size_t wrong = choices.below(3);
  std::vector<Node> terms;
  bool positive = false;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const bool is_wrong = !holds && i == wrong;
    if (!is_wrong && choices.once_in(3)) continue;
    const Node term = product({random_number(choices), free[i]});
    terms.push_back(is_wrong ? negative(term) : term);
    positive = positive || i == 1;
  }
  if (choices.once_in(2)) {
    terms.push_back(random_number(choices));
    positive = true;
  }
  const Node left = rewritten(choices, draft, sum(terms), static_cast<unsigned>(choices.below(5)));
  const bool strict = positive && choices.once_in(2);
  Example example{name, draft.declarations, "", holds, {}, "", "", holds};
  example.claim = "p: " + case_text(left) + (strict ? " > 0" : " >= 0");
  return example;
}

}  // namespace patchproof::differential
