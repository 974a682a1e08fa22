#include <patchproof/certificate/proposition_table.hpp>

namespace patchproof {

std::size_t PropositionTable::number_of(std::string head, std::vector<std::size_t> parts) {
  std::string key = head;
  // No head has a line break.
  for (const std::size_t part : parts) key += "\n" + std::to_string(part);
  const auto [found, is_new] = numbers_.try_emplace(std::move(key), nodes_.size());
  if (is_new) nodes_.push_back({std::move(head), std::move(parts)});
  return found->second;
}

}  // namespace patchproof
