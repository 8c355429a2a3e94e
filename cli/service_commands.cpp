#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

#include "base/clock.h"
#include "base/counted.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "cli/awaited_jobs.h"
#include "cli/bring_file.h"
#include "cli/commands.h"
#include "cli/converted_meshes.h"
#include "cli/coordinator_connection.h"
#include "cli/deliver_files.h"
#include "cli/fetch_files.h"
#include "cli/job_outcome.h"
#include "cli/loop_input.h"
#include "cli/progress_display.h"
#include "cli/progress_lines.h"
#include "cli/service_options.h"
#include "cli/unit_options.h"
#include "cli/wave_options.h"
#include "coordinator/log_lines.h"
#include "coordinator/server.h"
#include "worker/client.h"
#include "worker/machine.h"
#include "worker/solve_task.h"
#include "worker/task_host.h"
#include "worker/task_program.h"

namespace tetfarm {
namespace {

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

/// With the status of the job, which is there.
wire::StatusReply status_of_job(CoordinatorConnection& connection, const ClientOptions& client) {
  wire::StatusReply reply = connection.status(client.job, in_ms(client.timeout_s));
  if (reply.jobs_size() == 0) {
    throw Error(ExitCode::not_found, "no job " + client.job + " at " + client.endpoint);
  }
  return reply;
}

FetchOptions fetch_options(const ClientOptions& client) {
  return {.timeout_ms = in_ms(client.timeout_s), .progress = client.progress};
}

ExitCode report_submitted(const wire::Submitted& submitted, const ClientOptions& client) {
  if (client.json) {
    std::printf("{\"type\":\"submitted\",\"job\":\"%s\",\"existed\":%s}\n", submitted.job().c_str(),
                submitted.existed() ? "true" : "false");
  } else {
    std::printf("%s\n", submitted.job().c_str());
  }
  std::fflush(stdout);  // the end is the last, also where both go to one place
  CommandEnd end;
  end.state = "submitted";
  end.job = submitted.job();
  tell_end(client.progress, std::move(end));
  return ExitCode::ok;
}

void log_to_stderr(bool quiet) {
  spdlog::set_default_logger(spdlog::stderr_logger_st("tetfarm"));
  spdlog::set_formatter(one_line_formatter());
  spdlog::set_level(quiet ? spdlog::level::warn : spdlog::level::info);
  spdlog::flush_on(spdlog::level::info);
}

/// With the surface checked, unless that is left to the farm or only the coordinator sees it.
JobInput job_to_submit(const SubmitCommand& command) {
  const JobInput described = describe_job(command.job);
  check_submittable(described);
  const bool is_here = size_of_file(described.path).has_value();
  if (!is_here && !command.coordinator_reads) {
    throw ErrorWithHelp(
        ExitCode::not_found, described.path + ": no such file",
        "check the path; if only the coordinator can see the file, add --coordinator-reads");
  }
  if (command.coordinator_reads && !command.check) return described;
  if (!is_here) {
    std::fprintf(stderr, "note: %s cannot be seen from here; the farm will check it\n",
                 described.path.c_str());
    return described;
  }
  JobInput input = read_job(command.job);
  if (command.check) require_meshable(input);
  return input;
}

/// Into the store that both see, or over the connection, which has to outlive it.
BringFile way_to_coordinator(const SubmitCommand& command, CoordinatorConnection& connection) {
  const std::string& store = command.job.store;
  if (!store.empty()) return published_in(ArtifactStore::open_existing(store));
  return [&connection, options = fetch_options(command.client)](const std::string& name,
                                                                const std::string& bytes) {
    return bring_file(connection, bytes, name, options);
  };
}

/// After the surface has gone where the coordinator finds it, unless only its path goes.
wire::Submit bring_job(const SubmitCommand& command, const JobInput& input,
                       CoordinatorConnection& connection) {
  if (command.coordinator_reads) return name_job(input);
  const BringFile bring = way_to_coordinator(command, connection);
  return submission_of(input, bring(input.job.surface, input.surface));
}

/// An option of surfaces' jobs that was given; "": none.
std::string option_of_surfaces(const SubmitCommand& command) {
  const RunOptions& job = command.job;
  const std::pair<bool, const char*> given[] = {
      {job.subdomains.has_value(), "--subdomains"},
      {job.groups.has_value(), "--groups"},
      {!job.max_memory.empty(), "--max-memory"},
      {job.size.has_value(), "--size"},
      {!job.wave.frequency.empty(), "--frequency"},
      {job.wave.speed.has_value(), "--wave-speed"},
      {job.wave.per_wavelength.has_value(), "--per-wavelength"},
      {job.growth.has_value(), "--growth"},
      {job.remesh, "--remesh"},
      {job.size_on_body.has_value(), "--size-on-body"},
      {job.outer.has_value(), "--outer"},
      {job.outer_size.has_value(), "--outer-size"},
      {!job.symmetry.empty(), "--symmetry"},
      {!job.layers.empty(), "--layers"},
      {!job.pml.empty(), "--pml"},
      {!job.patch_types.empty(), "--patch-type"},
      {!job.patch_sizes.empty(), "--patch-size"},
      {job.scale.has_value(), "--scale"},
      {!job.unit.empty(), "--unit"},
      {job.max_elements.has_value(), "--max-elements"},
      {job.force, "--force"},
      {!job.formats.empty(), "--format"},
      {!job.keep.empty(), "--keep"},
      {command.coordinator_reads, "--coordinator-reads"}};
  for (const auto& [is_given, name] : given) {
    if (is_given) return name;
  }
  return {};
}

/// Before anything is sent: the jobs that this one shall wait for.
void expect_jobs_before(const SubmitCommand& command, CoordinatorConnection& connection) {
  const std::int64_t timeout_ms = in_ms(command.client.timeout_s);
  for (const std::string& wanted : command.after) {
    if (connection.status(wanted, timeout_ms).jobs_size() > 0) continue;
    std::vector<NamedJob> known;
    const wire::StatusReply all = connection.status("", timeout_ms);
    for (const wire::JobStatus& job : all.jobs()) known.push_back({job.job(), job.name()});
    const std::string problem = problem_with_awaited(wanted, known);
    if (problem.empty()) continue;  // it has just come
    throw ErrorWithHelp(ExitCode::not_found, "--after: " + problem,
                        "`tetfarm jobs` lists those of " + command.client.endpoint);
  }
}

/// When its tasks are handed out.
void set_order(const SubmitCommand& command, wire::Submit& submit) {
  submit.set_priority(command.priority);
  for (const std::string& job : command.after) submit.add_after(job);
}

ExitCode submit_loop(const SubmitCommand& command) {
  const ClientOptions& client = command.client;
  if (const std::string option = option_of_surfaces(command); !option.empty()) {
    throw UsageError(command.job.input +
                         " is the job file of an adaptation loop, and this an option for surfaces",
                     option);
  }
  const LoopInput input = read_loop(command.job.input);
  CoordinatorConnection connection = connect(client, command.job.store);
  expect_jobs_before(command, connection);
  wire::Submit submit = submission_of_loop(input, way_to_coordinator(command, connection));
  set_order(command, submit);
  return report_submitted(connection.submit(submit, in_ms(client.timeout_s)), client);
}

}  // namespace

ExitCode submit_command(const SubmitCommand& command) {
  if (is_loop_file(command.job.input)) return submit_loop(command);
  const ClientOptions& client = command.client;
  const JobInput input = job_to_submit(command);
  tell_lengths(input.job, client.progress);
  tell_wave(input.job, client.progress);
  CoordinatorConnection connection = connect(client, command.job.store);
  expect_jobs_before(command, connection);
  wire::Submit submit = bring_job(command, input, connection);
  set_order(command, submit);
  return report_submitted(connection.submit(submit, in_ms(client.timeout_s)), client);
}

ExitCode wait_command(const WaitCommand& command) {
  const ClientOptions& client = command.client;
  CoordinatorConnection connection = connect(client, command.store);
  ProgressDisplay display(client.progress);
  wire::StatusReply reply = status_of_job(connection, client);
  while (!has_ended(reply.jobs(0))) {
    display.show(reply.jobs(0), reply.workers());
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    reply = status_of_job(connection, client);
  }
  const wire::JobStatus& status = reply.jobs(0);
  display.show_forecast(status);
  display.end();
  std::vector<std::filesystem::path> files;
  if (!client.output.empty()) {
    files = command.store.empty()
                ? fetch_files(connection, status, client.output, fetch_options(client))
                : deliver_files(status, command.store, client.output);
    convert_mesh(status, client.progress, files);
  }
  return report_outcome(status, {.files = std::move(files),
                                 .seconds = status.seconds(),
                                 .json = client.json,
                                 .progress = client.progress});
}

ExitCode cancel_command(const CancelCommand& command) {
  const ClientOptions& client = command.client;
  CoordinatorConnection connection = connect(client, "");
  const wire::StatusReply status = connection.status(client.job, in_ms(client.timeout_s));
  const std::string before = status.jobs_size() == 0 ? "" : status.jobs(0).state();
  const bool found = connection.cancel(client.job, in_ms(client.timeout_s)).found();
  if (!found) throw Error(ExitCode::not_found, "no job " + client.job + " at " + client.endpoint);
  if (before == "done" || before == "failed") {
    throw ErrorWithHelp(ExitCode::failed,
                        client.job + " is already " + before + ": there is nothing to cancel", "");
  }
  if (client.json) {
    std::printf("{\"type\":\"cancelled\",\"job\":\"%s\"}\n", client.job.c_str());
  } else {
    std::printf("%s %s\n", client.job.c_str(),
                before == "cancelled" ? "was already cancelled" : "cancelled");
  }
  return ExitCode::ok;
}

ExitCode priority_command(const PriorityCommand& command) {
  const ClientOptions& client = command.client;
  CoordinatorConnection connection = connect(client, "");
  const wire::PrioritySet answer =
      connection.set_priority(client.job, command.priority, in_ms(client.timeout_s));
  if (!answer.found()) {
    throw Error(ExitCode::not_found, "no job " + client.job + " at " + client.endpoint);
  }
  if (answer.state() != "running" && answer.state() != "waiting") {
    throw ErrorWithHelp(
        ExitCode::failed,
        client.job + " is already " + answer.state() + ": none of its tasks wait for workers", "");
  }
  if (client.json) {
    std::printf("{\"type\":\"priority\",\"job\":\"%s\",\"priority\":%d}\n", client.job.c_str(),
                command.priority);
  } else {
    std::printf("%s has priority %d\n", client.job.c_str(), command.priority);
  }
  return ExitCode::ok;
}

ExitCode retry_command(const RetryCommand& command) {
  const ClientOptions& client = command.client;
  if (client.job.empty() == command.host.empty())
    throw UsageError("give either a job or --host NAME", "retry");
  wire::Retry retry;
  retry.set_job(client.job);
  retry.set_task(command.task);
  retry.set_host(command.host);
  CoordinatorConnection connection = connect(client, "");
  const std::uint64_t count = connection.retry(retry, in_ms(client.timeout_s)).count();
  const std::string& what = command.host.empty() ? client.job : command.host;
  if (count == 0)
    throw Error(ExitCode::not_found, what + (command.host.empty() ? ": nothing is in quarantine"
                                                                  : ": is not in quarantine"));
  if (client.json) {
    std::printf("{\"type\":\"retried\",\"count\":%llu}\n", static_cast<unsigned long long>(count));
  } else {
    const std::string freed =
        command.host.empty() ? counted(count, "task") + " of " + client.job : command.host;
    std::printf("took %s out of quarantine\n", freed.c_str());
  }
  return ExitCode::ok;
}

ExitCode drain_command(const DrainCommand& command) {
  const ClientOptions& client = command.client;
  const std::uint64_t worker = parse_worker_name(command.worker);
  if (command.all == (worker != 0)) throw UsageError("give either a worker or --all", "drain");
  CoordinatorConnection connection = connect(client, "");
  const std::uint64_t count = connection.drain(worker, in_ms(client.timeout_s)).count();
  if (count == 0 && !command.all) {
    throw Error(ExitCode::not_found, "no " + command.worker + " at " + client.endpoint);
  }
  if (client.json) {
    std::printf("{\"type\":\"draining\",\"count\":%llu}\n", static_cast<unsigned long long>(count));
  } else {
    std::printf("%s %s\n", counted(count, "worker").c_str(),
                count == 1 ? "is draining" : "are draining");
  }
  return ExitCode::ok;
}

ExitCode coordinator_command(const CoordinatorCommand& command) {
  log_to_stderr(command.quiet);
  return run_coordinator(coordinator_options(command));
}

ExitCode worker_command(const WorkerCommand& command) {
  log_to_stderr(command.quiet);
  ::setenv(solvers_variable, command.solvers ? "yes" : "no", 1);
  // What a farm's worker writes is not for others than its group, as in run_coordinator; the store
  // of a run is its user's own.
  if (std::filesystem::path(command.store).filename() != ".tetfarm") {
    ::umask(::umask(0) | S_IRWXO);
  }
  const auto environment = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  return run_worker(worker_options(command, environment, wall_ms()));
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
