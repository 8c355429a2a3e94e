#include "coordinator/views/query_answers.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "coordinator/decisions/job_status.h"
#include "coordinator/decisions/message_translation.h"
#include "coordinator/decisions/task_rows.h"
#include "coordinator/views/running_tasks.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_rows = 1000;
/// A page ends when it is larger, so that a message stays far below max_message_size.
constexpr std::size_t page_bytes = std::size_t{2} << 20U;

/// Of jobs that are at hand from their rows, of finished ones what is kept.
class JobStatuses {
 public:
  JobStatuses(const JobState& state, Moment now)
      : state_(state), now_(now), tasks_(tasks_of_jobs(state.durable())) {}

  wire::JobStatus of(const JobRow& job) const {
    const auto finished = state_.finished().jobs().find(job.id);
    if (!state_.is_at_hand(job.id) && finished != state_.finished().jobs().end()) {
      wire::JobStatus status;
      TF_CHECK(status.ParseFromString(finished->second.status));
      return status;
    }
    const auto own = tasks_.find(job.id);
    const std::vector<const TaskRow*> none;
    const std::vector<const TaskRow*>& tasks = own == tasks_.end() ? none : own->second;
    wire::JobStatus status =
        status_message(summary_of(state_.durable(), job, tasks,
                                  state_.is_stuck() ? state_.stuck_message() : "", now_.wall_ms));
    add_running_tasks(state_, tasks, now_, status);
    return status;
  }

 private:
  const JobState& state_;
  Moment now_;
  TasksOfJobs tasks_;
};

/// And what it made, as far as that is a figure of every such task.
void set_expectations(const TaskRow& task, wire::TaskLine& line) {
  const auto told = [&task](const char* name) {
    const auto found = task.numbers.find(name);
    return found == task.numbers.end() ? 0 : found->second;
  };
  line.set_expected_seconds(told("expected_seconds"));
  line.set_expected_bytes(told("expected_bytes"));
  line.set_cpu_seconds(told("cpu_seconds"));
  line.set_elements(told("tets"));
  line.set_min_dihedral_deg(told("min_dihedral_deg"));
  if (const auto size = told_size(task)) line.set_expected_elements(size->elements);
}

/// One question being answered.
class Answer {
 public:
  Answer(const wire::Query& query, const QueryContext& context)
      : query_(query),
        state_(context.state),
        rows_(context.state.durable()),
        history_(context.history),
        now_(context.now),
        limit_(query.limit() == 0 ? most_rows : std::min<std::size_t>(query.limit(), most_rows)) {
    TF_CHECK(limit_ > 0);
    if (query.job().empty()) return;
    job_ = parse_job_name(query.job());
    if (!rows_.jobs.contains(job_)) throw Error(ExitCode::not_found, "no job " + query.job());
  }

  wire::QueryReply give() {
    switch (query_.subject()) {
      case wire::Query::JOBS:
        jobs();
        break;
      case wire::Query::TASKS:
        tasks();
        break;
      case wire::Query::WORKERS:
        workers();
        break;
      case wire::Query::EVENTS:
        events();
        break;
      case wire::Query::ATTEMPTS:
      case wire::Query::LOGS:
        attempts();
        break;
      case wire::Query::EXPLAIN:
        explain();
        break;
      case wire::Query::TREE:
        tree();
        break;
      default:
        throw Error(ExitCode::usage, "the subject of the query is unknown to this coordinator");
    }
    return std::move(reply_);
  }

 private:
  /// Whether the page ends before a row; then the next one goes on after `last`.
  bool is_full(std::size_t rows, std::uint64_t last) {
    if (rows < limit_ && bytes_ < page_bytes) return false;
    reply_.set_next(last);
    return true;
  }
  template <class Row>
  Row& counted(Row& row) {
    bytes_ += row.ByteSizeLong() + 8;
    return row;
  }

