#include "cli/job_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/angle_text.h"
#include "base/counted.h"
#include "base/file_system.h"
#include "base/printable_text.h"
#include "base/utf8.h"
#include "cli/coloured_text.h"
#include "cli/json_line.h"
#include "cli/printable_reply.h"
#include "cli/progress_display.h"
#include "cli/quality_gates.h"
#include "cli/running_report.h"
#include "cli/surface_angles.h"
#include "cli/text_table.h"
#include "mesh/core/subdomain.h"
#include "store/artifact_store.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_remark = 600;

double number_of(const wire::JobStatus& status, const std::string& name) {
  const auto found = status.numbers().find(name);
  return found == status.numbers().end() ? 0 : found->second;
}

std::string text_of(const wire::JobStatus& status, const std::string& name) {
  const auto found = status.texts().find(name);
  return found == status.texts().end() ? "" : found->second;
}

/// A place by its three numbers.
std::array<double, 3> place_of(const wire::JobStatus& status, const std::string& what) {
  return {number_of(status, what + "_x"), number_of(status, what + "_y"),
          number_of(status, what + "_z")};
}

std::string line_of(const Json& json) { return json_line(json); }

/// The figures that assembly reports under names that begin with `whose`; null when there are none.
Json shapes_json(const wire::JobStatus& status, const std::string& whose) {
  if (!status.numbers().contains(whose + "elements")) return nullptr;
  Json json;
  json["elements"] = static_cast<std::int64_t>(number_of(status, whose + "elements"));
  for (const char* name :
       {"min_dihedral_deg", "max_dihedral_deg", "mean_radius_ratio", "smallest_height"}) {
    json[name] = number_of(status, whose + name);
  }
  json["dihedral_histogram"] = Json::array();
  std::istringstream counts(text_of(status, whose + "dihedral_histogram"));
  for (std::int64_t count = 0; counts >> count;) json["dihedral_histogram"].push_back(count);
  return json;
}

std::string region_prefix(int region) { return "region_" + std::to_string(region) + "_"; }

/// Empty unless the domain has several regions, or named ones.
Json regions_json(const wire::JobStatus& status) {
  Json json = Json::array();
  for (int i = 1; status.texts().contains(region_prefix(i) + "name"); ++i) {
    Json region = {{"number", i},
                   {"name", text_of(status, region_prefix(i) + "name")},
                   {"volume", number_of(status, region_prefix(i) + "volume")}};
    region.update(shapes_json(status, region_prefix(i)));
    json.push_back(region);
  }
  return json;
}

/// What is said of sub-domains under such a mark, by their ways from the root: "uncut:", why they
/// could not be cut; "cut_further:", why they were cut though that was not planned.
std::vector<std::pair<std::string, std::string>> said_of_subdomains(const wire::JobStatus& status,
                                                                    std::string_view mark) {
  std::map<std::uint64_t, std::string> by_heap;
  for (const auto& [name, text] : status.texts()) {
    if (name.starts_with(mark)) by_heap[std::stoull(name.substr(mark.size()))] = text;
  }
  std::vector<std::pair<std::string, std::string>> said;
  for (const auto& [heap, reason] : by_heap) said.emplace_back(TreePath{heap}.text(), reason);
  return said;
}

/// A line for each of the first few, and one for all others.
std::string subdomains_text(const wire::JobStatus& status, std::string_view mark,
                            const std::string& what) {
  constexpr std::size_t most_lines = 5;
  const auto said = said_of_subdomains(status, mark);
  std::string text;
  for (std::size_t i = 0; i < std::min(most_lines, said.size()); ++i) {
    text += "           sub-domain " + said[i].first + " " + what + said[i].second + "\n";
  }
  if (said.size() <= most_lines) return text;
  return text + "           and " + std::to_string(said.size() - most_lines) +
         " more (--json lists all)\n";
}

Json said_json(const wire::JobStatus& status, std::string_view mark) {
  Json json = Json::object();
  for (const auto& [path, said] : said_of_subdomains(status, mark)) json[path] = said;
  return json;
}

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[240];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

std::string indented(const std::string& text) { return "           " + text + "\n"; }

