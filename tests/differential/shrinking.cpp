#include "shrinking.hpp"

namespace patchproof::differential {
namespace {

using Decisions = std::vector<std::uint64_t>;

/// The decisions without `length` of them from `start`.
Decisions without(const Decisions& all, std::size_t start, std::size_t length) {
  Decisions rest = all;
  const auto first = rest.begin() + static_cast<std::ptrdiff_t>(start);
  rest.erase(first, first + static_cast<std::ptrdiff_t>(length));
  return rest;
}

}  // namespace

std::vector<std::uint64_t> shrunk(
    std::vector<std::uint64_t> decisions, std::size_t kept, std::size_t attempts,
    const std::function<bool(const std::vector<std::uint64_t>&)>& fails) {
  const auto better = [&](Decisions candidate) {
    if (attempts == 0) return false;
    --attempts;
    if (!fails(candidate)) return false;
    decisions = std::move(candidate);
    return true;
  };
  for (bool progress = true; progress && attempts > 0;) {
    progress = false;
    for (std::size_t length = 32; length > 0; length /= 2)
      for (std::size_t start = kept; start + length <= decisions.size();)
        if (better(without(decisions, start, length)))
          progress = true;
        else
          start += length;
    for (std::size_t at = kept; at < decisions.size(); ++at)
      for (const std::uint64_t smaller : {std::uint64_t{0}, decisions[at] / 2, decisions[at] - 1}) {
        if (at >= decisions.size() || smaller >= decisions[at]) continue;
        Decisions candidate = decisions;
        candidate[at] = smaller;
        if (better(std::move(candidate))) progress = true;
      }
  }
  return decisions;
}

}  // namespace patchproof::differential
