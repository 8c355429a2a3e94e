#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/job_input.h"
#include "cli/progress_display.h"
#include "mesh/decompose/decomposition_plan.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/io/read_surface.h"
#include "worker/inspect_task.h"
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
};

SurfaceMesh domain_of(const JobInput& input, CheckedSurface checked) {
  const OuterBoundary outer = outer_boundary_of(input.job);
  if (outer.kind == OuterBoundary::Kind::none) return std::move(checked.surface);
  return add_outer_boundary(checked.surface, outer, input.job.growth);
}

Plan make_plan(const JobInput& input) {
  CheckedSurface checked =
      check_surface(read_surface_bytes(input.surface, input.path), region_rules_of(input.job));
  if (!checked.report.defects.empty()) {
    throw Error(ExitCode::bad_geometry, input.path + ": " + defect_message(checked.report.defects));
  }
  const SurfaceMesh domain = domain_of(input, std::move(checked));
  const SpacingField spacing = make_spacing_field(domain, spacing_options_of(input.job));
  const Subdomain root = root_subdomain(domain);
  Plan plan;
  plan.groups = input.job.groups;
  plan.across_cuts = input.job.across_cuts;
  plan.input_bytes = static_cast<double>(input.surface.size());
  plan.root = {estimated_elements(root, spacing), static_cast<double>(root.triangles.size()),
               static_cast<double>(spacing.to_bytes().size())};
  require_room(input.job, plan.input_bytes, plan.root);
  const auto most_bytes = static_cast<double>(input.job.max_memory_bytes);
  const std::int64_t parts =
      most_bytes > 0 ? parts_for_memory(plan.root, most_bytes)
                     : wanted_parts(input.job, plan.root.elements, region_count(domain));
  plan.tree = plan_decomposition(
      root, spacing, parts, [&](double elements, double triangles, std::int64_t wanted) {
        if (most_bytes == 0) return wanted;
        return parts_for_memory({elements, triangles, plan.root.spacing_bytes}, most_bytes);
      });
  return plan;
}

SubdomainSize size_of_node(const Plan& plan, const PlannedSubdomain& node) {
  return {node.elements, node.triangles, plan.root.spacing_bytes};
}

/// What all tasks of a kind come to: their number, the largest memory, the sum of the seconds.
struct KindCost {
  std::size_t count = 0;
  TaskCost cost;

  void add(const TaskCost& task) {
    ++count;
    cost.bytes = std::max(cost.bytes, task.bytes);
    cost.seconds += task.seconds;
  }
};

std::vector<SubdomainSize> leaves_of_tree(const Plan& plan) {
  std::vector<SubdomainSize> leaves;
  for (const PlannedSubdomain& node : plan.tree) {
    if (node.parts == 1) leaves.push_back(size_of_node(plan, node));
  }
  return leaves;
}

double sum_of_triangles(const std::vector<SubdomainSize>& leaves) {
  double sum = 0;
  for (const SubdomainSize& leaf : leaves) sum += leaf.triangles;
  return sum;
}

/// Groups of equal work. Surfaces of joined leaves grow as the power 2/3 of their number.
std::vector<SubdomainSize> joined(const Plan& plan, const std::vector<SubdomainSize>& leaves) {
  const auto groups = static_cast<double>(plan.groups);
  const double in_group = std::max(1.0, static_cast<double>(leaves.size()) / groups);
  const double triangles = sum_of_triangles(leaves) / groups / std::cbrt(in_group);
  const SubdomainSize group{plan.root.elements / groups, triangles, plan.root.spacing_bytes};
  return std::vector<SubdomainSize>(static_cast<std::size_t>(plan.groups), group);
}

using KindCosts = std::vector<std::pair<const char*, KindCost>>;

