#include "coordinator/views/status_page.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <vector>

#include "base/tree_path.h"
#include "proto/doing.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t newest_attempts = 1500;
constexpr std::size_t most_nodes = 1023;
constexpr double width = 1000;
constexpr double row_height = 14;

constexpr const char* head = R"html(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta http-equiv="refresh" content="10">
<title>Tetfarm</title><style>
body{font:14px sans-serif;margin:2em;color:#222}table{border-collapse:collapse}
td,th{padding:.2em .8em;text-align:left;border-bottom:1px solid #ddd}
svg{background:#f7f7f7;display:block;margin:.5em 0}text{font:10px sans-serif}
.open{fill:#fff;stroke:#888}.cut{fill:#bbb}.leaf{fill:#fc6}.meshed{fill:#5a5}.joined{fill:#9cf}
.remesh,.inspect,.number,.order,.extract{fill:#999}.decompose{fill:#36c}.assimilate{fill:#63c}
.mesh{fill:#5a5}.cosmetic{fill:#c83}.assemble,.write{fill:#088}.bad{fill:#c22}.running{opacity:.5}
</style></head><body><h1>Tetfarm</h1>
)html";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string cell(const std::string& text) { return "<td>" + in_html(text) + "</td>"; }

wire::QueryReply ask(const QueryContext& context, wire::Query::Subject subject,
                     std::uint64_t after = 0) {
  wire::Query query;
  query.set_subject(subject);
  query.set_after(after);
  return answer_query(query, context);
}

std::string box(const std::string& look, double x, double y, double w, double h,
                const std::string& title) {
  return "<rect class=\"" + look + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" +
         number(std::max(w, 1.0)) + "\" height=\"" + number(h) + "\"><title>" + in_html(title) +
         "</title></rect>\n";
}

std::string jobs_table(const QueryContext& context) {
  std::string text =
      "<h2>Jobs</h2><table><tr><th>job<th>name<th>state<th>stage<th>tasks done<th>running"
      "<th>ready<th>quarantine<th>tets<th>seconds<th></tr>\n";
  const wire::QueryReply reply = ask(context, wire::Query::JOBS);
  for (const wire::JobStatus& job : reply.jobs()) {
    text += "<tr>" + cell(job.job()) + cell(job.name()) + cell(job.state()) + cell(job.stage()) +
            cell(std::to_string(job.tasks_done())) + cell(std::to_string(job.tasks_running())) +
            cell(std::to_string(job.tasks_ready())) + cell(std::to_string(job.quarantine_size())) +
            cell(std::to_string(job.elements())) + cell(number(job.seconds())) +
            cell(job.message()) + "</tr>\n";
  }
  return text + "</table>\n" + (reply.next() != 0 ? "<p>… and more</p>\n" : "");
}

/// The job whose tree is shown: the newest that runs, else the newest.
JobId job_to_show(const DurableState& rows) {
  JobId shown;
  for (const auto& [id, job] : rows.jobs) {
    const bool is_better =
        !shown || job.phase == JobPhase::running || rows.jobs.at(shown).phase != JobPhase::running;
    if (is_better) shown = id;
  }
  return shown;
}

/// Each sub-domain below its parent, as wide as its share of the tree.
std::string tree_picture(const QueryContext& context) {
  const JobId job = job_to_show(context.state.durable());
  std::string boxes;
  std::size_t nodes = 0;
  int levels = 0;
  for (const SubdomainRow& row : context.history.tree(job)) {
    if (++nodes > most_nodes) continue;
    const int level = static_cast<int>(std::bit_width(row.path)) - 1;
    levels = std::max(levels, level + 1);
    const double share =
        width / static_cast<double>(std::uint64_t{1} << static_cast<unsigned>(level));
    const auto place =
        static_cast<double>(row.path - (std::uint64_t{1} << static_cast<unsigned>(level)));
    boxes += box(row.meshed ? "meshed" : name_of(row.state), place * share, level * row_height,
                 share - 1, row_height - 2,
                 "sub-domain " + tree_path(row.path) + ": " +
                     (row.meshed ? std::to_string(row.tets) + " tets" : name_of(row.state)));
  }
  if (nodes == 0) return {};
  return "<h2>Tree of " + job_name(job) + "</h2>\n" +
         (nodes > most_nodes ? "<p>the first " + std::to_string(most_nodes) + " of " +
                                   std::to_string(nodes) + " sub-domains</p>\n"
                             : "") +
         "<svg width=\"" + number(width) + "\" height=\"" + number(levels * row_height) + "\">\n" +
         boxes + "</svg>\n";
}

std::string workers_table(const QueryContext& context) {
  std::string text =
      "<h2>Workers</h2><table><tr><th>worker<th>host<th>state<th>task<th>doing<th>done"
      "<th>failed attempts<th>busy seconds</tr>\n";
  const wire::QueryReply reply = ask(context, wire::Query::WORKERS);
  for (const wire::WorkerLine& worker : reply.workers()) {
    text += "<tr>" + cell("worker-" + std::to_string(worker.worker())) + cell(worker.host()) +
            cell(worker.state()) + cell(worker.task() == 0 ? "" : std::to_string(worker.task())) +
            cell(doing_text(worker.doing())) + cell(std::to_string(worker.done())) +
            cell(std::to_string(worker.not_done())) + cell(number(worker.busy_seconds())) +
            "</tr>\n";
  }
  return text + "</table>\n" + (reply.next() != 0 ? "<p>… and more</p>\n" : "");
}

/// A row for each process that worked lately, a box for each attempt.
std::string timeline(const QueryContext& context) {
  const std::uint64_t last = context.state.durable().last_attempt;
  std::vector<wire::AttemptLine> attempts;
  std::uint64_t after = last > newest_attempts ? last - newest_attempts : 0;
  do {
    const wire::QueryReply page = ask(context, wire::Query::ATTEMPTS, after);
    attempts.insert(attempts.end(), page.attempts().begin(), page.attempts().end());
    after = page.next();
  } while (after != 0);
  if (attempts.empty()) return {};
  std::map<std::pair<std::string, std::int64_t>, int> process2row;
  std::int64_t begin = attempts.front().started_ms();
  for (const wire::AttemptLine& attempt : attempts) {
    process2row.try_emplace({attempt.host(), attempt.process()}, 0);
    begin = std::min(begin, attempt.started_ms());
  }
  int rows = 0;
  for (auto& [process, row] : process2row) row = rows++;
  const double span = std::max<double>(1, static_cast<double>(context.now.wall_ms - begin));
  std::string boxes;
  for (const wire::AttemptLine& attempt : attempts) {
    const bool runs = attempt.state() == "running";
    const std::int64_t end = runs ? context.now.wall_ms : attempt.ended_ms();
    const double x = width * static_cast<double>(attempt.started_ms() - begin) / span;
    const double w = width * static_cast<double>(end - attempt.started_ms()) / span;
    const std::string look = runs                        ? attempt.kind() + " running"
                             : attempt.state() == "done" ? attempt.kind()
                                                         : "bad";
    const int row = process2row.at({attempt.host(), attempt.process()});
    boxes += box(look, x, row * row_height, w, row_height - 2,
                 attempt.kind() + (attempt.path() == 0 ? "" : " ") +
                     task_place(attempt.kind(), attempt.path()) + ", task " +
                     std::to_string(attempt.task()) + " on " + attempt.host() + ": " +
                     attempt.state() + " " + attempt.message());
  }
  return "<h2>The last " + number(span / 1000) + " s</h2>\n<svg width=\"" + number(width) +
         "\" height=\"" + number(rows * row_height) + "\">\n" + boxes + "</svg>\n";
}

}  // namespace

std::string in_html(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string status_page(const QueryContext& context) {
  std::string text = head;
  if (context.state.is_stuck()) {
    text +=
        "<p><b>No tasks are handed out: " + in_html(context.state.stuck_message()) + "</b></p>\n";
  }
  return text + jobs_table(context) + tree_picture(context) + workers_table(context) +
         timeline(context) +
         "<p>For programs: <code>/metrics</code>, <code>/healthz</code>, "
         "<code>/readyz</code></p></body></html>\n";
}

}  // namespace tetfarm
