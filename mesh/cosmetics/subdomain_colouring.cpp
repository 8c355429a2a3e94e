#include "mesh/cosmetics/subdomain_colouring.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

struct NodeOfLeaf {
  Origin origin;
  std::uint32_t leaf = 0;  // its place in the list

  friend auto operator<=>(const NodeOfLeaf&, const NodeOfLeaf&) = default;
};

template <class T>
void sort_unique(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

std::vector<NodeOfLeaf> all_nodes(const std::vector<InterfaceNodes>& leaves) {
  std::vector<NodeOfLeaf> nodes;
  for (std::uint32_t leaf = 0; leaf < leaves.size(); ++leaf) {
    for (const Origin& origin : leaves[leaf].nodes) nodes.push_back({origin, leaf});
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Calls visit(origin, the places of its leaves) for every node that several leaves have.
template <class Visitor>
void for_each_shared(const std::vector<NodeOfLeaf>& nodes, Visitor&& visit) {
  std::vector<std::uint32_t> leaves;
  for (std::size_t first = 0; first < nodes.size();) {
    leaves.clear();
    std::size_t next = first;
    for (; next < nodes.size() && nodes[next].origin == nodes[first].origin; ++next) {
      leaves.push_back(nodes[next].leaf);
    }
    if (leaves.size() > 1) visit(nodes[first].origin, leaves);
    first = next;
  }
}

/// The sets of leaves that share some node, each once.
std::vector<std::vector<std::uint32_t>> sharer_sets(const std::vector<NodeOfLeaf>& nodes) {
  std::vector<std::vector<std::uint32_t>> sets;
  for_each_shared(nodes, [&](const Origin&, const std::vector<std::uint32_t>& leaves) {
    TF_CHECK(leaves.size() <= most_sharers);
    if (sets.empty() || sets.back() != leaves) sets.push_back(leaves);
  });
  sort_unique(sets);
  return sets;
}

std::int32_t free_colour(const ColouredLeaf& leaf, const std::vector<ColouredLeaf>& leaves) {
  std::vector<std::int32_t> taken;
  for (const ColouredLeaf& other : leaves) {
    if (other.path == leaf.path) break;
    if (std::binary_search(leaf.neighbours.begin(), leaf.neighbours.end(), other.path)) {
      taken.push_back(other.colour);
    }
  }
  sort_unique(taken);
  std::int32_t colour = 0;
  while (static_cast<std::size_t>(colour) < taken.size() &&
         taken[static_cast<std::size_t>(colour)] == colour) {
    ++colour;
  }
  return colour;
}

}  // namespace

InterfaceNodes interface_nodes(const Subdomain& leaf) {
  InterfaceNodes result;
  result.path = leaf.path;
  for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
    if (!is_of_cut(leaf.triangle_origin[t])) continue;
    for (const std::int32_t v : leaf.triangles[t]) {
      result.nodes.push_back(leaf.node_origin[static_cast<std::size_t>(v)]);
    }
  }
  sort_unique(result.nodes);
  return result;
}

CosmeticOrder colour_subdomains(std::vector<InterfaceNodes> leaves) {
  std::sort(leaves.begin(), leaves.end(),
            [](const InterfaceNodes& a, const InterfaceNodes& b) { return a.path < b.path; });
  const std::vector<NodeOfLeaf> nodes = all_nodes(leaves);
  const auto sets = sharer_sets(nodes);
  CosmeticOrder order;
  order.leaves.resize(leaves.size());
  order.shared.resize(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    order.leaves[i].path = order.shared[i].path = leaves[i].path;
  }
  // The sets of each leaf, and where a set stands among those of its leaf.
  std::vector<std::vector<std::size_t>> sets_of_leaf(leaves.size());
  for (std::size_t s = 0; s < sets.size(); ++s) {
    Sharers sharers;
    for (const std::uint32_t leaf : sets[s]) sharers.push_back(leaves[leaf].path.heap);
    for (const std::uint32_t leaf : sets[s]) {
      sets_of_leaf[leaf].push_back(s);
      order.shared[leaf].sets.push_back(sharers);
      for (const std::uint64_t heap : sharers) {
        if (heap != leaves[leaf].path.heap) order.leaves[leaf].neighbours.push_back({heap});
      }
    }
  }
  for_each_shared(nodes, [&](const Origin& origin, const std::vector<std::uint32_t>& sharers) {
    const auto set = static_cast<std::size_t>(std::lower_bound(sets.begin(), sets.end(), sharers) -
                                              sets.begin());
    TF_CHECK(set < sets.size());
    for (const std::uint32_t leaf : sharers) {
      const auto& of_leaf = sets_of_leaf[leaf];
      const auto place = std::lower_bound(of_leaf.begin(), of_leaf.end(), set) - of_leaf.begin();
      order.shared[leaf].nodes.push_back({origin, static_cast<std::uint32_t>(place)});
    }
  });
  for (ColouredLeaf& leaf : order.leaves) {
    sort_unique(leaf.neighbours);
    leaf.colour = free_colour(leaf, order.leaves);
  }
  return order;
}

}  // namespace tetfarm
