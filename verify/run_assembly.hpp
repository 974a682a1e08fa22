#pragma once

#include <verify/work.hpp>

#include <string>
#include <unordered_map>
#include <vector>

#include <patchproof/report/run_record.hpp>

namespace patchproof {

/// Puts the record of a run together from those of its files, in their order.
///
/// Cases whose names other files have already used are left out, as `read_files` does, and so is
/// what is not in the shard.
class RunAssembly {
 public:
  explicit RunAssembly(const Work& work);

  /// `shares` are those of the cases of the file.
  /// @throws std::runtime_error when there are many and they cannot be stored.
  void add(FileRecord file, const std::vector<CaseShare>& shares);
  RunRecord run() { return std::move(run_); }

 private:
  /// Where a name was first used: in which file of the run, and in which line.
  struct FirstUse {
    std::size_t file;
    std::size_t line;
  };

  bool is_taken(const CaseRecord& of, FileRecord& file);

  const Work& work_;
  RunRecord run_;
  std::unordered_map<std::string, FirstUse> first_;
  std::size_t files_ = 0;
  std::size_t claims_ = 0;
};

}  // namespace patchproof
