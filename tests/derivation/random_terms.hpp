#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include <patchproof/decide/decide.hpp>
#include <tests/symbolic/terms.hpp>

/// Terms drawn at random, as derivations have them: with zeros, ones and signs to be tidied.
namespace patchproof::terms {

/// Draws scalars, points in R^2 and 2 x 2 matrices; the same seed draws the same terms.
class TermDrawer {
 public:
  /// `functions` are unknown scalar functions of one parameter.
  TermDrawer(unsigned seed, std::vector<Term> letters, std::vector<Term> functions = {},
             std::vector<Term> points = {})
      : random_{seed},
        letters_{std::move(letters)},
        functions_{std::move(functions)},
        points_{std::move(points)} {}

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Term scalar(int depth) {
    if (depth == 0) return leaf();
    const auto inner = [&] { return scalar(depth - 1); };
    switch (below(15)) {
      case 0:
      case 1:
        return inner() + inner();
      case 2:
        return inner() - inner();
      case 3:
      case 4:
        return inner() * inner();
      case 5:
        return -inner();
      case 6:
        return power(inner(), below(4));
      case 7:
        return inner() / (power(leaf(), 2) + 1);
      case 8:
        return inner() / number(1 + below(3));
      case 9:
        return below(2) == 0 ? sin(inner()) : cos(inner());
      case 10: {
        const int degree = below(4);
        return bernstein(degree, below(degree + 1), leaf());
      }
      case 11:
        return functions_.empty() ? inner() : at(chosen(functions_), {inner()});
      case 12:
        return component(point_of(depth - 1), below(2));
      case 13:
        return make_term(Operation::dot, Type::scalar(),
                         {point_of(depth - 1), point_of(depth - 1)});
      default:
        return make_term(Operation::entry, Type::scalar(), {matrix_of(depth - 1)},
                         Indices{below(2), below(2)});
    }
  }

  Term point_of(int depth) {
    if (depth > 0) switch (below(5)) {
        case 0:
          return point_of(depth - 1) + point_of(depth - 1);
        case 1:
          return -point_of(depth - 1);
        case 2:
          return scalar(depth - 1) * point_of(depth - 1);
        case 3:
          return point_of(depth - 1) / number(1 + below(3));
        default:
          break;
      }
    if (!points_.empty() && below(2) == 0) return chosen(points_);
    const int inner = depth == 0 ? 0 : depth - 1;
    return point({scalar(inner), scalar(inner)});
  }

  Term matrix_of(int depth) {
    if (depth > 0) switch (below(4)) {
        case 0:
          return times(matrix_of(depth - 1), matrix_of(depth - 1));
        case 1: {
          const Term inner = matrix_of(depth - 1);
          return make_term(Operation::transpose, inner.type(), {inner});
        }
        case 2:
          return matrix_of(depth - 1) + matrix_of(depth - 1);
        default:
          break;
      }
    std::vector<Term> entries;
    for (int k = 0; k < 4; ++k) entries.push_back(leaf());
    return matrix(2, 2, entries);
  }

 private:
  Term leaf() { return below(3) == 0 ? number(below(5) - 2, 1 + below(2)) : chosen(letters_); }
  Term chosen(const std::vector<Term>& terms) {
    return terms[static_cast<std::size_t>(below(static_cast<int>(terms.size())))];
  }

  std::mt19937 random_;
  std::vector<Term> letters_;
  std::vector<Term> functions_;
  std::vector<Term> points_;
};

/// "PROVED both engines": what is decided of an equation; "holds" where it is proved, perhaps under
/// conditions, and both engines say so.
inline std::string decided_equation(const Term& left, const Term& right) {
  const Decision decision = decided(goal({equation(left, right)}), Limits{}, Engines::both);
  const bool proved = decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
  if (proved && decision.evidence == Evidence::both_engines) return "holds";
  return to_text(decision.verdict) + " " + to_text(decision.evidence);
}

}  // namespace patchproof::terms
