#include "mesh/assimilation/assimilation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/assimilation/group_refinement.h"

namespace tetfarm {
namespace {

/// A vertex or triangle of one of the leaves.
struct Item {
  Origin origin;
  std::int32_t leaf = 0;
  std::int32_t index = 0;
};

/// By origin; the first leaf's first.
std::vector<Item> sorted_items(std::span<const Subdomain> leaves,
                               std::vector<Origin> Subdomain::*origins) {
  std::vector<Item> items;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    std::int32_t index = 0;
    for (const Origin& origin : leaves[leaf].*origins) {
      items.push_back({origin, static_cast<std::int32_t>(leaf), index++});
    }
  }
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.origin != b.origin ? a.origin < b.origin : a.leaf < b.leaf;
  });
  return items;
}

/// Calls run(first, last) for the items of each origin.
template <class Run>
void for_each_origin(const std::vector<Item>& items, const Run& run) {
  for (std::size_t first = 0; first < items.size();) {
    std::size_t last = first + 1;
    while (last < items.size() && items[last].origin == items[first].origin) ++last;
    run(first, last);
    first = last;
  }
}

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto same = [](double s, double t) {
    return std::bit_cast<std::uint64_t>(s) == std::bit_cast<std::uint64_t>(t);
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

[[noreturn]] void refuse(const Subdomain& leaf, const std::string& what) {
  throw Error(ExitCode::failed,
              "the leaves cannot be joined: sub-domain " + leaf.path.text() + ": " + what);
}

class Joining {
 public:
  explicit Joining(std::span<const Subdomain> leaves) : leaves_(leaves) {
    TF_CHECK(!leaves.empty());
    for (const Subdomain& leaf : leaves) {
      if (leaf.region != leaves.front().region) refuse(leaf, "it belongs to another region");
      vertex2first_.emplace_back(leaf.vertices.size());
      is_shared_.emplace_back(leaf.triangles.size(), false);
    }
    find_first_vertices();
    find_shared_triangles();
  }

  Subdomain result() const {
    std::vector<std::vector<std::int32_t>> old2new = used_vertices();
    Subdomain joined;
    joined.path = leaves_.front().path;
    joined.region = leaves_.front().region;
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
      for (std::size_t v = 0; v < old2new[leaf].size(); ++v) {
        if (old2new[leaf][v] == unused) continue;
        old2new[leaf][v] = static_cast<std::int32_t>(joined.vertices.size());
        joined.vertices.push_back(leaves_[leaf].vertices[v]);
        joined.node_origin.push_back(leaves_[leaf].node_origin[v]);
      }
    }
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
      for (std::size_t t = 0; t < leaves_[leaf].triangles.size(); ++t) {
        if (is_shared_[leaf][t]) continue;
        Triangle triangle = leaves_[leaf].triangles[t];
        for (std::int32_t& v : triangle) {
          const Item& first = vertex2first_[leaf][at(v)];
          v = old2new[at(first.leaf)][at(first.index)];
          TF_CHECK(v >= 0);  // it is used
        }
        joined.triangles.push_back(triangle);
        joined.triangle_origin.push_back(leaves_[leaf].triangle_origin[t]);
      }
    }
    return joined;
  }

 private:
  static constexpr std::int32_t unused = -1;

  void find_first_vertices() {
    const std::vector<Item> items = sorted_items(leaves_, &Subdomain::node_origin);
    for_each_origin(items, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        vertex2first_[at(items[i].leaf)][at(items[i].index)] = items[first];
        if (!same_bits(position(items[i]), position(items[first]))) {
          refuse(leaves_[at(items[i].leaf)], "a node is not where another leaf has it");
        }
      }
    });
  }

  void find_shared_triangles() {
    const std::vector<Item> items = sorted_items(leaves_, &Subdomain::triangle_origin);
    for_each_origin(items, [&](std::size_t first, std::size_t last) {
      if (last - first == 1) return;
      const Item& a = items[first];
      const Item& b = items[first + 1];
      if (last - first > 2 || !is_of_cut(a.origin) || !are_reversed(a, b)) {
        refuse(leaves_[at(b.leaf)], "a triangle does not match that of another leaf");
      }
      is_shared_[at(a.leaf)][at(a.index)] = true;
      is_shared_[at(b.leaf)][at(b.index)] = true;
    });
  }

  const Vec3& position(const Item& vertex) const {
    return leaves_[at(vertex.leaf)].vertices[at(vertex.index)];
  }

  /// The nodes' origins, the smallest first, in the triangle's direction.
  std::array<Origin, 3> corners(const Item& triangle) const {
    const Subdomain& leaf = leaves_[at(triangle.leaf)];
    std::array<Origin, 3> origins;
    for (std::size_t i = 0; i < 3; ++i) {
      origins[i] = leaf.node_origin[at(leaf.triangles[at(triangle.index)][i])];
    }
    std::rotate(origins.begin(), std::min_element(origins.begin(), origins.end()), origins.end());
    return origins;
  }

  bool are_reversed(const Item& a, const Item& b) const {
    std::array<Origin, 3> there = corners(b);
    std::swap(there[1], there[2]);
    return corners(a) == there;
  }

  /// For the first occurrence of each vertex that a triangle is left of: 0; for the rest: unused.
  std::vector<std::vector<std::int32_t>> used_vertices() const {
    std::vector<std::vector<std::int32_t>> used;
    for (const Subdomain& leaf : leaves_) used.emplace_back(leaf.vertices.size(), unused);
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
      for (std::size_t t = 0; t < leaves_[leaf].triangles.size(); ++t) {
        if (is_shared_[leaf][t]) continue;
        for (const std::int32_t v : leaves_[leaf].triangles[t]) {
          const Item& first = vertex2first_[leaf][at(v)];
          used[at(first.leaf)][at(first.index)] = 0;
        }
      }
    }
    return used;
  }

  std::span<const Subdomain> leaves_;
  std::vector<std::vector<Item>> vertex2first_;  ///< by leaf and vertex: where the node is first
  std::vector<std::vector<bool>> is_shared_;     ///< by leaf and triangle
};

