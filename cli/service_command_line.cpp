#include "cli/service_command_line.h"

#include "cli/client_options.h"
#include "cli/option_checks.h"

namespace tetfarm {
namespace {

void add_folders(CLI::App& sub, CoordinatorCommand& coordinator) {
  sub.add_option("--store", coordinator.store, "Folder for everything the coordinator keeps")
      ->required()
      ->option_text("DIR");
  sub.add_option("--database", coordinator.database,
                 "Folder for the database, on a local disk (default: the store)")
      ->option_text("DIR");
  sub.add_option("--keys", coordinator.keys,
                 "Key folder, see `tetfarm keys` (default: /etc/tetfarm/keys for root, "
                 "tetfarm/keys in $XDG_CONFIG_HOME or ~/.config for others)")
      ->envname("TETFARM_KEYS")
      ->option_text("DIR");
  sub.add_option("--allow-root", coordinator.allowed_roots,
                 "Folder in which jobs may name surfaces (default: none); may be repeated")
      ->option_text("DIR");
  sub.add_option("--listen", coordinator.endpoints, "Address to listen on; may be repeated")
      ->required()
      ->option_text("tcp://ADDRESS:PORT");
}

void add_limits(CLI::App& sub, CoordinatorCommand& coordinator) {
  sub.add_option("--heartbeat-ms", coordinator.heartbeat_ms,
                 "Time between heartbeats (default 1000)")
      ->check(whole_number(10, 600'000))
      ->option_text("MS");
  sub.add_option("--lease-ms", coordinator.lease_ms,
                 "Time after which a silent worker counts as lost (default 10000)")
      ->check(whole_number(50, 86'400'000))
      ->option_text("MS");
  sub.add_option("--max-connections", coordinator.max_connections,
                 "Maximum simultaneous connections (default 16384)")
      ->check(whole_number(1, 1'000'000))
      ->option_text("N");
  sub.add_option("--max-workers", coordinator.max_workers,
                 "Maximum simultaneous workers (default 10000)")
      ->check(whole_number(1, 1'000'000))
      ->option_text("N");
  sub.add_option("--jobs-per-user", coordinator.jobs_per_user,
                 "Most jobs of one user that run and wait at once (default: any number)")
      ->check(whole_number(1, 1'000'000))
      ->option_text("N");
  sub.add_option(
         "--task-limit", coordinator.task_limit_s,
         "End a task after this time, or after 20 times its expected time if longer (default 3600)")
      ->check(positive_number())
      ->option_text("SECONDS");
  sub.add_option("--first-task-limit", coordinator.first_task_limit_s,
                 "The same, while no task of its kind has been timed (default 86400)")
      ->check(positive_number())
      ->option_text("SECONDS");
}

void add_who_may_come(CLI::App& sub, CoordinatorCommand& coordinator) {
  sub.add_flag(
      "--insecure", coordinator.insecure,
      "Plain text and no keys, even where other hosts can connect: anyone may do anything");
  sub.add_option("--http", coordinator.http_address,
                 "Serve /, /metrics, /healthz and /readyz at this address (default: nowhere)")
      ->option_text("127.0.0.1:8080");
  sub.add_option("--http-token", coordinator.http_token,
                 "File with the token that HTTP asks for; required where other hosts can connect")
      ->option_text("FILE");
  sub.add_option("--on-job-end", coordinator.on_job_end,
                 "Program that is started whenever a job has ended, with what there is to know in "
                 "TETFARM_JOB and other variables (default: none)")
      ->option_text("FILE");
  sub.add_option("--keep-days", coordinator.keep_days,
                 "Remove jobs that ended so many days ago, and files that only they need (default: "
                 "keep them)")
      ->check(number_between(1e-6, 36'500))
      ->option_text("N");
  sub.add_flag("--one-job", coordinator.one_job)->group("");
  sub.add_flag("-q,--quiet", coordinator.quiet, "Print only warnings");
}

void add_coordinator(CLI::App& sub, WorkerCommand& worker) {
  sub.add_option("--connect", worker.endpoint, "Address of the coordinator")
      ->envname("TETFARM_COORDINATOR")
      ->required()
      ->option_text("tcp://HOST:PORT");
  add_keys_of_a_peer(sub, worker.keys, StoreOption::yes);
}

void add_files(CLI::App& sub, WorkerCommand& worker) {
  sub.add_option(
         "--store", worker.store,
         "The coordinator's store, as seen from here (default: transfer files over the connection)")
      ->envname("TETFARM_STORE")
      ->option_text("DIR");
  sub.add_flag("--no-shared-store", worker.no_shared_store,
               "Transfer files over the connection, even if the store can be seen from here");
  sub.add_option("--cache", worker.cache,
                 "Folder for files received over the connection (default: in $TMPDIR)")
      ->option_text("DIR");
  sub.add_option("--cache-size", worker.cache_bytes,
                 "How much of them to keep from task to task (default 10GiB)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
}

void add_what_it_has(CLI::App& sub, WorkerCommand& worker) {
  sub.add_option("--grace", worker.grace_s, "Time to finish a task after SIGTERM (default 30)")
      ->check(not_negative_number())
      ->option_text("SECONDS");
  sub.add_option("--memory,--memory-limit", worker.memory_bytes,
                 "Memory for its tasks (default: all that the machine has)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--walltime", worker.walltime_s,
                 "Time until this worker will be ended (default: from the batch system)")
      ->check(positive_number())
      ->option_text("SECONDS");
  sub.add_option("--tag", worker.tag, "Name by which the pool that submitted it knows it")
      ->option_text("POOL/JOB");
  sub.add_option("--pool-memory", worker.pool_memory_bytes,
                 "Largest memory of any worker of its pool, for which larger tasks wait")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_flag("--solvers", worker.solvers,
               "Also run the solvers of adaptation loops: a job file says what commands they are");
  sub.add_flag("-q,--quiet", worker.quiet, "Print only warnings");
}

}  // namespace

void add_services(CLI::App& app, Services& services,
                  const std::function<void(const Command&)>& chosen) {
  const auto add = [&](const char* name, const char* what, const char* example,
                       auto& command) -> CLI::App& {
    return add_command(app, name, what, example, command, chosen);
  };
  CLI::App& coordinator =
      add("coordinator", "Take jobs, and hand out their tasks to workers",
          "tetfarm coordinator --store /shared/farm --listen tcp://127.0.0.1:5555",
          services.coordinator);
  add_folders(coordinator, services.coordinator);
  add_limits(coordinator, services.coordinator);
  add_who_may_come(coordinator, services.coordinator);

  CLI::App& worker =
      add("worker", "Work for a coordinator, one task at a time",
          "tetfarm worker --connect tcp://head:5555 --store /shared/farm", services.worker);
  add_coordinator(worker, services.worker);
  add_files(worker, services.worker);
  add_what_it_has(worker, services.worker);

  CLI::App& task = add("task", "", "", services.task);
  task.group("");
  task.add_option("STORE", services.task.store)->required();
  add("task-host", "", "", services.task_host).group("");
}

}  // namespace tetfarm
