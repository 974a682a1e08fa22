#pragma once

#include <verify/message.hpp>
#include <verify/work.hpp>

#include <map>
#include <string>
#include <vector>

#include <patchproof/report/record.hpp>

namespace patchproof {

/// What has come in of one file.
class FileState {
 public:
  explicit FileState(std::string path) : path_{std::move(path)} {}

  bool is_described() const { return described_; }
  bool is_complete() const { return missing_ == 0 && described_; }
  /// How many items and claims it has, once described.
  std::size_t items() const { return received_.size(); }
  std::size_t claims() const { return claims_.size(); }
  /// Of each of its cases.
  const std::vector<CaseShare>& shares() const { return shares_; }
  const std::vector<std::string>& unmatched() const { return unmatched_; }

  /// Takes in what a worker says that is in the file. Another one may say it again; when it says
  /// something else, the file is given up.
  void describe(const Message& description);
  /// Takes in what came of an item; of one that somebody else was faster with, nothing.
  /// @returns the id of the claim, where it was one.
  std::string take(const Message& answer);
  bool has(std::size_t item) const { return item < received_.size() && received_[item]; }
  /// Nothing can be said of the file.
  void give_up(const std::string& why);

  /// All that has come in, with all cases of the file.
  FileRecord record();

 private:
  std::string path_;
  bool described_ = false;
  std::size_t digest_ = 0;
  FileRecord record_;
  std::vector<CaseShare> shares_;
  std::vector<std::string> unmatched_;
  std::vector<bool> received_;
  std::size_t missing_ = 0;
  /// In the order of the items, each with the number of its case.
  std::vector<std::pair<std::size_t, ClaimRecord>> claims_;
  std::map<std::size_t, std::pair<std::size_t, ShownRecord>> shown_;
};

}  // namespace patchproof
