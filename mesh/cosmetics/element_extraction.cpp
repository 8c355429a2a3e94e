#include "mesh/cosmetics/element_extraction.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/cosmetics/element_passing.h"
#include "mesh/cosmetics/taken_tets.h"

namespace tetfarm {
namespace {

/// The sets by preference: the places in `sets`.
std::vector<std::uint32_t> by_preference(const std::vector<Sharers>& sets) {
  std::vector<std::uint32_t> order(sets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&sets](std::uint32_t a, std::uint32_t b) {
    const Sharers& s = sets[a];
    const Sharers& t = sets[b];
    return s.size() != t.size() ? s.size() > t.size() : s < t;
  });
  return order;
}

/// The rank of each node of the mesh that is shared; no_set_rank for the others.
std::vector<SetRank> ranks_of_nodes(const Subdomain& leaf, std::size_t nodes,
                                    const SharedNodes& shared,
                                    const std::vector<std::uint32_t>& preference) {
  std::vector<SetRank> rank_of_set(preference.size());
  for (SetRank rank = 0; rank < preference.size(); ++rank) rank_of_set[preference[rank]] = rank;
  std::vector<SetRank> ranks(nodes, no_set_rank);
  for (std::size_t v = 0; v < leaf.vertices.size(); ++v) {
    const Origin& origin = leaf.node_origin[v];
    const auto found = std::lower_bound(
        shared.nodes.begin(), shared.nodes.end(), origin,
        [](const SharedNodes::Node& node, const Origin& wanted) { return node.origin < wanted; });
    if (found == shared.nodes.end() || found->origin != origin) continue;
    TF_CHECK(found->set < rank_of_set.size());
    ranks[v] = rank_of_set[found->set];
  }
  return ranks;
}

Origin origin_of(const Subdomain& leaf, std::size_t node) {
  const std::size_t outer = leaf.vertices.size();
  if (node < outer) return leaf.node_origin[node];
  return {leaf.path.heap, static_cast<std::uint32_t>(node - outer)};
}

/// The tets without those that were taken, in place.
std::vector<Tet> without(const std::vector<std::uint32_t>& taken, std::vector<Tet> tets) {
  auto next = taken.begin();
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (next != taken.end() && *next == t) {
      ++next;
    } else {
      tets[kept++] = tets[t];
    }
  }
  TF_CHECK(next == taken.end());
  tets.resize(kept);
  return tets;
}

/// Gives the section those nodes of the mesh that its tets have, ascending by origin, and its
/// elements the numbers there.
void take_nodes_by_origin(const Subdomain& leaf, const std::vector<Vec3>& nodes,
                          ElementSection& section) {
  std::vector<std::int32_t> number(nodes.size(), -1);
  for (const Tet& tet : section.tets) {
    for (const std::int32_t v : tet) number[at(v)] = 0;
  }
  std::vector<std::int32_t> order;
  order.reserve(nodes.size());
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    if (number[v] == 0) order.push_back(static_cast<std::int32_t>(v));
  }
  const auto by_origin = [&leaf](std::int32_t a, std::int32_t b) {
    return origin_of(leaf, at(a)) < origin_of(leaf, at(b));
  };
  if (!std::is_sorted(order.begin(), order.end(), by_origin)) {
    std::sort(order.begin(), order.end(), by_origin);
  }
  section.nodes.reserve(order.size());
  section.node_origin.reserve(order.size());
  for (const std::int32_t v : order) {
    number[at(v)] = static_cast<std::int32_t>(section.nodes.size());
    section.nodes.push_back(nodes[at(v)]);
    section.node_origin.push_back(origin_of(leaf, at(v)));
  }
  TF_CHECK(section.nodes.size() == order.size());
  for (Tet& tet : section.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  for (Triangle& triangle : section.triangles) {
    for (std::int32_t& v : triangle) v = number[at(v)];
  }
}

