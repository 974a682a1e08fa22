#pragma once

#include <verify/cache_keys.hpp>
#include <verify/message.hpp>
#include <verify/work.hpp>

#include <memory>
#include <string>
#include <vector>

namespace patchproof {

/// A file in the hands of a worker: what is to be done with it, item by item.
///
/// The items are the claims that were asked for, in the order of the text, then what the cases
/// show, and then what is to be said of whole cases.
class OpenFile {
 public:
  OpenFile(const Work& work, std::size_t file);

  std::size_t number() const { return number_; }
  std::size_t size() const { return items_.size(); }
  /// What there is in the file and how many items.
  Message description() const;
  /// Does what is to be done. A claim of which the last one who tried was lost is unknown, for the
  /// reason given.
  Message item(std::size_t index, const std::string* lost);

 private:
  struct Item {
    enum class Kind { claim, shown, audit, certified } kind;
    std::size_t of;
    std::size_t index;
    /// Of a claim: among those of the case, of all shards.
    std::size_t position;
  };

  void add_items(std::size_t of);
  Message claim(const Item& item, const std::string* lost);
  std::optional<ClaimRecord> kept(const Item& item) const;
  void keep(const Item& item, const ClaimRecord& record) const;
  Message shown(const Item& item, const std::string* lost);
  Message audit(const Item& item, const std::string* lost) const;
  Message certified(const Item& item, const std::string* lost) const;

  const Work& work_;
  std::size_t number_;
  CacheKeys keys_;
  CaseFile file_;
  std::vector<Item> items_;
  /// Of each case.
  std::vector<CaseShare> shares_;
  std::vector<std::unique_ptr<CaseVerifier>> verifiers_;
  /// Of each case what has been decided, where the claims of a file belong together.
  std::vector<CaseResult> results_;
};

}  // namespace patchproof
