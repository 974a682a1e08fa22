#pragma once

#include <cstddef>

namespace patchproof {

/// Bytes now allocated through `new` in this program, blocks as large as the allocator made them.
///
/// Other threads may have up to 64 kB each that are not counted yet. Memory that libraries take
/// from `malloc` directly is not in it.
std::size_t allocated_bytes();

}  // namespace patchproof