  /// The task that is asked for, without files and values.
  TaskRow task() const {
    std::optional<TaskRow> found = history_.task(TaskId{query_.task()});
    if (!found || (job_ && found->job != job_)) {
      throw Error(ExitCode::not_found,
                  "no task " + std::to_string(query_.task()) + (job_ ? " of " + query_.job() : ""));
    }
    return *std::move(found);
  }

  void jobs() {
    const JobStatuses statuses(state_, now_);
    std::uint64_t last = 0;
    for (auto job = rows_.jobs.upper_bound(JobId{query_.after()}); job != rows_.jobs.end(); ++job) {
      if (job_ && job->first != job_) continue;
      if (is_full(static_cast<std::size_t>(reply_.jobs_size()), last)) return;
      wire::JobStatus status = statuses.of(job->second);
      status.clear_numbers();
      status.clear_texts();
      status.clear_files();
      counted(*reply_.add_jobs() = std::move(status));
      last = job->first.value;
    }
  }

  const WorkerRow* worker(WorkerId id) {
    const auto [known, is_new] = workers_.try_emplace(id);
    if (is_new && id) known->second = history_.worker(id);
    return known->second ? &*known->second : nullptr;
  }

  wire::TaskLine line_of(const TaskRow& task) {
    wire::TaskLine line;
    line.set_task(task.id.value);
    line.set_job(job_name(task.job));
    line.set_kind(name_of(task.kind));
    line.set_path(task.path);
    line.set_state(name_of(task.state));
    line.set_attempt(task.attempt.value);
    line.set_crashes(task.crashes);
    line.set_losses(task.losses);
    line.set_oom_count(task.oom_count);
    line.set_seconds(task.seconds);
    line.set_peak_rss_bytes(task.peak_rss_bytes);
    line.set_memory_bytes(task.memory_bytes);
    line.set_exit_code(task.exit_code);
    line.set_message(task.message);
    set_expectations(task, line);
    add_doing(state_, task, line);
    const auto attempt = rows_.running_attempts.find(task.attempt);
    if (attempt == rows_.running_attempts.end()) return line;
    line.set_seconds(static_cast<double>(now_.wall_ms - attempt->second.started_ms) / 1000);
    line.set_worker(attempt->second.worker.value);
    if (const WorkerRow* row = worker(attempt->second.worker)) line.set_host(row->host);
    return line;
  }

  void tasks() {
    std::uint64_t last = 0;
    for (const TaskRow& task : history_.tasks(job_, TaskId{query_.after()}, limit_ + 1)) {
      if (is_full(static_cast<std::size_t>(reply_.tasks_size()), last)) return;
      counted(*reply_.add_tasks() = line_of(task));
      last = task.id.value;
    }
  }

  void workers() {
    std::map<WorkerId, WorkerAtWork> here;
    for (const WorkerAtWork& at_work : state_.workers_at_work()) here[at_work.row.id] = at_work;
    std::uint64_t last = 0;
    const std::vector<WorkerRecord> records =
        history_.workers(WorkerId{query_.after()}, limit_ + 1, query_.with_gone());
    for (const WorkerRecord& record : records) {
      const auto at_work = here.find(record.row.id);
      const bool is_here = at_work != here.end();
      if (is_full(static_cast<std::size_t>(reply_.workers_size()), last)) return;
      last = record.row.id.value;
      // After a restart the rows of those that have not come back yet say that they are here.
      if (!is_here && !query_.with_gone()) continue;
      wire::WorkerLine& line = *reply_.add_workers();
      line.set_worker(record.row.id.value);
      line.set_host(record.row.host);
      line.set_process(record.row.process);
      line.set_cores(record.row.cores);
      line.set_memory_bytes(record.row.memory_bytes);
      line.set_program_version(record.row.program_version);
      line.set_seen_ms(record.row.seen_ms);
      line.set_state(!is_here                 ? "gone"
                     : at_work->second.drains ? "drains"
                     : at_work->second.task   ? "busy"
                                              : "idle");
      if (is_here) line.set_task(at_work->second.task.value);
      if (is_here) add_doing(state_, at_work->second, line);
      line.set_done(record.done);
      line.set_not_done(record.not_done);
      line.set_busy_seconds(record.busy_seconds);
      line.set_host_in_quarantine(rows_.quarantined_hosts.contains(record.row.host));
      counted(line);
    }
    // Of the rows that were read some may have been left out.
    if (records.size() > limit_) reply_.set_next(last);
  }

