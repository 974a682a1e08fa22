#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>
#include <patchproof/figure/figure.hpp>
#include <patchproof/figure/projection.hpp>

namespace patchproof {

/// How a figure is drawn.
struct FigureOptions {
  /// Width and greatest height in millimetres.
  Rational width = 90;
  Rational greatest_height = 90;
  View view;
  /// Cells of the grid of a patch, in each direction.
  std::size_t cells = 20;
  /// Isoparametric lines are this many cells apart.
  std::size_t cells_between_lines = 2;
  /// The control net also of patches that are not said to be Bézier patches.
  bool net = false;
  bool twists = false;
  bool zebra = false;
};

/// A figure, or in words why there is none.
struct Drawing {
  std::optional<Figure> figure;
  std::string problem;
  /// "did you mean 'P'?"; perhaps "".
  std::string help;
};

/// Draws what the names of a case stand for: curves, patches, scalar functions, several in one
/// figure, or the label of a refuted equation, whose sides are compared. In a family a name is that
/// of the first instance, "p[m=2]" of another.
///
/// What the case leaves open gets example values that satisfy its assumptions; unknowns have the
/// values that were derived. Nothing is concluded from a figure.
Drawing drawing_of(const CaseResult& result, const std::vector<std::string>& names,
                   const FigureOptions& options);

}  // namespace patchproof
