/// Joins the leaves of an over-decomposition into fewer sub-domains of about equal work.
///
/// Source: thesis 4.3.2 and 4.3.2.2. The leaves are grouped by a graph partitioner; the leaves of a
/// group become one sub-domain by dropping the triangles that two of them share. Nodes and
/// triangles keep their origins, so that the joined sub-domains agree with each other exactly as
/// leaves do.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "mesh/assimilation/graph_partition.h"
#include "mesh/assimilation/subdomain_graph.h"

namespace tetfarm {

/// The group of each leaf, numbered from 0 in the order of their first leaves. Every group is
/// connected through shared triangles. There are `groups` of them, or fewer where there are fewer
/// leaves, or more where the domain is in more pieces. Pieces (the regions of a domain, for
/// instance) are grouped each by itself, with groups shared out by their work. @pre 1 <= groups,
/// the graph has a leaf.
std::vector<std::int32_t> assimilate(const SubdomainGraph& graph, std::int32_t groups,
                                     PartitionMethod method);

/// One sub-domain of several leaves, under the path of the first. Vertices and triangles keep their
/// order, leaf by leaf; what two leaves share is there once (nodes) or not at all (triangles), and
/// nodes that no triangle is left of are gone. Two shells may touch at a node or an edge where the
/// leaves did. @pre leaves are of one decomposition. @throws Error when they are of two
/// regions, a shared triangle is not reversed, or a shared node lies at two places. Cost: O(n log
/// n); all leaves are in memory.
Subdomain join_subdomains(std::span<const Subdomain> leaves);

/// Consecutive nodes of an inter-domain mesh that are on no boundary any more.
struct DroppedNodes {
  TreePath cut;
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const DroppedNodes&, const DroppedNodes&) = default;
};

/// Finds out which nodes of the cuts are dropped, seeing one sub-domain at a time.
/// Cost: two bits a node.
class CutNodeMarks {
 public:
  void add_leaf(const Subdomain& leaf) { mark(leaf, there_); }
  void add_joined(const Subdomain& group) { mark(group, kept_); }
  /// By cut and number.
  std::vector<DroppedNodes> dropped() const;

 private:
  using Marks = std::map<std::uint64_t, std::vector<bool>>;
  static void mark(const Subdomain& subdomain, Marks& marks);

  Marks there_;
  Marks kept_;
};

/// How evenly something is spread over groups (thesis figs. 70 and 71).
struct Balance {
  double largest = 0;
  double mean = 0;
  double ratio() const { return mean > 0 ? largest / mean : 1; }
};
Balance balance_of(std::span<const double> amounts);

/// The sums of the leaves' amounts, group by group.
std::vector<double> sums_of_groups(std::span<const double> amounts,
                                   std::span<const std::int32_t> leaf2group);

}  // namespace tetfarm
