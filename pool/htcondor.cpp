#include "pool/htcondor.h"

#include "base/check.h"
#include "pool/worker_job.h"

namespace tetfarm {
namespace {

/// An argument in HTCondor's new syntax: in single quotes, both kinds of quotes doubled.
std::string argument(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) {
    text += letter;
    if (letter == '\'' || letter == '"') text += letter;
  }
  return text + "'";
}

std::string description_of(const PoolSettings& settings, const WorkerOrder& order) {
  TF_CHECK(order.count > 0);
  const std::string name = job_name_of(settings, order.bytes);
  std::string arguments;
  const std::vector<std::string> words = worker_words(settings, order.bytes);
  for (std::size_t i = 1; i < words.size(); ++i) arguments += argument(words[i]) + " ";
  arguments += "'--tag' '" + settings.name + "/$(Cluster).$(Process)'";
  std::string text = "# Workers under HTCondor: condor_submit FILE\n";
  const auto add = [&text](const std::string& key, const std::string& value) {
    text += key + " = " + value + "\n";
  };
  add("universe", "vanilla");
  add("executable", settings.program);
  add("arguments", "\"" + arguments + "\"");
  add("batch_name", name);
  add("MY.TetfarmPool", "\"" + settings.name + "\"");
  add("transfer_executable", "false");
  add("should_transfer_files", "NO");
  add("request_cpus", "1");
  add("request_memory", std::to_string(whole_mebibytes(order.bytes)) + "MB");
  add("kill_sig", "SIGTERM");
  add("want_graceful_removal", "true");
  add("job_max_vacate_time", std::to_string(settings.grace_s + 30));
  add("log", settings.logs + "/tetfarm-" + settings.name + ".condor.log");
  add("output", settings.logs + "/" + name + "-$(Cluster).$(Process).out");
  add("error", settings.logs + "/" + name + "-$(Cluster).$(Process).log");
  for (const std::string& option : settings.options) text += option + "\n";
  return text + "queue " + std::to_string(order.count) + "\n";
}

/// JobStatus: 1 idle, 2 running, 3 removed, 4 completed, 5 held, 6 transfers output, 7 suspended.
PoolJobState state_of(const std::string& status) {
  if (status == "1") return PoolJobState::pending;
  if (status == "2" || status == "6" || status == "7") return PoolJobState::running;
  return status == "5" ? PoolJobState::broken : PoolJobState::ending;
}

}  // namespace

std::vector<ShellCommand> HTCondor::submit(const WorkerOrder& order,
                                           const std::vector<PoolJob>& /*jobs*/) const {
  return {{{"condor_submit", "-terse", "-"}, description_of(settings_, order)}};
}

/// "12.0 - 12.3".
std::vector<std::string> HTCondor::submitted(const WorkerOrder& order,
                                             const CommandOutcome& outcome) const {
  const std::vector<std::string> lines = lines_of(outcome.out);
  if (outcome.code != 0 || lines.empty()) return {};
  const std::string cluster = lines.back().substr(0, lines.back().find('.'));
  if (!is_number(cluster)) return {};
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < order.count; ++i) ids.push_back(cluster + "." + std::to_string(i));
  return ids;
}

std::vector<ShellCommand> HTCondor::list() const {
  return {{{"condor_q", "-constraint", "TetfarmPool == \"" + settings_.name + "\"", "-autoformat",
            "ClusterId", "ProcId", "JobStatus", "JobBatchName"},
           ""}};
}

std::optional<std::vector<PoolJob>> HTCondor::listed(const CommandOutcome& outcome) const {
  if (outcome.code != 0) return std::nullopt;
  std::vector<PoolJob> jobs;
  for (const std::string& line : lines_of(outcome.out)) {
    const std::vector<std::string> parts = split(line, ' ');
    if (parts.size() != 4) continue;
    const std::optional<std::uint64_t> bytes = bytes_of_job_name(settings_, parts[3]);
    if (bytes) jobs.push_back({parts[0] + "." + parts[1], state_of(parts[2]), *bytes});
  }
  return jobs;
}

std::vector<ShellCommand> HTCondor::cancel(const std::vector<std::string>& jobs) const {
  std::vector<std::string> words = {"condor_rm"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  return {{words, ""}};
}

}  // namespace tetfarm
