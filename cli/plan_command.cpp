#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/counted.h"
#include "base/mebibytes.h"
#include "cli/commands.h"
#include "cli/job_input.h"
#include "cli/layers_report.h"
#include "cli/progress_display.h"
#include "cli/seen_times.h"
#include "cli/unit_options.h"
#include "cli/wave_options.h"
#include "json/json_line.h"
#include "mesh/core/triangle_angles.h"
#include "mesh/decompose/decomposition_plan.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/inspect/defect_text.h"
#include "store/disk_room.h"
#include "tasks/task_kind.h"
#include "worker/checked_input.h"
#include "worker/inspect_task.h"
#include "worker/job_domain.h"
#include "worker/job_layers.h"
#include "worker/job_remeshing.h"
#include "worker/job_surface.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_lines = 200;

/// The tree, and what goes into the tasks that see more than one sub-domain.
struct Plan {
  std::vector<PlannedSubdomain> tree;
  double input_bytes = 0;
  SubdomainSize root;
  std::int64_t groups = 0;
  bool across_cuts = true;
  std::size_t chunks = 0;  ///< of layers
  double layer_cells = 0;
  JobForecast forecast;
  TaskTimes times;
  std::vector<LayerFigures> layers;
  std::optional<PmlFigures> pml;
  std::optional<WaveSize> wave;
  std::string remark;  ///< on edges that are too long for it
};

Plan make_plan(const JobInput& input) {
  const CheckedSurface checked =
      check_surface_of_job(input.job, read_surface_of_job(input.job, input.surface, input.path));
  if (!checked.report.defects.empty()) {
    throw Error(ExitCode::bad_geometry, input.path + ": " + defects_text(checked.report.defects));
  }
  const JobDomain domain = domain_of_job(input.job, surface_to_mesh(input.job, checked).surface);
  Plan plan;
  plan.wave = input.job.wave;
  plan.remark = remark_on_long_edges(input.job, checked.report.longest_edge);
  plan.layers = layer_figures_of(input.job, domain.surface);
  plan.groups = input.job.groups;
  plan.across_cuts = input.job.across_cuts;
  plan.input_bytes = static_cast<double>(input.surface.size());
  plan.root = {domain.elements, static_cast<double>(domain.root.triangles.size()),
               static_cast<double>(domain.spacing.to_bytes().size()),
               static_cast<double>(needle_count(domain.root.vertices, domain.root.triangles))};
  require_room(input.job, plan.input_bytes, plan.root);
  const auto most_bytes = static_cast<double>(input.job.max_memory_bytes);
  const std::int64_t parts = parts_of_job(input.job, plan.root, region_count(domain.surface));
  plan.forecast = forecast_of(input.job, plan.input_bytes, plan.root, static_cast<double>(parts));
  if (domain.layers) {
    add_layers(*domain.layers, plan.forecast);
    plan.pml = domain.layers->pml;
    plan.chunks = domain.layers->chunks.size();
    plan.layer_cells = static_cast<double>(domain.layers->cells);
  }
  plan.tree = plan_decomposition(
      domain.root, domain.spacing, parts,
      [&](double elements, double triangles, std::int64_t wanted) {
        if (most_bytes == 0) return wanted;
        return parts_for_memory({elements, triangles, plan.root.spacing_bytes}, most_bytes);
      });
  return plan;
}

/// Where the needles will be is not known: they are shared out by elements.
SubdomainSize size_of_node(const Plan& plan, const PlannedSubdomain& node) {
  const double share = plan.root.elements > 0 ? node.elements / plan.root.elements : 1;
  return {node.elements, node.triangles, plan.root.spacing_bytes, share * plan.root.needles};
}

/// What all tasks of a kind come to: their number, the largest memory, the sum of the seconds.
struct KindCost {
  const char* name = "";
  std::size_t count = 0;
  double bytes = 0;
  SecondsRange seconds;
};

/// The kinds in the order in which they come.
class Costs {
 public:
  explicit Costs(const TaskTimes& times) : times_(times) {}

  void add(const TaskCost& task) {
    KindCost& kind = kinds_.at(static_cast<std::size_t>(task.kind));
    kind.name = name_of(task.kind);
    ++kind.count;
    kind.bytes = std::max(kind.bytes, task.bytes);
    kind.seconds += times_.seconds(task.kind, task.size);
  }

  std::vector<KindCost> of_kinds() const {
    std::vector<KindCost> result;
    for (const KindCost& kind : kinds_) {
      if (kind.count > 0) result.push_back(kind);
    }
    return result;
  }

 private:
  const TaskTimes& times_;
  std::array<KindCost, all_task_kinds.size()> kinds_;
};

std::vector<SubdomainSize> leaves_of_tree(const Plan& plan) {
  std::vector<SubdomainSize> leaves;
  for (const PlannedSubdomain& node : plan.tree) {
    if (node.parts == 1) leaves.push_back(size_of_node(plan, node));
  }
  return leaves;
}

