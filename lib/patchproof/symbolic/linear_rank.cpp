#include <patchproof/symbolic/linear_rank.hpp>

#include <algorithm>

#include <patchproof/symbolic/normal_form.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

// Numbers first: dividing by them costs nothing.
LinearRank::Row::const_iterator pivot(const LinearRank::Row& row) {
  const auto number = std::find_if(
      row.begin(), row.end(), [](const auto& entry) { return GiNaC::is_a<numeric>(entry.second); });
  return number != row.end() ? number : row.begin();
}

}  // namespace

// Takes a multiple of `by` away, after multiplying the row if the pivot is not a number.
void LinearRank::reduce(Row& row, unsigned column, const Row& by) {
  const ex pivot = by.at(column);
  const bool is_number = GiNaC::is_a<numeric>(pivot);
  const ex factor = is_number ? row.at(column) / pivot : row.at(column);
  if (!is_number) {
    for (auto& [unknown, entry] : row) entry = ring_.product(entry, pivot);
  }
  for (const auto& [unknown, entry] : by) {
    ex& target = row[unknown];
    target = normal_form(ring_, ring_.sum({target, -ring_.product(factor, entry)}));
  }
  std::erase_if(row, [](const auto& entry) { return entry.second.is_zero(); });
}

void LinearRank::add(Row row) {
  std::erase_if(row, [this](const auto& entry) { return is_zero(ring_, entry.second); });
  for (const unsigned column : order_) {
    ring_.spend(1);
    if (row.contains(column)) reduce(row, column, pivots_.at(column));
  }
  if (row.empty()) return;
  const unsigned column = pivot(row)->first;
  order_.push_back(column);
  pivots_.emplace(column, std::move(row));
}

}  // namespace patchproof::symbolic
