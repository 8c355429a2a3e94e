#include "cli/workers_wanted.h"

#include "cli/stopped_run.h"

namespace tetfarm {

std::size_t workers_wanted(const wire::StatusReply& farm) {
  std::uint64_t tasks = tasks_under_way(farm).size();
  for (const wire::TaskDemand& demand : farm.demand()) tasks += demand.tasks();
  return static_cast<std::size_t>(tasks);
}

}  // namespace tetfarm
