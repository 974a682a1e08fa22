#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <recheck/meter.hpp>
#include <recheck/number.hpp>

namespace recheck {

/// Thrown by a text that is no document of certificates: where, and what is wrong there.
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A place in a JSON document, with the path to it: `certificates[2].nodes[17]`.
///
/// Every function throws Unreadable when what stands there is something else.
class Place {
 public:
  Place(const nlohmann::json& json, std::string path) : json_{&json}, path_{std::move(path)} {}

  [[noreturn]] void fail(const std::string& problem) const;

  /// Requires an object with these members and no others; those behind "?" may be missing.
  void require_members(const std::vector<std::string_view>& names) const;
  bool has(std::string_view name) const;
  Place operator[](std::string_view name) const;

  /// The entries of a list.
  std::vector<Place> items() const;

  std::string text() const;
  bool truth() const;
  /// A whole number below the limit.
  std::size_t whole(std::size_t limit) const;
  /// A whole number of absolute value up to the limit.
  long integer(std::size_t limit) const;
  /// An exact number, as text.
  Rational number() const;
  /// Which of the texts it is.
  std::size_t one_of(const std::vector<std::string_view>& texts) const;

  bool is_text() const { return json_->is_string(); }

 private:
  const nlohmann::json* json_;
  std::string path_;
};

/// The JSON value of a text. No member stands twice in an object, nothing is nested deeper than the
/// limit.
/// @throws Unreadable
nlohmann::json json_of(const std::string& text, const Limits& limits);

}  // namespace recheck
