#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace patchproof {

/// Terms and propositions without names for what is bound, each kept once: two are the same exactly
/// when their numbers are. What is shared is shared, so large ones are cheap.
///
/// A node is a head and parts: "+", "<=", "implies", "forall R", "Bern 3 1", "-2". A variable is "#k"
/// where k counts the binders around its own one; entry 1, 2 of an array is "#k 1 2".
class PropositionTable {
 public:
  struct Node {
    std::string head;
    std::vector<std::size_t> parts;
  };

  std::size_t number_of(std::string head, std::vector<std::size_t> parts = {});
  const Node& node(std::size_t number) const { return nodes_.at(number); }

 private:
  std::vector<Node> nodes_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

}  // namespace patchproof
