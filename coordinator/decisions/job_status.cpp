#include "coordinator/decisions/job_status.h"

#include <algorithm>
#include <limits>

#include "coordinator/decisions/task_rows.h"
#include "tasks/decompose_contract.h"
#include "tasks/inspect_contract.h"
#include "tasks/ratio_histogram.h"
#include "tasks/solve_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_named = 100;
constexpr double most_reasons = 1000;

/// The largest over the mean: how evenly the work was spread (thesis figs. 70 and 71).
struct Evenness {
  double largest = 0;
  double sum = 0;
  double count = 0;

  void add(double amount) {
    largest = std::max(largest, amount);
    sum += amount;
    ++count;
  }
  double ratio() const { return sum > 0 ? largest * count / sum : 1; }
};

void count_subdomains(const DurableState& durable, JobSummary& summary) {
  Evenness estimated;
  Evenness actual;
  for (auto node = durable.subdomains.lower_bound({summary.job, 0});
       node != durable.subdomains.end() && node->first.first == summary.job; ++node) {
    if (node->second.state != SubdomainState::leaf) continue;
    ++summary.leaves_made;
    estimated.add(node->second.work);
    actual.add(static_cast<double>(node->second.tets));
    if (node->second.meshed) ++summary.leaves_meshed;
    summary.elements += node->second.tets;
  }
  if (summary.leaves_made == 0) return;
  summary.numbers["balance_estimated"] = estimated.ratio();
  if (summary.leaves_meshed == summary.leaves_made) {
    summary.numbers["balance_elements"] = actual.ratio();
  }
}

/// What is told of the assimilation: leaves, groups, faces and communication (fig. 69).
void add_assimilation(const TaskRow& assimilate, JobSummary& summary) {
  for (const auto& [name, number] : assimilate.numbers) {
    summary.numbers["assimilated_" + name] = number;
  }
}

/// What the job will come to, as the inspection tells.
void add_estimate(const TaskRow& inspect, JobSummary& summary) {
  const auto made = made_by<InspectMade>(inspect);
  const auto estimated = inspect.numbers.find("estimated_elements");
  summary.estimated_elements =
      estimated == inspect.numbers.end() ? made.total_work : estimated->second;
  if (made.parts > 0) summary.numbers["parts"] = static_cast<double>(made.parts);
  for (const char* name : {"forecast_bytes", "forecast_disk_bytes", "forecast_seconds"}) {
    const auto found = inspect.numbers.find(name);
    if (found != inspect.numbers.end()) summary.numbers[name] = found->second;
  }
  for (const char* start : {"layers_", "pml_"}) {
    for (auto number = inspect.numbers.lower_bound(start);
         number != inspect.numbers.end() && number->first.starts_with(start); ++number) {
      summary.numbers.insert(*number);
    }
  }
}

/// What the tasks of a kind took and were expected to take: the largest memory, all the time.
void add_cost(const TaskRow& task, JobSummary& summary) {
  if (task.state != TaskState::done) return;
  const std::string kind = std::string("task_") + name_of(task.kind);
  const auto most = [&](const std::string& name, double value) {
    double& known = summary.numbers[kind + name];
    known = std::max(known, value);
  };
  const auto told = [&task](const char* name) {
    const auto found = task.numbers.find(name);
    return found == task.numbers.end() ? 0 : found->second;
  };
  ++summary.numbers[kind + "_count"];
  summary.numbers[kind + "_seconds"] += task.seconds;
  summary.numbers[kind + "_cpu_seconds"] += told("cpu_seconds");
  summary.numbers[kind + "_expected_seconds"] += told("expected_seconds");
  most("_bytes", static_cast<double>(task.peak_rss_bytes));
  most("_expected_bytes", told("expected_bytes"));
  const double bound = told("expected_bytes");
  if (bound > 0) most("_of_expected_bytes", static_cast<double>(task.peak_rss_bytes) / bound);
}

/// Of an adaptation loop, from its first task on.
void add_cycles(const TaskRow& solve, JobSummary& summary) {
  static const std::string name = field_name(&SolveGiven::cycles);
  summary.numbers[name] = static_cast<double>(given_to<SolveGiven>(solve).cycles);
}

/// The least Jacobian of the prisms of all chunks.
void add_grown(const TaskRow& grow, JobSummary& summary) {
  const auto jacobian = grow.numbers.find("min_scaled_jacobian");
  if (jacobian == grow.numbers.end()) return;
  const auto [least, is_first] =
      summary.numbers.emplace("layers_min_scaled_jacobian", jacobian->second);
  least->second = std::min(least->second, jacobian->second);
}

/// What the tasks of a job told of the shape of its layers, added up.
struct LayerShapes {
  RatioHistogram jacobians;
  RatioHistogram jumps;

