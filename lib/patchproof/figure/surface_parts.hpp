#pragma once

#include <string>
#include <vector>

#include <patchproof/figure/figures.hpp>
#include <patchproof/figure/scene.hpp>
#include <patchproof/figure/studio.hpp>

namespace patchproof {

/// Exact points of a patch over an even grid of its domain: rows belong to the first parameter.
struct Grid {
  std::size_t cells = 0;
  std::vector<Point> points;
  const Point& at(std::size_t i, std::size_t j) const { return points[i * (cells + 1) + j]; }
};
Grid grid_of(const Subject& patch, std::size_t cells);

/// The mean of the corners.
Point centre_of(const Grid& grid);

/// How much the facets of the grid differ in depth at most: what lies on them is lifted by that.
Rational lift_over(const Grid& grid, const Projection& projection);

/// Facets, shaded by how much they face the light; isoparametric lines; boundary curves.
void add_facets(const Grid& grid, Ink front, Ink back, Scene& scene);
/// A line every so many cells.
void add_isolines(const Grid& grid, std::size_t step, Scene& scene);
void add_boundary(const Grid& grid, Ink ink, Scene& scene);

/// Zebra stripes in the place of facets: where a ray from the viewer, reflected, goes.
/// Source: Farin, Curves and Surfaces for CAGD, "Reflection lines".
void add_zebra(const Subject& patch, const Grid& grid, Scene& scene);

/// Legs and points of a control net; legs are hidden where the surface is in front.
void add_net(const DrawnNet& net, const Rational& lift, Scene& scene);

/// The control net of a polynomial patch or curve of degree up to 9; empty for any other.
std::optional<DrawnNet> bezier_net_of(const Subject& subject);

/// Names of control points, corners and boundary curves.
void add_names(const Subject& patch, const Grid& grid, Studio& studio, Scene& scene);

/// Mixed derivatives at the corners, drawn to one scale: the longest is a third of the patch.
void add_twists(const Subject& patch, const Grid& grid, Scene& scene);

}  // namespace patchproof
