// The commands that look, called as main calls them: what they ask, and what they show.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Pages of an answer, one after the other; `next` of each but the last leads to the one behind.
class Viewed : public ::testing::Test {
 protected:
  wire::QueryReply& page() { return pages_.emplace_back(); }
  ViewOptions view() const {
    ViewOptions options;
    options.client.endpoint = coordinator_.endpoint();
    options.client.timeout_s = 5;
    return options;
  }
  std::vector<wire::Query> asked() const {
    std::vector<wire::Query> queries;
    for (const wire::Envelope& envelope : coordinator_.heard()) {
      if (envelope.has_query()) queries.push_back(envelope.query());
    }
    return queries;
  }

  std::vector<wire::QueryReply> pages_;
  wire::StatusReply status_;
  FakeCoordinator coordinator_{[this](const wire::Envelope& said) {
    wire::Envelope answer;
    if (said.has_status_request()) *answer.mutable_status_reply() = status_;
    if (said.has_query()) {
      const auto i = static_cast<std::size_t>(said.query().after());
      *answer.mutable_query_reply() = pages_.at(i);
      answer.mutable_query_reply()->set_next(i + 1 < pages_.size() ? i + 1 : 0);
    }
    return std::vector<wire::Envelope>{answer};
  }};
};

TEST_F(Viewed, jobs_are_those_of_all_pages) {
  for (const char* job : {"job-1", "job-2"}) page().add_jobs()->set_job(job);
  JobsCommand command{view()};
  const Said text = said_by([&] { return jobs_command(command); });
  EXPECT_THAT(text.out, HasSubstr("job-1"));
  EXPECT_THAT(text.out, HasSubstr("job-2"));
  ASSERT_THAT(asked(), SizeIs(2));
  EXPECT_EQ(asked()[0].subject(), wire::Query::JOBS);
  EXPECT_EQ(asked()[1].after(), 1U);
  command.view.client.json = true;
  const Said said = said_by([&] { return jobs_command(command); });
  EXPECT_THAT(said.out, HasSubstr("\"job\":\"job-1\""));
  EXPECT_EQ(std::count(said.out.begin(), said.out.end(), '\n'), 2);
}

TEST_F(Viewed, jobs_come_after_the_trouble_of_the_coordinator_and_may_be_none) {
  page().set_trouble("the disk is full");
  EXPECT_EQ(said_by([&] { return jobs_command({view()}); }).out, "the disk is full\nno jobs\n");
  JobsCommand command{view()};
  command.view.client.json = true;
  EXPECT_EQ(said_by([&] { return jobs_command(command); }).out, "");
}

TEST_F(Viewed, status_is_told_of_all_jobs_with_the_farm_and_of_one_without) {
  status_.set_workers(1);
  status_.add_jobs()->set_job("job-1");
  status_.add_at_work()->set_worker(4);
  StatusCommand command{view()};
  EXPECT_THAT(said_by([&] { return status_command(command); }).out,
              HasSubstr("1 worker, 1 job, messages and handshakes refused: 0\njob-1 "));
  EXPECT_EQ(coordinator_.heard().back().status_request().job(), "");
  command.workers = true;
  EXPECT_THAT(said_by([&] { return status_command(command); }).out, HasSubstr("worker-4 "));
  command.workers = false;
  command.view.client.json = true;
  const auto types = [&] {
    std::istringstream lines(said_by([&] { return status_command(command); }).out);
    std::string all;
    for (std::string line; std::getline(lines, line);) {
      all += json::parse(line)["type"].get<std::string>() + " ";
    }
    return all;
  };
  EXPECT_EQ(types(), "farm job ");
  command.workers = true;
  EXPECT_EQ(types(), "farm worker job ");
  command.view.client.job = "job-1";
  EXPECT_EQ(types(), "worker job ");
  EXPECT_EQ(coordinator_.heard().back().status_request().job(), "job-1");
}

TEST_F(Viewed, status_of_no_job_is_not_found_and_of_no_jobs_is_well) {
  StatusCommand command{view()};
  EXPECT_EQ(said_by([&] { return status_command(command); }).code, ExitCode::ok);
  command.view.client.job = "job-9";
  const Said said = said_by([&] { return status_command(command); });
  EXPECT_EQ(said.code, ExitCode::not_found);
  EXPECT_EQ(said.error, "no job job-9");
}

TEST_F(Viewed, tasks_are_chosen_by_state_and_kind) {
  const auto add = [this](std::uint64_t id, const char* kind, const char* state) {
    wire::TaskLine& task = *page().add_tasks();
    task.set_task(id);
    task.set_kind(kind);
    task.set_state(state);
  };
  add(11, "mesh", "leased");
  add(12, "mesh", "done");
  add(13, "write", "leased");
  const auto shown = [&](const std::string& state, const std::string& kind) {
    TasksCommand command{view(), state, kind};
    command.view.client.job = "job-7";
    command.view.client.json = true;
    std::istringstream lines(said_by([&] { return tasks_command(command); }).out);
    std::string all;
    for (std::string line; std::getline(lines, line);) {
      all += std::to_string(json::parse(line)["task"].get<int>()) + " ";
    }
    return all;
  };
  EXPECT_EQ(shown("", ""), "11 12 13 ");
  EXPECT_EQ(asked()[0].subject(), wire::Query::TASKS);
  EXPECT_EQ(asked()[0].job(), "job-7");
  EXPECT_EQ(shown("running", ""), "11 13 ") << "programs read that they are leased";
  EXPECT_EQ(shown("leased", "write"), "13 ");
  EXPECT_EQ(shown("", "mesh"), "11 12 ");
  EXPECT_EQ(shown("failed", ""), "");
  TasksCommand command{view(), "failed", ""};
  EXPECT_EQ(said_by([&] { return tasks_command(command); }).out, "no matching tasks\n");
  command.state = "done";
  const std::string text = said_by([&] { return tasks_command(command); }).out;
  EXPECT_THAT(text, HasSubstr("\n12 "));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << "its head, and one";
}

