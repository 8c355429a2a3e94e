// A farm as a coordinator finds it in its database when it starts again: one job under way and one
// that failed. One worker of before has come back to its task, three others are new.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/sha256.h"
#include "coordinator/decisions/finished_jobs.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/views/query_answers.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {

class FarmInRows : public testing::Test {
 protected:
  FarmInRows() : database_(folder_.path() / "tetfarm.db") {
    database_.apply(committed());
    finished_ = FinishedJobs(rows_in(database_));
    DurableState rows = database_.load_unfinished();
    finished_.put_others_than(rows);
    state_ = std::make_unique<JobState>(
        std::move(rows), FarmRules{},
        [this](const ArtifactRef& file) { return !missing_.contains(file.hash); }, now_,
        &finished_);
    connect("gamma", 33, TaskId{5}, AttemptId{7});
    connect("beta", 44, {}, {});
    connect("delta", 55, {}, {});
    state_->drain(connect("eps", 66, {}, {}));
    database_.apply(state_->take_changes());
  }

  QueryContext context(const JobHistory& history) const { return {*state_, history, now_}; }
  wire::QueryReply ask(const wire::Query& query) const {
    const JobHistory history = database_.history();
    return answer_query(query, context(history));
  }
  wire::QueryReply ask(wire::Query::Subject subject) const {
    wire::Query query;
    query.set_subject(subject);
    return ask(query);
  }
  static std::string hash_of(char digit) { return std::string(32, digit); }

  const TempFolder folder_;
  const Moment now_{10'000, 10'000};
  std::set<std::string> missing_;  ///< files that are not in the store
  JobDatabase database_;
  FinishedJobs finished_;
  std::unique_ptr<JobState> state_;

 private:
  WorkerId connect(const std::string& host, std::int64_t process, TaskId task, AttemptId attempt) {
    WorkerInfo info;
    info.host = host;
    info.process = process;
    info.cores = static_cast<std::uint32_t>(process / 11);
    info.memory_bytes = 1000 * static_cast<std::uint64_t>(process);
    info.program_version = "1.2";
    info.nonce = "nonce of " + host;
    const WorkerId worker = state_->add_worker(info, task, attempt, now_);
    state_->worker_is_ready(worker, now_);
    return worker;
  }