  void add(const TaskRow& task) {
    add(task, "scaled_jacobians", jacobians);
    add(task, "top_jumps", jumps);
  }

 private:
  static void add(const TaskRow& task, const char* name, RatioHistogram& sum) {
    const auto text = task.texts.find(name);
    if (text == task.texts.end()) return;
    const std::optional<RatioHistogram> told = RatioHistogram::from(text->second);
    if (told) sum.add(*told);
  }
};

void add_layer_shapes(const LayerShapes& shapes, JobSummary& summary) {
  const auto tell = [&summary](const char* name, std::optional<double> value, double most) {
    if (value) summary.numbers[name] = std::min(*value, most);
  };
  // No prism is better shaped than a straight one.
  tell("layers_scaled_jacobian_1_percent", shapes.jacobians.quantile(0.01), 1);
  tell("layers_scaled_jacobian_median", shapes.jacobians.quantile(0.5), 1);
  constexpr double any = std::numeric_limits<double>::max();
  tell("layers_top_jump_median", shapes.jumps.quantile(0.5), any);
  tell("layers_top_jump_99", shapes.jumps.quantile(0.99), any);
}

/// Of the tets where the surface forces no small angles: their number, their smallest angle of all
/// leaves, and where it is.
void add_unforced(const TaskRow& write, JobSummary& summary) {
  const auto count = write.numbers.find("unforced_elements");
  if (count == write.numbers.end()) return;
  summary.numbers["unforced_elements"] += count->second;
  constexpr const char* angle = "unforced_min_dihedral_deg";
  const auto here = write.numbers.find(angle);
  if (here == write.numbers.end()) return;
  const auto known = summary.numbers.find(angle);
  if (known != summary.numbers.end() && known->second <= here->second) return;
  for (const char* name : {angle, "unforced_worst_x", "unforced_worst_y", "unforced_worst_z"}) {
    const auto found = write.numbers.find(name);
    if (found != write.numbers.end()) summary.numbers[name] = found->second;
  }
}

void count_task(const TaskRow& task, JobSummary& summary) {
  add_cost(task, summary);
  switch (task.state) {
    case TaskState::done:
      ++summary.tasks_done;
      break;
    case TaskState::leased:
      ++summary.tasks_running;
      break;
    case TaskState::ready:
    case TaskState::waiting:
      ++summary.tasks_ready;
      break;
    case TaskState::failed:
      if (summary.quarantine.size() < most_named) summary.quarantine.push_back(task);
      break;
    case TaskState::replaced:
      break;
  }
  summary.attempts_lost += task.losses;
  summary.crashes += task.crashes;
  summary.oom_count += task.oom_count;
  summary.peak_rss_bytes_worker = std::max(summary.peak_rss_bytes_worker, task.peak_rss_bytes);
}

/// Of a sub-domain that was to be cut and could not be, as text "uncut:PATH".
void add_reason_to_stay_whole(const TaskRow& task, JobSummary& summary) {
  if (task.kind != TaskKind::decompose || task.state != TaskState::done) return;
  static const std::string name = field_name(&DecomposeMade::reason);
  const auto reason = task.texts.find(name);
  if (reason == task.texts.end() || !task.outputs.empty()) return;
  if (++summary.numbers["uncut"] > most_reasons) return;
  summary.texts["uncut:" + std::to_string(task.path)] = reason->second;
}

/// Of a leaf that was cut further than the job asked for, as text "cut_further:PATH".
void add_further_cut(const DurableState& durable, const TaskRow& task, JobSummary& summary) {
  if (task.kind != TaskKind::mesh || task.state != TaskState::replaced) return;
  const SubdomainRow& node = durable.subdomains.at({task.job, task.path});
  if (node.state != SubdomainState::cut) return;
  if (++summary.numbers["cut_further"] > most_reasons) return;
  summary.texts["cut_further:" + std::to_string(task.path)] = task.message;
}

/// The kind with which a job ends that has tasks of this one.
TaskKind end_after(TaskKind kind) {
  const auto begin = all_task_kinds.begin() + static_cast<std::ptrdiff_t>(kind);
  return *std::find_if(begin, all_task_kinds.end(),
                       [](TaskKind later) { return traits_of(later).ends_job; });
}

}  // namespace

std::vector<JobId> waits_for(const DurableState& durable, const JobRow& job) {
  std::vector<JobId> waiting;
  for (const JobId id : job.after) {
    const auto found = durable.jobs.find(id);
    if (found != durable.jobs.end() && found->second.phase != JobPhase::done) waiting.push_back(id);
  }
  return waiting;
}

std::string job_words(const JobRow& job) { return job_name(job.id) + " (" + job.name + ")"; }

