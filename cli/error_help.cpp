#include "cli/error_help.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include "base/error_with_help.h"

namespace tetfarm {
namespace {

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Commands that take a job, and so a surface or a job file.
constexpr std::array<std::string_view, 4> of_jobs = {"run", "plan", "submit", "init"};
/// Commands for meshes of the plane.
constexpr std::array<std::string_view, 3> of_planes = {"plane", "adapt", "loop"};
/// Commands that ask a coordinator.
constexpr std::array<std::string_view, 19> of_clients = {
    "submit", "status", "wait",    "priority", "cancel",   "retry",   "drain",
    "jobs",   "tasks",  "workers", "events",   "logs",     "explain", "trace",
    "report", "pool",   "worker",  "top",      "dashboard"};
/// Commands that have to do with keys.
constexpr std::array<std::string_view, 4> of_keys = {"coordinator", "worker", "pool", "keys"};

std::string help_for_usage(const Error& error, std::string_view command) {
  const bool is_command = !command.empty() && !command.starts_with('-');
  const std::string help =
      "see `tetfarm " + (is_command ? std::string(command) + " " : "") + "--help`";
  const bool is_of_job_file = std::string_view(error.what()).find(".toml:") != std::string::npos;
  const char* document = is_one_of(command, of_planes) ? "docs/adaptation.md" : "docs/job_file.md";
  if (is_of_job_file) return help + " and " + document;
  return is_one_of(command, of_keys) ? help + " and docs/security.md" : help;
}

std::string help_for_what_is_missing(const Error& error, std::string_view command) {
  if (dynamic_cast<const IoError*>(&error) != nullptr) return "check the path";
  return is_one_of(command, of_clients)
             ? "check the name, and that the coordinator is running and can be reached"
             : "";
}

/// Of a path that is there, or could be, but not for this user or not as it is wanted.
bool is_barred(const Error& error) {
  const auto* failed = dynamic_cast<const IoError*>(&error);
  constexpr std::array<int, 6> barred = {EACCES, EPERM, EROFS, ENOTDIR, EISDIR, ENAMETOOLONG};
  return failed != nullptr && std::ranges::find(barred, failed->error_number()) != barred.end();
}

std::string help_for_failure(const Error& error, std::string_view command) {
  if (is_barred(error)) return "check the path, and what you may read and write there";
  if (command == "run")
    return "the logs are in .tetfarm in the output folder; run the same command again to retry";
  return command == "wait" ? "`tetfarm logs JOB` shows the output of its tasks" : "";
}

}  // namespace

std::string help_for(const Error& error, std::string_view command) {
  const auto* own = dynamic_cast<const ErrorWithHelp*>(&error);
  if (own != nullptr) return own->help();
  switch (error.code()) {
    case ExitCode::usage:
      return help_for_usage(error, command);
    case ExitCode::bad_geometry:
      if (command == "check") return "repair the input there";
      if (!is_one_of(command, of_jobs) && command != "wait") return "";
      return "repair the input there, or mend it by `tetfarm surface --heal-only`; "
             "`tetfarm check` shows every defect of the surface, and which of them healing would "
             "mend";
    case ExitCode::not_found:
      return help_for_what_is_missing(error, command);
    case ExitCode::out_of_resources:
      return command == "run" ? "make room, then run the same command again to continue"
                              : "make room, then try again";
    default:
      return help_for_failure(error, command);
  }
}

std::string complaint(const std::string& message, const std::string& help) {
  return "error: " + message + "\n" + (help.empty() ? "" : "help: " + help + "\n");
}

}  // namespace tetfarm
