#include <patchproof/figure/labels.hpp>

#include <cctype>

namespace patchproof {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Indices of one digit stand side by side.
std::string joined(const std::string& indices) {
  bool short_ones = true;
  std::size_t digits = 0;
  for (const char c : indices) {
    digits = c == ',' ? 0 : digits + 1;
    short_ones = short_ones && digits < 2;
  }
  if (!short_ones) return indices;
  std::string result;
  for (const char c : indices)
    if (c != ',') result += c;
  return result;
}

std::string plain_letters(const std::string& letters) {
  return letters.size() <= 1 ? letters : "\\mathit{" + letters + "}";
}

std::string with_index(const std::string& letters, const std::string& index) {
  if (index.empty()) return letters;
  return letters + "_" + (index.size() == 1 ? index : "{" + index + "}");
}

}  // namespace

LabelParts label_parts(const std::string& name) {
  LabelParts parts;
  std::size_t end = std::min(name.find('('), name.size());
  parts.rest = name.substr(end);
  std::string head = name.substr(0, end);
  if (const std::size_t bracket = head.find('['); bracket != std::string::npos) {
    parts.index = joined(head.substr(bracket + 1, head.find(']', bracket) - bracket - 1));
    head = head.substr(0, bracket);
  }
  if (const std::size_t line = head.find('_'); line != std::string::npos && line > 0) {
    if (parts.index.empty()) parts.index = head.substr(line + 1);
    head = head.substr(0, line);
  }
  std::size_t digits = head.size();
  while (digits > 1 && is_digit(head[digits - 1])) --digits;
  if (parts.index.empty()) {
    parts.index = head.substr(digits);
    head = head.substr(0, digits);
  }
  parts.letters = head;
  return parts;
}

LabelText latex_labels(const Notation& notation) {
  return [notation](const std::string& name) {
    const std::string base = name.substr(0, name.find_first_of("[("));
    const auto exact = notation.names.find(base);
    LabelParts parts = label_parts(name);
    if (exact != notation.names.end()) {
      // The name with its digits has a LaTeX form of its own; only indices go behind it.
      const std::string index = name.find('[') == std::string::npos ? "" : parts.index;
      return with_index(index.empty() ? exact->second : "{" + exact->second + "}", index) +
             parts.rest;
    }
    const auto letters = notation.names.find(parts.letters);
    const std::string written = letters != notation.names.end() ? "{" + letters->second + "}"
                                                                : plain_letters(parts.letters);
    return with_index(written, parts.index) + parts.rest;
  };
}

}  // namespace patchproof
