#include <algorithm>

#include "rewriting.hpp"
#include "subjects.hpp"
#include "written_out.hpp"

namespace patchproof::differential {
namespace {

Rational random_fraction(Choices& choices, std::uint64_t largest) {
  const Integer below = 1 + choices.below(7);
  return Rational{Integer{choices.below(largest)}, below};
}

/// Something by which a false bound is false: from 1 down to very little.
Rational little(Choices& choices) {
  const Integer one = 1;
  switch (choices.below(5)) {
    case 0:
      return 1;
    case 1:
      return Rational{one, 1000};
    case 2:
      return Rational{one, one << 61};
    case 3:
      return Rational{one, (one << 127) - 1};
    default:
      return Rational{one, 2 + choices.below(100)};
  }
}

Rational scale_of(Choices& choices) {
  const Integer one = 1;
  const std::vector<Rational> scales{1,
                                     1,
                                     3,
                                     Rational{one, 7},
                                     Rational{(one << 61) - 1},
                                     Rational{(one << 64) + 1},
                                     Rational{one, one << 128}};
  return choices.one_of(scales);
}

/// The claim left REL right with parameters u, v in [0, 1], with sides perhaps exchanged.
Example claim_of(Choices& choices, const std::string& subject, bool holds, const Node& larger,
                 bool strict, const Node& smaller) {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  Example example{subject, draft.declarations, "", holds, {}, "", "", holds};
  const Node left = rewritten(choices, draft, larger, static_cast<unsigned>(choices.below(3)));
  example.claim = choices.once_in(2)
                      ? "p: " + case_text(smaller) + (strict ? " < " : " <= ") + case_text(left)
                      : "p: " + case_text(left) + (strict ? " > " : " >= ") + case_text(smaller);
  return example;
}

}  // namespace

/// A polynomial with its least value where it is known: scale*((x - p)^2*q + … ) + least.
Example inequality_example(Choices& choices, const std::string& name, bool holds) {
  const auto variable = [](const char* of) { return plain_variable(of); };
  // A place in the square, by small denominators: it may be a corner, on an edge or inside.
  const auto place = [&] {
    const Integer below = 1 + choices.below(6);
    return Rational{Integer{choices.below(static_cast<std::uint64_t>(below) + 1)}, below};
  };
  const auto square_around = [&](const char* of) {
    return power(sum(variable(of), plain_number(-place())), 2);
  };
  const PlainPolynomial in_u = square_around("u");
  const Rational constant = 1 + random_fraction(choices, 4);
  PlainPolynomial p = product(in_u, sum(plain_number(constant), variable("v")));
  if (choices.once_in(2)) p = sum(p, square_around("v"));
  const Rational scale = scale_of(choices);
  const Rational least = random_fraction(choices, 20) - 5;
  p = sum(product(plain_number(scale), p), plain_number(least));
  // True: at least the least value, or more than something smaller. False: more than it, or at
  // least something larger.
  const bool tight = choices.once_in(2);
  const bool strict = holds ? !tight : tight;
  const Rational shift = tight ? Rational{0} : little(choices);
  const Rational bound = holds ? Rational{least - shift} : Rational{least + shift};
  return claim_of(choices, name, holds, written_out(p), strict, rational(bound));
}

/// A polynomial by its Bernstein coefficients: nowhere below the least of them, and at the corners
/// equal to those at the corners.
Example bernstein_bound_example(Choices& choices, const std::string& name, bool holds) {
  const unsigned m = 1 + static_cast<unsigned>(choices.below(3));
  const unsigned n = static_cast<unsigned>(choices.below(3));
  const Rational scale = scale_of(choices);
  const PlainPolynomial u = plain_variable("u"), v = plain_variable("v");
  const auto opposite = [](const PlainPolynomial& x) {
    return sum(plain_number(1), product(plain_number(-1), x));
  };
  const auto basis = [&](unsigned degree, unsigned i, const PlainPolynomial& x) {
    Integer binomial = 1;
    for (unsigned k = 0; k < i; ++k) binomial = binomial * (degree - k) / (k + 1);
    return product(plain_number(Rational{binomial}),
                   product(power(x, i), power(opposite(x), degree - i)));
  };
  PlainPolynomial p;
  std::optional<Rational> least, least_at_corner;
  for (unsigned i = 0; i <= m; ++i)
    for (unsigned j = 0; j <= n; ++j) {
      const Rational coefficient = scale * (random_fraction(choices, 20) - 3);
      p = sum(p, product(plain_number(coefficient), product(basis(m, i, u), basis(n, j, v))));
      if (!least || coefficient < *least) least = coefficient;
      const bool corner = (i == 0 || i == m) && (j == 0 || j == n);
      if (corner && (!least_at_corner || coefficient < *least_at_corner))
        least_at_corner = coefficient;
    }
  const bool strict = choices.once_in(2);
  Rational bound = holds ? *least : *least_at_corner;
  if (holds == strict) bound += (holds ? Rational{-1} : Rational{1}) * little(choices);
  if (!holds && !strict) bound += little(choices);
  return claim_of(choices, name, holds, written_out(p), strict, rational(bound));
}

/// Unknowns that linear equations determine, and what they are.
Example derive_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u"});
  declare_scalars(draft, {"a", "b", "c"});
  const bool points = choices.once_in(2);
  if (points) declare_points(draft, {"P", "Q"});
  const std::size_t n = 1 + choices.below(3);
  // The unknowns are no words of the solution.
  const std::vector<std::string> names{"X", "Y", "Z"};
  const auto unknown = [&](std::size_t i) {
    return points ? point_name(names[i]) : scalar_name(names[i]);
  };
  Draft known = draft;
  known.scalars.erase(known.scalars.begin());
  std::vector<Node> solution;
  for (std::size_t i = 0; i < n; ++i)
    solution.push_back(points ? random_point(choices, known, 1) : random_scalar(choices, known, 2));
  // A unit triangular matrix times a permutation is invertible.
  std::vector<std::string> equations;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Node> left, right;
    for (std::size_t j = 0; j <= i; ++j) {
      const Node factor = random_number(choices);
      left.push_back(product({factor, unknown(j)}));
      right.push_back(product({factor, solution[j]}));
    }
    const Node rewritten_right =
        rewritten(choices, known, sum(right), static_cast<unsigned>(choices.below(4)));
    equations.push_back(case_text(sum(left)) + " == " + case_text(rewritten_right));
  }
  std::swap(equations.front(), equations[choices.below(n)]);
  std::string unknowns, values;
  const std::size_t wrong = choices.below(n);
  Node left = number(0), right = number(0);
  for (std::size_t i = 0; i < n; ++i) {
    Node given = rewritten(choices, known, solution[i], static_cast<unsigned>(choices.below(4)));
    if (!holds && i == wrong) {
      const Node more = product({random_number(choices), choices.one_of(known.scalars)});
      given = sum({given, points ? product({more, choices.one_of(known.points)}) : more});
    }
    if (i == wrong) {
      left = solution[i];
      right = given;
    }
    unknowns += (i == 0 ? "" : ", ") + names[i];
    values += (i == 0 ? "" : ", ") + case_text(given);
  }
  std::string all;
  for (const std::string& equation : equations) all += (all.empty() ? "" : ", ") + equation;
  Example example{name, draft.declarations, "", holds, draft.python};
  example.declarations.push_back((points ? "point " : "scalar ") + unknowns);
  example.claim = "derive p: " + unknowns + " from " + all + " gives " + values;
  example.python_left = python_text(left);
  example.python_right = python_text(right);
  example.meaning_holds = same(meaning(left, draft.environment), meaning(right, draft.environment));
  return example;
}

}  // namespace patchproof::differential