/// One group for each piece at least; each further one goes where the groups are heaviest, and
/// where there are leaves for it.
std::vector<std::int32_t> shares_of_pieces(const SubdomainGraph& graph,
                                           const std::vector<std::vector<std::int32_t>>& pieces,
                                           std::int32_t groups) {
  std::vector<double> works;
  for (const std::vector<std::int32_t>& piece : pieces) {
    double& work = works.emplace_back(0);
    for (const std::int32_t leaf : piece) work += graph.work[at(leaf)];
  }
  std::vector<std::int32_t> shares(pieces.size(), 1);
  for (auto given = std::ssize(pieces); given < groups; ++given) {
    std::size_t heaviest = pieces.size();
    const auto load = [&](std::size_t i) { return works[i] / shares[i]; };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (shares[i] == std::ssize(pieces[i])) continue;
      if (heaviest == pieces.size() || load(i) > load(heaviest)) heaviest = i;
    }
    if (heaviest == pieces.size()) break;
    ++shares[heaviest];
  }
  return shares;
}

/// @pre `leaves` ascend and have no neighbours but each other.
SubdomainGraph part_of(const SubdomainGraph& graph, const std::vector<std::int32_t>& leaves) {
  SubdomainGraph part;
  for (const std::int32_t leaf : leaves) {
    part.path.push_back(graph.path[at(leaf)]);
    part.work.push_back(graph.work[at(leaf)]);
    part.faces.push_back(graph.faces[at(leaf)]);
    part.interface_nodes.push_back(graph.interface_nodes[at(leaf)]);
    std::vector<Neighbour>& neighbours = part.neighbours.emplace_back();
    for (const auto& [other, triangles] : graph.neighbours[at(leaf)]) {
      const auto place = std::lower_bound(leaves.begin(), leaves.end(), other) - leaves.begin();
      TF_CHECK(at(static_cast<std::int32_t>(place)) < leaves.size() &&
               leaves[static_cast<std::size_t>(place)] == other);
      neighbours.push_back({static_cast<std::int32_t>(place), triangles});
    }
  }
  return part;
}

