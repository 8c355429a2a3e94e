#include "coordinator/task_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "coordinator/cosmetic_graph.h"

namespace tetfarm {
namespace {

constexpr double most_parts = 1e6;

ArtifactRef file_of(std::span<const ArtifactRef> files, const std::string& name) {
  const std::optional<ArtifactRef> file = find_file(files, name);
  TF_CHECK(file.has_value());
  return *file;
}

ArtifactRef renamed(ArtifactRef file, std::string name) {
  file.name = std::move(name);
  return file;
}

/// A whole number from 0 to `most`; nothing when the result has none of that name.
std::optional<std::uint64_t> count_of(const std::map<std::string, double>& numbers,
                                      const std::string& name, double most) {
  const auto found = numbers.find(name);
  if (found == numbers.end()) return std::nullopt;
  const double value = found->second;
  if (!(value >= 0 && value <= most) || value != std::floor(value)) return std::nullopt;
  return static_cast<std::uint64_t>(value);
}

std::uint64_t count_or_zero(const std::map<std::string, double>& numbers, const std::string& name) {
  return count_of(numbers, name, 1e15).value_or(0);
}

std::uint32_t parts_of(const TaskRow& task, const std::string& name) {
  return static_cast<std::uint32_t>(count_of(task.numbers, name, most_parts).value_or(1));
}

TaskRow task_on_subdomain(const TaskRow& inspect, const SubdomainRow& subdomain) {
  TaskRow task;
  task.job = subdomain.job;
  task.path = subdomain.path;
  task.inputs = {file_of(inspect.inputs, "job"),
                 {"subdomain", subdomain.hash, subdomain.size},
                 file_of(inspect.outputs, "spacing")};
  if (subdomain.state == SubdomainState::leaf) {
    task.kind = TaskKind::mesh;
  } else {
    task.kind = TaskKind::decompose;
    task.parameters["parts"] = std::to_string(subdomain.parts);
  }
  return task;
}

SubdomainRow new_subdomain(JobId job, std::uint64_t path, std::uint32_t parts,
                           const ArtifactRef& file) {
  SubdomainRow subdomain;
  subdomain.job = job;
  subdomain.path = path;
  subdomain.parts = parts;
  subdomain.state = parts > 1 && path < deepest_cut ? SubdomainState::open : SubdomainState::leaf;
  subdomain.hash = file.hash;
  subdomain.size = file.size;
  return subdomain;
}

std::optional<std::string> problem_with_cut(const TaskRow& task, const TaskResult& result) {
  if (result.outputs.empty()) return std::nullopt;
  const auto left = count_of(result.numbers, "left_parts", most_parts);
  const auto right = count_of(result.numbers, "right_parts", most_parts);
  if (!left || !right || *left < 1 || *right < 1) return "left_parts or right_parts is missing";
  const auto parts = task.parameters.find("parts");
  if (parts != task.parameters.end() && std::to_string(*left + *right) != parts->second) {
    return "left_parts + right_parts is not " + parts->second;
  }
  return std::nullopt;
}

/// Every leaf that the task was given has its turn.
std::optional<std::string> problem_with_order(const TaskRow& task, const TaskResult& result) {
  const auto text = result.texts.find("order");
  const auto turns = text == result.texts.end() ? std::nullopt : turn_order_of(text->second);
  if (!turns) return "the order is missing or makes no sense";
  if (turns->size() != task.inputs.size()) return "the order has other leaves than the tree";
  for (const auto& [leaf, turn] : *turns) {
    if (!find_file(task.inputs, "subdomain:" + std::to_string(leaf))) {
      return "the order has a leaf that the tree has not";
    }
  }
  return std::nullopt;
}

std::vector<std::string> outputs_of(const TaskRow& task, const TaskResult& result) {
  switch (task.kind) {
    case TaskKind::inspect:
      return {"surface", "spacing", "root"};
    case TaskKind::decompose:
      if (result.outputs.empty()) return {};
      return {"left", "right"};
    case TaskKind::mesh:
      return {"mesh"};
    case TaskKind::order: {
      std::vector<std::string> shared;
      for (const ArtifactRef& input : task.inputs) {
        shared.push_back("shared:" + input.name.substr(input.name.find(':') + 1));
      }
      return shared;
    }
    case TaskKind::extract:
    case TaskKind::cosmetic:
      return {"elements"};
    case TaskKind::number:
      return {"numbering"};
    case TaskKind::assemble:
      return {};
  }
  return {};
}

}  // namespace

std::optional<ArtifactRef> find_file(std::span<const ArtifactRef> files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&name](const ArtifactRef& file) { return file.name == name; });
  return found == files.end() ? std::nullopt : std::optional<ArtifactRef>(*found);
}

