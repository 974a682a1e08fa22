#pragma once

#include <sys/types.h>
#include <verify/message.hpp>
#include <verify/work.hpp>

#include <string>
#include <vector>

namespace patchproof {

/// A worker in a process of its own, which has all that this process has had when it began. GiNaC
/// cannot be used by two threads, and what one claim does to its process is no harm to others.
class WorkerProcess {
 public:
  /// `others` are the descriptors of workers that were started before.
  /// @throws std::system_error when no process can be started.
  WorkerProcess(const Work& work, const std::vector<int>& others);
  /// Ends it.
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// To be waited for; then `mailbox` has something to receive, or its end.
  int descriptor() const { return answers_; }
  std::vector<int> descriptors() const { return {tasks_, answers_}; }
  Mailbox& mailbox() { return mailbox_; }
  /// False when it is there no more.
  bool tell(const Message& message) { return send(tasks_, message); }
  /// After the end of its mailbox: how it ended, "crash: ended by signal 11 (Segmentation fault)".
  std::string last_words();

 private:
  int tasks_;
  int answers_;
  Mailbox mailbox_;
  pid_t child_ = -1;
};

}  // namespace patchproof
