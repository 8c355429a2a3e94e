/// JobState, the part about results and failures of tasks, and about the wishes of clients.
#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "coordinator/decisions/assimilation_graph.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/job_status.h"
#include "coordinator/decisions/layer_graph.h"
#include "coordinator/decisions/loop_graph.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/remesh_contract.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

constexpr int exit_failed = static_cast<int>(ExitCode::failed);

/// What a submission's key stands for; see JobRow::content. @param first the task that begins it.
std::string content_of(const TaskRow& first) {
  std::string content;
  for (const ArtifactRef& input : first.inputs) {
    content += (content.empty() ? "" : "\n") + input.name + " " + input.hash;
  }
  return content;
}

TaskRow first_task(const Submission& submission) {
  if (submission.remeshes) {
    TF_CHECK(submission.given.input_surface.has_value());
    return new_task({}, 0, RemeshGiven{submission.given.job, *submission.given.input_surface});
  }
  if (!submission.loop) return new_task({}, 0, submission.given);
  TaskRow solve = new_task({}, submission.loop->cycle, *submission.loop);
  solve.memory_bytes = submission.loop_memory_bytes;
  return solve;
}

}  // namespace

std::string place_of(const TaskRow& task) {
  const std::string kind = name_of(task.kind);
  return kind + of_task_place(kind, task.path);
}

void JobState::done(WorkerId worker, TaskId id, AttemptId attempt, const TaskResult& result,
                    Moment now) {
  workers_.hear(worker, now.steady_ms);
  if (!holds(worker, id, attempt)) {
    commands_.emplace_back(SendAccepted{worker, id, attempt, was_accepted(id, attempt)});
    // Who comes too late has made the same files once more.
    const auto known = durable_.tasks.find(id);
    if (known != durable_.tasks.end()) note_files(known->second, files_of(known->second.job));
    return;
  }
  store_log(attempt, result.log, result.peak_rss_bytes);
  if (!std::all_of(result.outputs.begin(), result.outputs.end(), has_file_)) {
    lose_attempt(attempt, AttemptState::lost, "its outputs are not in the store", now);
    commands_.emplace_back(SendAccepted{worker, id, attempt, false});
    return;
  }
  commands_.emplace_back(SendAccepted{worker, id, attempt, true});
  TaskRow& task = edit(id);
  if (const auto problem = problem_with(task, result)) {
    end_attempt(attempt, AttemptState::failed, *problem, now);
    fail_task(task, exit_failed, "unusable result: " + *problem, now);
    return;
  }
  const bool made_before = !task.outputs.empty();
  if (made_before && task.outputs != result.outputs) {
    end_attempt(attempt, AttemptState::failed, "different bytes from the first time", now);
    fail_task(task, exit_failed,
              "run again for a lost file, it made different bytes from the first time; submit the "
              "job again",
              now);
    return;
  }
  end_attempt(attempt, AttemptState::done, "", now);
  revoke_attempts(task, "another attempt was faster", now);
  task.attempt = attempt;
  task.outputs = result.outputs;
  task.numbers = result.numbers;
  task.texts = result.texts;
  if (!rules_.program.empty()) task.texts["program"] = rules_.program;
  task.seconds = result.seconds;
  task.peak_rss_bytes = result.peak_rss_bytes;
  task.message.clear();
  set_state(task, TaskState::done);
  if (!made_before) remember_work(task);
  expectation_.learn(task);
  note_done_on_host(id, workers_.at(worker).row.host, now);
  delays_.forget(id);
  disk_pause_.end();
  if (made_before) wake_waiting(task.job, now);
  if (!made_before || traits_of(task.kind).ends_job) advance(task, now);
}

void JobState::failed(WorkerId worker, TaskId id, AttemptId attempt, const TaskFailure& failure,
                      Moment now) {
  workers_.hear(worker, now.steady_ms);
  if (!holds(worker, id, attempt)) {
    commands_.emplace_back(SendAccepted{worker, id, attempt, false});
    return;
  }
  commands_.emplace_back(SendAccepted{worker, id, attempt, true});
  store_log(attempt, failure.log, failure.peak_rss_bytes);
  take_failure(edit(id), worker, attempt, failure, now);
}

