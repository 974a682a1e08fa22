#pragma once

#include <ginac/ginac.h>

#include <map>
#include <set>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// The rows of a homogeneous linear system, brought to echelon form as they come.
class LinearRank {
 public:
  /// The coefficient of each unknown, by the number of its atom.
  using Row = std::map<unsigned, GiNaC::ex>;

  explicit LinearRank(Ring& ring) : ring_{ring} {}

  /// @throws OverBudget
  void add(Row row);

  std::size_t rank() const { return pivots_.size(); }

  /// Whether some row was solved for the unknown.
  bool is_pivot(unsigned unknown) const { return pivots_.contains(unknown); }

 private:
  void reduce(Row& row, unsigned column, const Row& by);

  Ring& ring_;
  // Each row has no unknown that was the pivot of an earlier one.
  std::map<unsigned, Row> pivots_;
  std::vector<unsigned> order_;
};

}  // namespace patchproof::symbolic