/// The range of all dihedral angles, in red where it ends within a degree of flat.
std::string angles_text(const wire::JobStatus& status, bool is_coloured) {
  constexpr double bad_deg = 1;
  const double smallest = number_of(status, "min_dihedral_deg");
  const double largest = number_of(status, "max_dihedral_deg");
  const bool is_bad = smallest < bad_deg || largest > 180 - bad_deg;
  return red("dihedral " + angle_text(smallest) + " to " + angle_text(largest) + " deg",
             is_coloured && is_bad);
}

/// Where the smallest angle is, whether the surface is the cause, and what the rest is like; empty
/// when it is a good one.
std::string worst_text(const wire::JobStatus& status) {
  constexpr double good_deg = 20;
  const double smallest = number_of(status, "min_dihedral_deg");
  if (smallest >= good_deg) return "";
  const auto place = [&status](const std::string& what) {
    const auto at = place_of(status, what);
    return format("(%.6g, %.6g, %.6g)", at[0], at[1], at[2]);
  };
  std::string worst = "worst " + angle_text(smallest) + " deg at " + place("worst");
  const double forced = number_of(status, "forced_dihedral_deg");
  if (forced < good_deg) {
    worst += "; the surface allows at most " + angle_text(forced) + " deg, at " + place("forced");
  }
  std::string text = indented(worst);
  const double unforced = number_of(status, "unforced_min_dihedral_deg");
  if (number_of(status, "unforced_elements") > 0 && unforced > smallest) {
    text += indented("where the surface forces no small angles: smallest dihedral " +
                     angle_text(unforced) + " deg, at " + place("unforced_worst"));
  }
  return text;
}

std::string near_cuts_text(const wire::JobStatus& status) {
  if (!status.numbers().contains("near_cuts_elements")) return "";
  return indented("near the cuts: smallest dihedral " +
                  angle_text(number_of(status, "near_cuts_min_dihedral_deg")) +
                  format(" deg, smallest height %.4g; elsewhere: ",
                         number_of(status, "near_cuts_smallest_height")) +
                  angle_text(number_of(status, "away_from_cuts_min_dihedral_deg")) +
                  format(" deg, %.4g", number_of(status, "away_from_cuts_smallest_height")));
}

/// Of the tets where the surface forces no small angles; null when there are none.
Json unforced_json(const wire::JobStatus& status) {
  if (number_of(status, "unforced_elements") == 0) return nullptr;
  return {{"elements", static_cast<std::int64_t>(number_of(status, "unforced_elements"))},
          {"min_dihedral_deg", number_of(status, "unforced_min_dihedral_deg")},
          {"worst_at", place_of(status, "unforced_worst")}};
}

Json gates_json(const wire::JobStatus& status) {
  Json json = Json::array();
  for (const QualityGate& gate : quality_gates_of(status)) {
    json.push_back({{"key", gate.key},
                    {"limit_deg", gate.limit_deg},
                    {"smallest_deg", gate.smallest_deg},
                    {"at", gate.at},
                    {"passed", gate.is_passed()}});
  }
  return json;
}

/// How evenly the work is spread, largest over mean, and what the assimilation came to.
Json balance_json(const wire::JobStatus& status) {
  Json json = Json::object();
  for (const auto& [key, name] :
       {std::pair{"estimated", "balance_estimated"}, std::pair{"elements", "balance_elements"}}) {
    if (status.numbers().contains(name)) json[key] = number_of(status, name);
  }
  if (!status.numbers().contains("assimilated_groups")) return json;
  const auto ratio = [&](const std::string& what) {
    return number_of(status, what + "_max") / number_of(status, what + "_mean");
  };
  json["faces"] = ratio("assimilated_faces");
  json["leaves"] = number_of(status, "assimilated_leaves");
  json["leaves_estimated"] = ratio("assimilated_leaf_estimated");
  json["leaves_faces"] = ratio("assimilated_leaf_faces");
  json["communication_nodes_max"] = number_of(status, "assimilated_communication_nodes_max");
  json["communication_nodes_sum"] = number_of(status, "assimilated_communication_nodes_sum");
  return json;
}