/// In the order in which the kinds of tasks come.
KindCosts cost_of_kinds(const Plan& plan) {
  KindCost inspect;
  KindCost decompose;
  KindCost assimilate;
  KindCost mesh;
  KindCost order;
  KindCost extract;
  KindCost cosmetic;
  KindCost number;
  KindCost write;
  KindCost assemble;
  inspect.add(inspect_cost(plan.input_bytes, plan.root.triangles, plan.root.spacing_bytes));
  for (const PlannedSubdomain& node : plan.tree) {
    if (node.parts > 1) decompose.add(decompose_cost(size_of_node(plan, node)));
  }
  std::vector<SubdomainSize> leaves = leaves_of_tree(plan);
  if (plan.groups > 0) {
    const double triangles = sum_of_triangles(leaves);
    leaves = joined(plan, leaves);
    assimilate.add(assimilate_cost(triangles, leaves.front().triangles));
  }
  const bool has_turns = plan.across_cuts && leaves.size() > 1;
  if (has_turns) order.add(order_cost(sum_of_triangles(leaves)));
  SubdomainSize largest;
  for (const SubdomainSize& leaf : leaves) {
    mesh.add(mesh_cost(leaf));
    write.add(write_cost(plan.root.triangles, leaf.elements));
    if (leaf.elements > largest.elements) largest = leaf;
    if (!has_turns) continue;
    extract.add(extract_cost(leaf.elements, leaf.triangles));
    cosmetic.add(cosmetic_cost(turn_elements(leaf), leaf.spacing_bytes));
  }
  number.add(number_cost(plan.root.triangles));
  assemble.add(assemble_cost(plan.root.triangles, plan.root.elements, largest));
  KindCosts all = {{"inspect", inspect},   {"decompose", decompose}, {"assimilate", assimilate},
                   {"mesh", mesh},         {"order", order},         {"extract", extract},
                   {"cosmetic", cosmetic}, {"number", number},       {"write", write},
                   {"assemble", assemble}};
  std::erase_if(all, [](const auto& kind) { return kind.second.count == 0; });
  return all;
}

TaskCost cost_of_node(const Plan& plan, const PlannedSubdomain& node) {
  const SubdomainSize size = size_of_node(plan, node);
  return node.parts > 1 ? decompose_cost(size) : mesh_cost(size);
}

void print_json(const JobInput& input, const Plan& plan) {
  Json json = {{"type", "plan"},
               {"name", input.job.name},
               {"estimated_elements", plan.root.elements},
               {"groups", plan.groups},
               {"max_memory_bytes", input.job.max_memory_bytes},
               {"subdomains", Json::array()},
               {"tasks", Json::object()}};
  for (const PlannedSubdomain& node : plan.tree) {
    const TaskCost cost = cost_of_node(plan, node);
    json["subdomains"].push_back({{"path", node.path.text()},
                                  {"parts", node.parts},
                                  {"elements", node.elements},
                                  {"triangles", node.triangles},
                                  {"bytes", cost.bytes},
                                  {"seconds", cost.seconds}});
  }
  for (const auto& [kind, total] : cost_of_kinds(plan)) {
    json["tasks"][kind] = {
        {"count", total.count}, {"bytes", total.cost.bytes}, {"seconds", total.cost.seconds}};
  }
  std::printf("%s\n", json.dump().c_str());
}

void print_text(const Plan& plan) {
  std::printf("%-32s %-10s %10s %10s %9s %8s\n", "sub-domain", "task", "elements", "triangles",
              "MB", "seconds");
  std::size_t lines = 0;
  for (const PlannedSubdomain& node : plan.tree) {
    if (++lines > most_lines) {
      std::printf("... and %zu more (--json has them all)\n", plan.tree.size() - most_lines);
      break;
    }
    const TaskCost cost = cost_of_node(plan, node);
    const std::string name =
        std::string(static_cast<std::size_t>(node.path.depth()), ' ') + node.path.text();
    const char* leaf_task = plan.groups > 0 ? "assimilate" : "mesh";
    std::printf("%-32s %-10s %10s %10s %9.0f %8.2f\n", name.c_str(),
                node.parts > 1 ? "decompose" : leaf_task, short_count(node.elements).c_str(),
                short_count(node.triangles).c_str(), cost.bytes / 1e6, cost.seconds);
  }
  std::printf("\n%-12s %8s %16s %12s\n", "tasks", "number", "MB, at most", "seconds");
  double seconds = 0;
  for (const auto& [kind, total] : cost_of_kinds(plan)) {
    seconds += total.cost.seconds;
    std::printf("%-12s %8zu %16.0f %12.2f\n", kind, total.count, total.cost.bytes / 1e6,
                total.cost.seconds);
  }
  std::printf("\nabout %s elements, %.1f s of one core\n", short_count(plan.root.elements).c_str(),
              seconds);
}

}  // namespace

ExitCode plan_command(const PlanCommand& command) {
  const JobInput input = read_job(command.job);
  const Plan plan = make_plan(input);
  if (command.job.json) {
    print_json(input, plan);
  } else {
    print_text(plan);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
