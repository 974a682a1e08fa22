#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>

namespace patchproof::test {

/// One formula, construction or sentence of the notes: a line of cases/items.tsv.
struct Item {
  std::string id;
  std::string document;  ///< "sk", "si", ...
  std::string section;
  std::string verdict;  ///< "TRUE", "OVERCLAIM", ... : what is to be said of it
  std::string statement;
  std::vector<std::string> cases;  ///< names of the cases that decide it
  std::string reason;              ///< why no case does, where there is none
};

/// The lines of an index, tab separated, below a header line.
/// @throws std::runtime_error naming the line that does not have six columns
std::vector<Item> items_of(const std::string& text);

/// Case name -> its decided claims.
using Results = std::map<std::string, std::vector<ClaimResult>>;

/// What is wrong with an item: a case that does not exist, or verdicts that do not add up to what
/// is said of it (an OVERCLAIM needs something refuted and something proved); "" when nothing is.
std::string fault_of(const Item& item, const Results& results);

/// docs/claims.md: one row for each item, with the verdicts found.
std::string claims_page(const std::vector<Item>& items, const Results& results);

}  // namespace patchproof::test
