#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace patchproof {

/// One of several parts of a corpus, for one of several machines: the claims whose ids fall into
/// it. Which part a claim is in depends on its id alone.
struct Shard {
  /// From 1.
  std::size_t number = 1;
  std::size_t of = 1;

  bool is_all() const { return of == 1; }
  /// FNV-1a (Fowler, Noll, Vo) of the bytes, 64 bits, folded to 32, modulo the number of shards.
  bool contains(const std::string& id) const;
};

/// "2/4"; empty for anything else, and for more than 100 000 shards.
std::optional<Shard> shard_from_text(const std::string& text);

}  // namespace patchproof
