/// The graph of the leaves of a decomposition: which of them are neighbours, and how strongly.
///
/// Source: thesis 4.3.2, figs. 66-68. A node is a leaf, an edge joins two leaves that share
/// inter-domain triangles and is weighted by their number. A departure: a node is weighted by its
/// estimated elements, as the cuts are, not by its boundary faces.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh/core/subdomain.h"

namespace tetfarm {

struct Neighbour {
  std::int32_t leaf = 0;
  std::int32_t triangles = 0;  ///< that the two share
};

/// Invariants: all vectors have one entry for each leaf, in the order in which they were added;
/// neighbours are ascending, never the leaf itself, and mutual.
struct SubdomainGraph {
  std::vector<TreePath> path;
  std::vector<double> work;                   ///< estimated elements
  std::vector<std::int64_t> faces;            ///< boundary triangles
  std::vector<std::int32_t> interface_nodes;  ///< nodes of inter-domain triangles
  std::vector<std::vector<Neighbour>> neighbours;

  std::size_t size() const { return path.size(); }
};

/// Sees one leaf after the other, so that no two are in memory: of each inter-domain triangle it
/// keeps who has it. Cost: 4 bytes an inter-domain triangle.
class SubdomainGraphBuilder {
 public:
  /// @throws Error when a third leaf has an inter-domain triangle.
  void add(const Subdomain& leaf, double work);

  /// @throws Error when an inter-domain triangle was met once only: a leaf is missing.
  SubdomainGraph finish() &&;

 private:
  void meet(const Origin& triangle, std::int32_t leaf);

  SubdomainGraph graph_;
  std::map<std::uint64_t, std::vector<std::int32_t>> cut2first_leaf_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> shared_;
};

/// How many nodes of a sub-domain lie on inter-domain triangles: what it communicates with others
/// (thesis fig. 69). Cost: O(n).
std::int32_t interface_nodes_of(const Subdomain& subdomain);

}  // namespace tetfarm
