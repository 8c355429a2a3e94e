#include "mesh/decompose/cut_lifting.h"

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "mesh/decompose/cut_check.h"
#include "mesh/decompose/intersection_repair.h"
#include "mesh/decompose/lift_heights.h"

namespace tetfarm {
namespace {

/// The lift of a candidate, and what it has been asked for so far.
struct Lift {
  std::vector<double> bisector_weights;
  std::vector<std::optional<double>> pushed;
};

/// Solves, and solves again with more weight on rim edges where the angle is still small.
void lift(InterdomainMesh& mesh, const Subdomain& subdomain, const std::vector<RimCorner>& corners,
          Lift& state) {
  constexpr int most_rounds = 4;
  constexpr double more_weight = 5;
  const double good_enough = cosine_of_degrees(45);
  for (int round = 0; round < most_rounds; ++round) {
    lift_heights(mesh, corners, state.bisector_weights, state.pushed);
    const auto cosines = cosines_at_rim(mesh, subdomain, corners);
    bool is_good = true;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      if (cosines[i] <= good_enough) continue;
      state.bisector_weights[i] *= more_weight;
      is_good = false;
    }
    if (is_good) return;
  }
}

/// The heights of the lattice nodes that are to stay where they are.
std::vector<std::optional<double>> held_heights(const InterdomainMesh& mesh) {
  std::vector<std::optional<double>> held;
  if (mesh.lattice.empty()) return held;
  held.resize(mesh.planar.points.size());
  TF_CHECK(mesh.rim_vertices.size() + mesh.lattice.size() <= held.size());
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    if (mesh.lattice[i].is_held) {
      held[mesh.rim_vertices.size() + i] = mesh.plane.height(mesh.lattice[i].at);
    }
  }
  return held;
}

std::size_t most_contacts(const InterdomainMesh& mesh) {
  constexpr std::size_t of_a_triangle = 12;
  constexpr std::size_t of_a_small_cut = 200;
  return of_a_triangle * mesh.planar.triangles.size() + of_a_small_cut;
}

std::ptrdiff_t count_too_near(const std::vector<SurfaceContact>& contacts) {
  return std::count_if(contacts.begin(), contacts.end(), is_too_near);
}

}  // namespace

bool is_entangled(const InterdomainMesh& mesh, const std::vector<SurfaceContact>& contacts) {
  return contacts.size() > most_contacts(mesh);
}

std::vector<SurfaceContact> lift_and_push(InterdomainMesh& mesh, const Subdomain& subdomain,
                                          const SurfaceTopology& topology,
                                          const FaceColours& colours,
                                          const std::vector<RimCorner>& corners) {
  constexpr int most_pushes = 6;
  constexpr int most_vain_pushes = 2;
  constexpr double margin = 2;  // in triangle sizes; nodes are pushed by less
  const double reach = PushOptions{}.too_near;
  TF_CHECK(colours.size() == subdomain.triangles.size());
  Lift state{std::vector<double>(mesh.rim.size(), usual_bisector_weight), held_heights(mesh)};
  lift(mesh, subdomain, corners, state);
  const NearbySurface nearby = find_nearby_surface(mesh, subdomain, topology, margin);
  auto contacts = find_contacts(mesh, subdomain, topology, nearby, reach, most_contacts(mesh));
  if (is_entangled(mesh, contacts)) return contacts;
  auto fewest = count_too_near(contacts);
  int vain = 0;
  for (int i = 0; i < most_pushes && vain < most_vain_pushes; ++i) {
    if (push_nodes(mesh, subdomain, colours, contacts, state.pushed) == 0) break;
    lift(mesh, subdomain, corners, state);
    contacts = find_contacts(mesh, subdomain, topology, nearby, reach);
    const auto now = count_too_near(contacts);
    vain = now < fewest ? 0 : vain + 1;
    fewest = std::min(fewest, now);
    if (now == 0) break;
  }
  return contacts;
}

}  // namespace tetfarm
