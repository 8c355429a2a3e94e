#include "pool/grid_engine.h"

#include "base/check.h"
#include "pool/worker_job.h"

namespace tetfarm {
namespace {

/// -notify: SIGUSR2 comes before the end, by as much as the queue says (`notify`, 60 s).
std::string script_of(const PoolSettings& settings, const WorkerOrder& order) {
  TF_CHECK(order.count > 0);
  std::string text = "#!/bin/sh\n# Workers under Grid Engine: qsub FILE\n";
  const auto add = [&text](const std::string& option) { text += "#$ " + option + "\n"; };
  add("-N " + job_name_of(settings, order.bytes));
  add("-t 1-" + std::to_string(order.count));
  add("-S /bin/sh");
  add("-cwd");
  add("-l h_rt=" + hours_minutes_seconds(settings.walltime_s));
  add("-l h_vmem=" + std::to_string(whole_mebibytes(order.bytes)) + "M");
  add("-notify");
  add("-r n");
  add("-j y");
  add("-o " + settings.logs + "/$JOB_NAME-$JOB_ID.$TASK_ID.log");
  for (const std::string& option : settings.options) add(option);
  return text + script_end(settings, order.bytes, "${JOB_ID}.${SGE_TASK_ID}");
}

/// Letters of a state: E error, d deleted, h held, q waits, r or t runs, s S T N suspended, R
/// again.
PoolJobState state_of(const std::string& letters) {
  const auto has = [&letters](const char* any) {
    return letters.find_first_of(any) != std::string::npos;
  };
  if (has("d")) return PoolJobState::ending;
  if (has("Eh")) return PoolJobState::broken;
  return has("q") ? PoolJobState::pending : PoolJobState::running;
}

/// What stands between <NAME> and </NAME> in an entry; "" when it is not there.
std::string element(const std::string& entry, const std::string& name) {
  const std::size_t from = entry.find("<" + name + ">");
  const std::size_t to = entry.find("</" + name + ">");
  if (from == std::string::npos || to == std::string::npos) return "";
  const std::size_t begin = from + name.size() + 2;
  return begin <= to ? entry.substr(begin, to - begin) : "";
}

}  // namespace

std::vector<ShellCommand> GridEngine::submit(const WorkerOrder& order,
                                             const std::vector<PoolJob>& /*jobs*/) const {
  return {{{"qsub", "-terse"}, script_of(settings_, order)}};
}

/// "12.1-5:1".
std::vector<std::string> GridEngine::submitted(const WorkerOrder& order,
                                               const CommandOutcome& outcome) const {
  const std::vector<std::string> lines = lines_of(outcome.out);
  if (outcome.code != 0 || lines.empty()) return {};
  const std::string id = lines.back().substr(0, lines.back().find('.'));
  return is_number(id) ? array_ids(id + ".", order.count, "") : std::vector<std::string>{};
}

/// As XML, since the table cuts names after ten letters; -g d: a line for each task of an array.
std::vector<ShellCommand> GridEngine::list() const {
  return {{{"qstat", "-u", settings_.user, "-g", "d", "-xml"}, ""}};
}

std::optional<std::vector<PoolJob>> GridEngine::listed(const CommandOutcome& outcome) const {
  if (outcome.code != 0 || outcome.out.find("job_info") == std::string::npos) return std::nullopt;
  std::vector<PoolJob> jobs;
  std::string rest = outcome.out;
  const std::string opening = "<job_list";
  for (std::size_t at = rest.find(opening); at != std::string::npos; at = rest.find(opening)) {
    rest = rest.substr(at + opening.size());
    const std::string entry = rest.substr(0, rest.find("</job_list>"));
    const std::optional<std::uint64_t> bytes =
        bytes_of_job_name(settings_, element(entry, "JB_name"));
    if (!bytes) continue;
    jobs.push_back({element(entry, "JB_job_number") + "." + element(entry, "tasks"),
                    state_of(element(entry, "state")), *bytes});
  }
  return jobs;
}

/// One command for each run of tasks of an array: -t takes a range of one job only.
std::vector<ShellCommand> GridEngine::cancel(const std::vector<std::string>& jobs) const {
  std::vector<ShellCommand> commands;
  for (const std::string& job : jobs) {
    const std::vector<std::string> parts = split(job, '.');
    if (parts.size() != 2 || !is_number(parts[1])) continue;
    if (!commands.empty() && commands.back().words[1] == parts[0]) {
      std::string& range = commands.back().words[3];
      const std::size_t dash = range.find('-');
      const std::string last = dash == std::string::npos ? range : range.substr(dash + 1);
      if (std::stoull(last) + 1 == std::stoull(parts[1])) {
        range = range.substr(0, dash) + "-" + parts[1];
        continue;
      }
    }
    commands.push_back({{"qdel", parts[0], "-t", parts[1]}, ""});
  }
  return commands;
}

}  // namespace tetfarm
