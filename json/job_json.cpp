#include "json/job_json.h"

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "json/json_line.h"
#include "json/quality_gates.h"
#include "json/reply_values.h"
#include "json/running_json.h"
#include "json/surface_angles.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

template <class Names>
Json names_json(const Names& names) {
  Json json = Json::array();
  for (const auto& name : names) json.push_back(name);
  return json;
}

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

Json said_json(const wire::JobStatus& status, std::string_view mark) {
  Json json = Json::object();
  for (const auto& [path, said] : said_of_subdomains(status, mark)) json[path] = said;
  return json;
}

/// Of the tets where the surface forces no small angles; null when there are none.
Json unforced_json(const wire::JobStatus& status) {
  if (number_of(status, "unforced_elements") == 0) return nullptr;
  return {{"elements", static_cast<std::int64_t>(number_of(status, "unforced_elements"))},
          {"min_dihedral_deg", number_of(status, "unforced_min_dihedral_deg")},
          {"worst_at", place_of(status, "unforced_worst")}};
}

Json pml_json(const wire::JobStatus& status) {
  Json json = Json::object();
  json["layers"] = static_cast<std::int64_t>(number_of(status, "pml_layers"));
  for (const char* name : {"height", "thickness"}) {
    json[name] = number_of(status, std::string("pml_") + name);
  }
  for (const char* name : {"cells", "tets", "prisms", "outer_triangles"}) {
    json[name] = static_cast<std::int64_t>(number_of(status, std::string("pml_") + name));
  }
  return json;
}

/// Of a job with layers: its cells by type, its boundary quads where there are some, and how much
/// of the wall has what was asked for.
void add_layers(const wire::JobStatus& status, Json& json) {
  const auto whole = [&status](const std::string& name) {
    return static_cast<std::int64_t>(number_of(status, name));
  };
  const bool has_boundary_layers = status.numbers().contains("layers_wall_triangles");
  const bool has_pml = status.numbers().contains("pml_layers");
  if (!has_boundary_layers && !has_pml) return;
  json["tets"] = whole(status.numbers().contains("tets") ? "tets" : "elements");
  for (const char* name : {"pyramids", "prisms"}) json[name] = whole(name);
  if (status.numbers().contains("quads")) json["boundary_quads"] = whole("quads");
  if (has_pml) json["pml"] = pml_json(status);
  if (!has_boundary_layers) return;
  Json layers = Json::object();
  for (const char* name : {"wall_triangles", "full", "partial", "none"}) {
    layers[name] = whole(std::string("layers_") + name);
  }
  const std::string of_reason = "layers_short_";
  std::map<std::string, std::int64_t> reasons;
  for (const auto& [name, number] : status.numbers()) {
    if (!name.starts_with(of_reason)) continue;
    reasons[name.substr(of_reason.size())] = static_cast<std::int64_t>(number);
  }
  layers["by_reason"] = reasons;
  const double with_first = number_of(status, "layers_with_first");
  for (const char* share : {"2", "10"}) {
    const double within = number_of(status, std::string("layers_first_within_") + share);
    layers[std::string("first_height_within_") + share + "_percent"] =
        with_first > 0 ? 100 * within / with_first : 0;
  }
  for (const char* name : {"min_scaled_jacobian", "scaled_jacobian_1_percent",
                           "scaled_jacobian_median", "top_jump_median", "top_jump_99"}) {
    const std::string number = std::string("layers_") + name;
    if (status.numbers().contains(number)) layers[name] = number_of(status, number);
  }
  const double cpu_seconds = number_of(status, "task_grow_cpu_seconds");
  const double prisms = number_of(status, "prisms");
  if (cpu_seconds > 0 && prisms > 0) layers["prisms_per_second"] = prisms / cpu_seconds;
  if (status.numbers().contains("layers_planes")) {
    for (const char* name :
         {"planes", "plane_triangles_before", "plane_triangles_after", "plane_quads"}) {
      layers[name] = whole(std::string("layers_") + name);
    }
  }
  json["layers"] = layers;
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

}  // namespace

nlohmann::ordered_json balance_json(const wire::JobStatus& status) {
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

nlohmann::ordered_json tasks_json(const wire::JobStatus& status) {
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

std::string result_json(const wire::JobStatus& status, double seconds,
                        const std::vector<std::filesystem::path>& files) {
  Json json = {{"type", "result"}, {"job", status.job()}, {"name", status.name()}};
  for (const char* name : {"elements", "nodes", "boundary_triangles", "subdomains"}) {
    json[name] = static_cast<std::int64_t>(number_of(status, name));
  }
  add_layers(status, json);
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
  return json_line(json);
}

std::string status_json(const wire::JobStatus& status) {
  const Json json = {{"type", "job"},
                     {"job", status.job()},
                     {"name", status.name()},
                     {"state", status.state()},
                     {"stage", status.stage()},
                     {"priority", status.priority()},
                     {"after", names_json(status.after())},
                     {"waits_for", names_json(status.waits_for())},
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
  return json_line(json);
}

std::string job_json(const wire::JobStatus& job) {
  return json_line({{"type", "job"},
                    {"job", job.job()},
                    {"name", job.name()},
                    {"state", job.state()},
                    {"stage", job.stage()},
                    {"priority", job.priority()},
                    {"after", names_json(job.after())},
                    {"waits_for", names_json(job.waits_for())},
                    {"subdomains", job.leaves_made()},
                    {"subdomains_meshed", job.leaves_meshed()},
                    {"elements", job.elements()},
                    {"estimated_elements", job.estimated_elements()},
                    {"tasks_done", job.tasks_done()},
                    {"tasks_ready", job.tasks_ready()},
                    {"tasks_running", job.tasks_running()},
                    {"tasks_in_quarantine", job.quarantine_size()},
                    {"created_ms", job.created_ms()},
                    {"finished_ms", job.finished_ms()},
                    {"seconds", job.seconds()},
                    {"message", job.message()},
                    {"exit_code", job.exit_code()}});
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
  return json_line(json);
}

std::string farm_events_json(const wire::StatusReply& reply, bool with_workers) {
  std::string lines;
  for (const wire::HostInQuarantine& host : reply.hosts()) {
    lines += json_line({{"type", "host_in_quarantine"},
                        {"host", host.host()},
                        {"reason", host.reason()},
                        {"since_ms", host.since_ms()}}) +
             "\n";
  }
  if (!with_workers) return lines;
  for (const wire::WorkerStatus& worker : reply.at_work()) {
    lines += json_line({{"type", "worker"},
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
  TF_CHECK(!what.empty());
  return json_line({{"type", what}, {"file", file}});
}

std::string error_json(const std::string& message, int exit_code) {
  return json_line({{"type", "error"}, {"message", message}, {"exit_code", exit_code}});
}

}  // namespace tetfarm