/// What each kind of task took, and what it was expected to take (worker/task_cost.h).
Json tasks_json(const wire::JobStatus& status) {
  Json json = Json::object();
  for (const TaskKind kind : all_task_kinds) {
    const std::string prefix = std::string("task_") + name_of(kind);
    if (!status.numbers().contains(prefix + "_count")) continue;
    Json& task = json[name_of(kind)];
    for (const char* name : {"count", "bytes", "expected_bytes", "of_expected_bytes", "seconds",
                             "cpu_seconds", "expected_seconds"}) {
      task[name] = number_of(status, prefix + "_" + name);
    }
  }
  return json;
}

/// The task that needed most, beside what it was expected to need.
std::string memory_text(const wire::JobStatus& status) {
  double bytes = 0;
  double bound = 0;
  const Json tasks = tasks_json(status);
  for (const Json& task : tasks) {
    bytes = std::max(bytes, task["bytes"].get<double>());
    bound = std::max(bound, task["expected_bytes"].get<double>());
  }
  return format("memory of a task: at most %.0f MB; expected limit %.0f MB", bytes / 1e6,
                bound / 1e6);
}

/// The same as a line for a person; empty while nothing is known.
std::string balance_text(const wire::JobStatus& status) {
  const auto& numbers = status.numbers();
  if (!numbers.contains("balance_estimated")) return {};
  std::string text =
      format("largest/mean: %.3f of estimated elements", number_of(status, "balance_estimated"));
  if (numbers.contains("balance_elements")) {
    text += format(", %.3f of elements", number_of(status, "balance_elements"));
  }
  if (!numbers.contains("assimilated_groups")) return text;
  const Json json = balance_json(status);
  return text +
         format(", %.3f of faces; %.0f leaves in %.0f groups, at most %.0f communication nodes",
                json["faces"].get<double>(), number_of(status, "assimilated_leaves"),
                number_of(status, "assimilated_groups"),
                number_of(status, "assimilated_communication_nodes_max"));
}

}  // namespace

std::string result_json(const wire::JobStatus& status, double seconds,
                        const std::vector<std::filesystem::path>& files) {
  Json json = {{"type", "result"}, {"job", status.job()}, {"name", status.name()}};
  for (const char* name : {"elements", "nodes", "boundary_triangles", "subdomains"}) {
    json[name] = static_cast<std::int64_t>(number_of(status, name));
  }
  for (const char* name : {"min_dihedral_deg", "max_dihedral_deg", "mean_radius_ratio", "volume"}) {
    json[name] = number_of(status, name);
  }
  json["worst_at"] = place_of(status, "worst");
  json["forced_dihedral_deg"] = number_of(status, "forced_dihedral_deg");
  json["forced_at"] = place_of(status, "forced");
  json["smallest_height"] = number_of(status, "smallest_height");
  json["surface"] = surface_angles_json(surface_angles_of(status));
  json["unforced"] = unforced_json(status);
  json["gates"] = gates_json(status);
  json["remarks"] = angle_remarks(surface_angles_of(status));
  json["near_cuts"] = shapes_json(status, "near_cuts_");
  json["away_from_cuts"] = shapes_json(status, "away_from_cuts_");
  json["regions"] = regions_json(status);
  json["uncut_subdomains"] = said_json(status, "uncut:");
  json["cut_further"] = said_json(status, "cut_further:");
  json["seconds"] = seconds;
  json["peak_rss_bytes_worker"] = status.peak_rss_bytes_worker();
  json["attempts_lost"] = status.attempts_lost();
  json["balance"] = balance_json(status);
  json["tasks"] = tasks_json(status);
  json["digest"] = text_of(status, "digest");
  json["files"] = Json::array();
  for (const std::filesystem::path& file : files) json["files"].push_back(file.string());
  return line_of(json);
}

Json quarantine_json(const wire::JobStatus& status) {
  Json list = Json::array();
  for (const wire::TaskInQuarantine& task : status.quarantine()) {
    list.push_back({{"task", task.task()},
                    {"kind", task.kind()},
                    {"path", task.path()},
                    {"reason", task.reason()},
                    {"exit_code", task.exit_code()}});
  }
  return list;
}

