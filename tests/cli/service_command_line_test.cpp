#include "cli/service_command_line.h"

#include <gmock/gmock.h>

#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using ServiceCommandLine = PlainEnvironment;

TEST_F(ServiceCommandLine, a_coordinator_of_a_store_has_defaults_for_all_else) {
  const auto command =
      parsed_as<CoordinatorCommand>({"coordinator", "--store", "s", "--listen", "tcp://h:1"});
  EXPECT_EQ(command.store, "s");
  EXPECT_THAT(command.endpoints, ElementsAre("tcp://h:1"));
  EXPECT_EQ(command.database + command.keys + command.http_address + command.http_token +
                command.on_job_end,
            "");
  EXPECT_TRUE(command.allowed_roots.empty());
  EXPECT_EQ(command.max_connections, 16'384U);
  EXPECT_EQ(command.max_workers, 10'000U);
  EXPECT_EQ(command.keep_days, 0);
  EXPECT_EQ(command.jobs_per_user, 0U);
  EXPECT_EQ(command.heartbeat_ms, 1'000);
  EXPECT_EQ(command.lease_ms, 10'000);
  EXPECT_EQ(command.task_limit_s, 3'600);
  EXPECT_EQ(command.first_task_limit_s, 86'400);
  EXPECT_FALSE(command.insecure || command.one_job || command.quiet);
}

TEST_F(ServiceCommandLine, a_coordinator_takes_each_of_its_options) {
  const auto command = parsed_as<CoordinatorCommand>({"coordinator",
                                                      "--store",
                                                      "s",
                                                      "--listen",
                                                      "tcp://h:1",
                                                      "--listen",
                                                      "ipc://x",
                                                      "--database",
                                                      "d",
                                                      "--keys",
                                                      "k",
                                                      "--allow-root",
                                                      "/a",
                                                      "--allow-root",
                                                      "/b",
                                                      "--heartbeat-ms",
                                                      "11",
                                                      "--lease-ms",
                                                      "51",
                                                      "--max-connections",
                                                      "12",
                                                      "--max-workers",
                                                      "13",
                                                      "--task-limit",
                                                      "1.5",
                                                      "--first-task-limit",
                                                      "2.5",
                                                      "--http",
                                                      "127.0.0.1:8080",
                                                      "--http-token",
                                                      "token",
                                                      "--on-job-end",
                                                      "/etc/told",
                                                      "--jobs-per-user",
                                                      "14",
                                                      "--keep-days",
                                                      "1.5",
                                                      "--quiet"});
  EXPECT_THAT(command.endpoints, ElementsAre("tcp://h:1", "ipc://x"));
  EXPECT_EQ(command.database, "d");
  EXPECT_EQ(command.keys, "k");
  EXPECT_THAT(command.allowed_roots, ElementsAre("/a", "/b"));
  EXPECT_EQ(command.heartbeat_ms, 11);
  EXPECT_EQ(command.lease_ms, 51);
  EXPECT_EQ(command.max_connections, 12U);
  EXPECT_EQ(command.max_workers, 13U);
  EXPECT_EQ(command.task_limit_s, 1.5);
  EXPECT_EQ(command.first_task_limit_s, 2.5);
  EXPECT_EQ(command.http_address, "127.0.0.1:8080");
  EXPECT_EQ(command.http_token, "token");
  EXPECT_EQ(command.on_job_end, "/etc/told");
  EXPECT_EQ(command.keep_days, 1.5);
  EXPECT_EQ(command.jobs_per_user, 14U);
  EXPECT_TRUE(command.quiet);
  EXPECT_FALSE(command.insecure || command.one_job);
  const std::vector<std::string> least = {"coordinator", "--store", "s", "--listen", "tcp://h:1"};
  const auto with = [&least](const char* option) {
    std::vector<std::string> words = least;
    words.emplace_back(option);
    return parsed_as<CoordinatorCommand>(words);
  };
  EXPECT_TRUE(with("--one-job").one_job);
  EXPECT_TRUE(with("--insecure").insecure);
  EXPECT_TRUE(with("-q").quiet);
}

TEST_F(ServiceCommandLine, the_folder_of_keys_may_come_from_the_environment) {
  ::setenv("TETFARM_KEYS", "/keys", 1);
  const auto command =
      parsed_as<CoordinatorCommand>({"coordinator", "--store", "s", "--listen", "tcp://h:1"});
  ::unsetenv("TETFARM_KEYS");
  EXPECT_EQ(command.keys, "/keys");
}

TEST_F(ServiceCommandLine, a_worker_of_a_coordinator_has_defaults_for_all_else) {
  const auto command = parsed_as<WorkerCommand>({"worker", "--connect", "tcp://h:1"});
  EXPECT_EQ(command.endpoint, "tcp://h:1");
  EXPECT_EQ(command.keys.own + command.keys.coordinator, "");
  EXPECT_EQ(command.store + command.cache + command.tag, "");
  EXPECT_FALSE(command.no_shared_store || command.quiet);
  EXPECT_EQ(command.cache_bytes, std::uint64_t{10} << 30U);
  EXPECT_EQ(command.grace_s, 30);
  EXPECT_EQ(command.memory_bytes, 0U);
  EXPECT_EQ(command.walltime_s, 0);
  EXPECT_EQ(command.pool_memory_bytes, 0U);
}

TEST_F(ServiceCommandLine, a_worker_takes_each_of_its_options) {
  const auto command = parsed_as<WorkerCommand>(
      {"worker", "--connect", "tcp://h:1", "--key",         "w.key", "--coordinator-key",
       "c.pub",  "--store",   "s",         "--cache",       "c",     "--cache-size",
       "3GB",    "--grace",   "0",         "--memory",      "2GB",   "--walltime",
       "7",      "--tag",     "p/1",       "--pool-memory", "5GB",   "--no-shared-store",
       "-q"});
  EXPECT_EQ(command.keys.own, "w.key");
  EXPECT_EQ(command.keys.coordinator, "c.pub");
  EXPECT_EQ(command.store, "s");
  EXPECT_EQ(command.cache, "c");
  EXPECT_EQ(command.cache_bytes, std::uint64_t{3} << 30U);
  EXPECT_EQ(command.grace_s, 0);
  EXPECT_EQ(command.memory_bytes, std::uint64_t{2} << 30U);
  EXPECT_EQ(command.walltime_s, 7);
  EXPECT_EQ(command.tag, "p/1");
  EXPECT_EQ(command.pool_memory_bytes, std::uint64_t{5} << 30U);
  EXPECT_TRUE(command.no_shared_store);
  EXPECT_TRUE(command.quiet);
}

TEST_F(ServiceCommandLine, what_a_worker_starts_is_no_command_for_people) {
  EXPECT_EQ(parsed_as<TaskCommand>({"task", "/farm"}).store, "/farm");
  EXPECT_TRUE(std::holds_alternative<TaskHostCommand>(parsed({"task-host"})));
  EXPECT_EQ(help_words({}).find("task-host"), std::string::npos);
  EXPECT_EQ(help_words({"coordinator"}).find("--one-job"), std::string::npos);
}

TEST_F(ServiceCommandLine, what_cannot_be_is_refused) {
  const auto coordinator = [](const std::string& option, const std::string& value) {
    return std::vector<std::string>{"coordinator", "--store", "s",  "--listen",
                                    "tcp://h:1",   option,    value};
  };
  const auto worker = [](const std::string& option, const std::string& value) {
    return std::vector<std::string>{"worker", "--connect", "tcp://h:1", option, value};
  };
  const std::string whole = ": must be a whole number from ";
  expect_refused({
      {{"coordinator", "--listen", "tcp://h:1"}, "--store is required"},
      {{"coordinator", "--store", "s"}, "--listen is required"},
      {{"worker", "--store", "s"}, "--connect is required"},
      {{"task"}, "STORE is required"},
      {coordinator("--heartbeat-ms", "9"), "--heartbeat-ms" + whole + "10 to 600000, not 9"},
      {coordinator("--heartbeat-ms", "600001"),
       "--heartbeat-ms" + whole + "10 to 600000, not 600001"},
      {coordinator("--lease-ms", "49"), "--lease-ms" + whole + "50 to 86400000, not 49"},
      {coordinator("--lease-ms", "86400001"),
       "--lease-ms" + whole + "50 to 86400000, not 86400001"},
      {coordinator("--max-connections", "0"), "--max-connections" + whole + "1 to 1000000, not 0"},
      {coordinator("--max-workers", "0"), "--max-workers" + whole + "1 to 1000000, not 0"},
      {coordinator("--task-limit", "0"), "--task-limit: must be a number above 0, not 0"},
      {coordinator("--first-task-limit", "0"),
       "--first-task-limit: must be a number above 0, not 0"},
      {worker("--grace", "-1"), "--grace: must be a number, 0 or above, not -1"},
      {worker("--walltime", "0"), "--walltime: must be a number above 0, not 0"},
  });
}

TEST_F(ServiceCommandLine, help_tells_the_defaults) {
  EXPECT_THAT(
      help_words({"coordinator"}),
      AllOf(HasSubstr("between heartbeats (default 1000)"), HasSubstr("lost (default 10000)"),
            HasSubstr("simultaneous connections (default 16384)"),
            HasSubstr("simultaneous workers (default 10000)"),
            HasSubstr("20 times its expected time if longer (default 3600)"),
            HasSubstr("no task of its kind has been timed (default 86400)")));
  EXPECT_THAT(help_words({"worker"}), AllOf(HasSubstr("task to task (default 10GiB)"),
                                            HasSubstr("after SIGTERM (default 30)")));
}

}  // namespace
}  // namespace tetfarm
