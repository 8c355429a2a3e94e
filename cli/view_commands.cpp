/// The commands that only look: at a coordinator, or at a store at rest.
#include <charconv>
#include <cstdio>

#include "base/clock.h"
#include "base/file_system.h"
#include "cli/chrome_trace.h"
#include "cli/commands.h"
#include "cli/farm_view.h"
#include "cli/job_text.h"
#include "cli/query_text.h"
#include "json/job_json.h"
#include "json/query_json.h"

namespace tetfarm {
namespace {

wire::Query about(wire::Query::Subject subject, const std::string& job = "") {
  wire::Query query;
  query.set_subject(subject);
  query.set_job(job);
  return query;
}

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }
void print_line(const std::string& text) { print(text + "\n"); }

}  // namespace

ExitCode status_command(const StatusCommand& command) {
  const ClientOptions& client = command.view.client;
  FarmView view(command.view);
  const wire::StatusReply reply = view.status();
  if (!client.job.empty() && reply.jobs_size() == 0) {
    throw Error(ExitCode::not_found, "no job " + client.job);
  }
  if (!client.json) {
    print(status_text(reply));
    if (command.workers) print(workers_text(reply));
    return ExitCode::ok;
  }
  if (client.job.empty()) print_line(farm_json(reply));
  print(farm_events_json(reply, command.workers));
  for (const wire::JobStatus& status : reply.jobs()) print_line(status_json(status));
  return ExitCode::ok;
}

ExitCode jobs_command(const JobsCommand& command) {
  FarmView view(command.view);
  std::vector<wire::JobStatus> jobs;
  std::string trouble;
  view.ask(about(wire::Query::JOBS), [&](const wire::QueryReply& page) {
    jobs.insert(jobs.end(), page.jobs().begin(), page.jobs().end());
    trouble = page.trouble();
  });
  if (!command.view.client.json && !trouble.empty()) print_line(trouble);
  if (!command.view.client.json) print(jobs.empty() ? "no jobs\n" : jobs_text(jobs));
  if (command.view.client.json) {
    for (const wire::JobStatus& job : jobs) print_line(job_json(job));
  }
  return ExitCode::ok;
}

ExitCode tasks_command(const TasksCommand& command) {
  const ClientOptions& client = command.view.client;
  const std::string wanted = command.state == "running" ? "leased" : command.state;
  FarmView view(command.view);
  std::vector<wire::TaskLine> tasks;
  view.ask(about(wire::Query::TASKS, client.job), [&](const wire::QueryReply& page) {
    for (const wire::TaskLine& task : page.tasks()) {
      const bool is_wanted = (wanted.empty() || task.state() == wanted) &&
                             (command.kind.empty() || task.kind() == command.kind);
      if (!is_wanted) continue;
      if (client.json) print_line(task_json(task));
      if (!client.json) tasks.push_back(task);
    }
  });
  if (!client.json) print(tasks.empty() ? "no matching tasks\n" : tasks_text(tasks));
  return ExitCode::ok;
}

ExitCode workers_command(const WorkersCommand& command) {
  FarmView view(command.view);
  wire::Query query = about(wire::Query::WORKERS);
  query.set_with_gone(command.all);
  std::vector<wire::WorkerLine> workers;
  view.ask(query, [&](const wire::QueryReply& page) {
    workers.insert(workers.end(), page.workers().begin(), page.workers().end());
  });
  if (!command.view.client.json) {
    print(workers.empty() ? "no workers\n" : workers_table(workers));
  }
  if (command.view.client.json) {
    for (const wire::WorkerLine& worker : workers) print_line(worker_json(worker));
  }
  return ExitCode::ok;
}

ExitCode events_command(const EventsCommand& command) {
  const ClientOptions& client = command.view.client;
  FarmView view(command.view);
  wire::Query query = about(wire::Query::EVENTS, client.job);
  query.set_task(command.task);
  query.set_newest(!command.all);
  if (!command.all) query.set_limit(command.last);
  view.ask(query, [&](const wire::QueryReply& page) {
    for (const wire::EventLine& event : page.events()) {
      print(client.json ? event_json(event) + "\n" : event_text(event));
    }
  });
  return ExitCode::ok;
}

ExitCode logs_command(const LogsCommand& command) {
  const std::string& target = command.target;
  wire::Query query = about(wire::Query::LOGS);
  std::uint64_t task = 0;
  const char* end = target.data() + target.size();
  const auto [stopped, error] = std::from_chars(target.data(), end, task);
  if (error == std::errc{} && stopped == end) {
    query.set_task(task);
  } else {
    query.set_job(target);
  }
  FarmView view(command.view);
  view.ask(query, [&](const wire::QueryReply& page) {
    for (const wire::AttemptLine& attempt : page.attempts()) {
      print(command.view.client.json ? attempt_json(attempt, true) + "\n" : log_text(attempt));
    }
  });
  return ExitCode::ok;
}

ExitCode trace_command(const TraceCommand& command) {
  FarmView view(command.view);
  const std::string& job = command.view.client.job;
  std::vector<wire::AttemptLine> attempts;
  view.ask(about(wire::Query::ATTEMPTS, job), [&](const wire::QueryReply& page) {
    attempts.insert(attempts.end(), page.attempts().begin(), page.attempts().end());
  });
  std::vector<wire::EventLine> events;
  view.ask(about(wire::Query::EVENTS, job), [&](const wire::QueryReply& page) {
    events.insert(events.end(), page.events().begin(), page.events().end());
  });
  write_file_atomically(command.output, chrome_trace(attempts, events, wall_ms()));
  if (command.view.client.json) print_line(copy_json("trace", command.output));
  return ExitCode::ok;
}

ExitCode explain_command(const ExplainCommand& command) {
  FarmView view(command.view);
  wire::Query query = about(wire::Query::EXPLAIN);
  query.set_task(command.task);
  view.ask(query, [&](const wire::QueryReply& reply) {
    const wire::Explanation& explanation = reply.explanation();
    print(command.view.client.json ? explanation_json(explanation) + "\n"
                                   : explanation_text(explanation));
  });
  return ExitCode::ok;
}

}  // namespace tetfarm