/// The taken tets as a mesh of their own, its nodes ascending by origin.
JoinedElements taken_elements(const Subdomain& leaf, const TetMesh& mesh,
                              const std::vector<TakenTet>& taken,
                              const std::vector<ElementHome>& home_of_rank) {
  JoinedElements joined;
  std::vector<std::int32_t> number(mesh.nodes.size(), -1);
  std::vector<std::pair<Origin, std::int32_t>> nodes;
  for (const TakenTet& item : taken) {
    TF_CHECK(item.tet < mesh.tets.size());
    joined.tets.push_back(mesh.tets[item.tet]);
    joined.tet_home.push_back(home_of_rank[item.rank]);
    for (const std::int32_t v : mesh.tets[item.tet]) {
      if (number[at(v)] >= 0) continue;
      number[at(v)] = 0;
      nodes.emplace_back(origin_of(leaf, at(v)), v);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  for (const auto& [origin, v] : nodes) {
    number[at(v)] = static_cast<std::int32_t>(joined.nodes.size());
    joined.nodes.push_back(mesh.nodes[at(v)]);
    joined.node_origin.push_back(origin);
  }
  for (Tet& tet : joined.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
    if (leaf.triangle_origin[t].owner != 0) continue;
    Triangle triangle = leaf.triangles[t];
    for (std::int32_t& v : triangle) v = number[at(v)];
    if (*std::min_element(triangle.begin(), triangle.end()) < 0) continue;
    joined.triangles.push_back(triangle);
    joined.triangle_index.push_back(leaf.triangle_origin[t].index);
  }
  return joined;
}

/// Leaves out the triangles that are a face of none of the tets.
void keep_faces_only(JoinedElements& joined) {
  const auto tet_of = tets_of_triangles(joined.nodes.size(), joined.tets, joined.triangles);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tet_of.size(); ++i) {
    if (tet_of[i] == joined.tets.size()) continue;
    joined.triangles[kept] = joined.triangles[i];
    joined.triangle_index[kept++] = joined.triangle_index[i];
  }
  joined.triangles.resize(kept);
  joined.triangle_index.resize(kept);
}

}  // namespace

ExtractedElements extract_elements(const Subdomain& leaf, const TetMesh& mesh,
                                   const SharedNodes& shared, const ExtractionOptions& options) {
  TF_CHECK(shared.path == leaf.path);
  TF_CHECK(mesh.boundary_nodes >= 0 && at(mesh.boundary_nodes) == leaf.vertices.size());
  const std::vector<std::uint32_t> preference = by_preference(shared.sets);
  std::vector<SetRank> ranks = ranks_of_nodes(leaf, mesh.nodes.size(), shared, preference);
  std::vector<Sharers> preferred;
  for (const std::uint32_t set : preference) preferred.push_back(shared.sets[set]);
  const std::vector<TakenTet> taken = taken_tets(mesh, std::move(ranks), preferred, options);
  std::vector<bool> has_tets(preferred.size(), false);
  for (const TakenTet& item : taken) has_tets[item.rank] = true;
  std::vector<Sharers> sharers;
  for (SetRank rank = 0; rank < preferred.size(); ++rank) {
    if (has_tets[rank]) sharers.push_back(preferred[rank]);
  }
  std::sort(sharers.begin(), sharers.end());
  std::vector<ElementHome> home_of_rank;
  for (const Sharers& wanted : preferred) {
    const auto section = std::lower_bound(sharers.begin(), sharers.end(), wanted);
    const auto owner = std::lower_bound(wanted.begin(), wanted.end(), leaf.path.heap);
    home_of_rank.push_back({static_cast<std::uint32_t>(section - sharers.begin()),
                            static_cast<std::uint8_t>(owner - wanted.begin())});
  }
  JoinedElements joined = taken_elements(leaf, mesh, taken, home_of_rank);
  keep_faces_only(joined);
  ExtractedElements extracted;
  extracted.sections = share_out_elements(joined, sharers);
  CoreElements& core = extracted.core;
  core.tets = mesh.tets.size() - taken.size();
  for (const TakenTet& item : taken) core.taken_tets.push_back(item.tet);
  core.taken_triangles = std::move(joined.triangle_index);
  std::sort(core.taken_triangles.begin(), core.taken_triangles.end());
  const auto of_surface = std::count_if(leaf.triangle_origin.begin(), leaf.triangle_origin.end(),
                                        [](const Origin& origin) { return origin.owner == 0; });
  TF_CHECK(static_cast<std::uint64_t>(of_surface) >= core.taken_triangles.size());
  core.triangles = static_cast<std::uint64_t>(of_surface) - core.taken_triangles.size();
  return extracted;
}

ElementSection core_section(const Subdomain& leaf, TetMesh mesh, const CoreElements& core) {
  const auto& taken = core.taken_tets;
  if (core.tets + taken.size() != mesh.tets.size() ||
      (!taken.empty() && taken.back() >= mesh.tets.size())) {
    throw Error(ExitCode::failed, "what was taken out of a core is not of its mesh");
  }
  ElementSection section;
  section.sharers = {leaf.path.heap};
  section.tets = without(taken, std::move(mesh.tets));
  section.tet_owner.assign(section.tets.size(), 0);
  const auto& triangles = core.taken_triangles;
  for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
    const Origin& origin = leaf.triangle_origin[t];
    if (origin.owner != 0) continue;
    if (std::binary_search(triangles.begin(), triangles.end(), origin.index)) continue;
    section.triangles.push_back(leaf.triangles[t]);
    section.triangle_index.push_back(origin.index);
  }
  section.triangle_owner.assign(section.triangles.size(), 0);
  take_nodes_by_origin(leaf, mesh.nodes, section);
  return section;
}

}  // namespace tetfarm
