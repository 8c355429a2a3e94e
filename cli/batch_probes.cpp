#include "cli/batch_probes.h"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <sstream>

#include "base/check.h"
#include "base/counted.h"
#include "cli/command_line.h"
#include "cli/pool_rules.h"
#include "pool/batch_system.h"
#include "pool/run_command.h"

namespace tetfarm {
namespace {

struct KnownSystem {
  const char* name;
  const char* submits;  ///< the program that a pool submits with
};

constexpr std::array<KnownSystem, 4> known_systems = {
    {{"slurm", "sbatch"}, {"condor", "condor_submit"}, {"lsf", "bsub"}, {"ge", "qsub"}}};

/// Where a shell would find the program; "": nowhere.
std::string place_on_path(const std::string& program, const std::string& path) {
  std::istringstream folders(path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string place = (folder.empty() ? "." : folder) + "/" + program;
    std::error_code ignored;
    const bool is_file = std::filesystem::is_regular_file(place, ignored);
    if (is_file && ::access(place.c_str(), X_OK) == 0) return place;
  }
  return {};
}

std::unique_ptr<BatchSystem> system_named(const std::string& name) {
  PoolCommand pool;
  pool.system = name;
  pool.name = "doctor";
  return make_batch_system(name, pool_settings(pool, pool_rules(pool)));
}

std::string first_line_of(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Lists the jobs of a pool that is not there, as a pool does.
Finding look_at_answers(const KnownSystem& known, const std::string& place,
                        std::int64_t timeout_ms) {
  const std::unique_ptr<BatchSystem> system = system_named(known.name);
  for (const ShellCommand& command : system->list()) {
    TF_CHECK(!command.words.empty());
    const CommandOutcome outcome = run_command(command, timeout_ms);
    if (system->listed(outcome)) continue;
    const std::string said = first_line_of(outcome.err.empty() ? outcome.out : outcome.err);
    return {"batch system", Verdict::problem,
            std::string(known.name) + ": " + command.words.front() + " does not answer: " +
                (said.empty() ? "exit code " + std::to_string(outcome.code) : said),
            "check that this machine may submit jobs, and that the batch system runs"};
  }
  return {"batch system", Verdict::ok, std::string(known.name) + " answers; " + place, ""};
}

}  // namespace

Findings look_at_batch_systems(const std::string& path, const std::string& wanted,
                               std::int64_t timeout_ms) {
  Findings findings;
  for (const KnownSystem& known : known_systems) {
    if (!wanted.empty() && wanted != known.name) continue;
    const std::string place = place_on_path(known.submits, path);
    if (!place.empty()) {
      findings.push_back(look_at_answers(known, place, timeout_ms));
    } else if (!wanted.empty()) {
      findings.push_back({"batch system", Verdict::problem,
                          wanted + ": " + known.submits + " is not on the PATH",
                          "run this where jobs are submitted from, or add its folder to PATH"});
    }
  }
  if (findings.empty()) {
    findings.push_back({"batch system", Verdict::ok,
                        "none here: sbatch, condor_submit, bsub and qsub are not on the PATH", ""});
  }
  return findings;
}

}  // namespace tetfarm
