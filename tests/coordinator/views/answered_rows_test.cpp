#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/coordinator/views/farm_in_rows.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

template <class Messages>
std::vector<std::string> texts_of(const Messages& messages) {
  std::vector<std::string> texts;
  for (const auto& message : messages) texts.push_back(message.ShortDebugString());
  return texts;
}

/// What answers of this farm are, field by field.
class AnsweredRows : public FarmInRows {
 protected:
  /// "EXIT CODE: MESSAGE" of a refusal, "" when it is answered.
  std::string refusal_of(const wire::Query& query) const {
    try {
      ask(query);
    } catch (const Error& error) {
      return std::to_string(static_cast<int>(error.code())) + ": " + error.what();
    }
    return "";
  }
};

const std::string wing =
    R"(job: "job-1" name: "wing <1>" state: "running" stage: "mesh" leaves_made: 3 )"
    R"(leaves_meshed: 1 elements: 120 estimated_elements: 800 tasks_done: 4 tasks_ready: 1 )"
    R"(tasks_running: 1 attempts_lost: 2 peak_rss_bytes_worker: 7000 seconds: 9 crashes: 1 )"
    R"(oom_count: 1 created_ms: 1000 running { task: 5 kind: "mesh" path: 6 attempt: 7 )"
    R"(seconds: 3 })";
const std::string duct =
    R"(job: "job-2" name: "duct" state: "failed" stage: "inspect" message: "the surface is open" )"
    R"(exit_code: 3 peak_rss_bytes_worker: 9000 seconds: 3.5 quarantine { task: 7 )"
    R"(kind: "inspect" reason: "the surface is open" exit_code: 3 } created_ms: 2000 )"
    R"(finished_ms: 5500)";

TEST_F(AnsweredRows, of_jobs_have_all_but_their_numbers_texts_and_files) {
  const wire::QueryReply reply = ask(wire::Query::JOBS);
  EXPECT_THAT(texts_of(reply.jobs()), ElementsAre(wing, duct));
  EXPECT_EQ(reply.next(), 0U);
  wire::Query query;
  query.set_subject(wire::Query::JOBS);
  query.set_job("job-2");
  EXPECT_THAT(texts_of(ask(query).jobs()), ElementsAre(duct));
}

TEST_F(AnsweredRows, of_tasks_have_what_they_took_and_what_was_expected) {
  const std::vector<std::string> tasks = {
      R"(task: 1 job: "job-1" kind: "inspect" state: "done" attempt: 1 seconds: 1.5 )"
      R"(peak_rss_bytes: 7000 expected_seconds: 2 expected_bytes: 3000 cpu_seconds: 1.25)",
      R"(task: 2 job: "job-1" kind: "decompose" path: 1 state: "done" attempt: 3 crashes: 1 )"
      R"(seconds: 0.5 expected_elements: 800)",
      R"(task: 3 job: "job-1" kind: "mesh" path: 2 state: "done" attempt: 4 seconds: 1.75 )"
      R"(peak_rss_bytes: 5000 expected_seconds: 2.5 expected_bytes: 6000 cpu_seconds: 1.125 )"
      R"(expected_elements: 100 elements: 120 min_dihedral_deg: 21.5)",
      R"(task: 4 job: "job-1" kind: "decompose" path: 3 state: "done" attempt: 5 )"
      R"(seconds: 0.25 expected_elements: 700)",
      R"(task: 5 job: "job-1" kind: "mesh" path: 6 state: "leased" attempt: 7 worker: 4 )"
      R"(host: "gamma" seconds: 3 expected_elements: 400)",
      R"(task: 6 job: "job-1" kind: "mesh" path: 7 state: "ready" losses: 2 oom_count: 1 )"
      R"(memory_bytes: 4096 message: "killed" expected_elements: 300)",
      R"(task: 7 job: "job-2" kind: "inspect" state: "failed" peak_rss_bytes: 9000 )"
      R"(exit_code: 3 message: "the surface is open")"};
  EXPECT_THAT(texts_of(ask(wire::Query::TASKS).tasks()), testing::ElementsAreArray(tasks));
  wire::Query query;
  query.set_subject(wire::Query::TASKS);
  query.set_job("job-1");
  query.set_after(3);
  query.set_limit(2);
  const wire::QueryReply page = ask(query);
  EXPECT_THAT(texts_of(page.tasks()), ElementsAre(tasks[3], tasks[4]));
  EXPECT_EQ(page.next(), 5U);
  query.set_after(5);
  EXPECT_THAT(texts_of(ask(query).tasks()), ElementsAre(tasks[5]));
  EXPECT_EQ(ask(query).next(), 0U);
}

