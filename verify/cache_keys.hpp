#pragma once

#include <string>
#include <vector>

#include <patchproof/patchproof.hpp>

namespace patchproof {

/// The digests under which a cache keeps the claims of one file: of everything a verdict may depend
/// on. Where in the file the case stands, and what other cases are there, is not part of it.
class CacheKeys {
 public:
  /// Remembers what is loaded while the file is read. This object has to stay where it is.
  Loader remembering(const Loader& load);

  /// Once the file has been read. `program` tells this program from every other one.
  void note(const CaseFile& file, const std::string& program, Engines engines);

  /// Of this claim of this case of the file; after `note`.
  std::string digest(std::size_t of, std::size_t claim) const;

 private:
  std::string loaded_;
  /// Of each case.
  std::vector<std::string> digests_;
};

}  // namespace patchproof