void JobState::take_failure(TaskRow& task, WorkerId worker, AttemptId attempt,
                            const TaskFailure& failure, Moment now) {
  switch (failure.cause) {
    case FailureCause::for_good:
      end_attempt(attempt, AttemptState::failed, failure.message, now);
      if (task.outputs.empty()) {
        std::copy_if(failure.evidence.begin(), failure.evidence.end(),
                     std::back_inserter(task.outputs), has_file_);
      }
      fail_task(task, failure.exit_code, failure.message, now);
      break;
    case FailureCause::damaged_input:
      lose_attempt(attempt, AttemptState::returned, failure.message, now);
      settle_waiting(task.id, now);
      if (task.state == TaskState::ready) count_loss(task, failure.message, now);
      break;
    case FailureCause::out_of_memory: {
      const std::uint64_t had_bytes = durable_.running_attempts.at(attempt).memory_bytes;
      lose_attempt(attempt, AttemptState::starved, failure.message, now);
      count_out_of_memory(task, had_bytes, failure, now);
      break;
    }
    case FailureCause::disk_full:
      lose_attempt(attempt, AttemptState::returned, failure.message, now);
      out_of_resources(failure.message, now);
      break;
    case FailureCause::killed:
      lose_attempt(attempt, AttemptState::killed, failure.message, now);
      count_loss(task, failure.message, now);
      break;
    case FailureCause::error:
      lose_attempt(attempt, AttemptState::crashed, failure.message, now);
      count_crash(task, worker, failure.message, now);
      break;
  }
}

void JobState::advance(const TaskRow& task, Moment now) {
  const TaskRow* inspect = find_task(task.job, TaskKind::inspect, 0);
  switch (task.kind) {
    case TaskKind::solve:
      add_task(after_solve(task,
                           [this, job = task.job](TaskKind kind, std::uint64_t cycle) {
                             return find_done(job, kind, cycle);
                           }),
               now);
      break;
    case TaskKind::adapt:
      add_task(after_adapt(task, *find_done(task.job, TaskKind::solve, task.path - 1)), now);
      break;
    case TaskKind::remesh:
      add_task(inspect_task(task), now);
      break;
    case TaskKind::inspect:
      progress_.set_chunks(task.job, made_by<InspectMade>(task).layers.size());
      carry_out(after_inspect(task), now);
      break;
    case TaskKind::decompose: {
      const SubdomainRow& self = durable_.subdomains.at({task.job, task.path});
      const bool is_further = progress_.former_leaves_above(task.job, 2 * task.path) > 0;
      GraphStep step = after_decompose(*inspect, task, self, is_further);
      // What could not be cut after all is tried once more with all the room.
      for (TaskRow& next : step.tasks) {
        if (next.path == task.path) next.memory_bytes = task.memory_bytes;
      }
      carry_out(step, now);
      break;
    }
    case TaskKind::assimilate:
      carry_out(after_assimilate(*inspect, task, tree_of(task.job)), now);
      break;
    case TaskKind::mesh:
      put(after_mesh(task, durable_.subdomains.at({task.job, task.path})));
      if (find_task(task.job, TaskKind::order, 0) != nullptr) {
        extract_when_ordered(task.job, task.path, now);
      } else if (progress_.is_settled(task.job)) {
        number_tree(task.job, now);
      }
      break;
    case TaskKind::order:
      for (const auto& [leaf, turn] : turns_of(task.job)) {
        extract_when_ordered(task.job, leaf, now);
      }
      break;
    case TaskKind::extract:
      give_turns_round(task.job, task.path, now);
      break;
    case TaskKind::cosmetic:
      progress_.note_turn_over(task.job);
      give_turns_round(task.job, task.path, now);
      if (progress_.had_all_turns(task.job)) number_tree(task.job, now);
      break;
    case TaskKind::number:
      write_leaves(task, now);
      grow_layers(task, now);
      break;
    case TaskKind::write:
    case TaskKind::grow:
      progress_.note_written(task.job);
      assemble_when_written(task.job, now);
      break;
    case TaskKind::assemble:
    case TaskKind::collect:
      set_phase(edit(task.job), JobPhase::done, now);
      changes_.add({now.wall_ms, task.job, {}, {}, {}, "job done", ""});
      break;
  }
}

