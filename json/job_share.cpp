#include "json/job_share.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/check.h"
#include "json/reply_values.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

/// A part of the work, which a job that is at a later kind of task has behind it.
struct PartOfWork {
  TaskKind last = TaskKind::inspect;  ///< kind of task of it
  double weight = 0;                  ///< all together 1
};

constexpr std::array<PartOfWork, 6> parts_of_work = {{{TaskKind::inspect, 0.04},
                                                      {TaskKind::assimilate, 0.14},
                                                      {TaskKind::mesh, 0.45},
                                                      {TaskKind::cosmetic, 0.12},
                                                      {TaskKind::write, 0.2},
                                                      {TaskKind::assemble, 0.05}}};

double ratio(double part, double whole) {
  return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
}

/// Of a part that is not behind the job yet.
double share_of_part(const wire::JobStatus& status, TaskKind last, double share_of_meshing) {
  const double leaves = status.leaves_made();
  switch (last) {
    case TaskKind::assimilate:
      return ratio(leaves, number_of(status, "parts"));
    case TaskKind::mesh:
      return share_of_meshing;
    case TaskKind::cosmetic:
      return ratio(status.leaves_mended(), leaves);
    case TaskKind::write:
      return ratio(number_of(status, "task_write_count"), leaves);
    default:
      return 0;
  }
}

/// Each cycle has a task that solves and, but for the first, one that adapts; collecting is the
/// last.
double share_of_loop(const wire::JobStatus& status) {
  return ratio(static_cast<double>(status.tasks_done()), 2 * number_of(status, "cycles"));
}

}  // namespace

double share_of_job(const wire::JobStatus& status, double share_of_meshing) {
  TF_CHECK(share_of_meshing >= 0 && share_of_meshing <= 1);
  if (status.state() == "done") return 1;
  const std::optional<TaskKind> stage = task_kind_named(status.stage());
  if (!stage) return 0;
  if (*stage <= TaskKind::collect) return share_of_loop(status);
  double share = 0;
  for (const PartOfWork& part : parts_of_work) {
    const bool is_behind = *stage > part.last;
    share += part.weight * (is_behind ? 1 : share_of_part(status, part.last, share_of_meshing));
  }
  return std::min(share, 1.0);
}

}  // namespace tetfarm
