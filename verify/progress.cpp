#include <unistd.h>
#include <verify/files.hpp>
#include <verify/progress.hpp>

namespace patchproof {

namespace {

constexpr std::chrono::milliseconds between_lines{100};
constexpr std::size_t widest_id = 60;
const std::string start_of_line = "\r\x1b[K";

}  // namespace

Progress::Progress(std::size_t total) : total_{total}, terminal_{::isatty(STDERR_FILENO) == 1} {}

Progress::~Progress() {
  if (shown_) print_error(start_of_line);
}

void Progress::next(const std::string& id, std::size_t total) {
  total_ = total;
  next(id);
}

void Progress::next(const std::string& id) {
  ++done_;
  if (!terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < between_lines) return;
  last_ = now;
  shown_ = true;
  print_error(start_of_line + "[" + std::to_string(done_) + "/" + std::to_string(total_) + "] " +
              id.substr(0, widest_id));
}

}  // namespace patchproof
