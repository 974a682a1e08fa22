#pragma once

#include <verify/work.hpp>

#include <map>
#include <string>
#include <vector>

#include <patchproof/report/record.hpp>

namespace patchproof {

/// Puts the record of a run together from those of its files, in their order.
///
/// Cases whose names other files have already used are left out, as `read_files` does, and so is
/// what is not in the shard.
class RunAssembly {
 public:
  explicit RunAssembly(const Work& work);

  /// `shares` are those of the cases of the file.
  void add(FileRecord file, const std::vector<CaseShare>& shares);
  RunRecord run() { return std::move(run_); }

 private:
  bool is_taken(const CaseRecord& of, FileRecord& file);

  RunRecord run_;
  /// Where the names were first used.
  std::map<std::string, FilePlace> first_;
  std::size_t claims_ = 0;
};

}  // namespace patchproof
