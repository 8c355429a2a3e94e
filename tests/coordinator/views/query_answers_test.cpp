#include "coordinator/views/query_answers.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "store/job_database.h"
#include "tasks/failure_cause.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A job of one task on two workers, decided by the state and kept by a real database.
class QueryAnswers : public testing::Test {
 protected:
  QueryAnswers()
      : database_(folder_.path() / "db"),
        state_(
            {}, {}, [this](const ArtifactRef& file) { return !missing_.contains(file.hash); },
            now_) {}

  JobId submit(const std::string& name) {
    Submission submission;
    submission.name = name;
    submission.given = {{std::string(32, 'a'), 1}, TaskFile{std::string(32, 'b'), 2}, std::nullopt};
    const JobId job = state_.submit(submission, now_).job;
    commit();
    return job;
  }
  WorkerId add_worker(const std::string& host, std::uint64_t memory_bytes = 1U << 30U) {
    WorkerInfo info;
    info.host = host;
    info.nonce = host;
    info.memory_bytes = memory_bytes;
    const WorkerId worker = state_.add_worker(info, {}, {}, now_);
    state_.worker_is_ready(worker, now_);
    return worker;
  }
  void tick() {
    state_.tick(now_);
    commit();
  }
  void commit() {
    database_.apply(state_.take_changes());
    state_.take_commands();
  }
  AttemptId running() const { return state_.durable().running_attempts.begin()->first; }
  void fail(WorkerId worker, const TaskFailure& failure) {
    state_.failed(worker, TaskId{1}, running(), failure, now_);
    commit();
  }
  wire::QueryReply ask(wire::Query query) const {
    const JobHistory history = database_.history();
    return answer_query(query, {state_, history, now_});
  }
  wire::QueryReply ask(wire::Query::Subject subject) const {
    wire::Query query;
    query.set_subject(subject);
    return ask(query);
  }
  std::vector<std::string> reasons(std::uint64_t task = 1) const {
    wire::Query query;
    query.set_subject(wire::Query::EXPLAIN);
    query.set_task(task);
    const wire::Explanation explanation = ask(query).explanation();
    return {explanation.reasons().begin(), explanation.reasons().end()};
  }

  const TempFolder folder_;
  Moment now_{5000, 5000};
  std::set<std::string> missing_;
  JobDatabase database_;
  JobState state_;
};

TEST_F(QueryAnswers, all_jobs_of_a_store_are_listed_page_by_page) {
  for (const char* name : {"wing", "duct", "box"}) submit(name);
  wire::Query query;
  query.set_subject(wire::Query::JOBS);
  query.set_limit(2);
  const wire::QueryReply first = ask(query);
  ASSERT_THAT(first.jobs(), SizeIs(2));
  EXPECT_EQ(first.jobs(1).name(), "duct");
  EXPECT_EQ(first.jobs(0).tasks_ready(), 1U);
  query.set_after(first.next());
  const wire::QueryReply second = ask(query);
  ASSERT_THAT(second.jobs(), SizeIs(1));
  EXPECT_EQ(second.jobs(0).name(), "box");
  EXPECT_EQ(second.next(), 0U);
}

TEST_F(QueryAnswers, tasks_events_and_attempts_come_page_by_page_to_the_last_row) {
  for (int i = 0; i < 5; ++i) submit("job");
  for (const wire::Query::Subject subject : {wire::Query::TASKS, wire::Query::EVENTS}) {
    wire::Query query;
    query.set_subject(subject);
    query.set_limit(2);
    std::size_t rows = 0;
    do {
      const wire::QueryReply page = ask(query);
      rows += static_cast<std::size_t>(page.tasks_size() + page.events_size());
      query.set_after(page.next());
    } while (query.after() != 0);
    EXPECT_EQ(rows, subject == wire::Query::TASKS ? 5U : 10U);
  }
}

