#include "cli/service_command_line.h"

#include "cli/client_options.h"
#include "cli/option_checks.h"

namespace tetfarm {
namespace {

void add_folders(CLI::App& sub, CoordinatorCommand& coordinator) {
  sub.add_option("--store", coordinator.store, "Folder of everything durable")
      ->required()
      ->option_text("DIR");
  sub.add_option("--database", coordinator.database,
                 "Folder of the database, on a disk of this host (default: the store)")
      ->option_text("DIR");
  sub.add_option("--keys", coordinator.keys,
                 "Folder of the keys, see `tetfarm keys` (default: /etc/tetfarm/keys for root, "
                 "tetfarm/keys in $XDG_CONFIG_HOME or ~/.config for others)")
      ->envname("TETFARM_KEYS")
      ->option_text("DIR");
  sub.add_option("--allow-root", coordinator.allowed_roots,
                 "A folder that jobs may name surfaces in (none); may be repeated")
      ->option_text("DIR");
  sub.add_option("--listen", coordinator.endpoints, "Where to listen; may be repeated")
      ->required()
      ->option_text("tcp://ADDRESS:PORT");
}

void add_limits(CLI::App& sub, CoordinatorCommand& coordinator) {
  sub.add_option("--heartbeat-ms", coordinator.heartbeat_ms, "Between heartbeats (1000)")
      ->check(whole_number(10, 600'000));
  sub.add_option("--lease-ms", coordinator.lease_ms, "A silent worker is lost (10000)")
      ->check(whole_number(50, 86'400'000));
  sub.add_option("--max-connections", coordinator.max_connections, "At once (16384)")
      ->check(whole_number(1, 1'000'000));
  sub.add_option("--max-workers", coordinator.max_workers, "At once (10000)")
      ->check(whole_number(1, 1'000'000));
  sub.add_option("--task-limit", coordinator.task_limit_s,
                 "A task may run so long, or 20 times what is expected of its kind (3600)")
      ->check(positive_number())
      ->option_text("SECONDS");
  sub.add_option("--first-task-limit", coordinator.first_task_limit_s,
                 "The same while nothing is known of its kind (86400)")
      ->check(positive_number())
      ->option_text("SECONDS");
}

void add_who_may_come(CLI::App& sub, CoordinatorCommand& coordinator) {
  sub.add_flag("--insecure", coordinator.insecure,
               "Plain text and no keys, also where other hosts can reach it: whoever "
               "comes may do anything");
  sub.add_option("--http", coordinator.http_address,
                 "Show /, /metrics, /healthz and /readyz there (default: nowhere)")
      ->option_text("127.0.0.1:8080");
  sub.add_option("--http-token", coordinator.http_token,
                 "A file with a token that HTTP asks for; required where others can reach it")
      ->option_text("FILE");
  sub.add_flag("--one-job", coordinator.one_job)->group("");
  sub.add_flag("-q,--quiet", coordinator.quiet, "Warnings only");
}

void add_coordinator(CLI::App& sub, WorkerCommand& worker) {
  sub.add_option("--connect", worker.endpoint, "The coordinator")
      ->envname("TETFARM_COORDINATOR")
      ->required()
      ->option_text("tcp://HOST:PORT");
  add_keys_of_a_peer(sub, worker.keys, StoreOption::yes);
}

void add_files(CLI::App& sub, WorkerCommand& worker) {
  sub.add_option("--store", worker.store,
                 "The coordinator's store, as seen from here (default: files come over the "
                 "connection)")
      ->envname("TETFARM_STORE")
      ->option_text("DIR");
  sub.add_flag("--no-shared-store", worker.no_shared_store,
               "Files come over the connection, whether it sees the store or not");
  sub.add_option("--cache", worker.cache,
                 "For files that come over the connection (default: in $TMPDIR)")
      ->option_text("DIR");
  sub.add_option("--cache-size", worker.cache_bytes,
                 "How much of them is kept from task to task (10GiB)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
}

void add_what_it_has(CLI::App& sub, WorkerCommand& worker) {
  sub.add_option("--grace", worker.grace_s, "To finish a task in after SIGTERM (30)")
      ->check(not_negative_number())
      ->option_text("SECONDS");
  sub.add_option("--memory,--memory-limit", worker.memory_bytes,
                 "For its tasks (default: what the machine has)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--walltime", worker.walltime_s,
                 "It will be ended then (default: as the batch system says)")
      ->check(positive_number())
      ->option_text("SECONDS");
  sub.add_option("--tag", worker.tag, "How the pool that submitted it knows it")
      ->option_text("POOL/JOB");
  sub.add_option("--pool-memory", worker.pool_memory_bytes,
                 "The most that another worker of its pool can have: larger tasks wait for one")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_flag("-q,--quiet", worker.quiet, "Warnings only");
}

}  // namespace

void add_services(CLI::App& app, Services& services,
                  const std::function<void(const Command&)>& chosen) {
  const auto add = [&](const char* name, const char* what, const char* example,
                       auto& command) -> CLI::App& {
    return add_command(app, name, what, example, command, chosen);
  };
  CLI::App& coordinator =
      add("coordinator", "Serve jobs to workers",
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
