#include "worker/task_program.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/large_blocks.h"
#include "tasks/task_kind.h"
#include "worker/child_task.h"
#include "worker/run_task.h"

namespace tetfarm {

/// Each kind's function is in its file, KIND_task.h.
#define TETFARM_DECLARED(kind) void kind##_task(TaskIo& io);
TETFARM_TASK_KINDS(TETFARM_DECLARED)
#undef TETFARM_DECLARED

namespace {

#define TETFARM_BODY(kind) kind##_task,
const std::array<void (*)(TaskIo&), all_task_kinds.size()> bodies = {
    TETFARM_TASK_KINDS(TETFARM_BODY)};
#undef TETFARM_BODY

/// Kinds that this program does not know have no body.
TaskBody body_of(const wire::Assign& assign) {
  const std::optional<TaskKind> kind = task_kind_on_wire(assign.kind());
  return kind ? TaskBody(bodies.at(static_cast<std::size_t>(*kind))) : nullptr;
}

std::string read_all(int fd) {
  std::string bytes;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(fd, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw IoError("cannot read the task", "standard input", errno);
    if (n == 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

void write_frame(int fd, const wire::Envelope& envelope) {
  const std::string frame = frame_of(envelope);
  std::size_t written = 0;
  while (written < frame.size()) {
    const ssize_t n = ::write(fd, frame.data() + written, frame.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw IoError("cannot write to the worker", "task result", errno);
    written += static_cast<std::size_t>(n);
  }
}

void choose_memory_for(const wire::Assign& assign) {
  const std::optional<TaskKind> kind = task_kind_on_wire(assign.kind());
  if (kind && traits_of(*kind).reads_file_by_file) {
    keep_freed_memory();
  } else {
    give_back_large_blocks();
  }
}

}  // namespace

void run_task_program(const std::filesystem::path& store, int in, int out) {
  ::prctl(PR_SET_NAME, "tetfarm-task");  // what `top` shows
  wire::TaskStart start;
  if (!start.ParseFromString(read_all(in))) {
    throw Error(ExitCode::failed, "the assignment cannot be read");
  }
  const wire::Assign& assign = start.assign();
  choose_memory_for(assign);
  const auto say = [out](const wire::Doing& doing) {
    wire::Envelope envelope;
    *envelope.mutable_heartbeat()->mutable_doing() = doing;
    write_frame(out, envelope);
  };
  write_frame(out, run_task_in(store, assign, body_of(assign), say, start.without_shared_store()));
}

}  // namespace tetfarm
