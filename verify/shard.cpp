#include <verify/shard.hpp>

#include <cstdint>

namespace patchproof {

namespace {

constexpr std::size_t most_shards = 100'000;

std::size_t number_in(const std::string& text) {
  if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos)
    return 0;
  return std::stoul(text);
}

}  // namespace

bool Shard::contains(const std::string& id) const {
  if (is_all()) return true;
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return ((hash >> 32U) ^ (hash & 0xffffffffU)) % of == number - 1;
}

std::optional<Shard> shard_from_text(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const Shard shard{number_in(text.substr(0, slash)), number_in(text.substr(slash + 1))};
  if (shard.number == 0 || shard.number > shard.of || shard.of > most_shards) return std::nullopt;
  return shard;
}

}  // namespace patchproof
