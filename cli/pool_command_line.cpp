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
      throw CLI::ValidationError("not a time: " + text);
    }
  }
  return std::to_string(seconds);
}

void add_workers(CLI::App& sub, PoolCommand& pool) {
  sub.add_option("--store", pool.store,
                 "The coordinator's store, as the workers see it (default: files come over their "
                 "connections)")
      ->envname("TETFARM_STORE")
      ->option_text("DIR");
  sub.add_option("--cache", pool.cache,
                 "For files that come over the connection, on the workers' machines (default: in "
                 "their $TMPDIR)")
      ->option_text("DIR");
  sub.add_option("--worker-key", pool.worker_key, "The secret key that the workers come with")
      ->option_text("NAME.key");
  sub.add_option("--program", pool.program, "`tetfarm`, as the workers see it (this one)")
      ->option_text("PATH");
  sub.add_option("--logs", pool.logs, "Folder of what workers say (the current one)")
      ->option_text("DIR");
  sub.add_option("--memory", pool.memory_bytes, "Memory of a worker's job (4GB)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--max-memory", pool.max_memory_bytes,
                 "Larger ones, up to this, where tasks want it (--memory)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--walltime", pool.walltime_s, "Of a worker's job (8:00:00)")
      ->transform(CLI::Validator(
          [](std::string& text) {
            text = seconds_of(text);
            return std::string();
          },
          "", ""))
      ->check(counting_number())
      ->option_text("H:MM:SS");
  sub.add_option("--grace", pool.grace_s, "To finish a task in, before a worker is ended (60)")
      ->check(whole_number(0, 86'400))
      ->option_text("SECONDS");
  sub.add_option("--option", pool.options,
                 "A line for the script (\"--partition=mesh\", \"-q long\") or the submit "
                 "description; may be repeated")
      ->option_text("TEXT");
  sub.add_option("--hosts", pool.hosts, "Of ssh: where to start workers, and how many")
      ->delimiter(',')
      ->option_text("NAME:N,...");
}

void add_limits(CLI::App& sub, PoolCommand& pool) {
  sub.add_option("--min", pool.min, "Workers to keep without work (0)")
      ->check(whole_number(0, 100'000))
      ->option_text("N");
  sub.add_option("--max", pool.max, "Jobs at the batch system at most")
      ->required()
      ->check(whole_number(1, 100'000))
      ->option_text("N");
  sub.add_option("--idle", pool.idle_s, "Without work so long, a worker is let go (120)")
      ->check(not_negative_number())
      ->option_text("SECONDS");
  sub.add_option("--interval", pool.interval_s, "Between looks (5)")
      ->check(number_between(0.1, 3600.0))
      ->option_text("SECONDS");
  sub.add_option("--rate", pool.rate, "Jobs to submit in a minute, at most (60)")
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
  sub.add_option("SYSTEM", pool.system, "Where workers come from")
      ->required()
      ->check(CLI::IsMember({"slurm", "condor", "lsf", "ge", "ssh", "local"}));
  sub.add_option("--coordinator,--connect", pool.endpoint, "The coordinator")
      ->envname("TETFARM_COORDINATOR")
      ->required()
      ->option_text("tcp://HOST:PORT");
  sub.add_option("--key", pool.keys.own, "The pool's own secret key, of a submitter")
      ->envname("TETFARM_KEY")
      ->option_text("NAME.key");
  sub.add_option("--coordinator-key", pool.keys.coordinator,
                 "The coordinator's public key (default: coordinator.pub of the store)")
      ->envname("TETFARM_COORDINATOR_KEY")
      ->option_text("FILE.pub");
  sub.add_option("--name", pool.name,
                 "Of the pool: its jobs are found again by it (default: made from the endpoint)")
      ->option_text("NAME");
  add_workers(sub, pool);
  add_limits(sub, pool);
  CLI::Option* dry = sub.add_flag("--dry-run", pool.dry_run, "Print the script and the commands");
  sub.add_flag("--stop", pool.stop, "Let all workers of the pool go, and end when they are gone")
      ->excludes(dry);
  sub.add_flag("--json", pool.json, "Print one JSON object a line on standard output");
}

}  // namespace tetfarm
