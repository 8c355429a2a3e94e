/// The command lines of the commands that only look: dashboard, jobs, status, tasks, workers,
/// events, logs, explain, trace, report; and of those that copy the database.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/command_line.h"

namespace tetfarm {

/// What they read.
struct Views {
  StatusCommand status;
  JobsCommand jobs;
  TasksCommand tasks;
  WorkersCommand workers;
  EventsCommand events;
  LogsCommand logs;
  ExplainCommand explain;
  TopCommand top;
  DashboardCommand dashboard;
  TraceCommand trace;
  ReportCommand report;
  BackupCommand backup;
  RestoreCommand restore;
};

/// Adds those that look; `chosen` is called with the one that was given. @pre `views` outlives the
/// app.
void add_views(CLI::App& app, Views& views, const std::function<void(const Command&)>& chosen);
/// The same of backup and restore.
void add_copies(CLI::App& app, Views& views, const std::function<void(const Command&)>& chosen);

}  // namespace tetfarm