double most_triangles(const std::vector<SubdomainSize>& leaves) {
  double most = 0;
  for (const SubdomainSize& leaf : leaves) most = std::max(most, leaf.triangles);
  return most;
}

double sum_of_triangles(const std::vector<SubdomainSize>& leaves) {
  double sum = 0;
  for (const SubdomainSize& leaf : leaves) sum += leaf.triangles;
  return sum;
}

/// Groups of equal work. Surfaces of joined leaves grow as the power 2/3 of their number.
std::vector<SubdomainSize> joined(const Plan& plan, const std::vector<SubdomainSize>& leaves) {
  TF_CHECK(plan.groups > 0 && !leaves.empty());
  const auto groups = static_cast<double>(plan.groups);
  const double in_group = std::max(1.0, static_cast<double>(leaves.size()) / groups);
  const double triangles = sum_of_triangles(leaves) / groups / std::cbrt(in_group);
  const SubdomainSize group{plan.root.elements / groups, triangles, plan.root.spacing_bytes,
                            plan.root.needles / groups};
  return std::vector<SubdomainSize>(static_cast<std::size_t>(plan.groups), group);
}

/// The turn of a leaf; its memory is a bound, its seconds go by the elements that are expected near
/// the triangles of its cuts.
TaskCost turn_cost(const SubdomainSize& leaf, double cut_triangles) {
  constexpr double elements_near_triangle = 16;
  TaskCost cost = cosmetic_cost(turn_elements(leaf), leaf.spacing_bytes);
  cost.size.elements = std::min(cost.size.elements, elements_near_triangle * cut_triangles);
  return cost;
}

/// The tasks on leaves, of which there are as many as leaves.
void add_leaves(const Plan& plan, const std::vector<SubdomainSize>& leaves, Costs& costs) {
  TF_CHECK(!leaves.empty());
  const bool has_turns = plan.across_cuts && leaves.size() > 1;
  const double all_triangles = sum_of_triangles(leaves);
  if (has_turns) costs.add(order_cost(all_triangles, most_triangles(leaves)));
  const double cut_triangles =
      std::max(0.0, all_triangles - plan.root.triangles) / static_cast<double>(leaves.size());
  for (const SubdomainSize& leaf : leaves) {
    costs.add(mesh_cost(leaf));
    costs.add(write_cost(leaf.elements));
    if (!has_turns) continue;
    costs.add(extract_cost(leaf.elements, leaf.triangles));
    costs.add(turn_cost(leaf, cut_triangles));
  }
}

std::vector<KindCost> cost_of_kinds(const Plan& plan) {
  Costs costs(plan.times);
  costs.add(inspect_cost(plan.input_bytes, plan.root));
  for (const PlannedSubdomain& node : plan.tree) {
    if (node.parts > 1) costs.add(decompose_cost(size_of_node(plan, node)));
  }
  std::vector<SubdomainSize> leaves = leaves_of_tree(plan);
  if (plan.groups > 0) {
    const double triangles = sum_of_triangles(leaves);
    leaves = joined(plan, leaves);
    costs.add(assimilate_cost(triangles, leaves.front().triangles));
  }
  add_leaves(plan, leaves, costs);
  for (std::size_t i = 0; i < plan.chunks; ++i) {
    costs.add(grow_cost(plan.layer_cells / static_cast<double>(plan.chunks)));
  }
  const auto largest = std::max_element(
      leaves.begin(), leaves.end(),
      [](const SubdomainSize& a, const SubdomainSize& b) { return a.elements < b.elements; });
  TF_CHECK(largest != leaves.end());
  costs.add(number_cost(plan.root.triangles));
  costs.add(assemble_cost(plan.root.triangles, plan.forecast.elements, *largest));
  return costs.of_kinds();
}

SecondsRange sum_of(const std::vector<KindCost>& kinds) {
  SecondsRange sum;
  for (const KindCost& kind : kinds) sum += kind.seconds;
  return sum;
}

TaskCost cost_of_node(const Plan& plan, const PlannedSubdomain& node) {
  const SubdomainSize size = size_of_node(plan, node);
  return node.parts > 1 ? decompose_cost(size) : mesh_cost(size);
}

void put(const SecondsRange& seconds, Json& json) {
  json["seconds"] = seconds.expected;
  json["seconds_low"] = seconds.low;
  json["seconds_high"] = seconds.high;
}

