#include <patchproof/language/loader.hpp>

namespace patchproof {

std::string path_beside(const std::string& file, const std::string& path) {
  const std::size_t slash = file.rfind('/');
  if (slash == std::string::npos || path.starts_with('/')) return path;
  return file.substr(0, slash + 1) + path;
}

}  // namespace patchproof
