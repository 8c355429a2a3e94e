/// Makes groups of leaves connected and evens out their work, by moving leaves between neighbours.
///
/// The thesis takes what METIS gives (4.3.2); its groups may be in several pieces, and with some
/// ten leaves to a group their work differs by several percent. Here a group is connected through
/// shared triangles, so that joining its leaves gives one sub-domain; then leaves move to a
/// neighbouring group, or change places with one of it, as long as that evens out the work.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/assimilation/subdomain_graph.h"

namespace tetfarm {

struct RefinementOptions {
  /// Enough when the heaviest group has no more than this, times the mean.
  double balanced = 1.02;
};

/// The groups of the leaves, numbered from 0 in the order of their first leaves. There are as many
/// as before, but for empty ones that no leaf could be found for, and for pieces of the domain that
/// touch no other: a group never spans two of them.
/// Deterministic; ties are decided by the numbers of leaves and groups.
/// Cost: O(moves * leaves of two groups * their leaves), some milliseconds for hundreds of leaves.
std::vector<std::int32_t> refine_groups(const SubdomainGraph& graph,
                                        std::span<const std::int32_t> leaf2group,
                                        const RefinementOptions& options = {});

/// The leaves of each part of the graph that hangs together, ascending; by their first leaves.
std::vector<std::vector<std::int32_t>> connected_pieces(const SubdomainGraph& graph);

/// Whether the leaves of each group hang together through shared triangles.
bool groups_are_connected(const SubdomainGraph& graph, std::span<const std::int32_t> leaf2group);

}  // namespace tetfarm
