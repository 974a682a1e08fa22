#pragma once

#include <patchproof/report/run_record.hpp>

namespace patchproof {

/// Keeps the records of files in a file without a name, in the folder for temporary files.
class TemporaryStore : public FileStore {
 public:
  TemporaryStore() = default;
  ~TemporaryStore() override;

  void add(const FileRecord& file) override;
  void for_each(const std::function<void(const FileRecord&)>& see) override;

 private:
  /// From the first `add` on.
  int descriptor_ = -1;
};

}  // namespace patchproof