TEST_F(QueryAnswers, what_is_not_there_is_not_found) {
  submit("wing");
  wire::Query query;
  query.set_subject(wire::Query::TASKS);
  query.set_job("job-9");
  EXPECT_THROW(ask(query), Error);
  query.set_job("job-1");
  EXPECT_THAT(ask(query).tasks(), SizeIs(1));
  EXPECT_THROW(reasons(77), Error);
  EXPECT_THROW(ask(wire::Query::SUBJECT_UNSPECIFIED), Error);
}

TEST_F(QueryAnswers, a_task_without_workers_says_so) {
  submit("wing");
  EXPECT_THAT(reasons(), ElementsAre("no worker is connected"));
}

TEST_F(QueryAnswers, a_task_behind_others_counts_them_and_names_what_keeps_each_worker) {
  submit("wing");
  submit("duct");
  submit("box");
  add_worker("a");
  tick();
  EXPECT_THAT(reasons(3), ElementsAre("1 of 1 workers: busy", "1 ready task comes before it"));
  EXPECT_THAT(reasons(1), IsEmpty()) << "it runs";
}

TEST_F(QueryAnswers, a_task_after_an_error_says_how_long_it_waits_and_why) {
  submit("wing");
  const WorkerId worker = add_worker("a");
  tick();
  TaskFailure failure;
  failure.cause = FailureCause::error;
  failure.message = "signal 11";
  fail(worker, failure);
  ASSERT_THAT(reasons(), SizeIs(1));
  EXPECT_THAT(reasons()[0], HasSubstr("after 1 error it waits"));
  EXPECT_THAT(reasons()[0], HasSubstr("waits another 1 s; last failure: signal 11"));
}

TEST_F(QueryAnswers, a_task_that_fits_nowhere_says_what_it_is_given_and_what_is_free) {
  submit("wing");
  const WorkerId small = add_worker("a", 100U << 20U);
  tick();
  TaskFailure failure;
  failure.cause = FailureCause::out_of_memory;
  failure.message = "std::bad_alloc";
  failure.peak_rss_bytes = 90U << 20U;
  const WorkerId large = add_worker("b", 1U << 30U);
  fail(small, failure);
  state_.drain(large);
  now_.steady_ms += 60'000;
  state_.heartbeat(small, {}, {}, now_);
  state_.heartbeat(large, {}, {}, now_);
  state_.worker_is_ready(small, now_);
  const std::vector<std::string> why = reasons();
  EXPECT_THAT(why, testing::Contains("1 of 2 workers: about to leave"));
  EXPECT_THAT(why, testing::Contains("1 of 2 workers: without room for it"));
}

