#include "mesh/decompose/cut_candidate.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/decompose/cut_check.h"
#include "mesh/decompose/cut_lifting.h"
#include "mesh/decompose/edge_path_smoothing.h"
#include "mesh/decompose/path_relaxation.h"

namespace tetfarm {
namespace {

/// Colours, path and loops (thesis 4.3.1.5 to 4.3.1.8).
void find_loops(Candidate& candidate, const Parent& parent) {
  TF_CHECK(candidate.stage == Stage::new_plane);
  const auto& [subdomain, spacing, topology] = parent;
  candidate.colours = colour_by_centroid(topology, candidate.place.plane);
  relax_path(candidate.colours, subdomain, topology, candidate.place.plane);
  tidy_path(candidate.colours, topology, subdomain.triangles);
  const auto is_left = [](Side side) { return side == Side::left; };
  const bool has_left = std::any_of(candidate.colours.begin(), candidate.colours.end(), is_left);
  const bool has_right = !std::all_of(candidate.colours.begin(), candidate.colours.end(), is_left);
  if (!has_left || !has_right) return refuse(candidate, "no crossing");
  candidate.loops = find_edge_loops(candidate.colours, topology, subdomain.triangles);
  if (!candidate.loops.pinched_nodes.empty()) return refuse(candidate, "pinch");
  for (const auto& loop : candidate.loops.loops) {
    for (const RimEdge& edge : loop) {
      candidate.corners.push_back(rim_corner(subdomain, topology, edge));
      candidate.cosine = std::max(candidate.cosine, cosine_at_bisector(candidate.corners.back()));
    }
  }
  candidate.stage = Stage::has_loops;
}

/// Chords whose ends keep a cut triangle at a small angle to the surface, or too near to it.
std::vector<Chord> find_harmful_chords(const Candidate& candidate, const Parent& parent,
                                       const std::vector<SurfaceContact>& contacts,
                                       double cosine_limit) {
  const InterdomainMesh& mesh = candidate.mesh;
  std::vector<Chord> harmful;
  const auto add = [&](std::int32_t triangle) {
    const auto chords = chords_of_triangle(mesh, triangle);
    harmful.insert(harmful.end(), chords.begin(), chords.end());
  };
  for (const SurfaceContact& contact : contacts) {
    if (is_too_near(contact)) add(contact.cut_triangle);
  }
  const auto cosines = cosines_at_rim(mesh, parent.subdomain, candidate.corners);
  TF_CHECK(candidate.corners.size() == mesh.rim.size());
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    if (cosines[i] > cosine_limit) add(mesh.rim2triangle[i]);
  }
  std::sort(harmful.begin(), harmful.end());
  harmful.erase(std::unique(harmful.begin(), harmful.end()), harmful.end());
  return harmful;
}

/// The lattice nodes that a lattice plane brings into its cut.
InnerNodes lattice_nodes_of(const Candidate& candidate, const Parent& parent) {
  InnerNodes inner;
  if (!candidate.place.lattice) return inner;
  Box3 box;
  for (const auto& loop : candidate.loops.loops) {
    for (const RimEdge& edge : loop) box.add(parent.subdomain.vertices[at(edge.from)]);
  }
  inner.lattice = parent.spacing.lattice_nodes_in_plane(box, *candidate.place.lattice);
  return inner;
}

/// The inter-domain mesh, lifted and checked (thesis 4.3.1.9). Chords that do harm are split (fig.
/// 63).
void make_mesh(Candidate& candidate, const Parent& parent, double cosine_limit) {
  TF_CHECK(candidate.stage == Stage::has_loops);
  constexpr int most_rounds = 3;
  const double worst_triangle = cosine_of_degrees(8);
  InnerNodes inner = lattice_nodes_of(candidate, parent);
  std::vector<SurfaceContact> contacts;
  for (int round = 0; round < most_rounds; ++round) {
    InterdomainResult made = mesh_interdomain(parent.subdomain, parent.topology, candidate.loops,
                                              candidate.place.plane, parent.spacing, inner);
    if (!made.problem.empty()) return refuse(candidate, made.problem);
    candidate.mesh = std::move(made.mesh);
    contacts = lift_and_push(candidate.mesh, parent.subdomain, parent.topology, candidate.colours,
                             candidate.corners);
    if (is_entangled(candidate.mesh, contacts)) break;
    const auto harmful = find_harmful_chords(candidate, parent, contacts, cosine_limit);
    if (harmful.empty()) break;
    inner.unwanted_chords.insert(inner.unwanted_chords.end(), harmful.begin(), harmful.end());
  }
  const std::string problem = judge_contacts(contacts);
  if (!problem.empty()) return refuse(candidate, problem);
  if (!shells_are_on_their_sides(candidate.mesh, parent.subdomain, candidate.colours,
                                 parent.topology.triangle2shell)) {
    return refuse(candidate, "shell on the wrong side");
  }
  if (cosine_of_smallest_triangle_angle(candidate.mesh, parent.subdomain) > worst_triangle) {
    return refuse(candidate, "thin triangle");
  }
  const auto cosines = cosines_at_rim(candidate.mesh, parent.subdomain, candidate.corners);
  candidate.cosine = cosines.empty() ? 0 : *std::max_element(cosines.begin(), cosines.end());
  candidate.stage = Stage::has_mesh;
}

}  // namespace

void refuse(Candidate& candidate, const std::string& problem) {
  PlaneCandidate place = candidate.place;
  candidate = Candidate{};
  candidate.place = place;
  candidate.stage = Stage::refused;
  candidate.problem = problem;
}

bool passes(Candidate& candidate, const Parent& parent, double cosine_limit) {
  if (candidate.stage == Stage::new_plane) find_loops(candidate, parent);
  if (candidate.stage == Stage::has_loops && candidate.cosine <= cosine_limit) {
    make_mesh(candidate, parent, cosine_limit);
  }
  return candidate.stage == Stage::has_mesh && candidate.cosine <= cosine_limit;
}

}  // namespace tetfarm
