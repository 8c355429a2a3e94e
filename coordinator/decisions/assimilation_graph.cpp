#include "coordinator/decisions/assimilation_graph.h"

#include <cmath>
#include <map>
#include <sstream>

#include "base/check.h"

namespace tetfarm {
namespace {

const std::string leaf_file = "subdomain:";
const std::string group_file = "group:";

ArtifactRef file_of(std::span<const ArtifactRef> files, const std::string& name) {
  const std::optional<ArtifactRef> file = find_file(files, name);
  TF_CHECK(file.has_value());
  return *file;
}

std::string text_of(const TaskResult& result, const std::string& name) {
  const auto found = result.texts.find(name);
  return found == result.texts.end() ? std::string() : found->second;
}

/// The lines "HEAP GROUP": leaf HEAP goes into the group whose first leaf is GROUP.
using Groups = std::map<std::uint64_t, std::uint64_t>;

std::optional<Groups> parse_groups(const std::string& text) {
  Groups groups;
  std::istringstream lines(text);
  std::uint64_t leaf = 0;
  std::uint64_t group = 0;
  while (lines >> leaf >> group) {
    if (!groups.emplace(leaf, group).second) return std::nullopt;
  }
  return lines.eof() ? std::optional<Groups>(groups) : std::nullopt;
}

}  // namespace

bool is_assimilated(const TaskRow& inspect) {
  const auto groups = inspect.numbers.find("groups");
  return groups != inspect.numbers.end() && groups->second >= 1;
}

std::optional<std::string> problem_with_groups(const TaskRow& task, const TaskResult& result) {
  const std::optional<Groups> groups = parse_groups(text_of(result, "groups"));
  if (!groups) return "the text 'groups' cannot be read";
  std::size_t leaves = 0;
  for (const ArtifactRef& input : task.inputs) {
    if (!input.name.starts_with(leaf_file)) continue;
    ++leaves;
    const auto leaf = groups->find(std::stoull(input.name.substr(leaf_file.size())));
    if (leaf == groups->end()) return "the leaf " + input.name + " is in no group";
    const auto first = groups->find(leaf->second);
    if (first == groups->end() || first->second != first->first) {
      return "the group " + std::to_string(leaf->second) + " is not named by a leaf of its own";
    }
    if (!find_file(result.outputs, group_file + std::to_string(leaf->second))) {
      return "the group " + std::to_string(leaf->second) + " has no file";
    }
  }
  if (leaves != groups->size()) return "there are groups of unknown leaves";
  return std::nullopt;
}

std::optional<TaskRow> assimilate_task(const TaskRow& inspect, std::span<const SubdomainRow> tree) {
  if (!is_assimilated(inspect)) return std::nullopt;
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::assimilate;
  task.inputs = {file_of(inspect.inputs, "job")};
  std::string table;
  for (const SubdomainRow& node : tree) {
    if (node.state == SubdomainState::cut) continue;
    TF_CHECK(node.state == SubdomainState::leaf);
    const std::string path = std::to_string(node.path);
    task.inputs.push_back({leaf_file + path, node.hash, node.size});
    table += path + " " + std::to_string(std::llround(node.work)) + "\n";
  }
  task.parameters["table"] = table;
  return task;
}

GraphStep after_assimilate(const TaskRow& inspect, const TaskRow& assimilate,
                           std::span<const SubdomainRow> tree) {
  const std::optional<Groups> groups = parse_groups(assimilate.texts.at("groups"));
  TF_CHECK(groups.has_value());
  std::map<std::uint64_t, double> group2work;
  for (const SubdomainRow& node : tree) {
    if (node.state == SubdomainState::leaf) group2work[groups->at(node.path)] += node.work;
  }
  GraphStep step;
  for (const SubdomainRow& node : tree) {
    if (node.state != SubdomainState::leaf) continue;
    SubdomainRow& leaf = step.subdomains.emplace_back(node);
    const std::uint64_t group = groups->at(node.path);
    if (group != node.path) {
      leaf.state = SubdomainState::joined;
      leaf.joined_into = group;
      continue;
    }
    const ArtifactRef file = file_of(assimilate.outputs, group_file + std::to_string(group));
    leaf.hash = file.hash;
    leaf.size = file.size;
    leaf.work = group2work.at(group);
    step.tasks.push_back(mesh_task(inspect, leaf));
  }
  return step;
}

}  // namespace tetfarm
