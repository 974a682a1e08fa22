#pragma once

#include <string>
#include <tuple>
#include <vector>

namespace patchproof {

/// One change of a statement in one line: the bytes [begin, end) become `text`.
struct Edit {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
  /// What was changed: "sign", "number", "index", "name", "derivative", "transposed", "reversed",
  /// "exchanged", "entry".
  std::string what;

  friend bool operator<(const Edit& a, const Edit& b) {
    return std::tie(a.begin, a.end, a.text) < std::tie(b.begin, b.end, b.text);
  }
  /// The same change, whatever it is called.
  friend bool operator==(const Edit& a, const Edit& b) {
    return std::tie(a.begin, a.end, a.text) == std::tie(b.begin, b.end, b.text);
  }
};

/// Whether both cannot be made.
bool overlap(const Edit& a, const Edit& b);

/// The line with all changes made; they do not overlap and are in order.
std::string changed(const std::string& line, const std::vector<Edit>& edits);

/// Below the changed line: '^' where something is new, blanks elsewhere; without trailing blanks.
std::string marks_of(const std::string& line, const std::vector<Edit>& edits);

/// "15 -> 25 (entry)"; what was added to nothing, or taken away, is shown as such.
std::string in_words(const std::string& line, const Edit& edit);

}  // namespace patchproof