TEST_F(AnsweredRows, of_running_tasks_have_what_their_worker_said) {
  state_->note_work(WorkerId{4}, TaskId{5}, AttemptId{7}, {WorkStage::points, 2, 30, 60});
  const std::string doing = R"(doing { stage: "points" pass: 2 done: 30 total: 60 })";
  const wire::TaskLine line = ask(wire::Query::TASKS).tasks(4);
  EXPECT_EQ(line.doing().ShortDebugString(), R"(stage: "points" pass: 2 done: 30 total: 60)");
  EXPECT_NEAR(line.share(), 0.14 + 0.36 / 2, 1e-9);
  const wire::JobStatus job = ask(wire::Query::JOBS).jobs(0);
  EXPECT_EQ(job.running(0).doing().ShortDebugString(), line.doing().ShortDebugString());
  EXPECT_DOUBLE_EQ(job.running(0).share(), line.share());
  EXPECT_NEAR(job.elements_under_way(), 400 * line.share(), 1e-9);
  EXPECT_EQ(ask(wire::Query::WORKERS).workers(0).ShortDebugString(),
            R"(worker: 4 host: "gamma" process: 33 cores: 3 memory_bytes: 33000 )"
            R"(program_version: "1.2" seen_ms: 10000 state: "busy" task: 5 )" +
                doing);
}

TEST_F(AnsweredRows, of_workers_have_what_they_did_and_where_they_are) {
  const std::vector<std::string> here = {
      R"(worker: 4 host: "gamma" process: 33 cores: 3 memory_bytes: 33000 )"
      R"(program_version: "1.2" seen_ms: 10000 state: "busy" task: 5)",
      R"(worker: 5 host: "beta" process: 44 cores: 4 memory_bytes: 44000 )"
      R"(program_version: "1.2" seen_ms: 10000 state: "idle" host_in_quarantine: true)",
      R"(worker: 6 host: "delta" process: 55 cores: 5 memory_bytes: 55000 )"
      R"(program_version: "1.2" seen_ms: 10000 state: "idle")",
      R"(worker: 7 host: "eps" process: 66 cores: 6 memory_bytes: 66000 )"
      R"(program_version: "1.2" seen_ms: 10000 state: "drains")"};
  EXPECT_THAT(texts_of(ask(wire::Query::WORKERS).workers()), testing::ElementsAreArray(here))
      << "worker 3 has not come back under that number, though its row says that it is here";
  wire::Query query;
  query.set_subject(wire::Query::WORKERS);
  query.set_with_gone(true);
  query.set_limit(3);
  const wire::QueryReply page = ask(query);
  EXPECT_THAT(
      texts_of(page.workers()),
      ElementsAre(R"(worker: 1 host: "alpha" process: 11 cores: 1 memory_bytes: 11000 )"
                  R"(program_version: "1.0" seen_ms: 900 state: "gone" done: 2 not_done: 3 )"
                  R"(busy_seconds: 3.005)",
                  R"(worker: 2 host: "beta" process: 22 cores: 2 memory_bytes: 22000 )"
                  R"(program_version: "1.1" seen_ms: 950 state: "gone" done: 2 busy_seconds: 2.25 )"
                  R"(host_in_quarantine: true)",
                  R"(worker: 3 host: "gamma" process: 33 cores: 3 memory_bytes: 33000 )"
                  R"(program_version: "1.2" seen_ms: 960 state: "gone")"));
  EXPECT_EQ(page.next(), 3U);
  query.set_after(3);
  query.set_limit(4);
  EXPECT_THAT(texts_of(ask(query).workers()), testing::ElementsAreArray(here));
  EXPECT_EQ(ask(query).next(), 0U);
}

TEST_F(AnsweredRows, of_workers_lead_on_though_some_rows_of_a_page_are_of_workers_not_here) {
  wire::Query query;
  query.set_subject(wire::Query::WORKERS);
  query.set_limit(2);
  std::vector<std::uint64_t> workers;
  do {
    const wire::QueryReply page = ask(query);
    for (const wire::WorkerLine& worker : page.workers()) workers.push_back(worker.worker());
    EXPECT_LE(page.workers_size(), 2);
    query.set_after(page.next());
  } while (query.after() != 0);
  EXPECT_THAT(workers, ElementsAre(4, 5, 6, 7));
}

