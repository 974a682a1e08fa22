#include "subjects.hpp"

namespace patchproof::differential {

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all{
      {"ring", ring_example},
      {"points", points_example},
      {"space", space_example},
      {"matrix", matrix_example},
      {"quotient", quotient_example},
      {"assumption", assumption_example},
      {"integral", integral_example},
      {"unknown function", unknown_function_example},
      {"bezier curve", bezier_curve_example},
      {"bezier patch", bezier_patch_example},
      {"coons", coons_example},
      {"ruled", ruled_example},
      {"hermite", hermite_example},
      {"bicubic", bicubic_example},
      {"discrete coons", discrete_coons_example},
      {"spline", spline_example},
      {"inequality", inequality_example},
      {"bernstein bound", bernstein_bound_example},
      {"derive", derive_example},
      {"condition", condition_example},
      {"linear inequality", linear_inequality_example},
  };
  return all;
}

}  // namespace patchproof::differential
