#pragma once

#include <verify/message.hpp>

#include <optional>
#include <string>

namespace patchproof {

/// A folder with what was decided before, each claim in a file of its own.
///
/// A claim is found again only by the same program, with the same text of its case, the same
/// definitions and included files, the same limits and engines: the name of its file is the digest
/// of all that, see `CacheKeys`. A file is written under another name and then renamed, so that
/// several runs can use one folder at the same time; one that is not whole counts as not there.
class Cache {
 public:
  /// Makes the folder where there is none.
  /// @throws std::runtime_error when that cannot be done, or this program cannot be told from
  ///   others.
  explicit Cache(std::string folder);

  /// What was kept under this digest.
  std::optional<Message> find(const std::string& digest) const;
  /// Nothing is said when it cannot be written: the claim will be decided again.
  void keep(const std::string& digest, const Message& decided) const;

  /// The digest of this program.
  const std::string& program() const { return program_; }

 private:
  std::string path_of(const std::string& digest) const;

  std::string folder_;
  std::string program_;
};

}  // namespace patchproof