std::vector<std::int32_t> numbered_by_first_leaf(const std::vector<std::int32_t>& leaf2group) {
  std::map<std::int32_t, std::int32_t> group2number;
  std::vector<std::int32_t> numbers;
  for (const std::int32_t group : leaf2group) {
    const auto next = static_cast<std::int32_t>(group2number.size());
    numbers.push_back(group2number.emplace(group, next).first->second);
  }
  return numbers;
}

}  // namespace

std::vector<std::int32_t> assimilate(const SubdomainGraph& graph, std::int32_t groups,
                                     PartitionMethod method) {
  TF_CHECK(groups >= 1);
  const std::vector<std::vector<std::int32_t>> pieces = connected_pieces(graph);
  const std::vector<std::int32_t> shares = shares_of_pieces(graph, pieces, groups);
  std::vector<std::int32_t> mixed(graph.size(), 0);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SubdomainGraph piece = part_of(graph, pieces[i]);
    const std::vector<std::int32_t> leaf2group =
        refine_groups(piece, partition_graph(piece, shares[i], method));
    TF_CHECK(leaf2group.size() == pieces[i].size());
    for (std::size_t leaf = 0; leaf < pieces[i].size(); ++leaf) {
      mixed[at(pieces[i][leaf])] = next + leaf2group[leaf];
    }
    next += 1 + *std::max_element(leaf2group.begin(), leaf2group.end());
  }
  return numbered_by_first_leaf(mixed);
}

Subdomain join_subdomains(std::span<const Subdomain> leaves) { return Joining(leaves).result(); }

void CutNodeMarks::mark(const Subdomain& subdomain, Marks& marks) {
  for (const Origin& origin : subdomain.node_origin) {
    if (!is_of_cut(origin)) continue;
    std::vector<bool>& of_cut = marks[origin.owner];
    if (of_cut.size() <= origin.index) of_cut.resize(origin.index + 1, false);
    of_cut[origin.index] = true;
  }
}

std::vector<DroppedNodes> CutNodeMarks::dropped() const {
  std::vector<DroppedNodes> dropped;
  for (const auto& [cut, there] : there_) {
    const auto found = kept_.find(cut);
    for (std::uint32_t node = 0; node < there.size(); ++node) {
      const bool is_kept =
          found != kept_.end() && node < found->second.size() && found->second[node];
      if (is_kept || !there[node]) continue;
      const bool goes_on = !dropped.empty() && dropped.back().cut.heap == cut &&
                           dropped.back().first + dropped.back().count == node;
      if (goes_on) {
        ++dropped.back().count;
      } else {
        dropped.push_back({{cut}, node, 1});
      }
    }
  }
  return dropped;
}

Balance balance_of(std::span<const double> amounts) {
  if (amounts.empty()) return {};
  return {
      *std::max_element(amounts.begin(), amounts.end()),
      std::accumulate(amounts.begin(), amounts.end(), 0.0) / static_cast<double>(amounts.size())};
}

std::vector<double> sums_of_groups(std::span<const double> amounts,
                                   std::span<const std::int32_t> leaf2group) {
  std::vector<double> sums;
  TF_CHECK(amounts.size() == leaf2group.size());
  for (std::size_t leaf = 0; leaf < leaf2group.size(); ++leaf) {
    const std::size_t group = at(leaf2group[leaf]);
    if (sums.size() <= group) sums.resize(group + 1, 0);
    sums[group] += amounts[leaf];
  }
  return sums;
}

}  // namespace tetfarm
