#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "base/clock.h"
#include "cli/commands.h"
#include "cli/coordinator_connection.h"
#include "cli/job_outcome.h"
#include "cli/job_report.h"
#include "cli/progress_display.h"
#include "coordinator/server.h"
#include "worker/client.h"
#include "worker/machine.h"
#include "worker/task_host.h"
#include "worker/task_program.h"

namespace tetfarm {
namespace {

std::int64_t in_ms(double seconds) { return static_cast<std::int64_t>(seconds * 1000); }

CoordinatorConnection connect(const ClientOptions& client, const std::string& store) {
  return CoordinatorConnection(client.endpoint, read_peer_keys(client.keys, store));
}

/// The 7 of "worker-7"; 0 when it is anything else.
std::uint64_t parse_worker_name(const std::string& name) {
  const std::string prefix = "worker-";
  if (!name.starts_with(prefix)) return 0;
  std::uint64_t worker = 0;
  const char* end = name.data() + name.size();
  const auto [stopped, error] = std::from_chars(name.data() + prefix.size(), end, worker);
  return error == std::errc{} && stopped == end ? worker : 0;
}

wire::JobStatus status_of_job(CoordinatorConnection& connection, const ClientOptions& client) {
  const wire::StatusReply reply = connection.status(client.job, in_ms(client.timeout_s));
  if (reply.jobs_size() == 0) {
    throw Error(ExitCode::not_found, "no job " + client.job + " at " + client.endpoint);
  }
  return reply.jobs(0);
}

void log_to_stderr(bool quiet) {
  spdlog::set_default_logger(spdlog::stderr_logger_st("tetfarm"));
  spdlog::set_level(quiet ? spdlog::level::warn : spdlog::level::info);
  spdlog::flush_on(spdlog::level::info);
}

}  // namespace

ExitCode submit_command(const SubmitCommand& command) {
  const std::string& store = command.job.store;
  const wire::Submit submit =
      store.empty() ? name_job(describe_job(command.job))
                    : publish_job(ArtifactStore::open_existing(store), read_job(command.job));
  CoordinatorConnection connection = connect(command.client, store);
  const wire::Submitted submitted = connection.submit(submit, in_ms(command.client.timeout_s));
  if (command.client.json) {
    std::printf("{\"type\":\"submitted\",\"job\":\"%s\",\"existed\":%s}\n", submitted.job().c_str(),
                submitted.existed() ? "true" : "false");
  } else {
    std::printf("%s\n", submitted.job().c_str());
  }
  return ExitCode::ok;
}

ExitCode wait_command(const WaitCommand& command) {
  const ClientOptions& client = command.client;
  if (!client.output.empty() && command.store.empty()) {
    throw UsageError("to bring the files, say where the store is", "--output needs --store");
  }
  CoordinatorConnection connection = connect(client, command.store);
  ProgressDisplay display(client.progress);
  wire::JobStatus status = status_of_job(connection, client);
  while (!has_ended(status)) {
    display.show(status);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    status = status_of_job(connection, client);
  }
  display.end();
  return report_outcome(status, {.store = command.store,
                                 .output = client.output,
                                 .seconds = status.seconds(),
                                 .json = client.json});
}

ExitCode cancel_command(const CancelCommand& command) {
  const ClientOptions& client = command.client;
  CoordinatorConnection connection = connect(client, "");
  const bool found = connection.cancel(client.job, in_ms(client.timeout_s)).found();
  if (!found) throw Error(ExitCode::not_found, "no running job " + client.job);
  if (client.json) {
    std::printf("{\"type\":\"cancelled\",\"job\":\"%s\"}\n", client.job.c_str());
  } else {
    std::printf("%s cancelled\n", client.job.c_str());
  }
  return ExitCode::ok;
}

ExitCode retry_command(const RetryCommand& command) {
  const ClientOptions& client = command.client;
  if (client.job.empty() == command.host.empty()) throw UsageError("name a job or a host", "retry");
  wire::Retry retry;
  retry.set_job(client.job);
  retry.set_task(command.task);
  retry.set_host(command.host);
  CoordinatorConnection connection = connect(client, "");
  const std::uint64_t count = connection.retry(retry, in_ms(client.timeout_s)).count();
  const std::string& what = command.host.empty() ? client.job : command.host;
  if (count == 0) throw Error(ExitCode::not_found, what + ": nothing there is in quarantine");
  if (client.json) {
    std::printf("{\"type\":\"retried\",\"count\":%llu}\n", static_cast<unsigned long long>(count));
  } else {
    std::printf("%s goes on\n", what.c_str());
  }
  return ExitCode::ok;
}

ExitCode drain_command(const DrainCommand& command) {
  const ClientOptions& client = command.client;
  const std::uint64_t worker = parse_worker_name(command.worker);
  if (command.all == (worker != 0)) throw UsageError("name one worker, or --all", "drain");
  CoordinatorConnection connection = connect(client, "");
  const std::uint64_t count = connection.drain(worker, in_ms(client.timeout_s)).count();
  if (count == 0 && !command.all) {
    throw Error(ExitCode::not_found, "no " + command.worker + " at " + client.endpoint);
  }
  if (client.json) {
    std::printf("{\"type\":\"draining\",\"count\":%llu}\n", static_cast<unsigned long long>(count));
  } else {
    std::printf("%llu workers drain\n", static_cast<unsigned long long>(count));
  }
  return ExitCode::ok;
}

ExitCode coordinator_command(const CoordinatorCommand& command) {
  log_to_stderr(command.quiet);
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
  options.on_http = [&command](const std::string& address) {
    if (!command.quiet) std::printf("showing http://%s/\n", address.c_str());
    std::fflush(stdout);
  };
  options.log_to_stderr = !command.quiet;
  options.on_listening = [&command](const std::vector<std::string>& endpoints) {
    for (const std::string& endpoint : endpoints) {
      if (!command.quiet) std::printf("listening on %s\n", endpoint.c_str());
    }
    std::fflush(stdout);
  };
  return run_coordinator(options);
}

ExitCode worker_command(const WorkerCommand& command) {
  log_to_stderr(command.quiet);
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
  const auto environment = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  options.ends_in_ms =
      command.walltime_s > 0 ? in_ms(command.walltime_s) : walltime_left_ms(environment, wall_ms());
  options.grace_ms = in_ms(command.grace_s);
  return run_worker(options);
}

ExitCode task_command(const TaskCommand& command) {
  run_task_program(command.store, STDIN_FILENO, task_result_fd);
  return ExitCode::ok;
}

ExitCode task_host_command() {
  const std::optional<std::string> store = serve_as_task_host(task_host_fd);
  if (store) run_task_program(*store, STDIN_FILENO, task_result_fd);
  return ExitCode::ok;
}

}  // namespace tetfarm