void print_json(const JobInput& input, const Plan& plan) {
  Json json = {{"type", "plan"},
               {"name", input.job.name},
               {"estimated_elements", plan.forecast.elements},
               {"disk_bytes", plan.forecast.disk_bytes},
               {"surface_triangles", plan.root.triangles},
               {"needles", plan.root.needles},
               {"groups", plan.groups},
               {"max_memory_bytes", input.job.max_memory_bytes}};
  const std::vector<KindCost> kinds = cost_of_kinds(plan);
  put(sum_of(kinds), json);
  json["learnt_from_tasks"] = plan.times.learnt();
  put_lengths(input.job, json);
  put_wave(plan.wave, json);
  if (!plan.layers.empty()) json["layers"] = layers_json(plan.layers);
  if (plan.pml) json["pml"] = pml_json(*plan.pml);
  json["subdomains"] = Json::array();
  for (const PlannedSubdomain& node : plan.tree) {
    const TaskCost cost = cost_of_node(plan, node);
    json["subdomains"].push_back({{"path", node.path.text()},
                                  {"parts", node.parts},
                                  {"elements", node.elements},
                                  {"triangles", node.triangles},
                                  {"bytes", cost.bytes}});
    put(plan.times.seconds(cost.kind, cost.size), json["subdomains"].back());
  }
  json["tasks"] = Json::object();
  for (const KindCost& kind : kinds) {
    json["tasks"][kind.name] = {{"count", kind.count}, {"bytes", kind.bytes}};
    put(kind.seconds, json["tasks"][kind.name]);
  }
  std::printf("%s\n", json_line(json).c_str());
}

void print_tree(const Plan& plan) {
  std::printf("%-32s %-10s %10s %10s %9s %8s\n", "sub-domain", "task", "elements", "triangles",
              "MB", "seconds");
  std::size_t lines = 0;
  for (const PlannedSubdomain& node : plan.tree) {
    if (++lines > most_lines) {
      std::printf("... and %zu more (--json lists all)\n", plan.tree.size() - most_lines);
      break;
    }
    const TaskCost cost = cost_of_node(plan, node);
    const std::string name =
        std::string(static_cast<std::size_t>(node.path.depth()), ' ') + node.path.text();
    const char* leaf_task = plan.groups > 0 ? "assimilate" : "mesh";
    std::printf("%-32s %-10s %10s %10s %9.0f %8.2f\n", name.c_str(),
                node.parts > 1 ? "decompose" : leaf_task, short_count(node.elements).c_str(),
                short_count(node.triangles).c_str(), cost.bytes / 1e6,
                plan.times.seconds(cost.kind, cost.size).expected);
  }
}

void print_text(const JobFile& job, const Plan& plan, const std::string& store) {
  print_tree(plan);
  std::printf("\n%-12s %8s %16s %12s   %s\n", "tasks", "number", "MB, at most", "seconds", "range");
  const std::vector<KindCost> kinds = cost_of_kinds(plan);
  for (const KindCost& kind : kinds) {
    std::printf("%-12s %8zu %16.0f %12.2f   %s\n", kind.name, kind.count, kind.bytes / 1e6,
                kind.seconds.expected, range_text(kind.seconds.low, kind.seconds.high).c_str());
  }
  for (const LayerFigures& layers : plan.layers) {
    std::printf("\nlayers on %s", layers_text(layers).c_str());
  }
  if (plan.pml) std::printf("\npml on %s", pml_text(*plan.pml).c_str());
  if (!plan.layers.empty() || plan.pml) std::printf("\n");
  const std::string lengths = lengths_text(job);
  if (!lengths.empty()) std::printf("\nlengths %s\n", lengths.c_str());
  if (plan.wave) std::printf("\nsize %s\n", wave_size_text(*plan.wave).c_str());
  if (!plan.remark.empty()) std::printf("%s\n", plan.remark.c_str());
  const SecondsRange sum = sum_of(kinds);
  JobForecast forecast = plan.forecast;
  forecast.seconds = sum.expected;
  std::printf("\n%s\n%s on one core, most likely %s\n", forecast_text(forecast).c_str(),
              range_text(sum.low, sum.high).c_str(),
              range_text(sum.expected, sum.expected).c_str());
  if (plan.root.needles > 0) {
    std::printf(
        "%.0f of the surface's %.0f triangles have an angle below %g deg, which may take "
        "most of the time\n",
        plan.root.needles, plan.root.triangles, needle_deg);
  }
  if (store.empty()) {
    std::printf(
        "the times were measured with other surfaces on another machine; --store DIR takes them "
        "from the tasks of a store or the output folder of a run\n");
  } else {
    std::printf("times from %s of %s\n", counted(plan.times.learnt(), "task").c_str(),
                store.c_str());
  }
}

/// It need not be run here: nothing is refused.
void warn_of_small_disk(const Plan& plan, const std::string& output) {
  const DiskRoom room = disk_room(std::filesystem::absolute(output));
  if (room.has(static_cast<std::uint64_t>(std::min(plan.forecast.disk_bytes, 1e18)))) return;
  std::fprintf(stderr, "warning: the disk here has only %s free\n",
               mebibytes(room.free_bytes).c_str());
}

}  // namespace

ExitCode plan_command(const PlanCommand& command) {
  const JobInput input = read_job(command.job);
  TaskTimes times = times_seen_in(command.job.store, command.job.database);
  Plan plan = make_plan(input);
  plan.times = std::move(times);
  if (command.job.json) {
    print_json(input, plan);
  } else {
    print_text(input.job, plan, command.job.store);
  }
  warn_of_small_disk(plan, command.job.output);
  return ExitCode::ok;
}

}  // namespace tetfarm
