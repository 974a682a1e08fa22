#include <patchproof/certificate/array_entry.hpp>

#include <cctype>

namespace patchproof {

std::optional<ArrayEntry> array_entry(const std::string& name) {
  const std::size_t open = name.find('[');
  if (open == std::string::npos || name.back() != ']') return std::nullopt;
  ArrayEntry result{name.substr(0, open), {}};
  std::string digits;
  for (std::size_t k = open + 1; k < name.size(); ++k) {
    const char c = name[k];
    if (std::isdigit(static_cast<unsigned char>(c))) {
      digits += c;
    } else if ((c == ',' || c == ']') && !digits.empty() && digits.size() < 5) {
      result.indices.push_back(static_cast<unsigned>(std::stoul(digits)));
      digits.clear();
    } else if (c != ' ') {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace patchproof