TEST_F(AnsweredRows, of_events_are_those_of_a_job_or_a_task_and_the_newest_on_demand) {
  const std::string submitted =
      R"(event: 1 wall_ms: 1000 job: "job-1" what: "submitted" message: "wing <1>")";
  const std::string crashed =
      R"(event: 2 wall_ms: 2900 job: "job-1" task: 2 attempt: 2 worker: 1 what: "crashed" )"
      R"(message: "decompose 1: signal 11")";
  const std::string quarantined =
      R"(event: 3 wall_ms: 5500 job: "job-2" task: 7 what: "quarantined" )"
      R"(message: "inspect: the surface is open")";
  const std::string gamma =
      R"(event: 4 wall_ms: 10000 worker: 4 what: "worker" message: "gamma process 33")";
  const std::string again =
      R"(event: 5 wall_ms: 10000 job: "job-1" task: 5 attempt: 7 worker: 4 what: "reconnected" )"
      R"(message: "mesh 6")";
  const std::string delta =
      R"(event: 7 wall_ms: 10000 worker: 6 what: "worker" message: "delta process 55")";
  const std::string eps =
      R"(event: 8 wall_ms: 10000 worker: 7 what: "worker" message: "eps process 66")";
  wire::Query query;
  query.set_subject(wire::Query::EVENTS);
  query.set_limit(5);
  const wire::QueryReply first = ask(query);
  EXPECT_THAT(texts_of(first.events()), ElementsAre(submitted, crashed, quarantined, gamma, again));
  EXPECT_EQ(first.next(), 5U);
  query.set_newest(true);
  query.set_limit(2);
  EXPECT_THAT(texts_of(ask(query).events()), ElementsAre(delta, eps));
  EXPECT_EQ(ask(query).next(), 0U) << "there is one page of the newest";
  query.set_newest(false);
  query.set_job("job-1");
  query.set_limit(0);
  EXPECT_THAT(texts_of(ask(query).events()), ElementsAre(submitted, crashed, again));
  query.set_job("");
  query.set_task(7);
  EXPECT_THAT(texts_of(ask(query).events()), ElementsAre(quarantined));
}

TEST_F(AnsweredRows, of_attempts_have_who_made_them_and_how_they_ended) {
  const std::vector<std::string> attempts = {
      R"(attempt: 1 task: 1 kind: "inspect" worker: 1 host: "alpha" process: 11 state: "done" )"
      R"(started_ms: 1000 ended_ms: 2500 job: "job-1")",
      R"(attempt: 2 task: 2 kind: "decompose" path: 1 worker: 1 host: "alpha" process: 11 )"
      R"(state: "crashed" started_ms: 2600 ended_ms: 2900 memory_bytes: 3000 )"
      R"(peak_rss_bytes: 2000 message: "signal 11" job: "job-1")",
      R"(attempt: 3 task: 2 kind: "decompose" path: 1 worker: 2 host: "beta" process: 22 )"
      R"(state: "done" started_ms: 4000 ended_ms: 4500 job: "job-1")",
      R"(attempt: 4 task: 3 kind: "mesh" path: 2 worker: 2 host: "beta" process: 22 )"
      R"(state: "done" started_ms: 4600 ended_ms: 6350 job: "job-1")",
      R"(attempt: 5 task: 4 kind: "decompose" path: 3 worker: 1 host: "alpha" process: 11 )"
      R"(state: "done" started_ms: 4600 ended_ms: 5000 job: "job-1")",
      R"(attempt: 6 task: 3 kind: "mesh" path: 2 worker: 1 host: "alpha" process: 11 )"
      R"(state: "revoked" started_ms: 5000 ended_ms: 5800 races: true )"
      R"(message: "another attempt was faster" job: "job-1")",
      R"(attempt: 7 task: 5 kind: "mesh" path: 6 worker: 4 host: "gamma" process: 33 )"
      R"(state: "running" started_ms: 7000 memory_bytes: 8000 job: "job-1")",
      R"(attempt: 8 task: 7 kind: "inspect" worker: 1 host: "alpha" process: 11 )"
      R"(state: "failed" started_ms: 2900 ended_ms: 2905 job: "job-2")"};
  EXPECT_THAT(texts_of(ask(wire::Query::ATTEMPTS).attempts()), testing::ElementsAreArray(attempts));
  wire::Query query;
  query.set_subject(wire::Query::ATTEMPTS);
  query.set_after(2);
  query.set_limit(3);
  EXPECT_THAT(texts_of(ask(query).attempts()), ElementsAre(attempts[2], attempts[3], attempts[4]));
  EXPECT_EQ(ask(query).next(), 5U);
  query.set_task(3);
  query.set_after(4);
  EXPECT_THAT(texts_of(ask(query).attempts()), ElementsAre(attempts[5]));
  query.set_subject(wire::Query::LOGS);
  query.set_task(2);
  query.set_after(0);
  const wire::QueryReply logs = ask(query);
  ASSERT_EQ(logs.attempts_size(), 2);
  EXPECT_EQ(logs.attempts(0).log(), "its last words");
  EXPECT_EQ(logs.attempts(1).log(), "") << "it is not kept";
  wire::Query of_job;
  of_job.set_subject(wire::Query::LOGS);
  of_job.set_job("job-2");
  EXPECT_THAT(texts_of(ask(of_job).attempts()), ElementsAre(attempts[7]));
}

