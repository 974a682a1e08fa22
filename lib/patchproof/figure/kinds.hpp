#pragma once

#include <string_view>
#include <vector>

#include <patchproof/figure/figures.hpp>
#include <patchproof/figure/studio.hpp>

namespace patchproof {

/// One line of the table of figures; the first kind that fits is drawn.
struct FigureKind {
  std::string_view name;
  bool (*fits)(const Studio& studio);
  Figure (*figure)(Studio& studio, const FigureOptions& options);
};

/// Two sides of a refuted equation and what lies between them.
bool is_deviation(const Studio& studio);
Figure deviation_figure(Studio& studio, const FigureOptions& options);

/// Curves alone, perhaps several.
bool are_curves(const Studio& studio);
Figure curve_figure(Studio& studio, const FigureOptions& options);

/// Patches, the edges they have in common, and curves with them.
bool are_surfaces(const Studio& studio);
Figure surface_figure(Studio& studio, const FigureOptions& options);

}  // namespace patchproof