std::string status_json(const wire::JobStatus& status) {
  const Json json = {{"type", "job"},
                     {"job", status.job()},
                     {"name", status.name()},
                     {"state", status.state()},
                     {"stage", status.stage()},
                     {"subdomains", status.leaves_made()},
                     {"subdomains_meshed", status.leaves_meshed()},
                     {"subdomains_mended", status.leaves_mended()},
                     {"elements", status.elements()},
                     {"estimated_elements", status.estimated_elements()},
                     {"expected_task_bytes", number_of(status, "forecast_bytes")},
                     {"expected_disk_bytes", number_of(status, "forecast_disk_bytes")},
                     {"expected_cpu_seconds", number_of(status, "forecast_seconds")},
                     {"tasks_done", status.tasks_done()},
                     {"tasks_ready", status.tasks_ready()},
                     {"tasks_running", status.tasks_running()},
                     {"attempts_lost", status.attempts_lost()},
                     {"crashes", status.crashes()},
                     {"out_of_memory", status.oom_count()},
                     {"quarantine", quarantine_json(status)},
                     {"running", running_json(status)},
                     {"elements_under_way", status.elements_under_way()},
                     {"peak_rss_bytes_worker", status.peak_rss_bytes_worker()},
                     {"seconds", status.seconds()},
                     {"balance", balance_json(status)},
                     {"cut_further", said_json(status, "cut_further:")},
                     {"message", status.message()},
                     {"exit_code", status.exit_code()}};
  return line_of(json);
}

std::string result_text(const wire::JobStatus& said, double seconds,
                        const std::vector<std::filesystem::path>& files, bool is_coloured) {
  const wire::JobStatus status = printable_reply(said);
  std::string text =
      format("done       %s tets, %s nodes, %s, ",
             short_count(number_of(status, "elements")).c_str(),
             short_count(number_of(status, "nodes")).c_str(),
             counted(static_cast<std::uint64_t>(number_of(status, "subdomains")), "sub-domain")
                 .c_str()) +
      angles_text(status, is_coloured) +
      format(", mean radius ratio %.3f   %s\n", number_of(status, "mean_radius_ratio"),
             clock_text(seconds).c_str());
  text += worst_text(status);
  for (const std::string& remark : angle_remarks(surface_angles_of(status))) {
    text += indented(harmless(remark, longest_remark));
  }
  text += near_cuts_text(status);
  for (int i = 1; status.texts().contains(region_prefix(i) + "name"); ++i) {
    text += indented(text_of(status, region_prefix(i) + "name") + ": " +
                     short_count(number_of(status, region_prefix(i) + "elements")) +
                     " tets, smallest dihedral " +
                     angle_text(number_of(status, region_prefix(i) + "min_dihedral_deg")) + " deg");
  }
  text += subdomains_text(status, "cut_further:", "was cut further than planned: ");
  text += subdomains_text(status, "uncut:", "is larger than planned; it was not cut: ");
  text += "           " + memory_text(status) + "\n";
  if (number_of(status, "subdomains") > 1) text += "           " + balance_text(status) + "\n";
  for (const std::filesystem::path& file : files) {
    text += "           " + printable(file.string()) + "\n";
  }
  return text;
}

std::string farm_json(const wire::StatusReply& reply) {
  Json json = {{"type", "farm"},
               {"workers", reply.workers()},
               {"jobs", reply.jobs_size()},
               {"security", reply.security()},
               {"connections", reply.connections()},
               {"authorized_keys", reply.authorized_keys()},
               {"refused", Json::object()}};
  // A map of the wire has no order of its own.
  const std::map<std::string, std::uint64_t> refused(reply.refused().begin(),
                                                     reply.refused().end());
  for (const auto& [kind, count] : refused) json["refused"][kind] = count;
  if (!reply.trouble().empty()) json["trouble"] = reply.trouble();
  return line_of(json);
}

