#include "pool/slurm.h"

#include "base/check.h"
#include "pool/worker_job.h"

namespace tetfarm {
namespace {

constexpr std::int64_t slack_s = 30;

/// Slurm looks once in half a minute: the warning has to be that much earlier.
std::string script_of(const PoolSettings& settings, const WorkerOrder& order) {
  TF_CHECK(order.count > 0);
  std::string text = "#!/bin/sh\n# Workers under Slurm: sbatch FILE\n";
  const auto add = [&text](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  add("--job-name=" + job_name_of(settings, order.bytes));
  add("--array=1-" + std::to_string(order.count));
  add("--nodes=1");
  add("--ntasks=1");
  add("--cpus-per-task=1");
  add("--mem=" + std::to_string(whole_mebibytes(order.bytes)) + "M");
  add("--time=" + hours_minutes_seconds(settings.walltime_s));
  add("--signal=B:TERM@" + std::to_string(settings.grace_s + slack_s));
  add("--no-requeue");
  add("--open-mode=append");
  add("--output=" + settings.logs + "/" + job_name_of(settings, order.bytes) + "-%A_%a.log");
  for (const std::string& option : settings.options) add(option);
  return text + script_end(settings, order.bytes, "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}");
}

PoolJobState state_of(const std::string& state) {
  if (state == "RUNNING" || state == "SUSPENDED" || state == "CONFIGURING" || state == "STOPPED" ||
      state == "SIGNALING" || state == "RESIZING") {
    return PoolJobState::running;
  }
  if (state == "PENDING" || state == "REQUEUED" || state == "REQUEUE_FED") {
    return PoolJobState::pending;
  }
  if (state == "REQUEUE_HOLD" || state == "SPECIAL_EXIT") return PoolJobState::broken;
  return PoolJobState::ending;
}

/// What a waiting job will never get over by itself.
bool is_hopeless(const std::string& reason) {
  return reason == "JobHeldAdmin" || reason == "JobHeldUser" || reason == "BadConstraints" ||
         reason == "launch_failed_requeued_held" || reason == "InvalidAccount" ||
         reason == "InvalidQOS" || reason == "PartitionTimeLimit";
}

}  // namespace

std::vector<ShellCommand> Slurm::submit(const WorkerOrder& order,
                                        const std::vector<PoolJob>& /*jobs*/) const {
  return {{{"sbatch", "--parsable"}, script_of(settings_, order)}};
}

/// "12", or "12;cluster".
std::vector<std::string> Slurm::submitted(const WorkerOrder& order,
                                          const CommandOutcome& outcome) const {
  const std::vector<std::string> lines = lines_of(outcome.out);
  if (outcome.code != 0 || lines.empty()) return {};
  const std::string id = lines.back().substr(0, lines.back().find(';'));
  return is_number(id) ? array_ids(id + "_", order.count, "") : std::vector<std::string>{};
}

std::vector<ShellCommand> Slurm::list() const {
  return {{{"squeue", "--noheader", "--array", "--user=" + settings_.user, "--format=%i|%T|%r|%j"},
           ""}};
}

std::optional<std::vector<PoolJob>> Slurm::listed(const CommandOutcome& outcome) const {
  if (outcome.code != 0) return std::nullopt;
  std::vector<PoolJob> jobs;
  for (const std::string& line : lines_of(outcome.out)) {
    const std::vector<std::string> parts = split(line, '|');
    if (parts.size() != 4) continue;
    const std::optional<std::uint64_t> bytes = bytes_of_job_name(settings_, parts[3]);
    if (!bytes) continue;
    PoolJobState state = state_of(parts[1]);
    if (state == PoolJobState::pending && is_hopeless(parts[2])) state = PoolJobState::broken;
    jobs.push_back({parts[0], state, *bytes});
  }
  return jobs;
}

std::vector<ShellCommand> Slurm::cancel(const std::vector<std::string>& jobs) const {
  std::vector<std::string> words = {"scancel"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  return {{words, ""}};
}

}  // namespace tetfarm
