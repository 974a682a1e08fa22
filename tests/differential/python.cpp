#include "python.hpp"

#include <cstdlib>
#include <stdexcept>

namespace patchproof::differential {

std::string python_with_sympy() {
  for (const std::string python : {"python3", "/usr/bin/python3"})
    if (std::system((python + " -c 'import sympy' 2>/dev/null").c_str()) == 0) return python;
  throw std::runtime_error{"no python3 with SymPy; on Debian: apt-get install python3-sympy"};
}

}  // namespace patchproof::differential
