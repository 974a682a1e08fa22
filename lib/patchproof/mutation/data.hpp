#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/language/syntax.hpp>
#include <patchproof/repair/edit.hpp>

namespace patchproof {

/// One number of the data of a case: a coordinate of a control point, an entry of a matrix, or a
/// coordinate of a given curve or patch.
struct Datum {
  /// "V[1,2]"; "C1" of a curve.
  std::string owner;
  /// The entry: all coordinates of the point.
  Span entry;
  /// The number itself.
  syntax::ExpressionPointer value;
  /// Which coordinate, counted from the last: heights are 0.
  std::size_t from_last = 0;
};

/// A declaration that holds nothing but numbers, or functions of parameters made of numbers:
/// `matrix V = [(0, 0, 1), …]`, `let k = 3`, `curve C(u) = (u, u^2)`.
struct Data {
  /// "V"; of several names "V, W".
  std::string name;
  const syntax::Statement* statement = nullptr;
  std::vector<Datum> numbers;
  /// The same declared for symbols: "point V[0..3, 0..3] in R^3".
  std::string for_symbols;
  /// What is special about the numbers, as in "V[i,j] = V[j,i]"; empty for functions.
  std::vector<std::string> shape;
  /// Whether the numbers are those of functions, not of points.
  bool is_function = false;
};

/// What the declaration holds, when it holds data only.
std::optional<Data> data_of(const syntax::Statement& statement);

/// All data of a case, in the order of the text.
std::vector<Data> data_of(const syntax::Case& written);

/// What a number of the data can be made to break symmetry, planes and lines: one more, and others
/// near by; for a function of parameters something is added that is zero at the ends.
std::vector<Edit> small_changes(const Data& data, const Datum& datum);

}  // namespace patchproof
