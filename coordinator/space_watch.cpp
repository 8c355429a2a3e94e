#include "coordinator/space_watch.h"

#include <algorithm>
#include <utility>

#include "base/mebibytes.h"
#include "coordinator/decisions/task_rows.h"

namespace tetfarm {
namespace {

constexpr std::int64_t look_again_ms = 500;
/// Of a tet, with the nodes inside; store/formats.md.
constexpr std::uint64_t bytes_per_element = 20;

std::uint64_t sum(const std::vector<ArtifactRef>& files) {
  std::uint64_t bytes = 0;
  for (const ArtifactRef& file : files) bytes += file.size;
  return bytes;
}

/// What a task writes at most for each byte that it reads. The last one puts in a row what it
/// reads, and most of that lies in the file of the mesh already.
std::uint64_t bytes_of_byte_read(TaskKind kind) { return kind == TaskKind::assemble ? 1 : 2; }

/// Estimated elements of a task that is told them; 0 of others.
std::uint64_t work_of(const TaskRow& task) {
  return static_cast<std::uint64_t>(told_size(task).value_or(ToldSize{}).elements);
}

}  // namespace

void SpaceWatch::note(const TaskRow& task) {
  if (task.state != TaskState::done) return;
  std::uint64_t& bytes = largest_[{task.job, task.kind}];
  bytes = std::max(bytes, sum(task.outputs));
}

std::uint64_t SpaceWatch::expected_bytes(const JobState& state, std::size_t workers) const {
  std::uint64_t expected = 0;
  for (const TaskId id : state.running_and_next(workers)) {
    const TaskRow& task = state.durable().tasks.at(id);
    const auto known = largest_.find({task.job, task.kind});
    const bool by_work = task.kind == TaskKind::mesh && work_of(task) > 0;
    expected += known != largest_.end() ? known->second
                : by_work               ? bytes_per_element * work_of(task)
                                        : bytes_of_byte_read(task.kind) * sum(task.inputs);
  }
  return expected;
}

std::string SpaceWatch::trouble(const JobState& state, Moment now) {
  if (now.steady_ms < next_look_ms_) return "";
  next_look_ms_ = now.steady_ms + look_again_ms;
  const std::uint64_t wanted = expected_bytes(state, state.worker_count());
  const DiskRoom room = room_of_(store_);
  if (wanted > 0 && !room.has(wanted)) {
    return store_.string() + ": " + mebibytes(room.free_bytes) + " free, " + mebibytes(wanted) +
           " needed for what runs and comes next, " + mebibytes(room.reserve()) +
           " kept in reserve";
  }
  const DiskRoom own = room_of_(database_);
  if (wanted > 0 && !own.has(0)) {
    return database_.string() + ": " + mebibytes(own.free_bytes) + " free for the database";
  }
  return "";
}

}  // namespace tetfarm
