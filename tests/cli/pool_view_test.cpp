#include "cli/pool_view.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(PoolView, adds_up_what_asks_for_the_same_memory) {
  wire::StatusReply reply;
  for (const auto& [bytes, tasks] : {std::pair(4, 2), {8, 1}, {4, 5}}) {
    wire::TaskDemand& demand = *reply.add_demand();
    demand.set_memory_bytes(static_cast<std::uint64_t>(bytes));
    demand.set_tasks(static_cast<std::uint32_t>(tasks));
  }
  EXPECT_THAT(coordinator_view(reply, false).demand, ElementsAre(Pair(4, 7), Pair(8, 1)));
}

TEST(PoolView, sees_what_waits_for_solvers_where_its_workers_run_them) {
  wire::StatusReply reply;
  reply.add_demand()->set_tasks(3);
  wire::TaskDemand& solvers = *reply.add_demand();
  solvers.set_tasks(2);
  solvers.set_of_solvers(true);
  EXPECT_THAT(coordinator_view(reply, false).demand, ElementsAre(Pair(0, 3)));
  EXPECT_THAT(coordinator_view(reply, true).demand, ElementsAre(Pair(0, 5)));
}

TEST(PoolView, shuns_the_workers_of_hosts_in_quarantine) {
  wire::StatusReply reply;
  reply.add_hosts()->set_host("bad");
  for (const char* host : {"good", "bad"}) {
    wire::WorkerStatus& worker = *reply.add_at_work();
    worker.set_host(host);
    worker.set_worker(7);
    worker.set_tag("farm/1");
    worker.set_task(3);
    worker.set_memory_bytes(100);
  }
  const std::vector<PoolWorker> workers = coordinator_view(reply, false).workers;
  ASSERT_EQ(workers.size(), 2U);
  EXPECT_FALSE(workers[0].is_shunned);
  EXPECT_TRUE(workers[1].is_shunned);
  EXPECT_EQ(workers[0].worker, 7U);
  EXPECT_EQ(workers[0].tag, "farm/1");
  EXPECT_TRUE(workers[0].is_busy);
  EXPECT_FALSE(workers[0].drains);
  EXPECT_EQ(workers[0].bytes, 100U);
}

}  // namespace
}  // namespace tetfarm