void JobState::carry_out(const GraphStep& step, Moment now) {
  for (const SubdomainRow& subdomain : step.subdomains) put(subdomain);
  // Before the meshes: one that an earlier job has done is done at once, and has to find the order.
  if (!step.subdomains.empty()) tree_has_grown(step.subdomains.front().job, now);
  for (const TaskRow& task : step.tasks) add_task(task, now);
}

/// When the last cut is made, the leaves are joined where the job asks for it; when that is over,
/// their order in cosmetics is found.
void JobState::tree_has_grown(JobId job, Moment now) {
  if (progress_.has_open(job)) return;
  const TaskRow* inspect = find_task(job, TaskKind::inspect, 0);
  const TaskRow* assimilate = find_task(job, TaskKind::assimilate, 0);
  if (assimilate == nullptr) {
    if (const auto task = assimilate_task(*inspect, tree_of(job))) {
      add_task(*task, now);
      return;
    }
  } else if (assimilate->outputs.empty()) {
    return;
  }
  order_when_whole(job, now);
}

/// The whole tree is meshed, and had its turns: the nodes can be numbered.
void JobState::number_tree(JobId job, Moment now) {
  const TaskRow* inspect = find_task(job, TaskKind::inspect, 0);
  const TaskRow* order = find_task(job, TaskKind::order, 0);
  const TaskRow* assimilate = find_task(job, TaskKind::assimilate, 0);
  NumberGiven number = given_to_number(*inspect, assimilate, tree_of(job));
  if (order != nullptr) {
    const auto find = [this, job](TaskKind kind, std::uint64_t path) {
      return find_done(job, kind, path);
    };
    add_elements(*order, turns_of(job), find, number);
  }
  add_task(new_task(job, 0, number), now);
}

/// The nodes have their numbers: every leaf is written, in any order.
void JobState::write_leaves(const TaskRow& number, Moment now) {
  const JobId job = number.job;
  const WriteGiven of_all = given_to_write(*find_task(job, TaskKind::inspect, 0), number);
  const bool has_seam_cosmetics = find_task(job, TaskKind::order, 0) != nullptr;
  const auto find = [this, job](TaskKind kind, std::uint64_t path) {
    return find_done(job, kind, path);
  };
  for (const SubdomainRow& node : tree_of(job)) {
    if (node.state != SubdomainState::leaf) continue;
    const TaskRow* mesh = find_done(job, TaskKind::mesh, node.path);
    TF_CHECK(mesh != nullptr);
    WriteGiven write = of_all;
    add_mesh(*mesh, write);
    if (has_seam_cosmetics) add_final_elements(node.path, turns_of(job), find, write);
    add_task(new_task(job, node.path, write), now);
  }
}

/// The same of every chunk of layers.
void JobState::grow_layers(const TaskRow& number, Moment now) {
  const TaskRow& inspect = *find_task(number.job, TaskKind::inspect, 0);
  GrowGiven grow = given_to_grow(inspect, number);
  for (const auto& [heap, chunk] : made_by<InspectMade>(inspect).layers) {
    grow.layers = chunk;
    add_task(new_task(number.job, heap, grow), now);
  }
}

void JobState::assemble_when_written(JobId job, Moment now) {
  if (!progress_.is_written(job)) return;
  const TaskRow* inspect = find_task(job, TaskKind::inspect, 0);
  const TaskRow* number = find_task(job, TaskKind::number, 0);
  const auto find_written = [this, job](std::uint64_t leaf) {
    return find_done(job, TaskKind::write, leaf);
  };
  const auto find_grown = [this, job](std::uint64_t chunk) {
    return find_done(job, TaskKind::grow, chunk);
  };
  add_task(assemble_task(*inspect, *number, tree_of(job), find_written, find_grown), now);
}

/// Whether the job is done and left memory, and its results are there: nothing is to be decided.
bool JobState::has_results(JobId job) const {
  const auto past = finished_->jobs().find(job);
  if (is_at_hand(job) || past == finished_->jobs().end()) return false;
  const std::vector<ArtifactRef>& results = past->second.results;
  return durable_.jobs.at(job).phase == JobPhase::done &&
         std::all_of(results.begin(), results.end(), has_file_);
}

bool JobState::has_all_jobs(const std::string& owner) const {
  if (rules_.jobs_per_user == 0) return false;
  const auto has = std::count_if(durable_.jobs.begin(), durable_.jobs.end(), [&](const auto& job) {
    return job.second.owner == owner && !is_end(job.second.phase);
  });
  return static_cast<std::size_t>(has) >= rules_.jobs_per_user;
}

