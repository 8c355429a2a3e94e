#include "cli/service_options.h"

#include <gmock/gmock.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

TEST(ServiceOptions, of_a_coordinator_are_those_of_its_command_line) {
  CoordinatorCommand command;
  command.store = "s";
  command.database = "d";
  command.keys = "k";
  command.endpoints = {"tcp://h:1", "ipc://x"};
  command.allowed_roots = {"/a", "/b"};
  command.max_connections = 11;
  command.max_workers = 12;
  command.heartbeat_ms = 13;
  command.lease_ms = 14;
  command.task_limit_s = 1.5;
  command.first_task_limit_s = 2.5;
  command.http_address = "127.0.0.1:8080";
  command.http_token = "token";
  command.on_job_end = "/etc/told";
  command.keep_days = 0.5;
  command.jobs_per_user = 3;
  const CoordinatorOptions options = coordinator_options(command);
  EXPECT_EQ(options.store, "s");
  EXPECT_EQ(options.database, "d");
  EXPECT_EQ(options.keys, "k");
  EXPECT_THAT(options.endpoints, ElementsAre("tcp://h:1", "ipc://x"));
  EXPECT_THAT(options.allowed_roots, ElementsAre("/a", "/b"));
  EXPECT_EQ(options.max_connections, 11U);
  EXPECT_EQ(options.max_workers, 12U);
  EXPECT_EQ(options.heartbeat_ms, 13);
  EXPECT_EQ(options.lease_ms, 14);
  EXPECT_EQ(options.task_limit_ms, 1'500);
  EXPECT_EQ(options.first_task_limit_ms, 2'500);
  EXPECT_EQ(options.http_address, "127.0.0.1:8080");
  EXPECT_EQ(options.http_token, "token");
  EXPECT_EQ(options.on_job_end, "/etc/told");
  EXPECT_EQ(options.keep_ms, 43'200'000);
  EXPECT_EQ(options.jobs_per_user, 3U);
  EXPECT_FALSE(options.insecure || options.one_job);
  EXPECT_TRUE(options.log_to_stderr);
  command.insecure = true;
  EXPECT_TRUE(coordinator_options(command).insecure);
  command.insecure = false;
  command.one_job = true;
  EXPECT_TRUE(coordinator_options(command).one_job);
  EXPECT_FALSE(coordinator_options(command).insecure);
}

TEST(ServiceOptions, of_a_coordinator_tell_where_it_listens_unless_it_is_quiet) {
  CoordinatorCommand command;
  const auto said = [&command] {
    const CoordinatorOptions options = coordinator_options(command);
    ::testing::internal::CaptureStdout();
    options.on_listening({"tcp://h:1", "ipc://x"});
    options.on_http("h:8080");
    return ::testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(said(),
            "listening on tcp://h:1\nlistening on ipc://x\nstatus page on http://h:8080/\n");
  command.quiet = true;
  EXPECT_EQ(said(), "");
  EXPECT_FALSE(coordinator_options(command).log_to_stderr);
}

std::string empty_environment(const char* /*name*/) { return ""; }

TEST(ServiceOptions, of_a_worker_are_those_of_its_command_line) {
  WorkerCommand command;
  command.endpoint = "tcp://h:1";
  command.keys = {"w.key", "c.pub"};
  command.store = "/farm";
  command.cache = "/cache";
  command.cache_bytes = 11;
  command.memory_bytes = 12;
  command.pool_memory_bytes = 13;
  command.tag = "p/1";
  command.solvers = true;
  command.grace_s = 1.5;
  command.walltime_s = 2.5;
  const WorkerOptions options = worker_options(command, empty_environment, 0);
  EXPECT_EQ(options.endpoint, "tcp://h:1");
  EXPECT_EQ(options.keys.own, "w.key");
  EXPECT_EQ(options.keys.coordinator, "c.pub");
  EXPECT_EQ(options.store, "/farm");
  EXPECT_EQ(options.cache, "/cache");
  EXPECT_EQ(options.cache_bytes, 11U);
  EXPECT_EQ(options.memory_bytes, 12U);
  EXPECT_EQ(options.pool_memory_bytes, 13U);
  EXPECT_EQ(options.tag, "p/1");
  EXPECT_TRUE(options.runs_solvers);
  EXPECT_EQ(options.grace_ms, 1'500);
  EXPECT_EQ(options.ends_in_ms, 2'500);
  EXPECT_THAT(options.task_command, ElementsAre("/proc/self/exe", "task"));
  EXPECT_THAT(options.host_command, ElementsAre("/proc/self/exe", "task-host"));
}

TEST(ServiceOptions, of_a_worker_have_whole_paths) {
  WorkerCommand command;
  command.store = "farm";
  command.cache = "cache";
  const WorkerOptions options = worker_options(command, empty_environment, 0);
  EXPECT_EQ(options.store, std::filesystem::current_path() / "farm");
  EXPECT_EQ(options.cache, std::filesystem::current_path() / "cache");
  const WorkerOptions least = worker_options(WorkerCommand{}, empty_environment, 0);
  EXPECT_EQ(least.store, "");
  EXPECT_EQ(least.cache, std::filesystem::absolute(default_cache_folder()));
  EXPECT_EQ(least.ends_in_ms, 0);
}

TEST(ServiceOptions, a_worker_that_may_not_use_the_store_has_the_key_that_lies_there) {
  WorkerCommand command;
  command.store = "/farm";
  command.no_shared_store = true;
  command.keys.own = "w.key";
  const WorkerOptions apart = worker_options(command, empty_environment, 0);
  EXPECT_EQ(apart.store, "");
  EXPECT_EQ(apart.keys.coordinator, published_key_path("/farm"));
  command.keys.coordinator = "c.pub";
  EXPECT_EQ(worker_options(command, empty_environment, 0).keys.coordinator, "c.pub");
  command.keys = {};
  EXPECT_EQ(worker_options(command, empty_environment, 0).keys.coordinator, "")
      << "it has no key to go with it";
  command.keys.own = "w.key";
  command.no_shared_store = false;
  EXPECT_EQ(worker_options(command, empty_environment, 0).keys.coordinator, "");
}

TEST(ServiceOptions, a_worker_ends_when_its_batch_system_says_unless_it_was_told) {
  const Environment slurm = [](const char* name) {
    return std::string(name) == "SLURM_JOB_END_TIME" ? "1000" : "";
  };
  WorkerCommand command;
  EXPECT_EQ(worker_options(command, slurm, 400'000).ends_in_ms, 600'000);
  command.walltime_s = 7;
  EXPECT_EQ(worker_options(command, slurm, 400'000).ends_in_ms, 7'000);
}

}  // namespace
}  // namespace tetfarm
