// `tetfarm pool condor` with a real HTCondor: eviction, and death of what runs the jobs.
#include "tests/system/batch_farm.h"

namespace tetfarm {
namespace {

using test::comes_true;
using test::shell;

class CondorFarm : public test::BatchFarm {
 protected:
  void SetUp() override {
    const bool installed = farm("installed", "").code == 0;
    if (!is_there(installed, "HTCondor", "./dev packages batch, as root")) GTEST_SKIP();
    // Jobs belong to another user, who shares the folder.
    shell("chmod 755 " + folder() + " && chown 1000:1000 " + folder());
    const CommandOutcome up = farm("up", folder() + " " + std::to_string(::getpid()));
    is_up_ = true;
    ASSERT_EQ(up.code, 0) << up.err;
    bring_program();
    launcher_ = {"/bin/bash",
                 script(),
                 "exec",
                 folder(),
                 "env",
                 "LD_LIBRARY_PATH=" + folder() + "/lib",
                 folder() + "/tetfarm"};
    start_coordinator(folder_of_test_.path());
  }
  void TearDown() override {
    if (is_up_) farm("down", folder());
  }
  /// The program and its libraries, which the other root has not; but with its own C library.
  void bring_program() const {
    shell("cp " + test::built_program().string() + " " + folder() + "/tetfarm && mkdir -p " +
          folder() + "/lib && cp $(ldd " + test::built_program().string() +
          " | awk '$3 ~ /^\\// {print $3}' |"
          " grep -vE '/lib(c|m|pthread|dl|rt|gcc_s|stdc\\+\\+)\\.so') " +
          folder() + "/lib");
  }
  std::unique_ptr<test::Program> start_pool() {
    return pool("condor", {"--option", "environment = \"LD_LIBRARY_PATH=" + folder() + "/lib\""});
  }
  static std::string script() { return test::sources() + "/tests/system/condor_farm.sh"; }
  std::string folder() const { return folder_of_test_.path().string(); }
  static CommandOutcome farm(const std::string& action, const std::string& more) {
    return run_command({{"bash", "-c", script() + " " + action + " " + more}, ""}, 120'000);
  }
  std::string condor(const std::string& command) const {
    return shell(script() + " exec " + folder() + " " + command);
  }
  int jobs() const {
    const std::string list = condor("condor_q -af ClusterId ProcId JobStatus");
    return static_cast<int>(std::count(list.begin(), list.end(), '\n'));
  }
  /// Up to so many jobs whose workers run, as words.
  std::string running(int most) const {
    return shell(script() + " exec " + folder() +
                 " condor_q -constraint JobStatus==2 -af ClusterId ProcId | tr ' ' . | head -" +
                 std::to_string(most) + " | tr '\\n' ' '");
  }

  test::TemporaryFolder folder_of_test_;
  bool is_up_ = false;
};

TEST_F(CondorFarm, gives_the_mesh_of_a_local_run_and_lets_its_workers_go) {
  submit_job(small_job);
  const test::JobCounter counter([this] { return jobs(); });
  const auto pool = start_pool();
  expect_the_mesh_of_a_local_run();
  EXPECT_EQ(counter.most(), most_jobs);
  EXPECT_TRUE(comes_true(60, [this] { return jobs() == 0; })) << "idle workers leave";
  EXPECT_EQ(pool->out_so_far().find("\"cancelled\""), std::string::npos)
      << "they were drained, not cancelled: " << pool->out_so_far();
}

TEST_F(CondorFarm, gives_the_same_mesh_without_a_shared_folder) {
  submit_job(small_job);
  has_shared_store_ = false;
  const auto pool = start_pool();
  expect_the_mesh_of_a_local_run();
  expect_that_files_came_over_the_connection();
}

TEST_F(CondorFarm, goes_on_when_workers_are_vacated) {
  submit_job(larger_job);
  const auto pool = start_pool();
  ASSERT_TRUE(comes_true(120, [&] { return has_done(3) && !running(1).empty(); }));
  condor("condor_vacate_job " + running(1));
  ASSERT_TRUE(comes_true(120, [&] { return has_done(6) && !running(1).empty(); }));
  const auto vacate = [&] {
    const std::string jobs = running(3);
    if (!jobs.empty()) condor("condor_vacate_job -fast " + jobs);
    return !jobs.empty();
  };
  EXPECT_TRUE(loses_an_attempt(vacate)) << "whoever is killed loses what it did";
  expect_the_mesh_of_a_local_run();
}

TEST_F(CondorFarm, goes_on_when_starters_the_queue_the_coordinator_and_the_pool_are_killed) {
  submit_job(larger_job);
  auto pool = start_pool();
  ASSERT_TRUE(comes_true(120, [&] { return has_done(3); }));
  const test::JobCounter counter([this] { return jobs(); });
  EXPECT_TRUE(loses_an_attempt(
      [&] { return !running(1).empty() && farm("kill", folder() + " condor_starter").code == 0; }));
  ASSERT_TRUE(comes_true(120, [&] { return has_done(5); }));
  farm("kill", folder() + " condor_schedd");
  pool->signal(SIGKILL);
  pool->wait();
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  pool = start_pool();
  start_coordinator(folder_);
  expect_the_mesh_of_a_local_run();
  EXPECT_LE(counter.most(), most_jobs) << "the new pool knew the jobs of the old one";
}

}  // namespace
}  // namespace tetfarm