TEST_F(AnsweredRows, explain_a_task_with_its_files_and_who_makes_them) {
  missing_.insert(hash_of('7'));
  wire::Query query;
  query.set_subject(wire::Query::EXPLAIN);
  query.set_task(6);
  const wire::QueryReply reply = ask(query);
  const wire::Explanation& told = reply.explanation();
  EXPECT_EQ(told.task().ShortDebugString(), ask(wire::Query::TASKS).tasks(5).ShortDebugString());
  EXPECT_THAT(told.reasons(),
              ElementsAre("its input 'subdomain' is not in the store, or damaged; task 4, "
                          "decompose of sub-domain R, makes it (done)"));
  EXPECT_THAT(
      texts_of(told.inputs()),
      ElementsAre(
          "name: \"job\" hash: \"" + hash_of('5') + "\" size: 50 is_there: true made_by: 1",
          "name: \"subdomain\" hash: \"" + hash_of('7') + "\" size: 70 made_by: 4",
          "name: \"spacing\" hash: \"" + hash_of('3') + "\" size: 30 is_there: true made_by: 1"));
  EXPECT_EQ(told.subdomain_state(), "leaf");
  EXPECT_DOUBLE_EQ(told.expected_seconds(), 1.75 / 100 * 300) << "as the mesh that is done took";
  EXPECT_EQ(told.limit_seconds(), 3600);
  EXPECT_EQ(told.room_bytes(), 5000U) << "what a mesh took is more than it asked for";
  EXPECT_EQ(told.attempts_size(), 0);
  query.set_limit(1);
  EXPECT_EQ(ask(query).explanation().inputs_size(), 1);
}

TEST_F(AnsweredRows, explain_the_task_of_a_job_that_is_over) {
  wire::Query query;
  query.set_subject(wire::Query::EXPLAIN);
  query.set_task(7);
  const wire::Explanation told = ask(query).explanation();
  EXPECT_EQ(told.task().task(), 7U);
  EXPECT_THAT(told.reasons(), ElementsAre("in quarantine: the surface is open"));
  EXPECT_EQ(told.subdomain_state(), "");
  ASSERT_EQ(told.attempts_size(), 1);
  EXPECT_EQ(told.attempts(0).attempt(), 8U);
}

TEST_F(AnsweredRows, of_a_tree_are_its_subdomains_with_their_files_page_by_page) {
  wire::Query query;
  query.set_subject(wire::Query::TREE);
  query.set_job("job-1");
  query.set_limit(3);
  const wire::QueryReply first = ask(query);
  const std::string file = "hash: \"" + hash_of('8') + "\" size: 80";
  EXPECT_THAT(
      texts_of(first.subdomains()),
      ElementsAre("path: 1 state: \"cut\" " + file, "path: 2 state: \"leaf\" meshed: true " + file,
                  "path: 3 state: \"cut\" " + file));
  EXPECT_EQ(first.surface().hash(), hash_of('9'));
  EXPECT_EQ(first.surface().size(), 90U);
  EXPECT_EQ(first.next(), 3U);
  query.set_after(3);
  const wire::QueryReply last = ask(query);
  EXPECT_THAT(texts_of(last.subdomains()),
              ElementsAre("path: 6 state: \"leaf\" " + file, "path: 7 state: \"leaf\" " + file));
  EXPECT_EQ(last.next(), 0U);
  query.set_after(7);
  EXPECT_EQ(ask(query).ShortDebugString(), "");
}

