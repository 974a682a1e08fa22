#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <patchproof/report/record.hpp>
#include <patchproof/report/summary.hpp>

namespace patchproof {

/// Records of files that are not kept in memory but can be looked at again and again.
class FileStore {
 public:
  FileStore() = default;
  FileStore(const FileStore&) = delete;
  FileStore& operator=(const FileStore&) = delete;
  virtual ~FileStore() = default;

  /// @throws std::runtime_error when it cannot be kept.
  virtual void add(const FileRecord& file) = 0;
  /// Calls `see` with each file in the order they were added.
  /// @throws std::runtime_error when that cannot be done.
  virtual void for_each(const std::function<void(const FileRecord&)>& see) = 0;
};

/// The files of a run in order, with the sum of what happened in them. Where there is a store, only
/// the first of many are kept in memory.
class FileRecords {
 public:
  FileRecords() = default;
  explicit FileRecords(std::unique_ptr<FileStore> store) : store_{std::move(store)} {}

  /// @throws std::runtime_error when it cannot be stored.
  void push_back(FileRecord file);
  /// Calls `see` with each file.
  /// @throws std::runtime_error when one cannot be read again.
  void for_each(const std::function<void(const FileRecord&)>& see) const;
  const Summary& summary() const { return summary_; }

 private:
  std::vector<FileRecord> first_;
  std::unique_ptr<FileStore> store_;
  bool stores_ = false;
  Summary summary_;
};

/// A run as its report tells it.
struct RunRecord {
  FileRecords files;
  bool strict = false;
  std::optional<ShardRecord> shard;
};

RunRecord record_of(const Report& report);

/// What a run with this record ends with: the gravest of what happened in it.
ExitCode exit_code(const RunRecord& run);

}  // namespace patchproof
