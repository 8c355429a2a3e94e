#include "cli/view_command_line.h"

#include <gmock/gmock.h>

#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

using ViewCommandLine = PlainEnvironment;

/// All that says where to look.
const std::vector<std::string> everywhere = {
    "--connect", "tcp://h:1", "--key", "me.key",     "--timeout", "2.5",   "--coordinator-key",
    "c.pub",     "--store",   "/farm", "--database", "/local",    "--json"};

void expect_everywhere(const ViewOptions& view) {
  EXPECT_EQ(view.client.endpoint, "tcp://h:1");
  EXPECT_EQ(view.client.keys.own, "me.key");
  EXPECT_EQ(view.client.keys.coordinator, "c.pub");
  EXPECT_EQ(view.client.timeout_s, 2.5);
  EXPECT_TRUE(view.client.json);
  EXPECT_EQ(view.store, "/farm");
  EXPECT_EQ(view.database, "/local");
  EXPECT_FALSE(view.is_quiet);
}

void expect_nowhere(const ViewOptions& view) {
  EXPECT_EQ(view.client.endpoint, "");
  EXPECT_EQ(view.client.keys.own, "");
  EXPECT_EQ(view.client.keys.coordinator, "");
  EXPECT_EQ(view.client.job, "");
  EXPECT_EQ(view.client.timeout_s, 10);
  EXPECT_FALSE(view.client.json);
  EXPECT_EQ(view.store, "");
  EXPECT_EQ(view.database, "");
}

std::vector<std::string> with_everywhere(std::vector<std::string> words) {
  words.insert(words.end(), everywhere.begin(), everywhere.end());
  return words;
}

TEST_F(ViewCommandLine, each_that_looks_takes_where_to_look) {
  expect_everywhere(parsed_as<JobsCommand>(with_everywhere({"jobs"})).view);
  expect_everywhere(parsed_as<StatusCommand>(with_everywhere({"status"})).view);
  expect_everywhere(parsed_as<TasksCommand>(with_everywhere({"tasks"})).view);
  expect_everywhere(parsed_as<WorkersCommand>(with_everywhere({"workers"})).view);
  expect_everywhere(parsed_as<EventsCommand>(with_everywhere({"events"})).view);
  expect_everywhere(parsed_as<LogsCommand>(with_everywhere({"logs", "3"})).view);
  expect_everywhere(parsed_as<ExplainCommand>(with_everywhere({"explain", "3"})).view);
  expect_everywhere(parsed_as<TraceCommand>(with_everywhere({"trace", "j", "-o", "t"})).view);
  expect_everywhere(parsed_as<ReportCommand>(with_everywhere({"report", "j", "-o", "r"})).view);
}

TEST_F(ViewCommandLine, a_dashboard_is_for_this_host_and_only_looks_unless_told_otherwise) {
  const auto least = parsed_as<DashboardCommand>({"dashboard", "--store", "s"});
  EXPECT_EQ(least.view.store, "s");
  EXPECT_EQ(least.http_address, "127.0.0.1:8470");
  EXPECT_EQ(least.http_token, "");
  EXPECT_FALSE(least.acts);
  const auto all = parsed_as<DashboardCommand>({"dashboard", "--connect", "tcp://h:1", "--http",
                                                "0.0.0.0:80", "--http-token", "token", "--acts"});
  EXPECT_EQ(all.view.client.endpoint, "tcp://h:1");
  EXPECT_EQ(all.http_address, "0.0.0.0:80");
  EXPECT_EQ(all.http_token, "token");
  EXPECT_TRUE(all.acts);
}

TEST_F(ViewCommandLine, each_that_looks_may_be_told_by_the_environment_where) {
  ::setenv("TETFARM_COORDINATOR", "tcp://e:2", 1);
  ::setenv("TETFARM_STORE", "/of_environment", 1);
  ::setenv("TETFARM_KEY", "e.key", 1);
  ::setenv("TETFARM_COORDINATOR_KEY", "e.pub", 1);
  const ViewOptions view = parsed_as<JobsCommand>({"jobs"}).view;
  EXPECT_EQ(view.client.endpoint, "tcp://e:2");
  EXPECT_EQ(view.store, "/of_environment");
  EXPECT_EQ(view.client.keys.own, "e.key");
  EXPECT_EQ(view.client.keys.coordinator, "e.pub");
  EXPECT_EQ(parsed_as<SubmitCommand>({"submit", "a.stl"}).job.store, "/of_environment");
  EXPECT_EQ(parsed_as<WaitCommand>({"wait", "job-1"}).store, "/of_environment");
  EXPECT_EQ(parsed_as<QualityOptions>({"quality", "m"}).source.store, "/of_environment");
  for (const char* name :
       {"TETFARM_COORDINATOR", "TETFARM_STORE", "TETFARM_KEY", "TETFARM_COORDINATOR_KEY"}) {
    ::unsetenv(name);
  }
}

TEST_F(ViewCommandLine, status_and_jobs) {
  expect_nowhere(parsed_as<JobsCommand>({"jobs"}).view);
  expect_nowhere(parsed_as<StatusCommand>({"status"}).view);
  EXPECT_FALSE(parsed_as<StatusCommand>({"status"}).workers);
  const auto status = parsed_as<StatusCommand>({"status", "job-7", "--workers"});
  EXPECT_TRUE(status.workers);
  EXPECT_EQ(status.view.client.job, "job-7");
}

