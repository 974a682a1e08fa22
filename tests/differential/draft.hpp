#pragma once

#include <string>
#include <vector>

#include "choices.hpp"
#include "meaning.hpp"

namespace patchproof::differential {

/// Another way to write a derivative of a function: an expression in the formals of the function.
struct Alternative {
  std::string derivative;
  Node body;
};

/// A function that a case declares, and what is known about it.
struct DeclaredFunction {
  std::string name;
  std::vector<std::string> formals;
  Type type = Type::point;
  /// How often it is differentiated by name; `diff` does so once more.
  unsigned order = 2;
  std::vector<Alternative> alternatives;
};

/// A case in the making: its declarations, and the words a claim may be built of.
struct Draft {
  Environment environment;
  std::vector<std::string> declarations;
  /// The same for opinion.py.
  std::vector<std::string> python;
  /// Names of parameters, which have the range [0, 1]; they stand among the scalars too.
  std::vector<std::string> parameters;
  std::vector<Node> scalars;
  std::vector<Node> points;
  std::vector<DeclaredFunction> functions;
  /// Names of nets and lists; their shapes are in the environment.
  std::vector<std::string> arrays;
  /// What is nowhere 0 under the assumptions.
  std::vector<Node> divisors;
  /// Equations that are assumed, as names and their values.
  std::vector<std::pair<std::string, Node>> assumed;
};

void declare_parameters(Draft& draft, const std::vector<std::string>& names);
void declare_scalars(Draft& draft, const std::vector<std::string>& names);
/// Points of any dimension.
void declare_points(Draft& draft, const std::vector<std::string>& names);
void declare_points_in_space(Draft& draft, const std::vector<std::string>& names);
/// A list (no columns) or net of points or scalars; its elements are added to the points or
/// scalars.
void declare_array(Draft& draft, const std::string& name, std::size_t rows, std::size_t columns,
                   Type type);
/// An unknown curve, patch or scalar function; one parameter or two.
void declare_unknown(Draft& draft, const DeclaredFunction& function);
/// A curve or patch that is defined.
void declare_defined(Draft& draft, const DeclaredFunction& function, const Node& definition);
void assume_different(Draft& draft, const Node& a, const Node& b);

/// The element at these indices.
Node element_of(const Draft& draft, const std::string& array, std::size_t i, std::size_t j = 0);
/// Whether an array is a list, of one index.
bool is_list(const Draft& draft, const std::string& array);

/// A number, small, of two words, next to a boundary of 64 or 128 bits, or a multiple of 2^61 - 1.
Node random_number(Choices& choices);
Node random_scalar(Choices& choices, const Draft& draft, unsigned depth);
Node random_point(Choices& choices, const Draft& draft, unsigned depth);
/// A function of the draft, or one of its derivatives, at random arguments.
Node random_application(Choices& choices, const Draft& draft);

}  // namespace patchproof::differential
