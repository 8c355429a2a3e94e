#include "coordinator/decisions/task_graph.h"

#include <algorithm>

#include "base/check.h"
#include "coordinator/decisions/assimilation_graph.h"
#include "coordinator/decisions/cosmetic_graph.h"
#include "coordinator/decisions/layer_graph.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/assemble_contract.h"
#include "tasks/assimilate_contract.h"
#include "tasks/decompose_contract.h"
#include "tasks/inspect_contract.h"
#include "tasks/mesh_contract.h"
#include "tasks/order_contract.h"
#include "tasks/remesh_contract.h"
#include "tasks/task_contracts.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

/// A number that is not told where it is 0.
std::optional<std::uint64_t> if_any(std::uint64_t count) {
  return count > 0 ? std::optional(count) : std::nullopt;
}

/// Of what is to become leaves; older versions told of none where it is one.
std::uint32_t at_least_one(std::uint64_t parts) {
  return static_cast<std::uint32_t>(std::max<std::uint64_t>(1, parts));
}

/// The wanted parts of the two sides are the parent's, as evenly as can be.
TaskRow decompose_task(const InspectMade& inspected, const SubdomainRow& subdomain,
                       std::uint64_t needles) {
  DecomposeGiven given;
  given.job = inspected.settings;
  given.subdomain = {subdomain.hash, subdomain.size};
  given.spacing = inspected.spacing;
  given.left_parts = subdomain.parts / 2;
  given.right_parts = subdomain.parts - given.left_parts;
  given.work = told_work(subdomain.work);
  given.most_bytes = if_any(inspected.most_bytes);
  given.needles = if_any(needles);
  return new_task(subdomain.job, subdomain.path, given);
}

TaskRow mesh_task(const InspectMade& inspected, const SubdomainRow& leaf, std::uint64_t needles) {
  MeshGiven given;
  given.job = inspected.settings;
  given.subdomain = {leaf.hash, leaf.size};
  given.spacing = inspected.spacing;
  given.work = told_work(leaf.work);
  given.needles = if_any(needles);
  return new_task(leaf.job, leaf.path, given);
}

/// Triangles with a small angle, as the task that made a sub-domain counted them, by its path.
using Needles = std::map<std::uint64_t, std::uint64_t>;

/// What is to be done with new sub-domains. Leaves that are to be assimilated wait for the others.
void add_tasks(const InspectMade& inspected, bool meshes_leaves, const Needles& needles,
               GraphStep& step) {
  for (const SubdomainRow& subdomain : step.subdomains) {
    if (subdomain.state == SubdomainState::open) {
      step.tasks.push_back(decompose_task(inspected, subdomain, needles.at(subdomain.path)));
    } else if (subdomain.state == SubdomainState::leaf && meshes_leaves) {
      step.tasks.push_back(mesh_task(inspected, subdomain, needles.at(subdomain.path)));
    }
  }
}

SubdomainRow new_subdomain(JobId job, std::uint64_t path, std::uint32_t parts, double work,
                           const TaskFile& file) {
  TF_CHECK(!file.hash.empty());
  SubdomainRow subdomain;
  subdomain.job = job;
  subdomain.path = path;
  subdomain.parts = parts;
  subdomain.work = work;
  subdomain.state = parts > 1 && path < deepest_cut ? SubdomainState::open : SubdomainState::leaf;
  subdomain.hash = file.hash;
  subdomain.size = file.size;
  return subdomain;
}

/// A half with the parts that the task found where memory decides, else as it was told.
SubdomainRow new_half(JobId job, std::uint64_t path, const DecomposeMade::Half& half,
                      std::uint64_t told_parts) {
  return new_subdomain(job, path, at_least_one(half.parts.value_or(told_parts)), half.work,
                       half.file);
}

