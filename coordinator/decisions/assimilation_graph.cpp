#include "coordinator/decisions/assimilation_graph.h"

#include <map>
#include <sstream>

#include "base/check.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/inspect_contract.h"

namespace tetfarm {
namespace {

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

bool is_assimilated(const TaskRow& inspect) { return made_by<InspectMade>(inspect).groups >= 1; }

std::optional<std::string> problem_with_groups(const AssimilateGiven& given,
                                               const AssimilateMade& made) {
  const std::optional<Groups> groups = parse_groups(made.groups);
  if (!groups) return "the groups cannot be read";
  for (const auto& [heap, file] : given.subdomains) {
    const auto leaf = groups->find(heap);
    if (leaf == groups->end()) return "the leaf " + std::to_string(heap) + " is in no group";
    const auto first = groups->find(leaf->second);
    if (first == groups->end() || first->second != first->first) {
      return "the group " + std::to_string(leaf->second) + " is not named by a leaf of its own";
    }
    if (!made.group_files.contains(leaf->second)) {
      return "the group " + std::to_string(leaf->second) + " has no file";
    }
  }
  if (given.subdomains.size() != groups->size()) return "there are groups of unknown leaves";
  return std::nullopt;
}

std::optional<TaskRow> assimilate_task(const TaskRow& inspect, std::span<const SubdomainRow> tree) {
  if (!is_assimilated(inspect)) return std::nullopt;
  AssimilateGiven given;
  given.job = given_to<InspectGiven>(inspect).job;
  for (const SubdomainRow& node : tree) {
    if (node.state == SubdomainState::cut) continue;
    TF_CHECK(node.state == SubdomainState::leaf);
    given.subdomains[node.path] = {node.hash, node.size};
    given.table += std::to_string(node.path) + " " + std::to_string(told_work(node.work)) + "\n";
  }
  return new_task(inspect.job, 0, given);
}

GraphStep after_assimilate(const TaskRow& inspect, const TaskRow& assimilate,
                           std::span<const SubdomainRow> tree) {
  const auto made = made_by<AssimilateMade>(assimilate);
  const std::optional<Groups> groups = parse_groups(made.groups);
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
    const TaskFile& file = made.group_files.at(group);
    leaf.hash = file.hash;
    leaf.size = file.size;
    leaf.work = group2work.at(group);
    step.tasks.push_back(mesh_task(inspect, leaf));
  }
  return step;
}

}  // namespace tetfarm
