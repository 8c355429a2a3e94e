#include "cli/view_command_line.h"

#include <string_view>
#include <vector>

#include "cli/client_options.h"
#include "cli/option_checks.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

void add_rows(CLI::App& app, ViewOptions& view) {
  app.add_option("--store", view.store,
                 "A store, or the output folder of a run, to read when no coordinator answers")
      ->envname("TETFARM_STORE")
      ->option_text("DIR");
  app.add_option("--database", view.database, "Folder of the database (default: the store)")
      ->option_text("DIR");
}

void add_view(CLI::App& app, ViewOptions& view) {
  add_connection(app, view.client, StoreOption::yes);
  add_rows(app, view);
}

/// The one that is for people alone.
void add_top(CLI::App& sub, TopCommand& top) {
  sub.add_flag("--once", top.once, "Print one snapshot, as without a terminal");
  sub.add_option("--interval", top.interval_s, "Time between two looks (default 2)")
      ->check(number_between(0.1, 3600))
      ->option_text("SECONDS");
  add_peer(sub, top.view.client, StoreOption::yes);
  add_rows(sub, top.view);
}

void add_dashboard(CLI::App& sub, DashboardCommand& dashboard) {
  sub.add_option("--http", dashboard.http_address,
                 "Address for browsers; port 0 is any that is free (default 127.0.0.1:8470)")
      ->option_text("127.0.0.1:8080");
  sub.add_option("--http-token", dashboard.http_token,
                 "File with the token that HTTP asks for; required where other hosts can connect")
      ->option_text("FILE");
  sub.add_flag("--acts", dashboard.acts,
               "Let browsers cancel jobs, set priorities, retry and drain (default: "
               "only look)");
  add_peer(sub, dashboard.view.client, StoreOption::yes);
  add_rows(sub, dashboard.view);
}

void add_copy(CLI::App& sub, BackupCommand& copy) {
  sub.add_option("--database", copy.database, "Folder of the database (default: the store)")
      ->option_text("DIR");
  add_json(sub, copy.json);
}

std::vector<std::string_view> names_of_kinds() {
  std::vector<std::string_view> names;
  for (const TaskKind kind : all_task_kinds) names.emplace_back(name_of(kind));
  return names;
}

void add_choice_of_tasks(CLI::App& sub, TasksCommand& tasks) {
  sub.add_option("JOB", tasks.view.client.job, "Only of this job (default: all)");
  sub.add_option("--state", tasks.state, "Only in this state")
      ->check(
          CLI::IsMember({"waiting", "ready", "running", "leased", "done", "failed", "replaced"}))
      ->option_text("waiting|ready|running|done|failed");
  sub.add_option("--kind", tasks.kind, "Only of this kind: inspect, decompose, mesh, ...")
      ->check(suggested(names_of_kinds()))
      ->option_text("KIND");
}

}  // namespace

void add_views(CLI::App& app, Views& views, const std::function<void(const Command&)>& chosen) {
  const auto add = [&](const char* name, const char* what, const char* example,
                       auto& command) -> CLI::App& {
    CLI::App& sub = add_command(app, name, what, example, command, chosen);
    add_view(sub, command.view);
    return sub;
  };
  add_top(add_command(app, "top", "Watch jobs and workers on one screen; the key q quits",
                      "tetfarm top --connect tcp://head:5555", views.top, chosen),
          views.top);
  add_dashboard(add_command(app, "dashboard", "Show jobs, tasks and workers in browsers, live",
                            "tetfarm dashboard --connect tcp://head:5555", views.dashboard, chosen),
                views.dashboard);
  add("jobs", "List the jobs, one per line", "tetfarm jobs --connect tcp://head:5555", views.jobs);

  CLI::App& status = add("status", "Show the progress of jobs, and what is wrong with them",
                         "tetfarm status job-7 --connect tcp://head:5555", views.status);
  status.add_option("JOB", views.status.view.client.job, "One job (default: all)");
  status.add_flag("--workers", views.status.workers,
                  "Also list every worker and what it is running");

  CLI::App& tasks =
      add("tasks", "List the tasks", "tetfarm tasks job-7 --state ready", views.tasks);
  add_choice_of_tasks(tasks, views.tasks);

  CLI::App& workers =
      add("workers", "List the workers, what they are running and what they have done",
          "tetfarm workers --all", views.workers);
  workers.add_flag("--all", views.workers.all, "Also those that have left");

  CLI::App& events =
      add("events", "Show what happened, oldest first", "tetfarm events job-7 --all", views.events);
  events.add_option("JOB", views.events.view.client.job, "Only of this job (default: all)");
  events.add_option("--task", views.events.task, "Only of this task")
      ->check(counting_number())
      ->option_text("N");
  CLI::Option* last =
      events
          .add_option("-n,--last", views.events.last, "How many to show, the newest (default 50)")
          ->check(whole_number(1, 1000))
          ->option_text("N");
  events.add_flag("--all", views.events.all, "Show all that are kept")->excludes(last);

  CLI::App& logs =
      add("logs", "Show the output of tasks, attempt by attempt", "tetfarm logs 31", views.logs);
  logs.add_option("JOB|TASK", views.logs.target, "A job (job-7), or a task's number")->required();

  CLI::App& explain = add("explain", "Explain why a task is waiting or failed, and where it ran",
                          "tetfarm explain 31", views.explain);
  explain.add_option("TASK", views.explain.task, "The task's number, as `tetfarm tasks` shows it")
      ->required()
      ->check(counting_number());

  CLI::App& trace = add("trace", "Write a timeline of who did what, for ui.perfetto.dev",
                        "tetfarm trace job-7 -o trace.json", views.trace);
  trace.add_option("JOB", views.trace.view.client.job, "The job")->required();
  trace.add_option("-o,--output", views.trace.output, "The output file")
      ->required()
      ->option_text("JSON");

  CLI::App& report =
      add("report", "Write an HTML page about a finished job: quality, balance, work",
          "tetfarm report out -o report.html", views.report);
  report
      .add_option("FILE", views.report.view.client.job,
                  "The output folder of a run or a loop, a mesh, or a job (job-7)")
      ->required();
  report.add_option("-o,--output", views.report.output, "The output file")
      ->required()
      ->option_text("HTML");
}

void add_copies(CLI::App& app, Views& views, const std::function<void(const Command&)>& chosen) {
  CLI::App& backup = add_command(
      app, "backup", "Copy the database to a file, even while a coordinator is using it",
      "tetfarm backup /shared/farm -o farm.backup", views.backup, chosen);
  backup.add_option("STORE", views.backup.store, "The store")->required();
  backup.add_option("-o,--output", views.backup.file, "The backup")
      ->required()
      ->option_text("FILE");
  add_copy(backup, views.backup);

  CLI::App& restore = add_command(
      app, "restore", "Replace a store's database with a backup; no coordinator may be using it",
      "tetfarm restore farm.backup /shared/farm", views.restore, chosen);
  restore.add_option("FILE", views.restore.from.file, "The backup")->required();
  restore.add_option("STORE", views.restore.from.store, "The store")->required();
  add_copy(restore, views.restore.from);
}

}  // namespace tetfarm
