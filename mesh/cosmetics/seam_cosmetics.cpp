#include "mesh/cosmetics/seam_cosmetics.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/error.h"
#include "mesh/core/validate.h"
#include "mesh/cosmetics/element_passing.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// The part of the joined sections that is worked on, as a mesh of its own. The nodes of its outer
/// faces come first: they stay.
struct Region {
  TetMesh mesh;
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
  region.outer_faces = outer_faces_of(make_tet_complex(region.mesh));
  put_outer_nodes_first(region);
  return region;
}

using SortedTet = std::array<std::int32_t, 4>;

SortedTet sorted_tet(Tet tet) {
  std::sort(tet.begin(), tet.end());
  return tet;
}

/// Where the tets of a region lay before it was worked on.
class OldTets {
 public:
  OldTets(const Region& region, const JoinedElements& joined) : mesh_(region.mesh) {
    for (std::size_t i = 0; i < region.tets.size(); ++i) {
      homes_.push_back(joined.tet_home[region.tets[i]]);
      by_nodes_.emplace_back(sorted_tet(mesh_.tets[i]), static_cast<std::int32_t>(i));
    }
    std::sort(by_nodes_.begin(), by_nodes_.end());
  }

  std::optional<ElementHome> home_of_same(const Tet& tet) const {
    const SortedTet nodes = sorted_tet(tet);
    const auto found = std::lower_bound(
        by_nodes_.begin(), by_nodes_.end(), nodes,
        [](const auto& item, const SortedTet& wanted) { return item.first < wanted; });
    if (found == by_nodes_.end() || found->first != nodes) return std::nullopt;
    return homes_[at(found->second)];
  }

  /// The home of the tet that held the point; where rounding leaves doubt, of the one that comes
  /// nearest to holding it.
  ElementHome home_at(const Vec3& p) {
    if (tree_.size() == 0) build_tree();
    Box3 box;
    box.add(p);
    std::int32_t best = 0;
    double best_inside = -HUGE_VAL;
    tree_.query(box, [&](std::int32_t t) {
      const double inside = how_far_inside(t, p);
      if (inside > best_inside || (inside == best_inside && t < best)) {
        best = t;
        best_inside = inside;
      }
    });
    return homes_[at(best)];
  }

 private:
  void build_tree() {
    std::vector<Box3> boxes(mesh_.tets.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
      for (const std::int32_t v : mesh_.tets[t]) boxes[t].add(mesh_.nodes[at(v)]);
    }
    tree_ = BoxTree(boxes);
  }

  /// The smallest barycentric coordinate of p, times the volume: negative outside.
  double how_far_inside(std::int32_t t, const Vec3& p) const {
    const Tet& tet = mesh_.tets[at(t)];
    double least = HUGE_VAL;
    for (std::size_t face = 0; face < 4; ++face) {
      const auto node = [&](std::size_t i) {
        return mesh_.nodes[at(tet[at(tet_face_nodes[face][i])])];
      };
      least = std::min(least, orient3d(node(0), node(2), node(1), p));
    }
    return least;
  }

  const TetMesh& mesh_;
  std::vector<ElementHome> homes_;
  std::vector<std::pair<SortedTet, std::int32_t>> by_nodes_;
  BoxTree tree_;
};

Vec3 centroid_of(const TetComplex& complex, const Tet& tet) {
  Vec3 sum;
  for (const std::int32_t v : tet) sum += complex.points[at(v)];
  return 0.25 * sum;
}

void require_valid(const TetComplex& complex, const Region& region, std::uint64_t self) {
  TetMesh mesh = to_tet_mesh(complex, region.mesh.boundary_nodes);
  std::vector<std::int32_t> number(mesh.nodes.size(), -1);
  std::int32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (complex.node2tet[v] < 0 && at(v) >= at(mesh.boundary_nodes)) continue;
    number[v] = count;
    mesh.nodes[at(count++)] = mesh.nodes[v];
  }
  mesh.nodes.resize(at(count));
  for (Tet& tet : mesh.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  const std::vector<std::string> complaints = validate(mesh, region.outer_faces);
  if (complaints.empty()) return;
  throw Error(ExitCode::failed, "cosmetics round sub-domain " + TreePath{self}.text() +
                                    " made an invalid mesh: " + complaints.front());
}

/// Puts the nodes of the improved region back; the joined number of each.
std::vector<std::int32_t> return_nodes(const Region& region, const TetComplex& complex,
                                       const SeamTurn& turn, JoinedElements& joined,
                                       SeamResult& result) {
  result.next_node = turn.next_node;
  std::vector<std::int32_t> region2joined = region.region2joined;
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
                 const std::vector<std::int32_t>& region2joined, JoinedElements& joined) {
  OldTets old(region, joined);
  std::vector<Tet> tets;
  std::vector<ElementHome> homes;
  for (std::size_t t = 0, next = 0; t < joined.tets.size(); ++t) {
    if (next < region.tets.size() && region.tets[next] == t) {
      ++next;
      continue;
    }
    tets.push_back(joined.tets[t]);
    homes.push_back(joined.tet_home[t]);
  }
  for (Tet tet : complex.nodes) {
    if (tet[0] < 0) continue;
    const auto same = old.home_of_same(tet);
    homes.push_back(same ? *same : old.home_at(centroid_of(complex, tet)));
    for (std::int32_t& v : tet) v = region2joined[at(v)];
    tets.push_back(tet);
  }
  joined.tets = std::move(tets);
  joined.tet_home = std::move(homes);
}

}  // namespace

SeamResult improve_seams(const std::vector<ElementSection>& sections, const SeamTurn& turn,
                         const SeamOptions& options) {
  SeamResult result;
  result.next_node = turn.next_node;
  if (sections.empty()) return result;
  std::vector<Sharers> sharers;
  for (const ElementSection& section : sections) sharers.push_back(section.sharers);
  JoinedElements joined = join_elements(sections);
  const Region region = region_of(joined, tets_within_reach(joined, sharers, turn, options));
  TetComplex complex = make_tet_complex(region.mesh);
  result.tets = std::ssize(region.tets);
  result.report = improve_mesh(complex, region.mesh.boundary_nodes, options.cosmetics);
  require_valid(complex, region, turn.self);
  return_tets(region, complex, return_nodes(region, complex, turn, joined, result), joined);
  result.sections = share_out_elements(joined, sharers);
  return result;
}

}  // namespace tetfarm
