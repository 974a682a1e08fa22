#pragma once

#include "example.hpp"

/// The makers of claims, by what they are about; `subjects()` is the list.
namespace patchproof::differential {

Example ring_example(Choices& choices, const std::string& name, bool holds);
Example points_example(Choices& choices, const std::string& name, bool holds);
Example space_example(Choices& choices, const std::string& name, bool holds);
Example matrix_example(Choices& choices, const std::string& name, bool holds);
Example quotient_example(Choices& choices, const std::string& name, bool holds);
Example assumption_example(Choices& choices, const std::string& name, bool holds);
Example integral_example(Choices& choices, const std::string& name, bool holds);
Example unknown_function_example(Choices& choices, const std::string& name, bool holds);

Example bezier_curve_example(Choices& choices, const std::string& name, bool holds);
Example bezier_patch_example(Choices& choices, const std::string& name, bool holds);
Example coons_example(Choices& choices, const std::string& name, bool holds);
Example ruled_example(Choices& choices, const std::string& name, bool holds);
Example hermite_example(Choices& choices, const std::string& name, bool holds);
Example discrete_coons_example(Choices& choices, const std::string& name, bool holds);
Example spline_example(Choices& choices, const std::string& name, bool holds);
Example bicubic_example(Choices& choices, const std::string& name, bool holds);

Example inequality_example(Choices& choices, const std::string& name, bool holds);
Example bernstein_bound_example(Choices& choices, const std::string& name, bool holds);
Example condition_example(Choices& choices, const std::string& name, bool holds);
Example linear_inequality_example(Choices& choices, const std::string& name, bool holds);
Example derive_example(Choices& choices, const std::string& name, bool holds);

}  // namespace patchproof::differential
