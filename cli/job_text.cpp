#include "cli/job_text.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/angle_text.h"
#include "base/counted.h"
#include "base/printable_text.h"
#include "base/utf8.h"
#include "cli/coloured_text.h"
#include "cli/printable_reply.h"
#include "cli/progress_display.h"
#include "cli/running_text.h"
#include "cli/text_table.h"
#include "json/job_json.h"
#include "json/quality_gates.h"
#include "json/reply_values.h"
#include "json/surface_angles.h"
#include "mesh/core/subdomain.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_remark = 600;

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

/// "1.2M tets"; of a mesh with layers all its cells.
std::string cells_text(const wire::JobStatus& status) {
  const auto& numbers = status.numbers();
  std::string text =
      short_count(number_of(status, numbers.contains("tets") ? "tets" : "elements")) + " tets";
  for (const char* name : {"pyramids", "prisms"}) {
    if (number_of(status, name) > 0) {
      text += ", " + short_count(number_of(status, name)) + " " + name;
    }
  }
  return text;
}

/// How well the prisms are shaped, and how the tets on top of them fit; empty where nobody knows.
std::string layer_shape_text(const wire::JobStatus& status) {
  std::string text;
  const auto tell = [&](const char* words, const char* name) {
    if (status.numbers().contains(name)) text += words + format("%.3g", number_of(status, name));
  };
  tell("; least Jacobian ", "layers_min_scaled_jacobian");
  tell(", of all but 1 % ", "layers_scaled_jacobian_1_percent");
  tell("; tets on top over last prisms: median ", "layers_top_jump_median");
  tell(", of all but 1 % ", "layers_top_jump_99");
  return text;
}

/// How much of the wall has the layers that were asked for; empty of a job without layers.
std::string wall_text(const wire::JobStatus& status) {
  if (!status.numbers().contains("layers_wall_triangles")) return {};
  const double with_first = number_of(status, "layers_with_first");
  const auto percent = [&](const char* name) {
    return format("%.2f %%", with_first > 0 ? 100 * number_of(status, name) / with_first : 0);
  };
  return indented("layers: all on " + short_count(number_of(status, "layers_full")) + " of " +
                  short_count(number_of(status, "layers_wall_triangles")) +
                  " triangles, fewer on " + short_count(number_of(status, "layers_partial")) +
                  ", none on " + short_count(number_of(status, "layers_none")) +
                  "; first height within 2 % on " + percent("layers_first_within_2") +
                  ", within 10 % on " + percent("layers_first_within_10") +
                  layer_shape_text(status));
}

/// What became of the planes that layers run in; empty where they run in none.
std::string planes_text(const wire::JobStatus& status) {
  if (!status.numbers().contains("layers_planes")) return {};
  const double quads = number_of(status, "layers_plane_quads");
  return indented("planes: layers run in " + short_count(number_of(status, "layers_planes")) +
                  ", whose " + short_count(number_of(status, "layers_plane_triangles_before")) +
                  " triangles are replaced by " +
                  short_count(number_of(status, "layers_plane_triangles_after")) +
                  (quads > 0 ? " and " + short_count(quads) + " quads" : ""));
}

/// Empty of a job without absorbing layers.
std::string pml_result_text(const wire::JobStatus& status) {
  if (!status.numbers().contains("pml_layers")) return {};
  const char* of_cells = number_of(status, "pml_prisms") > 0 ? "prisms" : "tets";
  return indented(format("pml: %.0f layers, %.4g high, %.4g together, ",
                         number_of(status, "pml_layers"), number_of(status, "pml_height"),
                         number_of(status, "pml_thickness")) +
                  short_count(number_of(status, "pml_cells")) + " " + of_cells);
}

}  // namespace

std::string result_text(const wire::JobStatus& said, double seconds,
                        const std::vector<std::filesystem::path>& files, bool is_coloured) {
  const wire::JobStatus status = printable_reply(said);
  std::string text =
      format("done       %s, %s nodes, %s, ", cells_text(status).c_str(),
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
  text += wall_text(status);
  text += planes_text(status);
  text += pml_result_text(status);
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
              (task.path() == 0 ? "" : " ") + task_place(task.kind(), task.path()) + ": " +
              task.reason() + "\n";
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

}  // namespace tetfarm
