// `tetfarm pool slurm` with a real Slurm: nodes, controller, preemption, and what survives them.
#include "tests/system/batch_farm.h"

namespace tetfarm {
namespace {

using test::comes_true;
using test::shell;

class SlurmFarm : public test::BatchFarm {
 protected:
  void SetUp() override {
    const bool installed = shell("command -v munged slurmctld slurmd sbatch | wc -l") == "4\n";
    if (!is_there(installed, "Slurm", "./dev packages batch")) GTEST_SKIP();
    slurm_ = folder_of_test_.path() / "slurm";
    // munge wants its socket to be reachable by all.
    std::filesystem::permissions(folder_of_test_.path(), std::filesystem::perms(0711));
    ::setenv("SLURM_CONF", (slurm_ / "slurm.conf").c_str(), 1);
    // Below the ports that the system hands out by itself.
    const int port = 20'000 + ::getpid() % 1'200 * 10;
    const CommandOutcome up =
        farm("up", "3 " + std::to_string(port) + " " + std::to_string(::getpid()));
    ASSERT_EQ(up.code, 0) << up.err;
    start_coordinator(folder_of_test_.path());
  }
  void TearDown() override {
    if (!slurm_.empty()) farm("down", "");
  }
  CommandOutcome farm(const std::string& action, const std::string& more) const {
    return run_command({{"bash", "-c",
                         test::sources() + "/tests/system/slurm_farm.sh " + action + " " +
                             slurm_.string() + " " + more},
                        ""},
                       90'000);
  }
  static std::string job_name() { return "tetfarm-" + pool_name() + "-1024M"; }
  static int jobs() { return std::stoi("0" + shell("squeue -h -r -n " + job_name() + " | wc -l")); }
  static std::string running() {
    return shell("squeue -h -r -t RUNNING -n " + job_name() + " -o %i | head -1 | tr -d '\\n'");
  }

  test::TemporaryFolder folder_of_test_;
  std::filesystem::path slurm_;
};

TEST_F(SlurmFarm, gives_the_mesh_of_a_local_run_and_lets_its_workers_go) {
  submit_job(small_job);
  const test::JobCounter counter([] { return jobs(); });
  const auto pool = this->pool("slurm", {});
  expect_the_mesh_of_a_local_run();
  EXPECT_EQ(counter.most(), most_jobs);
  EXPECT_TRUE(comes_true(60, [] { return jobs() == 0; })) << "idle workers leave";
  pool->signal(SIGTERM);
  EXPECT_EQ(pool->wait().code, 0);
  EXPECT_EQ(pool->out_so_far().find("\"cancelled\""), std::string::npos)
      << "they were drained, not cancelled: " << pool->out_so_far();
}

TEST_F(SlurmFarm, gives_the_same_mesh_without_a_shared_folder) {
  submit_job(small_job);
  has_shared_store_ = false;
  const auto pool = this->pool("slurm", {});
  expect_the_mesh_of_a_local_run();
  expect_that_files_came_over_the_connection();
}

TEST_F(SlurmFarm, goes_on_through_preemption_and_a_signal_of_the_operator) {
  submit_job(small_job);
  const auto pool = this->pool("slurm", {});
  ASSERT_TRUE(comes_true(120, [&] { return has_done(3); }));
  shell("scancel --batch --signal=TERM " + running());
  shell("sbatch -p urgent --array=1-3 --exclusive --output=/dev/null --wrap 'sleep 3'");
  EXPECT_TRUE(comes_true(60, [] {
    return shell("squeue -h -p urgent -t RUNNING | wc -l") != "0\n";
  })) << "workers are preempted";
  expect_the_mesh_of_a_local_run();
}

TEST_F(SlurmFarm, goes_on_when_a_node_dies) {
  submit_job(larger_job);
  const auto pool = this->pool("slurm", {});
  ASSERT_TRUE(comes_true(120, [&] { return has_done(3) && !running().empty(); }));
  const std::string node = shell("squeue -h -r -j " + running() + " -o %N | tr -d '\\n'");
  ASSERT_EQ(farm("kill-node", node).code, 0);
  expect_the_mesh_of_a_local_run();
  EXPECT_GE(lost_attempts(), 1U) << "what ran on the node";
}

TEST_F(SlurmFarm, goes_on_when_controller_coordinator_and_pool_are_killed) {
  submit_job(small_job);
  const test::JobCounter counter([] { return jobs(); });
  auto pool = this->pool("slurm", {});
  ASSERT_TRUE(comes_true(120, [&] { return has_done(3); }));
  farm("kill-controller", "");
  pool->signal(SIGKILL);
  pool->wait();
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  pool = this->pool("slurm", {});
  std::this_thread::sleep_for(std::chrono::seconds(3));
  start_coordinator(folder_);
  farm("start-controller", "");
  expect_the_mesh_of_a_local_run();
  EXPECT_LE(counter.most(), most_jobs) << "the new pool knew the jobs of the old one";
  pool->signal(SIGTERM);
  pool->wait();
  const test::Ended stopped = this->pool("slurm", {"--stop"})->wait();
  EXPECT_EQ(stopped.code, 0) << stopped.err;
  EXPECT_EQ(jobs(), 0);
}

}  // namespace
}  // namespace tetfarm
