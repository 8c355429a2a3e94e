#include "worker/assimilate_task.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/check.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/assemble/global_numbering.h"
#include "mesh/assimilation/assimilation.h"
#include "mesh/job_file/job_file.h"
#include "tasks/assimilate_contract.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

struct LeafLine {
  TreePath path;
  double work = 0;
};

/// In tree order, so that a group is named by what comes first in the mesh.
std::vector<LeafLine> leaves_of(const std::string& table) {
  std::vector<LeafLine> leaves;
  std::istringstream lines(table);
  LeafLine leaf;
  while (lines >> leaf.path.heap >> leaf.work) leaves.push_back(leaf);
  if (!lines.eof() || leaves.empty()) throw Error(ExitCode::failed, "the table of leaves is wrong");
  std::sort(leaves.begin(), leaves.end(),
            [](const LeafLine& a, const LeafLine& b) { return comes_before(a.path, b.path); });
  return leaves;
}

Subdomain read_leaf(const TaskIo& io, const AssimilateGiven& given, TreePath path) {
  return io.read(file_of_leaf(given.subdomains, path.heap), subdomain_from_bytes);
}

PartitionMethod method_of(const JobFile& job) {
  if (job.assimilate_method == "recursive") return PartitionMethod::recursive;
  if (job.assimilate_method == "k-way") return PartitionMethod::k_way;
  if (job.assimilate_method == "k-way-volume") return PartitionMethod::k_way_volume;
  throw UsageError("unknown method \"" + job.assimilate_method + "\"", "[decompose] assimilate");
}

void report_balance(TaskIo& io, const std::string& what, std::span<const double> amounts) {
  const Balance balance = balance_of(amounts);
  io.number(what + "_max", balance.largest);
  io.number(what + "_mean", balance.mean);
}

std::string dropped_text(const std::vector<DroppedNodes>& dropped) {
  std::string text;
  for (const auto& [cut, first, count] : dropped) {
    text += "dropped " + std::to_string(cut.heap) + " " + std::to_string(first) + " " +
            std::to_string(count) + "\n";
  }
  return text;
}

/// The joined sub-domain of a group, sound. Its leaves are in memory meanwhile.
Subdomain joined_group(const TaskIo& io, const AssimilateGiven& given,
                       const std::vector<TreePath>& members) {
  TF_CHECK(!members.empty());
  std::vector<Subdomain> leaves;
  for (const TreePath path : members) leaves.push_back(read_leaf(io, given, path));
  Subdomain group = join_subdomains(leaves);
  const std::vector<std::string> complaints = validate(group);
  if (complaints.empty()) return group;
  throw Error(ExitCode::failed, "joining made an invalid sub-domain " + group.path.text() + ": " +
                                    complaints.front());
}

struct GroupFigures {
  std::vector<double> faces;
  double most_communication_nodes = 0;
  double communication_nodes = 0;
};

/// Publishes the groups and what became of the nodes of the cuts.
GroupFigures join_groups(TaskIo& io, const AssimilateGiven& given,
                         const std::vector<LeafLine>& leaves,
                         const std::vector<std::int32_t>& leaf2group, CutNodeMarks nodes) {
  TF_CHECK(leaf2group.size() == leaves.size());
  std::vector<std::vector<TreePath>> groups;
  AssimilateMade made;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    const auto group = static_cast<std::size_t>(leaf2group[leaf]);
    groups.resize(std::max(groups.size(), group + 1));
    groups[group].push_back(leaves[leaf].path);
    made.groups += std::to_string(leaves[leaf].path.heap) + " " +
                   std::to_string(groups[group].front().heap) + "\n";
  }
  GroupFigures figures;
  io.progress().begin(WorkStage::join, groups.size());
  for (const std::vector<TreePath>& members : groups) {
    io.progress().add();
    const Subdomain group = joined_group(io, given, members);
    nodes.add_joined(group);
    figures.faces.push_back(static_cast<double>(group.triangles.size()));
    const double communication = interface_nodes_of(group);
    figures.communication_nodes += communication;
    figures.most_communication_nodes = std::max(figures.most_communication_nodes, communication);
    made.group_files[group.path.heap] = io.publish(subdomain_to_bytes(group));
  }
  made.dropped = io.publish(dropped_text(nodes.dropped()));
  io.made(made);
  return figures;
}

}  // namespace

void assimilate_task(TaskIo& io) {
  const auto given = io.given<AssimilateGiven>();
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  const std::vector<LeafLine> leaves = leaves_of(given.table);
  SubdomainGraphBuilder builder;
  CutNodeMarks nodes;
  io.progress().begin(WorkStage::graph, leaves.size());
  for (const auto& [path, work] : leaves) {
    io.progress().add();
    const Subdomain leaf = read_leaf(io, given, path);
    builder.add(leaf, work);
    nodes.add_leaf(leaf);
  }
  const SubdomainGraph graph = std::move(builder).finish();
  const std::vector<std::int32_t> leaf2group =
      assimilate(graph, static_cast<std::int32_t>(job.groups), method_of(job));
  const GroupFigures figures = join_groups(io, given, leaves, leaf2group, std::move(nodes));
  const std::vector<double> leaf_faces(graph.faces.begin(), graph.faces.end());
  report_balance(io, "leaf_faces", leaf_faces);
  report_balance(io, "leaf_estimated", graph.work);
  report_balance(io, "faces", figures.faces);
  report_balance(io, "estimated", sums_of_groups(graph.work, leaf2group));
  double triangles = 0;
  for (const double faces : leaf_faces) triangles += faces;
  report_cost(io, assimilate_cost(triangles, balance_of(figures.faces).largest));
  io.number("leaves", static_cast<double>(leaves.size()));
  io.number("groups", static_cast<double>(figures.faces.size()));
  io.number("communication_nodes_max", figures.most_communication_nodes);
  io.number("communication_nodes_sum", figures.communication_nodes);
}

}  // namespace tetfarm
