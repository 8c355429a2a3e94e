#include "coordinator/decisions/message_translation.h"

#include <algorithm>

#include "tasks/failure_cause.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

/// Longer than any walltime, and far from where sums of times overflow.
constexpr std::uint64_t longest_ms = std::uint64_t{1} << 50U;

/// A name that cannot lead out of a folder.
std::string plain_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == 127; }, '_');
  if (name.empty() || name == "." || name == "..") return "_";
  return name;
}

void add_file(const ArtifactRef& file, wire::Artifact& message) {
  message.set_name(file.name);
  message.set_hash(file.hash);
  message.set_size(file.size);
}

}  // namespace

WorkerInfo worker_info_of(const wire::Hello& hello) {
  WorkerInfo info;
  info.host = hello.host();
  info.process = hello.process();
  info.cores = hello.cores();
  info.memory_bytes = hello.memory_bytes();
  info.program_version = hello.program_version();
  info.nonce = hello.nonce();
  info.shares_memory = !hello.own_memory();
  info.ends_in_ms = static_cast<std::int64_t>(std::min(hello.ends_in_ms(), longest_ms));
  info.tag = hello.tag();
  info.pool_memory_bytes = hello.pool_memory_bytes();
  info.runs_solvers = hello.runs_solvers();
  return info;
}

std::vector<ArtifactRef> files_of(const google::protobuf::RepeatedPtrField<wire::Artifact>& files) {
  std::vector<ArtifactRef> list;
  for (const wire::Artifact& file : files) {
    list.push_back({plain_name(file.name()), file.hash(), file.size()});
  }
  return list;
}

TaskResult result_of(const wire::Done& done) {
  TaskResult result;
  result.outputs = files_of(done.outputs());
  result.numbers = {done.numbers().begin(), done.numbers().end()};
  result.texts = {done.texts().begin(), done.texts().end()};
  result.seconds = done.seconds();
  result.peak_rss_bytes = done.peak_rss_bytes();
  result.log = done.log();
  return result;
}

TaskFailure failure_of(const wire::Failed& failed) {
  TaskFailure failure;
  failure.exit_code = failed.exit_code();
  failure.message = failed.message();
  // A cause that this program does not know is worth another try, but not for ever.
  failure.cause = failure_cause_on_wire(failed.cause()).value_or(FailureCause::error);
  failure.peak_rss_bytes = failed.peak_rss_bytes();
  failure.log = failed.log();
  failure.evidence = files_of(failed.evidence());
  return failure;
}

wire::Envelope assign_message(const TaskRow& task, AttemptId attempt) {
  wire::Envelope envelope;
  wire::Assign& assign = *envelope.mutable_assign();
  assign.set_task(task.id.value);
  assign.set_attempt(attempt.value);
  assign.set_job(job_name(task.job));
  assign.set_kind(traits_of(task.kind).on_wire);
  assign.set_path(task.path);
  for (const ArtifactRef& input : task.inputs) add_file(input, *assign.add_inputs());
  assign.mutable_parameters()->insert(task.parameters.begin(), task.parameters.end());
  return envelope;
}

wire::Envelope accepted_message(const SendAccepted& accepted) {
  wire::Envelope envelope;
  envelope.mutable_accepted()->set_task(accepted.task.value);
  envelope.mutable_accepted()->set_attempt(accepted.attempt.value);
  envelope.mutable_accepted()->set_taken(accepted.taken);
  return envelope;
}

wire::Envelope refused_message(const std::string& reason, bool hello_again, int exit_code) {
  wire::Envelope envelope;
  envelope.mutable_refused()->set_reason(reason);
  envelope.mutable_refused()->set_hello_again(hello_again);
  envelope.mutable_refused()->set_exit_code(exit_code);
  return envelope;
}

void add_farm(const JobState& state, wire::StatusReply& message) {
  for (const auto& [name, row] : state.durable().quarantined_hosts) {
    wire::HostInQuarantine& host = *message.add_hosts();
    host.set_host(name);
    host.set_reason(row.reason);
    host.set_since_ms(row.since_ms);
  }
  for (const WorkerAtWork& at_work : state.workers_at_work()) {
    wire::WorkerStatus& worker = *message.add_at_work();
    worker.set_worker(at_work.row.id.value);
    worker.set_host(at_work.row.host);
    worker.set_process(at_work.row.process);
    worker.set_task(at_work.task.value);
    worker.set_drains(at_work.drains);
    worker.set_memory_bytes(at_work.row.memory_bytes);
    worker.set_tag(at_work.tag);
  }
  for (const bool of_solvers : {false, true}) {
    for (const auto& [bytes, tasks] : state.demand(of_solvers)) {
      wire::TaskDemand& demand = *message.add_demand();
      demand.set_memory_bytes(bytes);
      demand.set_tasks(tasks);
      demand.set_of_solvers(of_solvers);
    }
  }
}

wire::JobStatus status_message(const JobSummary& summary) {
  wire::JobStatus message;
  message.set_job(job_name(summary.job));
  message.set_name(summary.name);
  message.set_state(summary.state);
  message.set_stage(summary.stage);
  message.set_leaves_made(summary.leaves_made);
  message.set_leaves_meshed(summary.leaves_meshed);
  message.set_elements(summary.elements);
  message.set_estimated_elements(summary.estimated_elements);
  message.set_message(summary.message);
  message.set_exit_code(summary.exit_code);
  message.mutable_numbers()->insert(summary.numbers.begin(), summary.numbers.end());
  message.mutable_texts()->insert(summary.texts.begin(), summary.texts.end());
  for (const ArtifactRef& file : summary.files) add_file(file, *message.add_files());
  message.set_tasks_done(summary.tasks_done);
  message.set_tasks_ready(summary.tasks_ready);
  message.set_tasks_running(summary.tasks_running);
  message.set_attempts_lost(summary.attempts_lost);
  message.set_crashes(summary.crashes);
  message.set_oom_count(summary.oom_count);
  for (const TaskRow& failed : summary.quarantine) {
    wire::TaskInQuarantine& task = *message.add_quarantine();
    task.set_task(failed.id.value);
    task.set_kind(name_of(failed.kind));
    task.set_path(failed.path);
    task.set_reason(failed.message);
    task.set_exit_code(failed.exit_code);
  }
  message.set_peak_rss_bytes_worker(summary.peak_rss_bytes_worker);
  message.set_leaves_mended(summary.leaves_mended);
  message.set_seconds(summary.seconds);
  message.set_created_ms(summary.created_ms);
  message.set_priority(summary.priority);
  for (const JobId job : summary.after) message.add_after(job_name(job));
  for (const JobId job : summary.waits_for) message.add_waits_for(job_name(job));
  message.set_finished_ms(summary.finished_ms);
  return message;
}

}  // namespace tetfarm
