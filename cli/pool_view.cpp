#include "cli/pool_view.h"

#include <set>
#include <string>

namespace tetfarm {

CoordinatorView coordinator_view(const wire::StatusReply& reply, bool runs_solvers) {
  std::set<std::string> bad_hosts;
  for (const wire::HostInQuarantine& host : reply.hosts()) bad_hosts.insert(host.host());
  CoordinatorView view;
  for (const wire::WorkerStatus& worker : reply.at_work()) {
    view.workers.push_back({worker.worker(), worker.tag(), worker.task() != 0, worker.drains(),
                            worker.memory_bytes(), bad_hosts.contains(worker.host())});
  }
  for (const wire::TaskDemand& demand : reply.demand()) {
    if (demand.of_solvers() && !runs_solvers) continue;
    view.demand[demand.memory_bytes()] += demand.tasks();
  }
  return view;
}

}  // namespace tetfarm
