#include <patchproof/figure/figures.hpp>

#include <array>

#include <patchproof/figure/kinds.hpp>

namespace patchproof {

namespace {

const std::array<FigureKind, 3>& kinds() {
  static const std::array<FigureKind, 3> table{{
      {"deviation", is_deviation, deviation_figure},
      {"curve", are_curves, curve_figure},
      {"surface", are_surfaces, surface_figure},
  }};
  return table;
}

Figure figure_in(const CaseResult& result, const std::vector<std::string>& names,
                 const FigureOptions& options, Workspace& workspace) {
  Studio studio{result, names, workspace};
  for (const FigureKind& kind : kinds()) {
    if (!kind.fits(studio)) continue;
    Figure figure = kind.figure(studio, options);
    figure.notes = studio.notes();
    return figure;
  }
  throw CannotDraw{"there is nothing to be drawn"};
}

}  // namespace

Drawing drawing_of(const CaseResult& result, const std::vector<std::string>& names,
                   const FigureOptions& options) {
  const auto cannot = [&](const std::string& why) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "'" : ", '") + name + "'";
    return Drawing{std::nullopt, "cannot draw " + all + ": " + why, ""};
  };
  try {
    Budget budget{result.verified.limits};
    Workspace workspace{budget};
    for (;;) {
      try {
        return {figure_in(result, names, options, workspace), "", ""};
      } catch (const FinerAngles&) {
        budget.spend(1000);
      }
    }
  } catch (const CannotDraw& error) {
    return {std::nullopt, error.what(), error.help};
  } catch (const OverBudget& error) {
    return cannot(std::string{"limit: "} + error.what());
  } catch (const TooDeep& error) {
    return cannot(std::string{"limit: "} + error.what());
  } catch (const OutsideTheory& error) {
    return cannot(error.what());
  } catch (const std::domain_error& error) {
    return cannot(error.what());
  }
}

}  // namespace patchproof