bool JobState::has_inputs(const Submission& submission) const {
  const std::vector<ArtifactRef> inputs = first_task(submission).inputs;
  // Each is asked for, also after one that is missing.
  return std::count_if(inputs.begin(), inputs.end(), has_file_) ==
         static_cast<std::ptrdiff_t>(inputs.size());
}

SubmitAnswer JobState::submit(const Submission& submission, Moment now) {
  TaskRow first = first_task(submission);
  const std::string content = content_of(first);
  const auto known =
      submission.key.empty() ? keys_.end() : keys_.find({submission.owner, submission.key});
  if (known != keys_.end() && durable_.jobs.at(known->second).content != content) {
    return {known->second, true, true, {}, false};
  }
  if (known == keys_.end()) {
    if (const JobId unmet = unmet_of(submission.after)) return {{}, false, false, unmet, false};
  }
  const JobPhase before =
      known == keys_.end() ? JobPhase::cancelled : durable_.jobs.at(known->second).phase;
  const bool would_go_on = before == JobPhase::failed || before == JobPhase::cancelled;
  if (would_go_on && !submission.replaces_others && has_all_jobs(submission.owner)) {
    return {{}, false, false, {}, true};
  }
  if (submission.replaces_others) cancel_others(submission, now);
  if (known != keys_.end()) {
    if (has_results(known->second)) return {known->second, true, false, {}, false};
    bring_back(known->second);
    JobRow& job = edit(known->second);
    if (job.phase == JobPhase::failed || job.phase == JobPhase::cancelled) resume(job, now);
    if (job.phase == JobPhase::done) remake_results(job, now);
    return {known->second, true, false, {}, false};
  }
  JobRow job;
  job.id = JobId{++durable_.last_job};
  job.key = submission.key;
  job.name = submission.name;
  job.job_toml = submission.job_toml;
  job.created_ms = now.wall_ms;
  job.owner = submission.owner;
  job.content = content;
  job.priority = submission.priority;
  const std::set<JobId> after(submission.after.begin(), submission.after.end());
  job.after.assign(after.begin(), after.end());
  job.phase = phase_to_go_on(job);
  changes_.note(job.id);
  if (!job.key.empty()) keys_[{job.owner, job.key}] = job.id;
  durable_.jobs.emplace(job.id, job);
  changes_.add({now.wall_ms, job.id, {}, {}, {}, "submitted", job.name});
  if (job.phase == JobPhase::waiting) {
    waiting_jobs_.insert(job.id);
    changes_.add({now.wall_ms, job.id, {}, {}, {}, "waits", waiting_words(durable_, job)});
  }
  first.job = job.id;
  add_task(std::move(first), now);
  return {job.id, false, false, {}, false};
}

void JobState::cancel_others(const Submission& submission, Moment now) {
  for (const auto& [id, job] : durable_.jobs) {
    const bool is_same = job.key == submission.key && job.owner == submission.owner;
    if (!is_end(job.phase) && !is_same) cancel(id, now);
  }
}

bool JobState::set_priority(JobId id, int priority, Moment now) {
  TF_CHECK(std::abs(priority) <= most_priority);
  const auto found = durable_.jobs.find(id);
  if (found == durable_.jobs.end()) return false;
  const bool is_news = found->second.priority != priority;
  if (is_end(found->second.phase) || !is_news) return true;
  lists_.move(durable_.tasks, edit(id), priority);
  changes_.add({now.wall_ms, id, {}, {}, {}, "priority", std::to_string(priority)});
  return true;
}

bool JobState::cancel(JobId id, Moment now) {
  const auto found = durable_.jobs.find(id);
  if (found == durable_.jobs.end()) return false;
  if (is_end(found->second.phase)) return true;
  set_phase(edit(id), JobPhase::cancelled, now);
  changes_.add({now.wall_ms, id, {}, {}, {}, "cancelled", ""});
  for (const TaskId task : lists_.tasks_of(id)) {
    if (durable_.tasks.at(task).state != TaskState::leased) continue;
    revoke_attempts(edit(task), "the job was cancelled", now);
  }
  return true;
}

}  // namespace tetfarm