/// Every leaf that the task was given has its turn.
std::optional<std::string> problem_with_order(const OrderGiven& given, const std::string& order) {
  const std::optional<TurnOrder> turns = turn_order_of(order);
  if (!turns) return "the order is missing or makes no sense";
  if (turns->size() != given.subdomains.size()) {
    return "the order has different leaves from the tree";
  }
  for (const auto& [leaf, turn] : *turns) {
    if (!given.subdomains.contains(leaf)) {
      return "the order has a leaf that the tree does not have";
    }
  }
  return std::nullopt;
}

std::optional<std::string> problem_with_inspected(const InspectMade& made) {
  if (made.parts < 1) return "the number of parts is 0";
  return problem_with_layers(made);
}

/// Those that a result of the kind has to have.
std::vector<std::string> outputs_of(const TaskRow& task, const TaskResult& result) {
  const TaskKindTraits& traits = traits_of(task.kind);
  if (traits.may_make_nothing && result.outputs.empty()) return {};
  std::vector<std::string> names;
  for (const std::string_view output : traits.outputs) {
    const std::string name(output);
    if (name.empty()) continue;
    if (!name.ends_with(':')) {
      names.push_back(name);
      continue;
    }
    for (const ArtifactRef& input : task.inputs) {
      const std::size_t colon = input.name.find(':');
      if (colon != std::string::npos) names.push_back(name + input.name.substr(colon + 1));
    }
  }
  return names;
}

}  // namespace

std::optional<std::string> problem_with(const TaskRow& task, const TaskResult& result) {
  for (const std::string& name : outputs_of(task, result)) {
    if (!find_file(result.outputs, name)) return "the output '" + name + "' is missing";
  }
  const TaskWords made = made_words(result.outputs, result.numbers, result.texts);
  const std::string breach = breach_of_made(task.kind, made);
  if (!breach.empty()) return breach;
  if (task.kind == TaskKind::inspect) {
    return problem_with_inspected(from_words<InspectMade>(made).contract);
  }
  if (task.kind == TaskKind::assimilate) {
    return problem_with_groups(given_to<AssimilateGiven>(task),
                               from_words<AssimilateMade>(made).contract);
  }
  if (task.kind == TaskKind::order) {
    return problem_with_order(given_to<OrderGiven>(task),
                              from_words<OrderMade>(made).contract.order);
  }
  return std::nullopt;
}

TaskRow inspect_task(const TaskRow& remesh) {
  InspectGiven given;
  given.job = given_to<RemeshGiven>(remesh).job;
  given.remeshed_surface = made_by<RemeshMade>(remesh).surface;
  return new_task(remesh.job, 0, given);
}

TaskRow mesh_task(const TaskRow& inspect, const SubdomainRow& leaf) {
  return mesh_task(made_by<InspectMade>(inspect), leaf, 0);
}

GraphStep after_inspect(const TaskRow& inspect) {
  const auto made = made_by<InspectMade>(inspect);
  GraphStep step;
  const std::uint64_t root = root_path(made);
  step.subdomains = {
      new_subdomain(inspect.job, root, at_least_one(made.parts), made.total_work, made.root)};
  add_tasks(made, !is_assimilated(inspect), {{root, made.needles}}, step);
  return step;
}

GraphStep after_decompose(const TaskRow& inspect, const TaskRow& decompose,
                          const SubdomainRow& parent, bool is_further) {
  const auto given = given_to<DecomposeGiven>(decompose);
  const auto made = made_by<DecomposeMade>(decompose);
  GraphStep step;
  Needles needles = {{parent.path, given.needles.value_or(0)}};
  SubdomainRow self = parent;
  if (!made.halves) {
    self.state = SubdomainState::leaf;
    step.subdomains = {self};
  } else {
    const DecomposeMade::Half& left = made.halves->left;
    const DecomposeMade::Half& right = made.halves->right;
    self.state = SubdomainState::cut;
    self.interdomain_nodes = made.halves->interdomain_nodes;
    step.subdomains = {self, new_half(parent.job, 2 * parent.path, left, given.left_parts),
                       new_half(parent.job, 2 * parent.path + 1, right, given.right_parts)};
    needles[2 * parent.path] = left.needles;
    needles[2 * parent.path + 1] = right.needles;
  }
  add_tasks(made_by<InspectMade>(inspect), is_further || !is_assimilated(inspect), needles, step);
  return step;
}

