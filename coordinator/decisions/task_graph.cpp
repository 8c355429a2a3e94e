#include "coordinator/decisions/task_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "coordinator/decisions/assimilation_graph.h"
#include "coordinator/decisions/cosmetic_graph.h"
#include "tasks/task_contracts.h"
#include "tasks/task_kind.h"

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

/// The wanted parts of the two sides are the parent's, as evenly as can be.
TaskRow decompose_task(const TaskRow& inspect, const SubdomainRow& subdomain) {
  TaskRow task;
  task.job = subdomain.job;
  task.kind = TaskKind::decompose;
  task.path = subdomain.path;
  task.inputs = {renamed(file_of(inspect.outputs, "settings"), "job"),
                 {"subdomain", subdomain.hash, subdomain.size},
                 file_of(inspect.outputs, "spacing")};
  const std::uint32_t left_parts = subdomain.parts / 2;
  task.parameters["left_parts"] = std::to_string(left_parts);
  task.parameters["right_parts"] = std::to_string(subdomain.parts - left_parts);
  task.parameters["work"] = std::to_string(std::llround(subdomain.work));
  const std::uint64_t most_bytes = count_or_zero(inspect.numbers, "most_bytes");
  if (most_bytes > 0) task.parameters["most_bytes"] = std::to_string(most_bytes);
  return task;
}

/// Of a task on a sub-domain: how many triangles with a small angle the task that made it counted.
void tell_needles(std::uint64_t needles, TaskRow& task) {
  if (needles > 0) task.parameters["needles"] = std::to_string(needles);
}

/// What is to be done with new sub-domains. Leaves that are to be assimilated wait for the others.
void add_tasks(const TaskRow& inspect, bool meshes_leaves, GraphStep& step) {
  for (const SubdomainRow& subdomain : step.subdomains) {
    if (subdomain.state == SubdomainState::open) {
      step.tasks.push_back(decompose_task(inspect, subdomain));
    } else if (subdomain.state == SubdomainState::leaf && meshes_leaves) {
      step.tasks.push_back(mesh_task(inspect, subdomain));
    }
  }
}

SubdomainRow new_subdomain(JobId job, std::uint64_t path, std::uint32_t parts, double work,
                           const ArtifactRef& file) {
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

/// The parts that a half is to become: as the task found where memory decides, else as it was told.
std::uint32_t half_parts(const TaskRow& decompose, const std::string& name) {
  const auto found = count_of(decompose.numbers, name, most_parts);
  if (found) return std::max(1U, static_cast<std::uint32_t>(*found));
  const auto told = decompose.parameters.find(name);
  return told == decompose.parameters.end() ? 1
                                            : static_cast<std::uint32_t>(std::stoul(told->second));
}

double work_of(const TaskRow& task, const std::string& name) {
  const auto found = task.numbers.find(name);
  return found == task.numbers.end() || !(found->second >= 0) ? 0 : found->second;
}

TaskWords words_of(const TaskResult& result) {
  TaskWords words;
  for (const ArtifactRef& file : result.outputs) {
    words.files.push_back({file.name, {file.hash, file.size}});
  }
  words.texts = result.texts;
  words.numbers = result.numbers;
  return words;
}

/// Every leaf that the task was given has its turn.
std::optional<std::string> problem_with_order(const TaskRow& task, const TaskResult& result) {
  const auto text = result.texts.find("order");
  const auto turns = text == result.texts.end() ? std::nullopt : turn_order_of(text->second);
  if (!turns) return "the order is missing or makes no sense";
  if (turns->size() != task.inputs.size()) return "the order has different leaves from the tree";
  for (const auto& [leaf, turn] : *turns) {
    if (!find_file(task.inputs, "subdomain:" + std::to_string(leaf))) {
      return "the order has a leaf that the tree does not have";
    }
  }
  return std::nullopt;
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

std::optional<ArtifactRef> find_file(std::span<const ArtifactRef> files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&name](const ArtifactRef& file) { return file.name == name; });
  return found == files.end() ? std::nullopt : std::optional<ArtifactRef>(*found);
}

std::optional<std::string> problem_with(const TaskRow& task, const TaskResult& result) {
  for (const std::string& name : outputs_of(task, result)) {
    if (!find_file(result.outputs, name)) return "the output '" + name + "' is missing";
  }
  const std::string breach = breach_of_made(task.kind, words_of(result));
  if (!breach.empty()) return breach;
  if (task.kind == TaskKind::inspect && result.numbers.at("parts") < 1) {
    return "the number of parts is 0";
  }
  if (task.kind == TaskKind::assimilate) return problem_with_groups(task, result);
  if (task.kind == TaskKind::order) return problem_with_order(task, result);
  return std::nullopt;
}

