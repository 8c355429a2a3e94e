#include "cli/query_text.h"

#include <array>
#include <cstdio>
#include <ctime>

#include "cli/printable_reply.h"
#include "cli/progress_display.h"
#include "cli/running_text.h"
#include "cli/text_table.h"
#include "json/reply_values.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

std::string seconds_text(double seconds) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.1f", seconds);
  return text.data();
}

std::string mebibytes(std::uint64_t bytes) {
  return bytes == 0 ? "" : std::to_string(bytes >> 20U) + " MiB";
}

/// A task's state in a word for people: programs read "leased".
std::string state_text(const std::string& state) { return state == "leased" ? "running" : state; }

/// "3.1 s and 20 MiB"; memory that is not known is left out.
std::string cost_text(double seconds, std::uint64_t bytes) {
  return seconds_text(seconds) + " s" + (bytes == 0 ? "" : " and " + mebibytes(bytes));
}

std::string tries_text(const wire::TaskLine& task) {
  std::string text;
  const auto add = [&text](std::uint32_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  add(task.crashes(), "errors");
  add(task.losses(), "lost");
  add(task.oom_count(), "out of memory");
  return text;
}

}  // namespace

std::string time_text(std::int64_t since_1970_ms) {
  if (since_1970_ms == 0) return {};
  const std::time_t seconds = since_1970_ms / 1000;
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 32> text;
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
  return text.data();
}

std::string jobs_text(const std::vector<wire::JobStatus>& jobs) {
  std::vector<std::vector<std::string>> rows;
  for (const wire::JobStatus& said : jobs) {
    const wire::JobStatus job = printable_reply(said);
    const std::uint64_t failed = static_cast<std::uint64_t>(job.quarantine_size());
    const std::uint64_t all = job.tasks_done() + job.tasks_ready() + job.tasks_running() + failed;
    rows.push_back({job.job(), harmless(job.name(), 30), job.state(), job.stage(),
                    std::to_string(job.tasks_done()) + "/" + std::to_string(all),
                    std::to_string(job.tasks_running()), std::to_string(failed),
                    short_count(static_cast<double>(job.elements())), time_text(job.created_ms()),
                    clock_text(job.seconds()), job.message()});
  }
  return table_text({"JOB", "NAME", "STATE", "STAGE", "TASKS", "RUNNING", "QUARANTINE", "TETS",
                     "SUBMITTED (UTC)", "TOOK", ""},
                    rows);
}

std::string tasks_text(const std::vector<wire::TaskLine>& tasks) {
  std::vector<std::vector<std::string>> rows;
  for (const wire::TaskLine& said : tasks) {
    const wire::TaskLine task = printable_reply(said);
    const std::string where = worker_name(task.worker());
    const std::string doing = doing_with_share(task);
    rows.push_back(
        {std::to_string(task.task()), task.job(), task.kind(), task_place(task.kind(), task.path()),
         state_text(task.state()), task.seconds() > 0 ? seconds_text(task.seconds()) : "",
         mebibytes(task.peak_rss_bytes()), tries_text(task),
         where.empty() ? "" : where + " " + task.host(), doing.empty() ? task.message() : doing});
  }
  return table_text(
      {"TASK", "JOB", "KIND", "SUB-DOMAIN", "STATE", "SECONDS", "PEAK", "TRIED", "WHERE", ""},
      rows);
}

std::string workers_table(const std::vector<wire::WorkerLine>& workers) {
  std::vector<std::vector<std::string>> rows;
  for (const wire::WorkerLine& said : workers) {
    const wire::WorkerLine worker = printable_reply(said);
    rows.push_back({worker_name(worker.worker()), worker.host(), std::to_string(worker.process()),
                    worker.state(), worker.task() == 0 ? "" : std::to_string(worker.task()),
                    std::to_string(worker.done()), std::to_string(worker.not_done()),
                    seconds_text(worker.busy_seconds()), mebibytes(worker.memory_bytes()),
                    time_text(worker.seen_ms()),
                    worker.host_in_quarantine() ? "host in quarantine" : ""});
  }
  return table_text({"WORKER", "HOST", "PROCESS", "STATE", "TASK", "DONE", "FAILED ATTEMPTS",
                     "BUSY S", "MEMORY", "SINCE (UTC)", ""},
                    rows);
}

