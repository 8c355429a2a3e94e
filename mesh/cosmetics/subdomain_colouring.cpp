#include "mesh/cosmetics/subdomain_colouring.h"

#include <algorithm>
#include <set>

#include "base/check.h"

namespace tetfarm {
namespace {

/// One of millions, which is why owners are numbered.
struct NodeOfLeaf {
  std::uint32_t owner = 0;  // its place in the list
  std::uint32_t index = 0;
  std::uint32_t leaf = 0;  // its place in the list

  friend auto operator<=>(const NodeOfLeaf&, const NodeOfLeaf&) = default;
};

template <class T>
void sort_unique(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Ascending.
std::vector<std::uint64_t> owners_of(const std::vector<InterfaceNodes>& leaves) {
  std::set<std::uint64_t> owners;
  for (const InterfaceNodes& leaf : leaves) {
    const Origin* last = nullptr;
    for (const Origin& origin : leaf.nodes) {
      if (last == nullptr || origin.owner != last->owner) owners.insert(origin.owner);
      last = &origin;
    }
  }
  return {owners.begin(), owners.end()};
}

/// The nodes of all leaves, by origin; those of each leaf leave memory on the way.
class NodesOfLeaves {
 public:
  explicit NodesOfLeaves(std::vector<InterfaceNodes>& leaves) : owners_(owners_of(leaves)) {
    std::size_t count = 0;
    for (const InterfaceNodes& leaf : leaves) count += leaf.nodes.size();
    nodes_.reserve(count);
    for (std::uint32_t leaf = 0; leaf < leaves.size(); ++leaf) {
      for (const Origin& origin : leaves[leaf].nodes) {
        nodes_.push_back({number_of(origin.owner), origin.index, leaf});
      }
      leaves[leaf].nodes = {};
    }
    std::sort(nodes_.begin(), nodes_.end());
  }

  /// Calls visit(origin, the places of its leaves) for every node that several leaves have.
  template <class Visitor>
  void for_each_shared(Visitor&& visit) const {
    std::vector<std::uint32_t> leaves;
    for (auto first = nodes_.begin(); first != nodes_.end();) {
      leaves.clear();
      auto next = first;
      for (; next != nodes_.end() && is_same_node(*next, *first); ++next) {
        leaves.push_back(next->leaf);
      }
      if (leaves.size() > 1) visit(Origin{owners_[first->owner], first->index}, leaves);
      first = next;
    }
  }

 private:
  static bool is_same_node(const NodeOfLeaf& a, const NodeOfLeaf& b) {
    return a.owner == b.owner && a.index == b.index;
  }
  std::uint32_t number_of(std::uint64_t owner) const {
    const auto place = std::lower_bound(owners_.begin(), owners_.end(), owner);
    return static_cast<std::uint32_t>(place - owners_.begin());
  }

  std::vector<std::uint64_t> owners_;
  std::vector<NodeOfLeaf> nodes_;
};

/// The sets of leaves that share some node, each once, ascending.
std::vector<std::vector<std::uint32_t>> sharer_sets(const NodesOfLeaves& nodes) {
  std::set<std::vector<std::uint32_t>> sets;
  nodes.for_each_shared([&](const Origin&, const std::vector<std::uint32_t>& leaves) {
    TF_CHECK(leaves.size() <= most_sharers);
    sets.insert(leaves);
  });
  return {sets.begin(), sets.end()};
}

/// Of each leaf.
std::vector<std::size_t> shared_counts(const NodesOfLeaves& nodes, std::size_t leaves) {
  std::vector<std::size_t> counts(leaves, 0);
  nodes.for_each_shared([&](const Origin&, const std::vector<std::uint32_t>& sharers) {
    for (const std::uint32_t leaf : sharers) ++counts[leaf];
  });
  return counts;
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
  result.nodes.shrink_to_fit();  // a sixth of what was listed
  return result;
}

CosmeticOrder colour_subdomains(std::vector<InterfaceNodes> leaves) {
  std::sort(leaves.begin(), leaves.end(),
            [](const InterfaceNodes& a, const InterfaceNodes& b) { return a.path < b.path; });
  const NodesOfLeaves nodes(leaves);
  const auto sets = sharer_sets(nodes);
  CosmeticOrder order;
  order.leaves.resize(leaves.size());
  order.shared.resize(leaves.size());
  const std::vector<std::size_t> counts = shared_counts(nodes, leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    order.leaves[i].path = order.shared[i].path = leaves[i].path;
    order.shared[i].nodes.reserve(counts[i]);
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
  nodes.for_each_shared([&](const Origin& origin, const std::vector<std::uint32_t>& sharers) {
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