TaskRow mesh_task(const TaskRow& inspect, const SubdomainRow& leaf) {
  TaskRow task;
  task.job = leaf.job;
  task.kind = TaskKind::mesh;
  task.path = leaf.path;
  task.inputs = {renamed(file_of(inspect.outputs, "settings"), "job"),
                 {"subdomain", leaf.hash, leaf.size},
                 file_of(inspect.outputs, "spacing")};
  task.parameters["work"] = std::to_string(std::llround(leaf.work));
  return task;
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
  GraphStep step;
  step.subdomains = {new_subdomain(inspect.job, 1, parts_of(inspect, "parts"),
                                   work_of(inspect, "total_work"),
                                   file_of(inspect.outputs, "root"))};
  add_tasks(inspect, !is_assimilated(inspect), step);
  for (TaskRow& task : step.tasks) tell_needles(count_or_zero(inspect.numbers, "needles"), task);
  return step;
}

GraphStep after_decompose(const TaskRow& inspect, const TaskRow& decompose,
                          const SubdomainRow& parent, bool is_further) {
  GraphStep step;
  SubdomainRow self = parent;
  if (decompose.outputs.empty()) {
    self.state = SubdomainState::leaf;
    step.subdomains = {self};
  } else {
    self.state = SubdomainState::cut;
    self.interdomain_nodes = count_or_zero(decompose.numbers, "interdomain_nodes");
    step.subdomains = {
        self,
        new_subdomain(parent.job, 2 * parent.path, half_parts(decompose, "left_parts"),
                      work_of(decompose, "left_work"), file_of(decompose.outputs, "left")),
        new_subdomain(parent.job, 2 * parent.path + 1, half_parts(decompose, "right_parts"),
                      work_of(decompose, "right_work"), file_of(decompose.outputs, "right"))};
  }
  add_tasks(inspect, is_further || !is_assimilated(inspect), step);
  for (TaskRow& task : step.tasks) {
    const auto own = decompose.parameters.find("needles");
    if (task.path == parent.path) {
      if (own != decompose.parameters.end()) task.parameters["needles"] = own->second;
    } else {
      const char* side = task.path == 2 * parent.path ? "left_needles" : "right_needles";
      tell_needles(count_or_zero(decompose.numbers, side), task);
    }
  }
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
  step.tasks = {decompose_task(inspect, open)};
  return step;
}

SubdomainRow after_mesh(const TaskRow& mesh, SubdomainRow leaf) {
  leaf.meshed = true;
  leaf.interior_nodes = count_or_zero(mesh.numbers, "interior_nodes");
  leaf.tets = count_or_zero(mesh.numbers, "tets");
  return leaf;
}

bool is_settled(const SubdomainRow& subdomain) {
  return subdomain.state == SubdomainState::cut || subdomain.state == SubdomainState::joined ||
         (subdomain.state == SubdomainState::leaf && subdomain.meshed);
}

TaskRow number_task(const TaskRow& inspect, const TaskRow* assimilate,
                    std::span<const SubdomainRow> tree) {
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::number;
  task.inputs = {file_of(inspect.outputs, "surface")};
  if (assimilate != nullptr) task.inputs.push_back(file_of(assimilate->outputs, "dropped"));
  std::string table;
  for (const SubdomainRow& node : tree) {
    const std::string path = std::to_string(node.path);
    if (node.state == SubdomainState::cut) {
      table += "cut " + path + " " + std::to_string(node.interdomain_nodes) + "\n";
    } else if (node.state == SubdomainState::joined) {
      table += "joined " + path + " " + std::to_string(node.joined_into) + "\n";
    } else {
      table += "leaf " + path + " " + std::to_string(node.interior_nodes) + " " +
               std::to_string(node.tets) + "\n";
    }
  }
  task.parameters["table"] = table;
  return task;
}

TaskRow write_task(const TaskRow& inspect, const TaskRow& number, std::uint64_t leaf) {
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::write;
  task.path = leaf;
  task.inputs = {file_of(inspect.inputs, "job"), file_of(inspect.outputs, "surface"),
                 file_of(number.outputs, "numbering")};
  return task;
}

void add_mesh(const TaskRow& mesh, TaskRow& write) {
  write.inputs.push_back(file_of(mesh.inputs, "subdomain"));
  write.inputs.push_back(file_of(mesh.outputs, "mesh"));
}

TaskRow assemble_task(const TaskRow& inspect, const TaskRow& number,
                      std::span<const SubdomainRow> tree, const FindWritten& find_written) {
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::assemble;
  task.inputs = {file_of(inspect.inputs, "job"), file_of(inspect.outputs, "surface"),
                 file_of(number.outputs, "numbering")};
  for (const SubdomainRow& node : tree) {
    if (node.state != SubdomainState::leaf) continue;
    const TaskRow* written = find_written(node.path);
    TF_CHECK(written != nullptr);
    for (const std::string name : {"portion", "tets"}) {
      task.inputs.push_back(
          renamed(file_of(written->outputs, name), name + ":" + std::to_string(node.path)));
    }
  }
  return task;
}

}  // namespace tetfarm