TEST_F(ViewCommandLine, tasks_of_a_state_and_a_kind) {
  const auto all = parsed_as<TasksCommand>({"tasks"});
  expect_nowhere(all.view);
  EXPECT_EQ(all.state + all.kind, "");
  const auto some =
      parsed_as<TasksCommand>({"tasks", "job-7", "--state", "ready", "--kind", "mesh"});
  EXPECT_EQ(some.view.client.job, "job-7");
  EXPECT_EQ(some.state, "ready");
  EXPECT_EQ(some.kind, "mesh");
  for (const char* state :
       {"waiting", "ready", "running", "leased", "done", "failed", "replaced"}) {
    EXPECT_EQ(parsed_as<TasksCommand>({"tasks", "--state", state}).state, state);
  }
  EXPECT_THAT(refusal_of({"tasks", "--state", "asleep"}), HasSubstr("asleep not in {"));
}

TEST_F(ViewCommandLine, workers_events_logs_and_tasks_explained) {
  EXPECT_FALSE(parsed_as<WorkersCommand>({"workers"}).all);
  EXPECT_TRUE(parsed_as<WorkersCommand>({"workers", "--all"}).all);
  const auto events = parsed_as<EventsCommand>({"events"});
  expect_nowhere(events.view);
  EXPECT_EQ(events.task, 0U);
  EXPECT_EQ(events.last, 50U);
  EXPECT_FALSE(events.all);
  const auto of_task = parsed_as<EventsCommand>({"events", "job-7", "--task", "31", "-n", "1000"});
  EXPECT_EQ(of_task.view.client.job, "job-7");
  EXPECT_EQ(of_task.task, 31U);
  EXPECT_EQ(of_task.last, 1000U);
  EXPECT_EQ(parsed_as<EventsCommand>({"events", "--last", "1"}).last, 1U);
  EXPECT_TRUE(parsed_as<EventsCommand>({"events", "--all"}).all);
  EXPECT_EQ(parsed_as<LogsCommand>({"logs", "job-7"}).target, "job-7");
  EXPECT_EQ(parsed_as<ExplainCommand>({"explain", "31"}).task, 31U);
}

TEST_F(ViewCommandLine, traces_reports_and_copies_of_the_database) {
  const auto trace = parsed_as<TraceCommand>({"trace", "job-7", "-o", "t.json"});
  EXPECT_EQ(trace.view.client.job, "job-7");
  EXPECT_EQ(trace.output, "t.json");
  const auto report = parsed_as<ReportCommand>({"report", "out", "--output", "r.html"});
  EXPECT_EQ(report.view.client.job, "out");
  EXPECT_EQ(report.output, "r.html");
  const auto backup =
      parsed_as<BackupCommand>({"backup", "/farm", "-o", "b", "--database", "/d", "--json"});
  EXPECT_EQ(backup.store, "/farm");
  EXPECT_EQ(backup.file, "b");
  EXPECT_EQ(backup.database, "/d");
  EXPECT_TRUE(backup.json);
  const BackupCommand from =
      parsed_as<RestoreCommand>({"restore", "b", "/farm", "--database", "/d", "--json"}).from;
  EXPECT_EQ(from.file, "b");
  EXPECT_EQ(from.store, "/farm");
  EXPECT_EQ(from.database, "/d");
  EXPECT_TRUE(from.json);
  EXPECT_FALSE(parsed_as<BackupCommand>({"backup", "/farm", "-o", "b"}).json);
}

TEST_F(ViewCommandLine, what_cannot_be_is_refused) {
  expect_refused({
      {{"events", "--task", "0"}, "--task: must be a whole number above 0, not 0"},
      {{"events", "-n", "0"}, "--last: must be a whole number from 1 to 1000, not 0"},
      {{"events", "-n", "1001"}, "--last: must be a whole number from 1 to 1000, not 1001"},
      {{"events", "--all", "-n", "5"}, "--last excludes --all"},
      {{"logs"}, "JOB|TASK is required"},
      {{"explain"}, "TASK is required"},
      {{"explain", "0"}, "TASK: must be a whole number above 0, not 0"},
      {{"trace", "job-7"}, "--output is required"},
      {{"trace", "-o", "t.json"}, "JOB is required"},
      {{"report", "out"}, "--output is required"},
      {{"report", "-o", "r.html"}, "FILE is required"},
      {{"backup", "/farm"}, "--output is required"},
      {{"backup", "-o", "b"}, "STORE is required"},
      {{"restore", "b"}, "STORE is required"},
      {{"restore"}, "FILE is required"},
      {{"jobs", "--timeout", "0"}, "--timeout: must be a number above 0, not 0"},
  });
}

TEST_F(ViewCommandLine, help_tells_the_defaults) {
  EXPECT_THAT(help_words({"events"}), HasSubstr("the newest (default 50)"));
  EXPECT_THAT(help_words({"jobs"}), HasSubstr("wait for an answer (default 10)"));
  EXPECT_THAT(help_words({"jobs"}), HasSubstr("(default: coordinator.pub in the store)"));
  EXPECT_THAT(help_words({"jobs"}), HasSubstr("Folder of the database (default: the store)"));
}

}  // namespace
}  // namespace tetfarm
