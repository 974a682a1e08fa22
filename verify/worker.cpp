#include <poll.h>
#include <verify/open_file.hpp>
#include <verify/worker.hpp>

#include <algorithm>
#include <optional>

namespace patchproof {

namespace {

Task task_from(const Message& message) {
  const auto number = [&](const char* member) { return message.at(member).get<std::size_t>(); };
  Task task{number("task"), number("file"), number("first"), number("end"), {}};
  for (const Message& one : message.at("lost"))
    task.lost.emplace(one.at(0).get<std::size_t>(), one.at(1).get<std::string>());
  return task;
}

/// The process that works.
class Worker {
 public:
  Worker(const Work& work, int tasks, int answers)
      : work_{work}, tasks_{tasks}, inbox_{tasks}, answers_{answers} {}

  void run() {
    while (const std::optional<Task> task = next_task())
      if (!work_on(*task)) return;
  }

 private:
  std::optional<Task> next_task() {
    for (;;) {
      while (const std::optional<Message> message = inbox_.next())
        if (!message->contains("until")) return task_from(*message);
      if (!inbox_.receive()) return std::nullopt;
    }
  }

  bool work_on(const Task& task) {
    if (!open_ || open_->number() != task.file) {
      open_.reset();
      open_.emplace(work_, task.file);
    }
    if (!send(answers_, {{"opened", open_->description()}})) return false;
    std::size_t end = std::min(task.end, open_->size());
    for (std::size_t k = task.first; k < end; ++k) {
      const auto lost = task.lost.find(k);
      if (!send(answers_, open_->item(k, lost == task.lost.end() ? nullptr : &lost->second)))
        return false;
      end = std::min(end, end_now(task.number));
    }
    return send(answers_, {{"done", true}});
  }

  // Whether somebody else has taken over a part.
  std::size_t end_now(std::size_t task) {
    std::size_t end = static_cast<std::size_t>(-1);
    pollfd waiting{tasks_, POLLIN, 0};
    while (::poll(&waiting, 1, 0) > 0 && (waiting.revents & POLLIN) != 0 && inbox_.receive())
      while (const std::optional<Message> message = inbox_.next())
        if (message->at("task").get<std::size_t>() == task)
          end = std::min(end, message->at("until").get<std::size_t>());
    return end;
  }

  const Work& work_;
  int tasks_;
  Mailbox inbox_;
  int answers_;
  std::optional<OpenFile> open_;
};

}  // namespace

Message message_of(const Task& task) {
  Message lost = Message::array();
  for (const auto& [item, how] : task.lost) lost.push_back({item, how});
  return {{"task", task.number},
          {"file", task.file},
          {"first", task.first},
          {"end", task.end},
          {"lost", std::move(lost)}};
}

Message shortened(const Task& task) { return {{"task", task.number}, {"until", task.end}}; }

void work_through(const Work& work, int tasks, int answers) { Worker{work, tasks, answers}.run(); }

}  // namespace patchproof