std::string status_text(const wire::StatusReply& said) {
  const wire::StatusReply reply = printable_reply(said);
  std::string text = counted(reply.workers(), "worker") + ", " +
                     counted(static_cast<std::uint64_t>(reply.jobs_size()), "job") +
                     format(", messages and handshakes refused: %llu\n",
                            static_cast<unsigned long long>(reply.dropped_messages()));
  if (!reply.trouble().empty()) text += reply.trouble() + "\n";
  if (reply.security() == "insecure") {
    text +=
        "INSECURE: anyone who can reach this coordinator may submit and cancel jobs and hand in "
        "results\n";
  }
  for (const wire::JobStatus& status : reply.jobs()) {
    text += format("%-8s %-20s %-10s ", status.job().c_str(),
                   std::string(cut_utf8(status.name(), 60)).c_str(), status.state().c_str()) +
            progress_text(status, 0) + "\n";
    const std::string forecast = status.state() == "running" ? forecast_text(status) : "";
    if (!forecast.empty()) text += "         expected: " + forecast + "\n";
    if (status.leaves_made() > 1) text += "         " + balance_text(status) + "\n";
    text += running_tasks_text(status);
    if (!status.message().empty()) text += "         " + status.message() + "\n";
    if (status.state() != "running") continue;  // its message names them
    for (const wire::TaskInQuarantine& task : status.quarantine()) {
      text += "         in quarantine: task " + std::to_string(task.task()) + ", " + task.kind() +
              (task.path() == 0 ? "" : " " + TreePath{task.path()}.text()) + ": " + task.reason() +
              "\n";
    }
  }
  for (const wire::HostInQuarantine& host : reply.hosts()) {
    text += "host in quarantine: " + host.host() + ": " + host.reason() +
            " (tetfarm retry --host " + host.host() + ")\n";
  }
  return text;
}

std::string workers_text(const wire::StatusReply& said) {
  const wire::StatusReply reply = printable_reply(said);
  std::string text;
  for (const wire::WorkerStatus& worker : reply.at_work()) {
    text += format("worker-%-6llu %s process %lld, %llu MiB",
                   static_cast<unsigned long long>(worker.worker()), worker.host().c_str(),
                   static_cast<long long>(worker.process()),
                   static_cast<unsigned long long>(worker.memory_bytes() >> 20U));
    if (!worker.tag().empty()) text += " (" + worker.tag() + ")";
    if (worker.task() != 0) {
      text += format(", task %llu", static_cast<unsigned long long>(worker.task()));
    }
    text += worker.drains() ? ", draining\n" : "\n";
  }
  return text;
}

std::string farm_events_json(const wire::StatusReply& reply, bool with_workers) {
  std::string lines;
  for (const wire::HostInQuarantine& host : reply.hosts()) {
    lines += line_of({{"type", "host_in_quarantine"},
                      {"host", host.host()},
                      {"reason", host.reason()},
                      {"since_ms", host.since_ms()}}) +
             "\n";
  }
  if (!with_workers) return lines;
  for (const wire::WorkerStatus& worker : reply.at_work()) {
    lines += line_of({{"type", "worker"},
                      {"worker", "worker-" + std::to_string(worker.worker())},
                      {"host", worker.host()},
                      {"process", worker.process()},
                      {"task", worker.task()},
                      {"drains", worker.drains()},
                      {"memory_bytes", worker.memory_bytes()}}) +
             "\n";
  }
  return lines;
}

std::string copy_json(const std::string& what, const std::string& file) {
  return line_of({{"type", what}, {"file", file}});
}

std::string error_json(const std::string& message, int exit_code) {
  return line_of({{"type", "error"}, {"message", message}, {"exit_code", exit_code}});
}

std::vector<std::filesystem::path> deliver_files(const wire::JobStatus& status,
                                                 const std::filesystem::path& store_folder,
                                                 const std::filesystem::path& folder) {
  const ArtifactStore store = ArtifactStore::open_existing(store_folder);
  make_folders(folder);
  std::vector<std::filesystem::path> files;
  for (const wire::Artifact& artifact : status.files()) {
    const std::filesystem::path name = std::filesystem::path(artifact.name()).filename();
    if (name.empty() || name == "." || name == "..") continue;
    store.verify(artifact.hash(), artifact.size());
    link_or_copy_file(store.path_of(artifact.hash()), folder / name);
    files.push_back(folder / name);
  }
  return files;
}

}  // namespace tetfarm