std::string waiting_words(const DurableState& durable, const JobRow& job) {
  constexpr std::size_t most_told = 5;
  const std::vector<JobId> waiting = waits_for(durable, job);
  std::string words = "waits for ";
  for (std::size_t i = 0; i < std::min(most_told, waiting.size()); ++i) {
    const JobRow& other = durable.jobs.at(waiting[i]);
    words += (i > 0 ? "; " : "") + job_words(other) + ", which is " + name_of(other.phase);
  }
  if (waiting.size() <= most_told) return words;
  return words + "; and " + std::to_string(waiting.size() - most_told) + " more";
}

TasksOfJobs tasks_of_jobs(const DurableState& durable) {
  TasksOfJobs tasks;
  for (const auto& [id, task] : durable.tasks) tasks[task.job].push_back(&task);
  return tasks;
}

JobSummary summary_of(const DurableState& durable, const JobRow& job,
                      const std::string& stuck_message, std::int64_t now_wall_ms) {
  std::vector<const TaskRow*> tasks;
  for (const auto& [id, task] : durable.tasks) {
    if (task.job == job.id) tasks.push_back(&task);
  }
  return summary_of(durable, job, tasks, stuck_message, now_wall_ms);
}

JobSummary summary_of(const DurableState& durable, const JobRow& job,
                      const std::vector<const TaskRow*>& tasks, const std::string& stuck_message,
                      std::int64_t now_wall_ms) {
  JobSummary summary;
  summary.job = job.id;
  summary.name = job.name;
  summary.state = name_of(job.phase);
  summary.message = job.message;
  summary.created_ms = job.created_ms;
  summary.priority = job.priority;
  summary.after = job.after;
  summary.finished_ms = job.finished_ms;
  summary.exit_code = job.exit_code;
  if (job.phase == JobPhase::running && !stuck_message.empty()) {
    summary.state = "stuck";
    summary.message = stuck_message;
  }
  if (job.phase == JobPhase::waiting) {
    summary.waits_for = waits_for(durable, job);
    summary.message = waiting_words(durable, job);
  }
  const std::int64_t end_ms = job.finished_ms != 0 ? job.finished_ms : now_wall_ms;
  summary.seconds = static_cast<double>(end_ms - job.created_ms) / 1000;
  count_subdomains(durable, summary);
  std::optional<TaskKind> left;
  TaskKind stage = all_task_kinds.back();
  LayerShapes shapes;
  for (const TaskRow* row : tasks) {
    const TaskRow& task = *row;
    count_task(task, summary);
    add_further_cut(durable, task, summary);
    if (task.state == TaskState::replaced) continue;
    if (task.state != TaskState::done) left = std::min(left.value_or(task.kind), task.kind);
    stage = end_after(task.kind);
    if (task.kind == TaskKind::cosmetic && task.state == TaskState::done) ++summary.leaves_mended;
    if (task.kind == TaskKind::solve) add_cycles(task, summary);
    if (task.kind == TaskKind::inspect) add_estimate(task, summary);
    if (task.kind == TaskKind::assimilate && task.state == TaskState::done) {
      add_assimilation(task, summary);
    }
    if (task.state == TaskState::done) shapes.add(task);
    if (task.kind == TaskKind::grow && task.state == TaskState::done) add_grown(task, summary);
    if (task.kind == TaskKind::write && task.state == TaskState::done) {
      add_unforced(task, summary);
    }
    if (traits_of(task.kind).ends_job && task.state == TaskState::done) {
      summary.numbers.insert(task.numbers.begin(), task.numbers.end());
      summary.texts.insert(task.texts.begin(), task.texts.end());
    }
    add_reason_to_stay_whole(task, summary);
    const bool has_files = job.phase == JobPhase::done ? traits_of(task.kind).ends_job
                                                       : task.state == TaskState::failed;
    if (has_files) {
      summary.files.insert(summary.files.end(), task.outputs.begin(), task.outputs.end());
    }
  }
  add_layer_shapes(shapes, summary);
  summary.stage = name_of(left.value_or(stage));
  // Cosmetics change a little what the leaves had: the mesh counts once it is there.
  const auto elements = summary.numbers.find("elements");
  if (job.phase == JobPhase::done && elements != summary.numbers.end()) {
    summary.elements = static_cast<std::uint64_t>(elements->second);
  }
  return summary;
}

std::optional<TaskFile> inspected_surface(const TaskRow& task) {
  if (task.kind != TaskKind::inspect || task.state != TaskState::done) return std::nullopt;
  const TaskFile surface = made_by<InspectMade>(task).surface;
  return surface.hash.empty() ? std::nullopt : std::optional(surface);
}

}  // namespace tetfarm