TEST_F(AnsweredRows, are_refused_with_what_is_not_there) {
  const auto query = [](wire::Query::Subject subject, const char* job, std::uint64_t task) {
    wire::Query made;
    made.set_subject(subject);
    made.set_job(job);
    made.set_task(task);
    return made;
  };
  EXPECT_EQ(refusal_of(query(wire::Query::TASKS, "job-3", 0)), "5: no job job-3");
  EXPECT_EQ(refusal_of(query(wire::Query::TASKS, "x", 0)), "5: no job x");
  EXPECT_EQ(refusal_of(query(wire::Query::EXPLAIN, "", 8)), "5: no task 8");
  EXPECT_EQ(refusal_of(query(wire::Query::EXPLAIN, "", 0)), "5: no task 0");
  EXPECT_EQ(refusal_of(query(wire::Query::ATTEMPTS, "job-2", 1)), "5: no task 1 of job-2");
  EXPECT_EQ(refusal_of(query(wire::Query::EVENTS, "job-1", 7)), "5: no task 7 of job-1");
  EXPECT_EQ(refusal_of(query(wire::Query::EVENTS, "job-2", 7)), "");
  EXPECT_EQ(refusal_of(query(wire::Query::TREE, "job-3", 0)), "5: no job job-3");
  EXPECT_EQ(refusal_of(query(wire::Query::TREE, "", 0)),
            "2: a tree is of one job, which has to be named");
  EXPECT_EQ(refusal_of(query(wire::Query::SUBJECT_UNSPECIFIED, "", 0)),
            "2: the subject of the query is unknown to this coordinator");
}

TEST_F(AnsweredRows, are_at_most_a_thousand_on_a_page_and_at_most_as_many_as_a_message_carries) {
  ChangeSet more;
  for (int i = 0; i < 1100; ++i) more.events.push_back({1, {}, {}, {}, {}, "what", ""});
  for (int i = 0; i < 30; ++i) {
    more.events.push_back({1, {}, {}, {}, {}, "long", std::string(100'000, 'x')});
  }
  database_.apply(more);
  for (const std::uint32_t limit : {0U, 1000U, 5000U}) {
    wire::Query query;
    query.set_subject(wire::Query::EVENTS);
    query.set_limit(limit);
    const wire::QueryReply reply = ask(query);
    EXPECT_EQ(reply.events_size(), 1000) << limit;
    EXPECT_EQ(reply.next(), 1000U);
  }
  wire::Query query;
  query.set_subject(wire::Query::EVENTS);
  query.set_after(8 + 1100);
  EXPECT_EQ(ask(query).events_size(), 21) << "the first that makes it more than 2 MiB is the last";
  EXPECT_EQ(ask(query).next(), 8U + 1100 + 21);
}

TEST_F(AnsweredRows, of_a_status_have_the_farm_on_the_first_page_only) {
  wire::StatusRequest request;
  const wire::StatusReply all = answer_status(request, *state_, now_);
  EXPECT_EQ(all.workers(), 4U);
  EXPECT_THAT(texts_of(all.hosts()),
              ElementsAre(R"(host: "beta" reason: "three tasks crashed there" since_ms: 7500)"));
  EXPECT_THAT(texts_of(all.at_work()),
              ElementsAre(R"(worker: 4 host: "gamma" process: 33 task: 5 memory_bytes: 33000)",
                          R"(worker: 5 host: "beta" process: 44 memory_bytes: 44000)",
                          R"(worker: 6 host: "delta" process: 55 memory_bytes: 55000)",
                          R"(worker: 7 host: "eps" process: 66 drains: true memory_bytes: 66000)"));
  EXPECT_THAT(texts_of(all.demand()), ElementsAre("memory_bytes: 5000 tasks: 1"));
  ASSERT_EQ(all.jobs_size(), 2);
  EXPECT_EQ(all.jobs(0).numbers().at("task_decompose_count"), 2);
  EXPECT_EQ(all.jobs(1).ShortDebugString(), duct);
  request.set_after(1);
  const wire::StatusReply rest = answer_status(request, *state_, now_);
  EXPECT_EQ(rest.workers(), 4U);
  EXPECT_EQ(rest.hosts_size() + rest.at_work_size() + rest.demand_size(), 0);
  ASSERT_EQ(rest.jobs_size(), 1);
  EXPECT_EQ(rest.jobs(0).job(), "job-2");
  request.set_after(0);
  request.set_job("job-2");
  EXPECT_EQ(answer_status(request, *state_, now_).jobs_size(), 1);
  request.set_farm_only(true);
  const wire::StatusReply farm = answer_status(request, *state_, now_);
  EXPECT_EQ(farm.jobs_size(), 0);
  EXPECT_EQ(farm.at_work_size(), 4);
}

}  // namespace
}  // namespace tetfarm
