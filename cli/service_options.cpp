#include "cli/service_options.h"

#include <cstdio>
#include <filesystem>

namespace tetfarm {
namespace {

constexpr double seconds_of_a_day = 86'400;

}  // namespace

CoordinatorOptions coordinator_options(const CoordinatorCommand& command) {
  CoordinatorOptions options;
  options.store = command.store;
  options.database = command.database;
  options.keys = command.keys;
  options.endpoints = command.endpoints;
  options.allowed_roots.assign(command.allowed_roots.begin(), command.allowed_roots.end());
  options.max_connections = command.max_connections;
  options.max_workers = command.max_workers;
  options.heartbeat_ms = command.heartbeat_ms;
  options.lease_ms = command.lease_ms;
  options.task_limit_ms = in_ms(command.task_limit_s);
  options.first_task_limit_ms = in_ms(command.first_task_limit_s);
  options.insecure = command.insecure;
  options.one_job = command.one_job;
  options.http_address = command.http_address;
  options.http_token = command.http_token;
  options.on_job_end = command.on_job_end;
  options.jobs_per_user = command.jobs_per_user;
  options.keep_ms = in_ms(command.keep_days * seconds_of_a_day);
  options.log_to_stderr = !command.quiet;
  options.on_http = [is_quiet = command.quiet](const std::string& address) {
    if (!is_quiet) std::printf("status page on http://%s/\n", address.c_str());
    std::fflush(stdout);
  };
  options.on_listening = [is_quiet = command.quiet](const std::vector<std::string>& endpoints) {
    for (const std::string& endpoint : endpoints) {
      if (!is_quiet) std::printf("listening on %s\n", endpoint.c_str());
    }
    std::fflush(stdout);
  };
  return options;
}

WorkerOptions worker_options(const WorkerCommand& command, const Environment& environment,
                             std::int64_t now_wall_ms) {
  WorkerOptions options;
  options.endpoint = command.endpoint;
  options.keys = command.keys;
  if (!command.store.empty()) {
    options.store = std::filesystem::absolute(command.store);
    if (options.keys.coordinator.empty() && !options.keys.own.empty() && command.no_shared_store) {
      options.keys.coordinator = published_key_path(options.store);
    }
  }
  if (command.no_shared_store) options.store.clear();
  options.cache = std::filesystem::absolute(
      command.cache.empty() ? default_cache_folder() : std::filesystem::path(command.cache));
  options.cache_bytes = command.cache_bytes;
  options.task_command = {"/proc/self/exe", "task"};
  options.host_command = {"/proc/self/exe", "task-host"};
  options.memory_bytes = command.memory_bytes;
  options.tag = command.tag;
  options.pool_memory_bytes = command.pool_memory_bytes;
  options.runs_solvers = command.solvers;
  options.ends_in_ms = command.walltime_s > 0 ? in_ms(command.walltime_s)
                                              : walltime_left_ms(environment, now_wall_ms);
  options.grace_ms = in_ms(command.grace_s);
  return options;
}

}  // namespace tetfarm
