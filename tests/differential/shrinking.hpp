#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace patchproof::differential {

/// Fewer and smaller decisions that still fail, found by leaving out runs of them and making single
/// ones smaller, with at most `attempts` tries.
///
/// The first `kept` decisions stay as they are.
std::vector<std::uint64_t> shrunk(
    std::vector<std::uint64_t> decisions, std::size_t kept, std::size_t attempts,
    const std::function<bool(const std::vector<std::uint64_t>&)>& fails);

}  // namespace patchproof::differential
