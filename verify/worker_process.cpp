#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <verify/files.hpp>
#include <verify/worker.hpp>
#include <verify/worker_process.hpp>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace patchproof {

namespace {

struct Pipe {
  int from = -1;
  int into = -1;
};

Pipe new_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {};
  return {ends[0], ends[1]};
}

void close(const Pipe& pipe) {
  for (const int end : {pipe.from, pipe.into})
    if (end >= 0) ::close(end);
}

// The process that works; nothing of what the other one had begun is finished here.
[[noreturn]] void work_alone(const Work& work, int tasks, int answers) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  constexpr int fault = 70;
  int code = 0;
  try {
    work_through(work, tasks, answers);
  } catch (const std::exception& error) {
    print_error(std::string{"patchproof: a worker gave up: "} + error.what() + "\n");
    code = fault;
  }
  ::_exit(code);
}

}  // namespace

WorkerProcess::WorkerProcess(const Work& work, const std::vector<int>& others)
    : tasks_{-1}, answers_{-1}, mailbox_{-1} {
  const Pipe tasks = new_pipe();
  const Pipe answers = new_pipe();
  if (tasks.from >= 0 && answers.from >= 0) child_ = ::fork();
  if (child_ < 0) {
    const int why = errno;
    close(tasks);
    close(answers);
    throw std::system_error{why, std::generic_category()};
  }
  if (child_ == 0) {
    // Whoever holds an end keeps the other side waiting.
    for (const int other : others) ::close(other);
    ::close(tasks.into);
    ::close(answers.from);
    work_alone(work, tasks.from, answers.into);
  }
  ::close(tasks.from);
  ::close(answers.into);
  tasks_ = tasks.into;
  answers_ = answers.from;
  mailbox_ = Mailbox{answers_};
}

WorkerProcess::~WorkerProcess() {
  ::close(tasks_);
  ::close(answers_);
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

std::string WorkerProcess::last_words() {
  int status = 0;
  ::waitpid(child_, &status, 0);
  child_ = -1;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "limit: it did not end in time, and was ended";
  if (WIFSIGNALED(status))
    return "crash: ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
           ::strsignal(WTERMSIG(status)) + ")";
  return "crash: ended with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace patchproof