std::optional<std::string> problem_with(const TaskRow& task, const TaskResult& result) {
  for (const std::string& name : outputs_of(task, result)) {
    if (!find_file(result.outputs, name)) return "the output '" + name + "' is missing";
  }
  if (task.kind == TaskKind::inspect) {
    const auto parts = count_of(result.numbers, "parts", most_parts);
    if (!parts || *parts < 1) return "the number of parts is missing";
  }
  if (task.kind == TaskKind::decompose) return problem_with_cut(task, result);
  if (task.kind == TaskKind::order) return problem_with_order(task, result);
  return std::nullopt;
}

TaskRow inspect_task(JobId job, const ArtifactRef& job_file, std::span<const ArtifactRef> inputs) {
  TaskRow task;
  task.job = job;
  task.kind = TaskKind::inspect;
  task.inputs.push_back(renamed(job_file, "job"));
  task.inputs.insert(task.inputs.end(), inputs.begin(), inputs.end());
  return task;
}

GraphStep after_inspect(const TaskRow& inspect) {
  const SubdomainRow root =
      new_subdomain(inspect.job, 1, parts_of(inspect, "parts"), file_of(inspect.outputs, "root"));
  return {{root}, {task_on_subdomain(inspect, root)}};
}

GraphStep after_decompose(const TaskRow& inspect, const TaskRow& decompose,
                          const SubdomainRow& parent) {
  SubdomainRow self = parent;
  if (decompose.outputs.empty()) {
    self.state = SubdomainState::leaf;
    return {{self}, {task_on_subdomain(inspect, self)}};
  }
  self.state = SubdomainState::cut;
  self.interdomain_nodes = count_or_zero(decompose.numbers, "interdomain_nodes");
  const SubdomainRow left =
      new_subdomain(parent.job, 2 * parent.path, parts_of(decompose, "left_parts"),
                    file_of(decompose.outputs, "left"));
  const SubdomainRow right =
      new_subdomain(parent.job, 2 * parent.path + 1, parts_of(decompose, "right_parts"),
                    file_of(decompose.outputs, "right"));
  return {{self, left, right},
          {task_on_subdomain(inspect, left), task_on_subdomain(inspect, right)}};
}

SubdomainRow after_mesh(const TaskRow& mesh, SubdomainRow leaf) {
  leaf.meshed = true;
  leaf.interior_nodes = count_or_zero(mesh.numbers, "interior_nodes");
  leaf.tets = count_or_zero(mesh.numbers, "tets");
  return leaf;
}

bool is_settled(const SubdomainRow& subdomain) {
  return subdomain.state == SubdomainState::cut ||
         (subdomain.state == SubdomainState::leaf && subdomain.meshed);
}

TaskRow number_task(const TaskRow& inspect, std::span<const SubdomainRow> tree) {
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::number;
  task.inputs = {file_of(inspect.inputs, "job"), file_of(inspect.outputs, "surface")};
  std::string table;
  for (const SubdomainRow& node : tree) {
    const std::string path = std::to_string(node.path);
    if (node.state == SubdomainState::cut) {
      table += "cut " + path + " " + std::to_string(node.interdomain_nodes) + "\n";
    } else {
      table += "leaf " + path + " " + std::to_string(node.interior_nodes) + " " +
               std::to_string(node.tets) + "\n";
    }
  }
  task.parameters["table"] = table;
  return task;
}

TaskRow assemble_task(const TaskRow& inspect, const TaskRow& number,
                      std::span<const SubdomainRow> tree,
                      const std::map<std::uint64_t, ArtifactRef>& meshes) {
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::assemble;
  task.inputs = {file_of(inspect.inputs, "job"), file_of(inspect.outputs, "surface"),
                 file_of(inspect.outputs, "spacing"), file_of(number.outputs, "numbering")};
  for (const SubdomainRow& node : tree) {
    if (node.state != SubdomainState::leaf) continue;
    const std::string path = std::to_string(node.path);
    task.inputs.push_back({"subdomain:" + path, node.hash, node.size});
    task.inputs.push_back(renamed(meshes.at(node.path), "mesh:" + path));
  }
  return task;
}

}  // namespace tetfarm
