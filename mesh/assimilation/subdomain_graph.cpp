#include "mesh/assimilation/subdomain_graph.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {
namespace {

constexpr std::int32_t nobody = -1;
constexpr std::int32_t both_known = -2;

}  // namespace

std::int32_t interface_nodes_of(const Subdomain& subdomain) {
  std::vector<bool> is_on_cut(subdomain.vertices.size(), false);
  TF_CHECK(subdomain.triangle_origin.size() == subdomain.triangles.size());
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    if (!is_of_cut(subdomain.triangle_origin[t])) continue;
    for (const std::int32_t v : subdomain.triangles[t])
      is_on_cut[static_cast<std::size_t>(v)] = true;
  }
  return static_cast<std::int32_t>(std::count(is_on_cut.begin(), is_on_cut.end(), true));
}

void SubdomainGraphBuilder::add(const Subdomain& leaf, double work) {
  const auto number = static_cast<std::int32_t>(graph_.size());
  graph_.path.push_back(leaf.path);
  graph_.work.push_back(work);
  graph_.faces.push_back(std::ssize(leaf.triangles));
  graph_.interface_nodes.push_back(interface_nodes_of(leaf));
  for (const Origin& triangle : leaf.triangle_origin) {
    if (is_of_cut(triangle)) meet(triangle, number);
  }
}

void SubdomainGraphBuilder::meet(const Origin& triangle, std::int32_t leaf) {
  std::vector<std::int32_t>& first_leaf = cut2first_leaf_[triangle.owner];
  if (first_leaf.size() <= triangle.index) first_leaf.resize(triangle.index + 1, nobody);
  std::int32_t& first = first_leaf[triangle.index];
  if (first == nobody) {
    first = leaf;
    return;
  }
  if (first == both_known || first == leaf) {
    throw Error(ExitCode::failed, "triangle " + std::to_string(triangle.index) + " of the cut of " +
                                      TreePath{triangle.owner}.text() +
                                      " is not shared by two leaves");
  }
  ++shared_[{first, leaf}];
  first = both_known;
}

SubdomainGraph SubdomainGraphBuilder::finish() && {
  for (const auto& [cut, first_leaf] : cut2first_leaf_) {
    const bool is_alone = std::any_of(first_leaf.begin(), first_leaf.end(),
                                      [](std::int32_t leaf) { return leaf >= 0; });
    if (!is_alone) continue;
    throw Error(ExitCode::failed,
                "a triangle of the cut of " + TreePath{cut}.text() + " has only one leaf");
  }
  graph_.neighbours.resize(graph_.size());
  for (const auto& [leaves, triangles] : shared_) {
    graph_.neighbours[static_cast<std::size_t>(leaves.first)].push_back({leaves.second, triangles});
    graph_.neighbours[static_cast<std::size_t>(leaves.second)].push_back({leaves.first, triangles});
  }
  for (std::vector<Neighbour>& neighbours : graph_.neighbours) {
    std::sort(neighbours.begin(), neighbours.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.leaf < b.leaf; });
  }
  return std::move(graph_);
}

}  // namespace tetfarm
