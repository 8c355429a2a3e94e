#include "mesh/cosmetics/element_splitting.h"

#include <algorithm>

#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/smoothing.h"

namespace tetfarm::cosmetics {

namespace {

constexpr std::size_t most_cavity = 24;
constexpr std::size_t most_ring = 12;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// An outer face of a cavity as its inside sees it, and the tet beyond (-1: none).
struct CavityFace {
  std::array<std::int32_t, 3> nodes;
  std::int32_t beyond;
};

std::vector<CavityFace> faces_of_cavity(WorkMesh& work, const std::vector<std::int32_t>& cavity) {
  work.clear_marks();
  for (const std::int32_t t : cavity) work.set_mark(t);
  std::vector<CavityFace> faces;
  for (const std::int32_t t : cavity) {
    const Tet& tet = work.tet(t);
    for (int face = 0; face < 4; ++face) {
      const FaceHandle across = work.across(t, face);
      const std::int32_t beyond = across == no_face ? -1 : tet_of(across);
      if (beyond >= 0 && work.is_marked(beyond)) continue;
      const auto& local = tet_face_nodes[at(face)];
      faces.push_back({{tet[at(local[2])], tet[at(local[1])], tet[at(local[0])]}, beyond});
    }
  }
  return faces;
}

double goodness_over(const WorkMesh& work, const CavityFace& face, const Vec3& p) {
  return goodness(work.point(face.nodes[0]), work.point(face.nodes[1]), work.point(face.nodes[2]),
                  p);
}

/// Fills the cavity with tets from its faces to a new node; its best place is sought from `start`.
std::optional<Replacement> fill_with_star(WorkMesh& work, const std::vector<std::int32_t>& cavity,
                                          const Vec3& start, const SplitOptions& options) {
  const std::vector<CavityFace> faces = faces_of_cavity(work, cavity);
  Star star;
  for (const CavityFace& face : faces) {
    star.push_back(
        {work.point(face.nodes[0]), work.point(face.nodes[1]), work.point(face.nodes[2])});
  }
  const Place place = climb(star, start, options.enough);
  const double before = worst_of(work, cavity);
  if (!(place.worst > (options.takes_any ? 0 : least_worth(before)))) return std::nullopt;
  const auto is_too_near = [&](const Vec3& corner) {
    return norm2(corner - place.point) < options.least_distance * options.least_distance;
  };
  const auto node = static_cast<std::int32_t>(work.complex.points.size());
  Replacement replacement{cavity, {}, before, place.worst, place.point};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (std::any_of(star[i].begin(), star[i].end(), is_too_near)) return std::nullopt;
    const auto& [a, b, c] = faces[i].nodes;
    replacement.new_tets.push_back({a, b, c, node});
  }
  return replacement;
}

/// Takes the tet beyond the face that p sees worst into the cavity, again and again, and returns
/// the cavity that p saw best.
std::vector<std::int32_t> grown_cavity(WorkMesh& work, std::int32_t t, const Vec3& p) {
  std::vector<std::int32_t> cavity = {t};
  std::size_t best_size = 1;
  double best_worst = -HUGE_VAL;
  while (true) {
    double worst = 1;
    std::int32_t beyond = -1;
    for (const CavityFace& face : faces_of_cavity(work, cavity)) {
      const double here = goodness_over(work, face, p);
      if (here >= worst) continue;
      worst = here;
      beyond = face.beyond;
    }
    if (worst > best_worst) {
      best_worst = worst;
      best_size = cavity.size();
    }
    if (beyond < 0 || cavity.size() == most_cavity) break;
    cavity.push_back(beyond);
  }
  cavity.resize(best_size);
  return cavity;
}

}  // namespace

std::optional<Replacement> find_split(WorkMesh& work, std::int32_t t, const SplitOptions& options) {
  std::optional<Replacement> best;
  const auto take = [&best](std::optional<Replacement> found) {
    if (found && (!best || found->new_worst > best->new_worst)) best = std::move(found);
  };
  const Tet tet = work.tet(t);
  Vec3 centre;
  for (const std::int32_t v : tet) centre += 0.25 * work.point(v);
  take(fill_with_star(work, grown_cavity(work, t, centre), centre, options));
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const Vec3 middle = 0.5 * (work.point(tet[at(i)]) + work.point(tet[at(j)]));
      const auto ring = ring_of_edge(work, t, i, j, most_ring);
      if (ring) take(fill_with_star(work, ring->tets, middle, options));
    }
  }
  return best;
}

}  // namespace tetfarm::cosmetics
