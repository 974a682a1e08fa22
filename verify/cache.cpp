#include <unistd.h>
#include <verify/build_id.hpp>
#include <verify/cache.hpp>
#include <verify/files.hpp>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <patchproof/latex/sha256.hpp>

namespace patchproof {

Cache::Cache(std::string folder) : folder_{std::move(folder)}, program_{build_id()} {
  if (program_.empty())
    throw std::runtime_error{"this program was linked without a build id and cannot use a cache"};
  program_ = sha256(program_);
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!error && !std::filesystem::is_directory(folder_, error))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw std::runtime_error{"cannot make the folder '" + folder_ + "': " + error.message()};
}

std::string Cache::path_of(const std::string& digest) const {
  return folder_ + "/" + digest.substr(0, 2) + "/" + digest.substr(2);
}

// After the digest of the rest: a disk may be full, a machine may stop.
std::optional<Message> Cache::find(const std::string& digest) const {
  const std::optional<std::string> text = file_text(path_of(digest)).text;
  constexpr std::size_t digits = 64;
  if (!text || text->size() <= digits) return std::nullopt;
  const std::string kept = text->substr(digits);
  if (sha256(digest + kept) != text->substr(0, digits)) return std::nullopt;
  Message decided = Message::from_cbor(kept, true, false);
  if (decided.is_discarded()) return std::nullopt;
  return decided;
}

void Cache::keep(const std::string& digest, const Message& decided) const {
  std::string kept;
  Message::to_cbor(decided, kept);
  const std::string path = path_of(digest);
  std::error_code error;
  std::filesystem::create_directory(std::filesystem::path{path}.parent_path(), error);
  std::string fresh = path + ".XXXXXX";
  const int file = ::mkstemp(fresh.data());
  if (file < 0) return;
  const std::string problem = write_all(file, sha256(digest + kept) + kept);
  ::close(file);
  if (!problem.empty() || ::rename(fresh.c_str(), path.c_str()) != 0) ::unlink(fresh.c_str());
}

}  // namespace patchproof
