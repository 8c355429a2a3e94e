#include "pool/lsf.h"

#include <algorithm>

#include "base/check.h"
#include "pool/worker_job.h"

namespace tetfarm {
namespace {

std::int64_t minutes(std::int64_t seconds) { return (seconds + 59) / 60; }

/// Units are written out: what a bare number means is each site's choice (LSF_UNIT_FOR_LIMITS).
std::string script_of(const PoolSettings& settings, const WorkerOrder& order) {
  TF_CHECK(order.count > 0);
  const std::string name = job_name_of(settings, order.bytes);
  const std::string memory = std::to_string(whole_mebibytes(order.bytes)) + "MB";
  const std::int64_t time = minutes(settings.walltime_s);
  std::string text = "#!/bin/sh\n# Workers under LSF: bsub < FILE\n";
  const auto add = [&text](const std::string& option) { text += "#BSUB " + option + "\n"; };
  add("-J \"" + name + "[1-" + std::to_string(order.count) + "]\"");
  add("-n 1");
  add("-R \"span[hosts=1] rusage[mem=" + memory + "]\"");
  add("-M " + memory);
  const std::string odd_minutes = std::to_string(time % 60);
  add("-W " + std::to_string(time / 60) + ":" + (time % 60 < 10 ? "0" : "") + odd_minutes);
  add("-wt '" + std::to_string(minutes(settings.grace_s)) + "'");
  add("-wa 'TERM'");
  add("-rn");
  add("-o \"" + settings.logs + "/" + name + "-%J_%I.log\"");
  for (const std::string& option : settings.options) add(option);
  return text + script_end(settings, order.bytes, "${LSB_JOBID}[${LSB_JOBINDEX}]");
}

PoolJobState state_of(const std::string& status) {
  if (status == "PEND" || status == "WAIT" || status == "PROV") return PoolJobState::pending;
  if (status == "RUN" || status == "SSUSP" || status == "USUSP" || status == "UNKWN") {
    return PoolJobState::running;
  }
  return status == "PSUSP" ? PoolJobState::broken : PoolJobState::ending;
}

}  // namespace

std::vector<ShellCommand> Lsf::submit(const WorkerOrder& order,
                                      const std::vector<PoolJob>& /*jobs*/) const {
  return {{{"bsub"}, script_of(settings_, order)}};
}

/// "Job <35> is submitted to default queue <normal>."
std::vector<std::string> Lsf::submitted(const WorkerOrder& order,
                                        const CommandOutcome& outcome) const {
  const std::string before = "Job <";
  const std::size_t at = outcome.out.find(before);
  if (outcome.code != 0 || at == std::string::npos) return {};
  const std::string rest = outcome.out.substr(at + before.size());
  const std::string id = rest.substr(0, rest.find('>'));
  return is_number(id) ? array_ids(id + "[", order.count, "]") : std::vector<std::string>{};
}

std::vector<ShellCommand> Lsf::list() const {
  return {{{"bjobs", "-u", settings_.user, "-noheader", "-o",
            "jobid jobindex stat job_name delimiter='|'"},
           ""}};
}

/// Where nothing is listed bjobs says so as an error, with 255 where the site has it so
/// (LSB_BJOBS_CONSISTENT_EXIT_CODE).
std::optional<std::vector<PoolJob>> Lsf::listed(const CommandOutcome& outcome) const {
  const bool has_none = outcome.err.find("No unfinished job found") != std::string::npos;
  if (outcome.code != 0 && !has_none) return std::nullopt;
  std::vector<PoolJob> jobs;
  for (const std::string& line : lines_of(outcome.out)) {
    const std::vector<std::string> parts = split(line, '|');
    if (parts.size() != 4) continue;
    const std::optional<std::uint64_t> bytes = bytes_of_job_name(settings_, parts[3]);
    if (bytes) jobs.push_back({parts[0] + "[" + parts[1] + "]", state_of(parts[2]), *bytes});
  }
  return jobs;
}

std::vector<ShellCommand> Lsf::cancel(const std::vector<std::string>& jobs) const {
  std::vector<std::string> words = {"bkill"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  return {{words, ""}};
}

}  // namespace tetfarm
