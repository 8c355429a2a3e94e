#include "cli/pool_command_line.h"

#include "cli/option_checks.h"

namespace tetfarm {
namespace {

/// "8:00:00", "90:00" or "28800" as seconds.
std::string seconds_of(const std::string& text) {
  std::int64_t seconds = 0;
  std::int64_t part = 0;
  for (const char letter : text + ":") {
    if (letter == ':') {
      seconds = seconds * 60 + part;
      part = 0;
    } else if (letter >= '0' && letter <= '9' && part < 1'000'000'000) {
      part = part * 10 + (letter - '0');
    } else {
      throw CLI::ValidationError("must be a time such as 8:00:00, not " + text);
    }
  }
  return std::to_string(seconds);
}

void add_workers(CLI::App& sub, PoolCommand& pool) {
  sub.add_option("--store", pool.store,
                 "The coordinator's store, as the workers see it (default: they transfer files "
                 "over their connections)")
      ->envname("TETFARM_STORE")
      ->option_text("DIR");
  sub.add_option("--cache", pool.cache,
                 "Folder on the workers' machines for files received over the connection (default: "
                 "in $TMPDIR)")
      ->option_text("DIR");
  sub.add_option("--worker-key", pool.worker_key, "The workers' secret key")
      ->option_text("NAME.key");
  sub.add_option("--program", pool.program,
                 "Path of `tetfarm` on the workers' machines (default: this program's)")
      ->option_text("PATH");
  sub.add_option("--logs", pool.logs, "Folder for the workers' logs (default: the current one)")
      ->option_text("DIR");
  sub.add_option("--memory", pool.memory_bytes, "Memory of a worker's job (default 4GB)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--max-memory", pool.max_memory_bytes,
                 "Largest memory of a worker's job, for tasks that need more (default: --memory)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--walltime", pool.walltime_s, "Time limit of a worker's job (default 8:00:00)")
      ->transform(CLI::Validator(
          [](std::string& text) {
            text = seconds_of(text);
            return std::string();
          },
          "", ""))
      ->check(counting_number())
      ->option_text("H:MM:SS");
  sub.add_option("--grace", pool.grace_s,
                 "Time to finish a task before a worker is ended (default 60)")
      ->check(whole_number(0, 86'400))
      ->option_text("SECONDS");
  sub.add_option("--option", pool.options,
                 "Extra line for the script (\"--partition=mesh\", \"-q long\") or the submit "
                 "description; may be repeated")
      ->option_text("TEXT");
  sub.add_flag(
      "--solvers", pool.solvers,
      "The workers also run the solvers of adaptation loops: commands that job files name");
  sub.add_option("--hosts", pool.hosts, "For ssh: hosts to start workers on, and how many on each")
      ->delimiter(',')
      ->option_text("NAME:N,...");
}

void add_limits(CLI::App& sub, PoolCommand& pool) {
  sub.add_option("--min", pool.min, "Workers to keep even without work (default 0)")
      ->check(whole_number(0, 100'000))
      ->option_text("N");
  sub.add_option("--max", pool.max, "Maximum number of jobs at the batch system")
      ->required()
      ->check(whole_number(1, 100'000))
      ->option_text("N");
  sub.add_option("--idle", pool.idle_s,
                 "Release a worker that has had no work for this long (default 120)")
      ->check(not_negative_number())
      ->option_text("SECONDS");
  sub.add_option("--interval", pool.interval_s,
                 "Time between looks at the farm and the batch system (default 5)")
      ->check(number_between(0.1, 3600.0))
      ->option_text("SECONDS");
  sub.add_option("--rate", pool.rate, "Maximum number of jobs to submit per minute (default 60)")
      ->check(whole_number(1, 100'000))
      ->option_text("N");
}

}  // namespace

void add_pool(CLI::App& app, PoolCommand& pool, const std::function<void()>& chosen) {
  CLI::App& sub =
      *app.add_subcommand("pool", "Keep as many workers at a batch system as there is work for");
  sub.footer(
      "Example: tetfarm pool slurm --coordinator tcp://head:5555 --store /shared/farm --max 200");
  sub.callback(chosen);
  sub.add_option("SYSTEM", pool.system, "Where to start workers")
      ->required()
      ->check(CLI::IsMember({"slurm", "condor", "lsf", "ge", "ssh", "local"}));
  sub.add_option("--coordinator,--connect", pool.endpoint, "Address of the coordinator")
      ->envname("TETFARM_COORDINATOR")
      ->required()
      ->option_text("tcp://HOST:PORT");
  sub.add_option("--key", pool.keys.own, "The pool's own secret key, with the role submitter")
      ->envname("TETFARM_KEY")
      ->option_text("NAME.key");
  sub.add_option("--coordinator-key", pool.keys.coordinator,
                 "The coordinator's public key (default: coordinator.pub in the store)")
      ->envname("TETFARM_COORDINATOR_KEY")
      ->option_text("FILE.pub");
  sub.add_option("--name", pool.name,
                 "Name of the pool, by which it finds its jobs again (default: from the "
                 "coordinator's address)")
      ->option_text("NAME");
  add_workers(sub, pool);
  add_limits(sub, pool);
  CLI::Option* dry =
      sub.add_flag("--dry-run", pool.dry_run, "Only print the script and the commands");
  sub.add_flag("--stop", pool.stop, "Release all workers of the pool, and exit when they are gone")
      ->excludes(dry);
  sub.add_flag("--json", pool.json, "Print JSON on standard output, one object per line");
}

}  // namespace tetfarm