  void events() {
    EventFilter filter{.job = job_, .after = query_.after(), .limit = limit_ + 1};
    if (query_.task() != 0) {
      const TaskRow row = task();
      filter.task = row.id;
      filter.job = row.job;
    }
    filter.newest = query_.newest();
    if (filter.newest) filter.limit = limit_;
    std::uint64_t last = 0;
    for (const PastEvent& past : history_.events(filter)) {
      if (is_full(static_cast<std::size_t>(reply_.events_size()), last)) return;
      wire::EventLine& line = *reply_.add_events();
      line.set_event(past.id);
      line.set_wall_ms(past.row.wall_ms);
      if (past.row.job) line.set_job(job_name(past.row.job));
      line.set_task(past.row.task.value);
      line.set_attempt(past.row.attempt.value);
      line.set_worker(past.row.worker.value);
      line.set_what(past.row.what);
      line.set_message(past.row.message);
      counted(line);
      last = past.id;
    }
  }

  wire::AttemptLine line_of(const AttemptRow& attempt) {
    wire::AttemptLine line;
    line.set_attempt(attempt.id.value);
    line.set_task(attempt.task.value);
    if (const std::optional<TaskRow> task = history_.task(attempt.task)) {
      line.set_kind(name_of(task->kind));
      line.set_path(task->path);
      line.set_job(job_name(task->job));
    }
    line.set_worker(attempt.worker.value);
    if (const WorkerRow* row = worker(attempt.worker)) {
      line.set_host(row->host);
      line.set_process(row->process);
    }
    line.set_state(name_of(attempt.state));
    line.set_started_ms(attempt.started_ms);
    line.set_ended_ms(attempt.ended_ms);
    line.set_memory_bytes(attempt.memory_bytes);
    line.set_peak_rss_bytes(attempt.peak_rss_bytes);
    line.set_races(attempt.is_rival);
    line.set_message(attempt.message);
    return line;
  }

  void attempts() {
    std::vector<AttemptRow> rows =
        query_.task() != 0 ? history_.attempts_of(task().id)
                           : history_.attempts_of(job_, AttemptId{query_.after()}, limit_ + 1);
    std::uint64_t last = 0;
    for (const AttemptRow& attempt : rows) {
      if (attempt.id.value <= query_.after()) continue;
      if (is_full(static_cast<std::size_t>(reply_.attempts_size()), last)) return;
      wire::AttemptLine& line = *reply_.add_attempts();
      line = line_of(attempt);
      if (query_.subject() == wire::Query::LOGS) {
        line.set_log(history_.log_of(attempt.id).value_or(""));
      }
      counted(line);
      last = attempt.id.value;
    }
  }

  void explain() {
    const TaskRow asked = task();
    std::optional<JobState> past;
    if (!rows_.tasks.contains(asked.id)) past.emplace(state_.past_job(asked.job, now_));
    const JobState& state = past ? *past : state_;
    const DurableState& rows = state.durable();
    const TaskRow& row = rows.tasks.at(asked.id);
    const TaskOutlook outlook = state.outlook(row.id, now_);
    wire::Explanation& explanation = *reply_.mutable_explanation();
    *explanation.mutable_task() = line_of(row);
    for (const std::string& reason : outlook.reasons) explanation.add_reasons(reason);
    explanation.set_expected_seconds(outlook.expected_seconds);
    explanation.set_limit_seconds(static_cast<double>(outlook.limit_ms) / 1000);
    explanation.set_room_bytes(outlook.room_bytes);
    const auto place = rows.subdomains.find({row.job, row.path});
    if (place != rows.subdomains.end()) {
      explanation.set_subdomain_state(name_of(place->second.state));
    }
    std::vector<AttemptRow> tries = history_.attempts_of(row.id);
    if (tries.size() > limit_) tries.erase(tries.begin(), tries.end() - static_cast<long>(limit_));
    for (const AttemptRow& attempt : tries) *explanation.add_attempts() = line_of(attempt);
    std::map<std::string, TaskId> makers;
    for (const auto& [maker, other] : rows.tasks) {
      if (other.job != row.job) continue;
      for (const ArtifactRef& output : other.outputs) makers.emplace(output.hash, maker);
    }
    for (const ArtifactRef& input : row.inputs) {
      if (static_cast<std::size_t>(explanation.inputs_size()) == limit_) break;
      wire::InputLine& line = *explanation.add_inputs();
      line.set_name(input.name);
      line.set_hash(input.hash);
      line.set_size(input.size);
      line.set_is_there(state_.has_file(input));
      const auto maker = makers.find(input.hash);
      line.set_made_by(maker == makers.end() ? 0 : maker->second.value);
    }
  }

