#include <fcntl.h>
#include <unistd.h>
#include <verify/files.hpp>
#include <verify/output.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace patchproof {

namespace {

bool is_one_of(const std::string& path, const std::vector<std::string>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    std::error_code error;
    return std::filesystem::equivalent(path, input, error) && !error;
  });
}

}  // namespace

Output::Output(const std::string& path, const std::vector<std::string>& inputs)
    : path_{path}, descriptor_{STDOUT_FILENO} {
  if (path_.empty()) return;
  descriptor_ = -1;
  if (is_one_of(path_, inputs)) {
    complain("it is one of the case files");
    return;
  }
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) complain(std::strerror(errno));
}

Output::~Output() {
  if (!path_.empty() && descriptor_ >= 0) ::close(descriptor_);
}

bool Output::write(std::string_view text) {
  add(text);
  return end();
}

void Output::add(std::string_view piece) {
  constexpr std::size_t block = std::size_t{1} << 18;
  waiting_ += piece;
  if (waiting_.size() > block) flush();
}

void Output::flush() {
  if (problem_.empty()) problem_ = write_all(descriptor_, waiting_);
  waiting_.clear();
}

bool Output::end() {
  flush();
  if (!path_.empty()) {
    // Some file systems say only now that there was no room.
    if (::close(descriptor_) != 0 && problem_.empty()) problem_ = std::strerror(errno);
    descriptor_ = -1;
  }
  if (!problem_.empty()) complain(problem_);
  return problem_.empty();
}

void Output::complain(const std::string& problem) const {
  const std::string where = path_.empty() ? "standard output" : "'" + path_ + "'";
  print_error("patchproof: cannot write " + where + ": " + problem + "\n");
}

}  // namespace patchproof