TEST_F(Viewed, workers_may_be_asked_for_with_those_that_have_left) {
  page().add_workers()->set_worker(1);
  page().add_workers()->set_worker(2);
  WorkersCommand command{view()};
  const std::string text = said_by([&] { return workers_command(command); }).out;
  EXPECT_THAT(text, HasSubstr("worker-1"));
  EXPECT_THAT(text, HasSubstr("worker-2"));
  EXPECT_EQ(asked()[0].subject(), wire::Query::WORKERS);
  EXPECT_FALSE(asked()[0].with_gone());
  command.all = true;
  command.view.client.json = true;
  EXPECT_THAT(said_by([&] { return workers_command(command); }).out,
              HasSubstr("\"worker\":\"worker-2\""));
  EXPECT_TRUE(asked().back().with_gone());
}

TEST_F(Viewed, a_farm_without_workers_says_so_to_people) {
  page();
  WorkersCommand command{view()};
  EXPECT_EQ(said_by([&] { return workers_command(command); }).out, "no workers\n");
  command.view.client.json = true;
  EXPECT_EQ(said_by([&] { return workers_command(command); }).out, "");
}

TEST_F(Viewed, events_are_the_newest_or_all) {
  page().add_events()->set_what("ready");
  EventsCommand command{view()};
  command.view.client.job = "job-7";
  command.task = 31;
  command.last = 5;
  EXPECT_EQ(said_by([&] { return events_command(command); }).out, "  ready\n");
  wire::Query query = asked().back();
  EXPECT_EQ(query.subject(), wire::Query::EVENTS);
  EXPECT_EQ(query.job(), "job-7");
  EXPECT_EQ(query.task(), 31U);
  EXPECT_TRUE(query.newest());
  EXPECT_EQ(query.limit(), 5U);
  command.all = true;
  command.view.client.json = true;
  EXPECT_THAT(said_by([&] { return events_command(command); }).out,
              HasSubstr("\"what\":\"ready\""));
  query = asked().back();
  EXPECT_FALSE(query.newest());
  EXPECT_EQ(query.limit(), 0U);
}

TEST_F(Viewed, logs_are_of_a_task_by_its_number_or_of_a_job) {
  wire::AttemptLine& attempt = *page().add_attempts();
  attempt.set_log("hello");
  LogsCommand command{view(), "31"};
  EXPECT_THAT(said_by([&] { return logs_command(command); }).out, HasSubstr("\n  hello\n"));
  EXPECT_EQ(asked().back().subject(), wire::Query::LOGS);
  EXPECT_EQ(asked().back().task(), 31U);
  EXPECT_EQ(asked().back().job(), "");
  for (const char* job : {"job-7", "31x"}) {
    command.target = job;
    command.view.client.json = true;
    EXPECT_THAT(said_by([&] { return logs_command(command); }).out, HasSubstr("\"log\":\"hello\""));
    EXPECT_EQ(asked().back().task(), 0U);
    EXPECT_EQ(asked().back().job(), job);
  }
}

TEST_F(Viewed, a_task_is_explained) {
  page().mutable_explanation()->mutable_task()->set_task(31);
  ExplainCommand command{view(), 31};
  EXPECT_THAT(said_by([&] { return explain_command(command); }).out, HasSubstr("task 31 of "));
  EXPECT_EQ(asked().back().subject(), wire::Query::EXPLAIN);
  EXPECT_EQ(asked().back().task(), 31U);
  command.view.client.json = true;
  EXPECT_THAT(said_by([&] { return explain_command(command); }).out, HasSubstr("\"task\":31"));
}

TEST_F(Viewed, a_trace_is_of_all_attempts_and_events_of_its_job) {
  wire::QueryReply& first = page();
  first.add_attempts()->set_attempt(1);
  first.mutable_attempts(0)->set_started_ms(2000);
  first.mutable_attempts(0)->set_ended_ms(3000);
  first.mutable_attempts(0)->set_state("done");
  first.add_events()->set_wall_ms(1000);
  wire::QueryReply& second = page();
  second.add_attempts()->set_attempt(2);
  second.mutable_attempts(0)->set_started_ms(2500);
  second.mutable_attempts(0)->set_ended_ms(2600);
  second.mutable_attempts(0)->set_state("done");
  const TempFolder folder;
  TraceCommand command{view(), (folder.path() / "trace.json").string()};
  command.view.client.job = "job-7";
  EXPECT_EQ(said_by([&] { return trace_command(command); }).out, "");
  std::vector<json> slices;
  const json trace = json::parse(read_file(command.output));
  for (const json& event : trace["traceEvents"]) {
    if (event["ph"] == "X") slices.push_back(event);
  }
  ASSERT_THAT(slices, SizeIs(2));
  EXPECT_EQ(slices[0]["ts"], 1'000'000) << "since the first event";
  EXPECT_EQ(slices[1]["args"]["attempt"], 2);
  ASSERT_THAT(asked(), SizeIs(4));
  EXPECT_EQ(asked()[0].subject(), wire::Query::ATTEMPTS);
  EXPECT_EQ(asked()[2].subject(), wire::Query::EVENTS);
  for (const wire::Query& query : asked()) EXPECT_EQ(query.job(), "job-7");
  command.view.client.json = true;
  EXPECT_EQ(json::parse(said_by([&] { return trace_command(command); }).out),
            json({{"type", "trace"}, {"file", command.output}}));
}

}  // namespace
}  // namespace tetfarm
