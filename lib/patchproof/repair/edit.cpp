#include <patchproof/repair/edit.hpp>

#include <patchproof/language/utf8.hpp>

namespace patchproof {

namespace {

std::size_t characters(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count)
    at += std::max<std::size_t>(1, utf8_length(text, at));
  return count;
}

}  // namespace

bool overlap(const Edit& a, const Edit& b) {
  // Two things put into one place have no order.
  if (a.begin == b.begin) return true;
  return a.begin < b.begin ? b.begin < a.end : a.begin < b.end;
}

std::string changed(const std::string& line, const std::vector<Edit>& edits) {
  std::string result;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    result += line.substr(at, edit.begin - at) + edit.text;
    at = edit.end;
  }
  return result + line.substr(at);
}

std::string marks_of(const std::string& line, const std::vector<Edit>& edits) {
  std::string result;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    result.append(characters(line.substr(at, edit.begin - at)), ' ');
    // Where something was taken away, the place is marked.
    result.append(edit.text.empty() ? 1 : characters(edit.text), '^');
    at = edit.text.empty() ? std::min(edit.end + 1, line.size()) : edit.end;
  }
  return result;
}

std::string in_words(const std::string& line, const Edit& edit) {
  const std::string old = line.substr(edit.begin, edit.end - edit.begin);
  const std::string kind = " (" + edit.what + ")";
  if (old.empty()) return "added " + edit.text + kind;
  if (edit.text.empty()) return "without " + old + kind;
  return old + " -> " + edit.text + kind;
}

}  // namespace patchproof