GraphStep cut_once_more(const TaskRow& inspect, const SubdomainRow& leaf) {
  GraphStep step;
  SubdomainRow open = leaf;
  open.state = SubdomainState::open;
  open.parts = 2;
  open.meshed = false;
  open.interior_nodes = 0;
  open.tets = 0;
  step.subdomains = {open};
  step.tasks = {decompose_task(made_by<InspectMade>(inspect), open, 0)};
  return step;
}

SubdomainRow after_mesh(const TaskRow& mesh, SubdomainRow leaf) {
  const auto made = made_by<MeshMade>(mesh);
  leaf.meshed = true;
  leaf.interior_nodes = made.interior_nodes;
  leaf.tets = made.tets;
  return leaf;
}

bool is_settled(const SubdomainRow& subdomain) {
  return subdomain.state == SubdomainState::cut || subdomain.state == SubdomainState::joined ||
         (subdomain.state == SubdomainState::leaf && subdomain.meshed);
}

NumberGiven given_to_number(const TaskRow& inspect, const TaskRow* assimilate,
                            std::span<const SubdomainRow> tree) {
  NumberGiven given;
  const auto inspected = made_by<InspectMade>(inspect);
  given.surface = inspected.surface;
  given.layer_table = inspected.layer_table;
  if (assimilate != nullptr) given.dropped = made_by<AssimilateMade>(*assimilate).dropped;
  for (const SubdomainRow& node : tree) {
    const std::string path = std::to_string(node.path);
    if (node.state == SubdomainState::cut) {
      given.table += "cut " + path + " " + std::to_string(node.interdomain_nodes) + "\n";
    } else if (node.state == SubdomainState::joined) {
      given.table += "joined " + path + " " + std::to_string(node.joined_into) + "\n";
    } else {
      given.table += "leaf " + path + " " + std::to_string(node.interior_nodes) + " " +
                     std::to_string(node.tets) + "\n";
    }
  }
  return given;
}

WriteGiven given_to_write(const TaskRow& inspect, const TaskRow& number) {
  WriteGiven given;
  const auto inspected = made_by<InspectMade>(inspect);
  given.job = given_to<InspectGiven>(inspect).job;
  given.surface = inspected.surface;
  given.top_heights = inspected.top_heights;
  given.numbering = made_by<NumberMade>(number).numbering;
  return given;
}

void add_mesh(const TaskRow& mesh, WriteGiven& write) {
  write.subdomain = given_to<MeshGiven>(mesh).subdomain;
  write.mesh = made_by<MeshMade>(mesh).mesh;
}

TaskRow assemble_task(const TaskRow& inspect, const TaskRow& number,
                      std::span<const SubdomainRow> tree, const FindWritten& find_written,
                      const FindWritten& find_grown) {
  AssembleGiven given;
  const auto inspected = made_by<InspectMade>(inspect);
  given.job = given_to<InspectGiven>(inspect).job;
  given.surface = inspected.surface;
  given.numbering = made_by<NumberMade>(number).numbering;
  given.layer_map = inspected.layer_map;
  for (const SubdomainRow& node : tree) {
    if (node.state != SubdomainState::leaf) continue;
    const TaskRow* written = find_written(node.path);
    TF_CHECK(written != nullptr);
    const auto made = made_by<WriteMade>(*written);
    given.portions[node.path] = made.portion;
    given.tets[node.path] = made.tets;
  }
  for (const auto& [heap, chunk] : inspected.layers) {
    const TaskRow* grown = find_grown(heap);
    TF_CHECK(grown != nullptr);
    add_grown(*grown, given);
  }
  return new_task(inspect.job, 0, given);
}

}  // namespace tetfarm
