#include "choices.hpp"

namespace patchproof::differential {

std::uint64_t Choices::below(std::uint64_t bound) {
  const std::size_t next = made_.size();
  const std::uint64_t raw = free_ ? random_() : next < given_.size() ? given_[next] : 0;
  made_.push_back(raw % bound);
  return made_.back();
}

}  // namespace patchproof::differential
