#include <poll.h>
#include <verify/crew.hpp>
#include <verify/file_state.hpp>
#include <verify/run_assembly.hpp>
#include <verify/worker.hpp>
#include <verify/worker_process.hpp>

#include <algorithm>
#include <deque>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace patchproof {

namespace {

/// So many workers are lost over a file, one after the other, before it is given up. One that is
/// lost for a reason of its own will be lost again; but whoever kills workers at random, or is
/// short of memory for a moment, may meet the same file several times.
constexpr std::size_t most_attempts = 16;

class Crew {
 public:
  Crew(const Work& work, std::size_t jobs, const WorkProgress& progress)
      : work_{work}, progress_{progress}, members_{jobs}, attempts_(work.paths.size(), 0) {
    for (const std::string& path : work.paths) files_.emplace_back(path);
    for (std::size_t file = 0; file < work.paths.size(); ++file)
      open_.push_back({next_number_++, file, 0, no_end, {}});
  }

  void run() {
    for (;;) {
      give_tasks();
      if (!anyone_works()) return;
      wait();
    }
  }

  std::vector<FileState>& files() { return files_; }

 private:
  static constexpr std::size_t no_end = static_cast<std::size_t>(-1);

  struct Member {
    std::unique_ptr<WorkerProcess> process;
    bool works = false;
    Task task;
    bool has_opened = false;
    /// What it is at: it answers in order.
    std::size_t at = 0;
  };

  bool anyone_works() const {
    return std::any_of(members_.begin(), members_.end(),
                       [](const Member& member) { return member.works; });
  }

  void give_tasks() {
    for (Member& member : members_) {
      if (member.works) continue;
      if (open_.empty() && !divide()) return;
      if (!member.process && !start(member)) return;
      member.task = std::move(open_.front());
      open_.pop_front();
      member.works = true;
      member.has_opened = false;
      member.at = member.task.first;
      // Whether it is still there shows when it is listened to.
      member.process->tell(message_of(member.task));
    }
  }

  // Where processes are scarce, fewer have to do.
  bool start(Member& member) {
    std::vector<int> others;
    for (const Member& other : members_)
      if (other.process)
        for (const int descriptor : other.process->descriptors()) others.push_back(descriptor);
    try {
      member.process = std::make_unique<WorkerProcess>(work_, others);
      return true;
    } catch (const std::system_error&) {
      if (!anyone_works()) throw;
      return false;
    }
  }

  std::size_t end_of(const Member& member) const {
    return std::min(member.task.end, files_[member.task.file].items());
  }

  // Takes the latter half of what the member with most items left has not begun.
  bool divide() {
    if (work_.whole_files()) return false;
    Member* richest = nullptr;
    std::size_t most = 0;
    for (Member& member : members_) {
      if (!member.works || !member.has_opened || end_of(member) <= member.at + 1) continue;
      const std::size_t left = end_of(member) - member.at - 1;
      if (left > most) {
        most = left;
        richest = &member;
      }
    }
    if (richest == nullptr) return false;
    const std::size_t end = end_of(*richest);
    const std::size_t middle = end - (most + 1) / 2;
    open_.push_back({next_number_++, richest->task.file, middle, end, richest->task.lost});
    richest->task.end = middle;
    richest->process->tell(shortened(richest->task));
    return true;
  }

  void wait() {
    std::vector<pollfd> waiting;
    std::vector<Member*> of;
    for (Member& member : members_) {
      if (!member.works) continue;
      waiting.push_back({member.process->descriptor(), POLLIN, 0});
      of.push_back(&member);
    }
    if (::poll(waiting.data(), waiting.size(), -1) <= 0) return;
    for (std::size_t k = 0; k < waiting.size(); ++k)
      if (waiting[k].revents != 0) listen(*of[k]);
  }

  void listen(Member& member) {
    if (!member.process->mailbox().receive()) return lose(member);
    while (const std::optional<Message> message = member.process->mailbox().next())
      hear(member, *message);
  }

  void hear(Member& member, const Message& message) {
    FileState& file = files_[member.task.file];
    if (message.contains("opened")) {
      member.has_opened = true;
      const bool is_new = !file.is_described();
      file.describe(message.at("opened"));
      if (is_new) claims_ += file.claims();
    } else if (message.contains("done")) {
      member.works = false;
      for (std::size_t item = member.task.first; item < end_of(member); ++item)
        if (!file.has(item)) throw std::logic_error{"a worker has left out an item"};
    } else {
      const std::string id = file.take(message);
      attempts_[member.task.file] = 0;
      member.at = message.at("item").get<std::size_t>() + 1;
      if (!id.empty() && progress_) progress_(id, claims_);
    }
  }

  // The rest of its task is for somebody else.
  void lose(Member& member) {
    const std::string how = member.process->last_words();
    member.process.reset();
    if (!member.works) return;
    member.works = false;
    Task& task = member.task;
    FileState& file = files_[task.file];
    if (member.has_opened && member.at >= end_of(member)) return;
    // Neither what is in it nor that this was lost could be said.
    if (!member.has_opened || task.lost.contains(member.at)) {
      if (++attempts_[task.file] < most_attempts)
        open_.push_back(task);
      else
        file.give_up((member.has_opened ? "" : "nothing is known of it; ") + how);
      return;
    }
    task.lost[member.at] = how;
    task.first = work_.whole_files() ? 0 : member.at;
    task.number = next_number_++;
    open_.push_front(task);
  }

  const Work& work_;
  const WorkProgress& progress_;
  std::vector<Member> members_;
  std::vector<FileState> files_;
  std::vector<std::size_t> attempts_;
  std::deque<Task> open_;
  std::size_t next_number_ = 0;
  std::size_t claims_ = 0;
};

}  // namespace

WorkDone done_by_crew(const Work& work, std::size_t jobs, const WorkProgress& progress) {
  Crew crew{work, std::max<std::size_t>(1, jobs), progress};
  crew.run();
  WorkDone done{{}, work.selection.patterns()};
  RunAssembly run{work};
  for (FileState& file : crew.files()) {
    FileRecord record = file.record();
    if (record.unreadable.empty())
      std::erase_if(done.unmatched, [&](const std::string& pattern) {
        return std::find(file.unmatched().begin(), file.unmatched().end(), pattern) ==
               file.unmatched().end();
      });
    run.add(std::move(record), file.shares());
  }
  done.run = run.run();
  return done;
}

}  // namespace patchproof