  /// With its files; of a job that ended long ago they are read.
  std::optional<TaskRow> whole_task(TaskId id) const {
    const auto at_hand = rows_.tasks.find(id);
    if (at_hand != rows_.tasks.end()) return at_hand->second;
    if (!state_.finished().is_kept()) return std::nullopt;
    return state_.finished().task(id);
  }

  /// The surface that inspect made, whose pieces the sub-domains have; it is among the first tasks.
  void add_surface() {
    constexpr std::size_t first_tasks = 2;
    for (const TaskRow& task : history_.tasks(job_, TaskId{}, first_tasks)) {
      const std::optional<TaskRow> whole = whole_task(task.id);
      const std::optional<TaskFile> surface = whole ? inspected_surface(*whole) : std::nullopt;
      if (!surface) continue;
      reply_.mutable_surface()->set_hash(surface->hash);
      reply_.mutable_surface()->set_size(surface->size);
    }
  }

  void tree() {
    if (!job_) throw Error(ExitCode::usage, "a tree is of one job, which has to be named");
    std::uint64_t last = 0;
    for (const SubdomainRow& row : history_.tree(job_, query_.after(), limit_ + 1)) {
      if (is_full(static_cast<std::size_t>(reply_.subdomains_size()), last)) break;
      wire::SubdomainLine& line = *reply_.add_subdomains();
      line.set_path(row.path);
      line.set_state(name_of(row.state));
      line.set_meshed(row.meshed);
      line.set_hash(row.hash);
      line.set_size(row.size);
      counted(line);
      last = row.path;
    }
    if (reply_.subdomains_size() > 0) add_surface();
  }

  const wire::Query& query_;
  const JobState& state_;
  const DurableState& rows_;
  const JobHistory& history_;
  const Moment now_;
  const std::size_t limit_;
  JobId job_;  ///< 0: all
  std::map<WorkerId, std::optional<WorkerRow>> workers_;
  std::size_t bytes_ = 0;
  wire::QueryReply reply_;
};

}  // namespace

wire::QueryReply answer_query(const wire::Query& query, const QueryContext& context) {
  return Answer(query, context).give();
}

wire::StatusReply answer_status(const wire::StatusRequest& request, const JobState& state,
                                Moment now) {
  wire::StatusReply reply;
  reply.set_workers(static_cast<std::uint32_t>(state.worker_count()));
  if (request.after() == 0) add_farm(state, reply);
  if (request.farm_only()) return reply;
  const DurableState& rows = state.durable();
  const JobStatuses statuses(state, now);
  std::size_t bytes = 0;
  for (auto job = rows.jobs.upper_bound(JobId{request.after()}); job != rows.jobs.end(); ++job) {
    if (!request.job().empty() && request.job() != job_name(job->first)) continue;
    if (bytes >= page_bytes) {
      reply.set_next(std::prev(job)->first.value);
      break;
    }
    *reply.add_jobs() = statuses.of(job->second);
    bytes += reply.jobs(reply.jobs_size() - 1).ByteSizeLong();
  }
  return reply;
}

}  // namespace tetfarm
