#pragma once

#include <array>
#include <map>
#include <vector>

#include <patchproof/figure/sampled_function.hpp>

namespace patchproof {

/// Values for everything a case leaves open, pleasant to look at: nets over a square of points one
/// apart, curves along the edges of a unit square, small different numbers.
///
/// They say nothing of what a case assumes, and nothing is concluded from them.
class ExampleValues {
 public:
  /// `terms` are those in which the symbols are used: a matrix of vectors for a Hermite patch gets
  /// other values than a control net.
  ExampleValues(const std::vector<SymbolPointer>& symbols, const std::vector<Term>& terms);

  /// The value of a point or scalar; scalars have it in the first coordinate.
  Point constant(const SymbolPointer& symbol) const;

  /// The coordinates of an unknown function as polynomials in these variables, one for each
  /// parameter.
  std::array<Polynomial, 3> function(const SymbolPointer& symbol,
                                     const std::vector<Variable>& variables, Budget& budget) const;

 private:
  struct Part {
    /// Which one of its sort, from 0: of the nets, of the single points, of the curves in u, …
    int number = 0;
    /// Where it is used: "hermite", "ferguson_u", "bilinear" …, or "".
    std::string use;
    std::vector<int> indices;
    std::vector<int> extents;
  };
  void find_uses(const Term& term);
  void note_matrix(const Term& matrix, const std::string& use);

  std::map<unsigned, Part> parts_;
};

/// The indices of a symbol of an array: "V[1,2]" has 1 and 2; of any other symbol none.
std::vector<int> indices_of(const std::string& name);
/// "V" of "V[1,2]".
std::string base_of(const std::string& name);

}  // namespace patchproof
