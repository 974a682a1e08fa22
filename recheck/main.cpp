// The program `patchproof-recheck`: certificates in, exit code out.
#include <iostream>

#include <recheck/run.hpp>

namespace {

constexpr int wrong_usage = 64;
constexpr int fault = 70;

constexpr const char* usage =
    "usage: patchproof-recheck FILE.json...\n"
    "Looks at certificates again, independently of patchproof; - is standard input.\n"
    "Ends with 0 when all are rechecked, 1 when one is rejected, 2 when one cannot be judged,\n"
    "4 when a file cannot be read, 5 when there is no certificate, 64 for a wrong command line.\n";

}  // namespace

int main(int argument_count, char* arguments[]) {
  const std::vector<std::string> paths(arguments + 1, arguments + argument_count);
  if (paths.size() == 1 && paths.front() == "--help") {
    std::cout << usage;
    return 0;
  }
  for (const std::string& path : paths) {
    if (path.size() < 2 || path.front() != '-') continue;
    std::cerr << "patchproof-recheck: there is no option '" << path << "'\n" << usage;
    return wrong_usage;
  }
  if (paths.empty()) {
    std::cerr << usage;
    return wrong_usage;
  }
  try {
    const recheck::Run run = recheck::run_of(paths);
    std::cout << run.output << std::flush;
    std::cerr << run.errors;
    return std::cout ? run.code : 4;
  } catch (const std::exception& error) {
    std::cerr << "patchproof-recheck: internal error: " << error.what() << "\n";
    return fault;
  }
}