TEST_F(QueryAnswers, explain_tells_what_a_task_is_given_and_which_inputs_are_there) {
  constexpr std::uint64_t mib = 1U << 20U;
  submit("wing");
  const WorkerId first = add_worker("a", 100 * mib);
  tick();
  const WorkerId largest = add_worker("b", 150 * mib);
  add_worker("c", 50 * mib);
  TaskFailure failure;
  failure.cause = FailureCause::out_of_memory;
  failure.peak_rss_bytes = 90 * mib;
  fail(first, failure);
  state_.drain(largest);
  now_.steady_ms += 5'000;
  missing_.insert(std::string(32, 'b'));
  wire::Query query;
  query.set_subject(wire::Query::EXPLAIN);
  query.set_task(1);
  wire::Explanation told = ask(query).explanation();
  EXPECT_EQ(told.room_bytes(), 150 * mib);
  EXPECT_EQ(told.limit_seconds(), 86'400) << "of an unknown kind: a day";
  ASSERT_THAT(told.inputs(), SizeIs(2));
  EXPECT_TRUE(told.inputs(0).is_there());
  EXPECT_FALSE(told.inputs(1).is_there());
  missing_.clear();
  EXPECT_THAT(reasons(),
              testing::Contains("it needs 150 MiB; at most 150 MiB is free on any worker"));
}

TEST_F(QueryAnswers, of_many_attempts_the_last_are_told_and_which_of_them_raced) {
  submit("wing");
  const WorkerId worker = add_worker("a");
  tick();
  TaskFailure failure;
  failure.cause = FailureCause::error;
  fail(worker, failure);
  ChangeSet later;
  later.attempts = {{AttemptId{50}, TaskId{1}, worker, AttemptState::killed, 1, 2, "", "", true}};
  database_.apply(later);
  wire::Query query;
  query.set_subject(wire::Query::EXPLAIN);
  query.set_task(1);
  const wire::Explanation all = ask(query).explanation();
  ASSERT_THAT(all.attempts(), SizeIs(2));
  EXPECT_FALSE(all.attempts(0).races());
  EXPECT_TRUE(all.attempts(1).races());
  query.set_limit(1);
  const wire::Explanation last = ask(query).explanation();
  ASSERT_THAT(last.attempts(), SizeIs(1));
  EXPECT_EQ(last.attempts(0).attempt(), 50U);
}

TEST_F(QueryAnswers, a_task_in_quarantine_says_what_its_last_words_were) {
  submit("wing");
  const WorkerId worker = add_worker("a");
  tick();
  TaskFailure failure;
  failure.exit_code = 3;
  failure.message = "the surface is open";
  failure.log = "its log";
  failure.peak_rss_bytes = 77;
  fail(worker, failure);
  EXPECT_THAT(reasons(), ElementsAre("in quarantine: the surface is open"));
  wire::Query query;
  query.set_subject(wire::Query::LOGS);
  query.set_task(1);
  const wire::QueryReply logs = ask(query);
  ASSERT_THAT(logs.attempts(), SizeIs(1));
  EXPECT_EQ(logs.attempts(0).log(), "its log");
  EXPECT_EQ(logs.attempts(0).peak_rss_bytes(), 77U);
  EXPECT_EQ(logs.attempts(0).host(), "a");
  EXPECT_EQ(logs.attempts(0).state(), "failed");
  EXPECT_EQ(logs.attempts(0).kind(), "inspect");
}

TEST_F(QueryAnswers, a_missing_input_and_a_full_disk_are_named) {
  submit("wing");
  add_worker("a");
  missing_.insert(std::string(32, 'b'));
  EXPECT_THAT(reasons()[0], HasSubstr("its input 'input_surface' is not in the store"));
  missing_.clear();
  state_.out_of_resources("No space left on device", now_);
  EXPECT_THAT(reasons()[0], HasSubstr("no room on the disk (No space left on device)"));
  state_.cancel(JobId{1}, now_);
  EXPECT_THAT(reasons(), ElementsAre("its job is cancelled"));
}

TEST_F(QueryAnswers, workers_are_told_with_their_work_and_those_who_left_on_demand) {
  submit("wing");
  add_worker("a");
  tick();
  const WorkerId second = add_worker("b");
  state_.worker_left(second, false, now_);
  commit();
  const wire::QueryReply here = ask(wire::Query::WORKERS);
  ASSERT_THAT(here.workers(), SizeIs(1));
  EXPECT_EQ(here.workers(0).state(), "busy");
  EXPECT_EQ(here.workers(0).task(), 1U);
  wire::Query query;
  query.set_subject(wire::Query::WORKERS);
  query.set_with_gone(true);
  ASSERT_THAT(ask(query).workers(), SizeIs(2));
  EXPECT_EQ(ask(query).workers(1).state(), "gone");
}

TEST_F(QueryAnswers, a_status_of_many_jobs_is_cut_into_pages_that_a_message_can_carry) {
  for (int i = 0; i < 40; ++i) submit(std::string(100'000, 'x'));
  wire::StatusRequest request;
  std::size_t jobs = 0;
  std::size_t pages = 0;
  do {
    const wire::StatusReply page = answer_status(request, state_, now_);
    EXPECT_LT(page.ByteSizeLong(), std::size_t{4} << 20U);
    jobs += static_cast<std::size_t>(page.jobs_size());
    request.set_after(page.next());
    ++pages;
  } while (request.after() != 0);
  EXPECT_EQ(jobs, 40U);
  EXPECT_EQ(pages, 2U);
}

}  // namespace
}  // namespace tetfarm
