#include "mesh/cosmetics/seam_cosmetics.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/cosmetics/element_homes.h"

namespace tetfarm {
namespace {

/// The part of the joined sections that is worked on, as a mesh of its own. The nodes of its outer
/// faces come first: they stay.
struct Region {
  TetMesh mesh;
  TetComplex complex;  ///< the mesh with neighbours; sorting for them once is enough
  std::vector<Triangle> outer_faces;
  std::vector<std::int32_t> region2joined;
  std::vector<std::size_t> tets;  ///< in the joined sections, ascending
};

std::vector<std::size_t> tets_within_reach(const JoinedElements& joined,
                                           const std::vector<Sharers>& sharers,
                                           const SeamTurn& turn, const SeamOptions& options) {
  const int most = std::max(options.first_layers, options.later_layers);
  const std::vector<int> layers = layers_from(joined, sharers, turn.self, most);
  std::vector<std::size_t> tets;
  for (std::size_t t = 0; t < joined.tets.size(); ++t) {
    const ElementHome& home = joined.tet_home[t];
    const std::uint64_t owner = sharers[home.section][home.owner];
    const bool had_turn = std::binary_search(turn.had_turn.begin(), turn.had_turn.end(), owner);
    const int reach = had_turn ? options.later_layers : options.first_layers;
    if (layers[t] <= reach) tets.push_back(t);
  }
  return tets;
}

/// Faces with nothing on the other side, as their tets see them.
std::vector<Triangle> outer_faces_of(const TetComplex& complex) {
  std::vector<Triangle> faces;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (complex.nodes[t][0] < 0) continue;
    for (std::size_t face = 0; face < 4; ++face) {
      if (complex.neighbours[t][face] != no_face) continue;
      const auto& [i, j, k] = tet_face_nodes[face];
      const Tet& tet = complex.nodes[t];
      faces.push_back({tet[at(i)], tet[at(j)], tet[at(k)]});
    }
  }
  return faces;
}

/// Gives the nodes new numbers: those of outer faces first, in their order.
void put_outer_nodes_first(Region& region) {
  std::vector<bool> is_outer(region.mesh.nodes.size(), false);
  for (const Triangle& face : region.outer_faces) {
    for (const std::int32_t v : face) is_outer[at(v)] = true;
  }
  const auto outer_nodes = std::count(is_outer.begin(), is_outer.end(), true);
  std::int32_t next_outer = 0;
  auto next_inner = static_cast<std::int32_t>(outer_nodes);
  std::vector<std::int32_t> number(is_outer.size());
  std::vector<Vec3> nodes(is_outer.size());
  std::vector<std::int32_t> region2joined(is_outer.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[v] = is_outer[v] ? next_outer++ : next_inner++;
    nodes[at(number[v])] = region.mesh.nodes[v];
    region2joined[at(number[v])] = region.region2joined[v];
  }
  for (Tet& tet : region.mesh.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  for (Triangle& face : region.outer_faces) {
    for (std::int32_t& v : face) v = number[at(v)];
  }
  std::vector<std::int32_t> node2tet(is_outer.size());
  TF_CHECK(next_inner == static_cast<std::int32_t>(is_outer.size()) && next_outer == outer_nodes);
  for (std::size_t v = 0; v < number.size(); ++v) {
    node2tet[at(number[v])] = region.complex.node2tet[v];
  }
  region.complex.node2tet = std::move(node2tet);
  region.complex.nodes = region.mesh.tets;
  region.complex.points = nodes;
  region.mesh.nodes = std::move(nodes);
  region.mesh.boundary_nodes = static_cast<std::int32_t>(outer_nodes);
  region.region2joined = std::move(region2joined);
}

Region region_of(const JoinedElements& joined, std::vector<std::size_t> tets) {
  Region region;
  region.tets = std::move(tets);
  std::vector<std::int32_t> local(joined.nodes.size(), -1);
  for (const std::size_t t : region.tets) {
    Tet tet = joined.tets[t];
    for (std::int32_t& v : tet) {
      if (local[at(v)] < 0) {
        local[at(v)] = static_cast<std::int32_t>(region.region2joined.size());
        region.region2joined.push_back(v);
        region.mesh.nodes.push_back(joined.nodes[at(v)]);
      }
      v = local[at(v)];
    }
    region.mesh.tets.push_back(tet);
  }
  region.complex = make_tet_complex(region.mesh);
  region.outer_faces = outer_faces_of(region.complex);
  put_outer_nodes_first(region);
  return region;
}

/// As sets: each face begins with its smallest node, and they ascend.
std::vector<Triangle> in_order(std::vector<Triangle> faces) {
  for (Triangle& face : faces) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Tets of positive volume that agree with their neighbours fill what their outer faces enclose,
/// each point once: that these are as before is all that is left to ask, and nothing need be sorted
/// but them.
void require_valid(const TetComplex& complex, const Region& region, std::uint64_t self) {
  std::vector<std::string> complaints = validate(complex);
  if (complaints.empty() && in_order(outer_faces_of(complex)) != in_order(region.outer_faces)) {
    complaints.emplace_back("its outer faces are not what they were");
  }
  if (complaints.empty()) return;
  throw Error(ExitCode::failed, "cosmetics around sub-domain " + TreePath{self}.text() +
                                    " made an invalid mesh: " + complaints.front());
}

/// Puts the nodes of the improved region back; the joined number of each.
std::vector<std::int32_t> return_nodes(const Region& region, const TetComplex& complex,
                                       const SeamTurn& turn, JoinedElements& joined,
                                       SeamResult& result) {
  result.next_node = turn.next_node;
  std::vector<std::int32_t> region2joined = region.region2joined;
  TF_CHECK(complex.points.size() >= region.region2joined.size());
  for (std::size_t v = 0; v < complex.points.size(); ++v) {
    const bool is_used = complex.node2tet[v] >= 0;
    if (v < region.region2joined.size()) {
      const std::size_t node = at(region.region2joined[v]);
      joined.nodes[node] = complex.points[v];
      if (!is_used) result.gone.push_back(joined.node_origin[node]);
      continue;
    }
    region2joined.push_back(static_cast<std::int32_t>(joined.nodes.size()));
    if (!is_used) continue;
    joined.nodes.push_back(complex.points[v]);
    joined.node_origin.push_back({turn.self, result.next_node++});
  }
  std::sort(result.gone.begin(), result.gone.end());
  return region2joined;
}

/// Puts the tets of the improved region back, behind those that were out of reach.
void return_tets(const Region& region, const TetComplex& complex,
                 const std::vector<std::int32_t>& region2joined,
                 const std::vector<ElementHome>& homes, JoinedElements& joined) {
  TF_CHECK(homes.size() == complex.live_tets());
  std::size_t kept = 0;
  for (std::size_t t = 0, next = 0; t < joined.tets.size(); ++t) {
    if (next < region.tets.size() && region.tets[next] == t) {
      ++next;
      continue;
    }
    joined.tets[kept] = joined.tets[t];
    joined.tet_home[kept++] = joined.tet_home[t];
  }
  joined.tets.resize(kept);
  joined.tet_home.resize(kept);
  for (Tet tet : complex.nodes) {
    if (tet[0] < 0) continue;
    for (std::int32_t& v : tet) v = region2joined[at(v)];
    joined.tets.push_back(tet);
  }
  joined.tet_home.insert(joined.tet_home.end(), homes.begin(), homes.end());
  TF_CHECK(joined.tet_home.size() == joined.tets.size());
}

}  // namespace

SeamResult improve_seams(std::vector<ElementSection> sections, const SeamTurn& turn,
                         const SeamOptions& options) {
  SeamResult result;
  result.next_node = turn.next_node;
  if (sections.empty()) return result;
  std::vector<Sharers> sharers;
  for (const ElementSection& section : sections) sharers.push_back(section.sharers);
  JoinedElements joined = join_elements(std::move(sections));
  Region region = region_of(joined, tets_within_reach(joined, sharers, turn, options));
  TetComplex complex = std::move(region.complex);
  result.tets = std::ssize(region.tets);
  result.report = improve_mesh(complex, region.mesh.boundary_nodes, options.cosmetics);
  require_valid(complex, region, turn.self);
  std::vector<ElementHome> homes;
  for (const std::size_t t : region.tets) homes.push_back(joined.tet_home[t]);
  homes = find_homes(region.mesh, homes, complex);
  const auto region2joined = return_nodes(region, complex, turn, joined, result);
  return_tets(region, complex, region2joined, homes, joined);
  complex = TetComplex{};
  result.sections = share_out_elements(joined, sharers);
  return result;
}

}  // namespace tetfarm
