#include <poll.h>
#include <verify/crew.hpp>
#include <verify/file_state.hpp>
#include <verify/run_assembly.hpp>
#include <verify/worker.hpp>
#include <verify/worker_process.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace patchproof {

namespace {

/// So many workers are lost over a file, one after the other, before it is given up. One that is
/// lost for a reason of its own will be lost again; but whoever kills workers at random, or is
/// short of memory for a moment, may meet the same file several times.
constexpr std::size_t most_attempts = 16;

/// So many claims wait for those of a file before theirs, at most.
constexpr std::size_t most_waiting = 20'000;

class Crew {
 public:
  Crew(const Work& work, std::size_t jobs, const WorkProgress& progress)
      : work_{work}, progress_{progress}, members_{jobs}, assembly_{work} {
    done_.unmatched = work.selection.patterns();
  }

  void run() {
    for (;;) {
      assemble();
      give_tasks();
      if (!anyone_works()) return;
      wait();
    }
  }

  WorkDone done() {
    done_.run = assembly_.run();
    return std::move(done_);
  }

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

  /// A file from when somebody is to open it until it is in the record of the run.
  struct BegunFile {
    FileState state;
    /// How many workers were lost over it since one of its items was done.
    std::size_t attempts = 0;
  };

  bool anyone_works() const {
    return std::any_of(members_.begin(), members_.end(),
                       [](const Member& member) { return member.works; });
  }

  void give_tasks() {
    for (Member& member : members_) {
      if (member.works) continue;
      if (!has_task()) return;
      if (!member.process && !start(member)) return;
      member.task = std::move(open_.begin()->second);
      open_.erase(open_.begin());
      member.works = true;
      member.has_opened = false;
      member.at = member.task.first;
      // Whether it is still there shows when it is listened to.
      member.process->tell(message_of(member.task));
    }
  }

  void open(Task task) {
    const std::pair place{task.file, task.first};
    open_.emplace(place, std::move(task));
  }

  // Finds something to do where nothing is left over.
  bool has_task() {
    if (!open_.empty()) return true;
    if (next_file_ == work_.paths.size() || waiting_ > most_waiting) return divide();
    begun_.emplace(next_file_, BegunFile{FileState{work_.paths[next_file_]}, 0});
    open({next_number_++, next_file_++, 0, no_end, {}});
    return true;
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
    const auto file = begun_.find(member.task.file);
    return std::min(member.task.end, file == begun_.end() ? 0 : file->second.state.items());
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
    open({next_number_++, richest->task.file, middle, end, richest->task.lost});
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
    const auto begun = begun_.find(member.task.file);
    if (message.contains("done")) {
      member.works = false;
      for (std::size_t item = member.task.first; item < end_of(member); ++item)
        if (!begun->second.state.has(item)) throw std::logic_error{"a worker has left out an item"};
      return;
    }
    if (message.contains("opened")) {
      member.has_opened = true;
      if (begun == begun_.end()) return;
      FileState& file = begun->second.state;
      const bool is_new = !file.is_described();
      file.describe(message.at("opened"));
      if (is_new) claims_ += file.claims();
      return;
    }
    member.at = message.at("item").get<std::size_t>() + 1;
    if (begun == begun_.end()) return;
    const std::string id = begun->second.state.take(message);
    begun->second.attempts = 0;
    if (id.empty()) return;
    ++waiting_;
    if (progress_) progress_(id, claims_);
  }

  // The rest of its task is for somebody else.
  void lose(Member& member) {
    const std::string how = member.process->last_words();
    member.process.reset();
    if (!member.works) return;
    member.works = false;
    const auto begun = begun_.find(member.task.file);
    if (begun == begun_.end()) return;
    Task& task = member.task;
    if (member.has_opened && member.at >= end_of(member)) return;
    // Neither what is in it nor that this was lost could be said.
    if (!member.has_opened || task.lost.contains(member.at)) {
      if (++begun->second.attempts < most_attempts)
        open(std::move(task));
      else
        begun->second.state.give_up((member.has_opened ? "" : "nothing is known of it; ") + how);
      return;
    }
    task.lost[member.at] = how;
    task.first = work_.whole_files() ? 0 : member.at;
    task.number = next_number_++;
    open(std::move(task));
  }

  // Files that are complete, as far as they are next to each other, go into the record.
  void assemble() {
    for (auto first = begun_.begin();
         first != begun_.end() && first->first == assembled_ && first->second.state.is_complete();
         first = begun_.erase(first), ++assembled_) {
      FileState& file = first->second.state;
      waiting_ -= std::min(waiting_, file.claims());
      FileRecord record = file.record();
      if (record.unreadable.empty())
        std::erase_if(done_.unmatched, [&](const std::string& pattern) {
          return std::find(file.unmatched().begin(), file.unmatched().end(), pattern) ==
                 file.unmatched().end();
        });
      assembly_.add(std::move(record), file.shares());
    }
  }

  const Work& work_;
  const WorkProgress& progress_;
  std::vector<Member> members_;
  /// By the number of the file.
  std::map<std::size_t, BegunFile> begun_;
  /// What nobody works on, by file and first item.
  std::map<std::pair<std::size_t, std::size_t>, Task> open_;
  std::size_t next_file_ = 0;
  std::size_t next_number_ = 0;
  std::size_t claims_ = 0;
  /// So many claims are decided and not in the record.
  std::size_t waiting_ = 0;
  std::size_t assembled_ = 0;
  RunAssembly assembly_;
  WorkDone done_;
};

}  // namespace

WorkDone done_by_crew(const Work& work, std::size_t jobs, const WorkProgress& progress) {
  Crew crew{work, std::max<std::size_t>(1, jobs), progress};
  crew.run();
  return crew.done();
}

}  // namespace patchproof