std::string event_text(const wire::EventLine& said) {
  const wire::EventLine event = printable_reply(said);
  std::string line = time_text(event.wall_ms()) + "  ";
  if (!event.job().empty()) line += event.job() + " ";
  if (event.task() != 0) line += "task " + std::to_string(event.task()) + " ";
  if (event.attempt() != 0) line += "attempt " + std::to_string(event.attempt()) + " ";
  if (event.worker() != 0) line += worker_name(event.worker()) + " ";
  line += event.what();
  if (!event.message().empty()) line += ": " + event.message();
  return harmless(line, 1000) + "\n";
}

std::string log_text(const wire::AttemptLine& said) {
  const wire::AttemptLine attempt = printable_reply(said);
  std::string text = attempt.job() + " task " + std::to_string(attempt.task()) + ", " +
                     attempt.kind() + (attempt.path() == 0 ? "" : " ") +
                     task_place(attempt.kind(), attempt.path()) + ": attempt " +
                     std::to_string(attempt.attempt()) + " on " + worker_name(attempt.worker()) +
                     " " + attempt.host() + ", " + attempt.state();
  text = harmless(text, 1000) + "\n";
  if (attempt.log().empty()) return text + "  (no output is kept)\n";
  std::size_t begin = 0;
  while (begin < attempt.log().size()) {
    const std::size_t end = std::min(attempt.log().find('\n', begin), attempt.log().size());
    text += "  " + harmless(attempt.log().substr(begin, end - begin), 1000) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string explanation_text(const wire::Explanation& said) {
  const wire::Explanation explanation = printable_reply(said);
  const wire::TaskLine& task = explanation.task();
  std::string text =
      "task " + std::to_string(task.task()) + " of " + task.job() + ": " + task.kind();
  const bool is_in_tree = is_place_in_tree(task.kind(), task.path());
  if (is_in_tree) {
    text +=
        " of sub-domain " + subdomain_name(task.path()) + " (" + std::to_string(task.path()) + ")";
  } else {
    text += of_task_place(task.kind(), task.path());
  }
  text += ", " + state_text(task.state()) + "\n";
  if (is_in_tree && task.path() > 1) {
    text += "  in the tree: below " + subdomain_name(task.path() / 2) + ", beside " +
            subdomain_name(task.path() ^ 1U) + "; sub-domain " + explanation.subdomain_state() +
            "\n";
  }
  for (const std::string& reason : explanation.reasons()) {
    text += "  why: " + harmless(reason, 1000) + "\n";
  }
  if (const std::string doing = doing_with_share(task); !doing.empty()) {
    text += "  doing: " + doing + "\n";
  }
  if (task.state() == "done") text += "  took " + seconds_text(task.seconds()) + " s\n";
  if (task.state() == "failed") {
    text += "  try again: tetfarm retry " + task.job() + " " + std::to_string(task.task()) + "\n";
  }
  if (explanation.expected_seconds() > 0 && task.state() != "done") {
    text +=
        "  expected to take " + cost_text(explanation.expected_seconds(), explanation.room_bytes());
    if (explanation.limit_seconds() > 0) {
      text += "; it is stopped after " + seconds_text(explanation.limit_seconds()) + " s";
    }
    text += "\n";
  }
  std::vector<std::vector<std::string>> rows;
  for (const wire::AttemptLine& attempt : explanation.attempts()) {
    rows.push_back({"  " + std::to_string(attempt.attempt()),
                    worker_name(attempt.worker()) + " " + attempt.host(),
                    time_text(attempt.started_ms()), seconds_text(seconds_of(attempt)),
                    mebibytes(attempt.peak_rss_bytes()),
                    attempt.state() + (attempt.races() ? " (raced)" : ""), attempt.message()});
  }
  text +=
      table_text({"  ATTEMPT", "WHERE", "STARTED (UTC)", "SECONDS", "PEAK", "RESULT", ""}, rows);
  for (const wire::InputLine& input : explanation.inputs()) {
    if (input.is_there()) continue;
    text += "  missing: " + harmless(input.name()) + " " + harmless(input.hash()) + "\n";
  }
  return text;
}

}  // namespace tetfarm