  static ArtifactRef file(const char* name, char digit) {
    return {name, hash_of(digit), static_cast<std::uint64_t>(10 * (digit - '0'))};
  }
  static TaskRow task(std::uint64_t id, TaskKind kind, std::uint64_t path, TaskState state,
                      std::uint64_t attempt, double seconds, const char* work) {
    TaskRow row;
    row.id = TaskId{id};
    row.job = JobId{1};
    row.kind = kind;
    row.path = path;
    row.state = state;
    row.attempt = AttemptId{attempt};
    row.seconds = seconds;
    if (*work != '\0') row.parameters["work"] = work;
    return row;
  }
  static std::vector<TaskRow> tasks() {
    TaskRow inspect = task(1, TaskKind::inspect, 0, TaskState::done, 1, 1.5, "");
    inspect.peak_rss_bytes = 7000;
    inspect.inputs = {file("job", '1'), file("input_surface", '2')};
    inspect.outputs = {file("surface", '9'), file("spacing", '3'), file("root", '4'),
                       file("settings", '5')};
    inspect.numbers = {{"expected_seconds", 2},
                       {"expected_bytes", 3000},
                       {"cpu_seconds", 1.25},
                       {"total_work", 800}};
    TaskRow first_cut = task(2, TaskKind::decompose, 1, TaskState::done, 3, 0.5, "800");
    first_cut.crashes = 1;
    TaskRow meshed = task(3, TaskKind::mesh, 2, TaskState::done, 4, 1.75, "100");
    meshed.peak_rss_bytes = 5000;
    meshed.numbers = {{"expected_seconds", 2.5},
                      {"expected_bytes", 6000},
                      {"cpu_seconds", 1.125},
                      {"tets", 120},
                      {"min_dihedral_deg", 21.5}};
    TaskRow second_cut = task(4, TaskKind::decompose, 3, TaskState::done, 5, 0.25, "700");
    second_cut.outputs = {file("left", '6'), file("right", '7')};
    TaskRow running = task(5, TaskKind::mesh, 6, TaskState::leased, 7, 0, "400");
    TaskRow ready = task(6, TaskKind::mesh, 7, TaskState::ready, 0, 0, "300");
    ready.losses = 2;
    ready.oom_count = 1;
    ready.memory_bytes = 4096;
    ready.message = "killed";
    ready.inputs = {file("job", '5'), file("subdomain", '7'), file("spacing", '3')};
    TaskRow failed = task(7, TaskKind::inspect, 0, TaskState::failed, 0, 0, "");
    failed.job = JobId{2};
    failed.exit_code = 3;
    failed.message = "the surface is open";
    failed.peak_rss_bytes = 9000;
    return {inspect, first_cut, meshed, second_cut, running, ready, failed};
  }
  static std::vector<SubdomainRow> subdomains() {
    const auto node = [](std::uint64_t path, SubdomainState state) {
      SubdomainRow row;
      row.job = JobId{1};
      row.path = path;
      row.state = state;
      row.hash = hash_of('8');
      row.size = 80;
      row.work = 100;
      return row;
    };
    SubdomainRow meshed = node(2, SubdomainState::leaf);
    meshed.meshed = true;
    meshed.tets = 120;
    return {node(1, SubdomainState::cut), meshed, node(3, SubdomainState::cut),
            node(6, SubdomainState::leaf), node(7, SubdomainState::leaf)};
  }
  static std::vector<AttemptRow> attempts() {
    AttemptRow crashed{AttemptId{2}, TaskId{2}, WorkerId{1}, AttemptState::crashed,
                       2600,         2900,      "signal 11", ""};
    crashed.memory_bytes = 3000;
    crashed.peak_rss_bytes = 2000;
    crashed.log = "its last words";
    AttemptRow running{AttemptId{7}, TaskId{5}, WorkerId{3}, AttemptState::running,
                       7000,         0,         "",          sha256_hex("nonce of gamma")};
    running.memory_bytes = 8000;
    const auto ended = [](std::uint64_t id, std::uint64_t task, std::uint64_t worker,
                          AttemptState state, std::int64_t begin, std::int64_t end) {
      return AttemptRow{AttemptId{id}, TaskId{task}, WorkerId{worker}, state, begin, end, "", ""};
    };
    AttemptRow revoked = ended(6, 3, 1, AttemptState::revoked, 5000, 5800);
    revoked.message = "another attempt was faster";
    revoked.is_rival = true;
    return {ended(1, 1, 1, AttemptState::done, 1000, 2500),
            crashed,
            ended(3, 2, 2, AttemptState::done, 4000, 4500),
            ended(4, 3, 2, AttemptState::done, 4600, 6350),
            ended(5, 4, 1, AttemptState::done, 4600, 5000),
            revoked,
            running,
            ended(8, 7, 1, AttemptState::failed, 2900, 2905)};
  }
  static ChangeSet committed() {
    ChangeSet all;
    all.jobs = {
        {JobId{1}, "key", "wing <1>", "toml", JobPhase::running, 0, "", 1000, 0},
        {JobId{2}, "", "duct", "toml", JobPhase::failed, 3, "the surface is open", 2000, 5500}};
    all.tasks = tasks();
    all.subdomains = subdomains();
    all.workers = {{WorkerId{1}, "alpha", 11, 1, 11'000, "1.0", 900, true},
                   {WorkerId{2}, "beta", 22, 2, 22'000, "1.1", 950, true},
                   {WorkerId{3}, "gamma", 33, 3, 33'000, "1.2", 960, false}};
    all.attempts = attempts();
    all.hosts = {{"beta", true, 7500, "three tasks crashed there"}};
    all.events = {
        {1000, JobId{1}, {}, {}, {}, "submitted", "wing <1>"},
        {2900, JobId{1}, TaskId{2}, AttemptId{2}, WorkerId{1}, "crashed", "decompose 1: signal 11"},
        {5500, JobId{2}, TaskId{7}, {}, {}, "quarantined", "inspect: the surface is open"}};
    return all;
  }
};

}  // namespace tetfarm
