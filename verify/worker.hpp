#pragma once

#include <verify/message.hpp>
#include <verify/work.hpp>

namespace patchproof {

/// A task as a message for a worker.
Message message_of(const Task& task);
/// Tells a worker that the rest of its task, from its end on, has been given to somebody else; it
/// may come too late.
Message shortened(const Task& task);

/// Does the tasks that arrive through one pipe, and tells through the other what came of them,
/// until no more can come. Of each task: what is in the file, then each of its items, then that it
/// is done.
void work_through(const Work& work, int tasks, int answers);

}  // namespace patchproof
