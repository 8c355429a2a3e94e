#include "mesh/cosmetics/element_splitting.h"

#include <algorithm>
#include <queue>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/smoothing.h"

namespace tetfarm::cosmetics {

namespace {

constexpr std::size_t most_cavity = 24;
/// Layers of flat tets are larger.
constexpr std::size_t most_cavity_of_flat = 160;
constexpr std::size_t most_ring = 12;

/// An outer face of a cavity as its inside sees it, and the tet beyond (-1: none).
struct CavityFace {
  std::array<std::int32_t, 3> nodes;
  std::int32_t beyond;
};

/// Calls visit(face) for those of the tet's faces that no marked tet lies beyond.
template <class Visitor>
void visit_outer_faces(const WorkMesh& work, std::int32_t t, Visitor&& visit) {
  const Tet& tet = work.tet(t);
  for (int face = 0; face < 4; ++face) {
    const FaceHandle across = work.across(t, face);
    const std::int32_t beyond = across == no_face ? -1 : tet_of(across);
    if (beyond >= 0 && work.marks.has(beyond)) continue;
    const auto& local = tet_face_nodes[at(face)];
    visit(CavityFace{{tet[at(local[2])], tet[at(local[1])], tet[at(local[0])]}, beyond});
  }
}

std::vector<CavityFace> faces_of_cavity(WorkMesh& work, const std::vector<std::int32_t>& cavity) {
  work.marks.clear();
  for (const std::int32_t t : cavity) work.marks.add(t);
  std::vector<CavityFace> faces;
  for (const std::int32_t t : cavity) {
    visit_outer_faces(work, t, [&](const CavityFace& face) { faces.push_back(face); });
  }
  return faces;
}

double quality_over(const WorkMesh& work, const CavityFace& face, const Vec3& p) {
  return quality(work.point(face.nodes[0]), work.point(face.nodes[1]), work.point(face.nodes[2]),
                 p);
}

/// The angle between the faces is shared by the two tets of a star over them; the quality of the
/// worse one when they have a half each.
double most_quality_between(const Vec3& normal, const Vec3& other) {
  const double lengths = std::sqrt(norm2(normal) * norm2(other));
  return lengths > 0 ? 0.5 * (1 + dot(normal, other) / lengths) : 1;
}

/// An edge of a face of a cavity, its lower node first.
struct FaceEdge {
  std::array<std::int32_t, 2> nodes;
  std::size_t face;

  friend auto operator<=>(const FaceEdge&, const FaceEdge&) = default;
};

/// Whether the angles between the cavity's faces leave a star with a quality above this possible.
bool has_room_for(const Star& star, const std::vector<CavityFace>& faces, double least) {
  std::vector<Vec3> normals;
  std::vector<FaceEdge> edges;
  normals.reserve(faces.size());
  edges.reserve(3 * faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = star[i];
    normals.push_back(cross(b - a, c - a));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(faces[i].nodes[k], faces[i].nodes[(k + 1) % 3]);
      edges.push_back({{low, high}, i});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i].nodes != edges[i + 1].nodes) continue;
    if (most_quality_between(normals[edges[i].face], normals[edges[i + 1].face]) <= least) {
      return false;
    }
  }
  return true;
}

/// Fills the cavity with tets from its faces to a new node; its best place is sought from `start`.
/// Nothing when that is no better than `beat`.
std::optional<Replacement> fill_with_star(WorkMesh& work, const std::vector<std::int32_t>& cavity,
                                          const Vec3& start, double beat,
                                          const SplitOptions& options) {
  const std::vector<CavityFace> faces = faces_of_cavity(work, cavity);
  TF_CHECK(faces.size() >= 4);
  Star star;
  for (const CavityFace& face : faces) {
    star.push_back(
        {work.point(face.nodes[0]), work.point(face.nodes[1]), work.point(face.nodes[2])});
  }
  const double before = worst_of(work, cavity);
  const double least = std::max(beat, options.takes_any ? 0 : least_worth(before, work.gain));
  if (!has_room_for(star, faces, least)) return std::nullopt;
  const Place place = climb(star, start, options.enough);
  if (!(place.worst > least)) return std::nullopt;
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

/// A cavity that grows by the tet beyond one of its faces, and how well p sees each of them.
class GrowingCavity {
 public:
  GrowingCavity(WorkMesh& work, std::int32_t t, const Vec3& p) : work_(work), p_(p) {
    work_.marks.clear();
    add(t);
  }
  const std::vector<std::int32_t>& tets() const { return tets_; }
  struct Seen {
    double quality;
    std::int32_t number;
    std::int32_t beyond;

    friend bool operator<(const Seen& a, const Seen& b) {
      return a.quality != b.quality ? a.quality > b.quality : a.number > b.number;
    }
  };
  /// The first of those that p sees worst.
  const Seen& worst() {
    TF_CHECK(!faces_.empty());  // a cavity has an outside
    while (faces_.top().beyond >= 0 && work_.marks.has(faces_.top().beyond)) faces_.pop();
    return faces_.top();
  }

  void add(std::int32_t t) {
    tets_.push_back(t);
    work_.marks.add(t);
    visit_outer_faces(work_, t, [this](const CavityFace& face) {
      faces_.push({quality_over(work_, face, p_), count_++, face.beyond});
    });
  }

 private:
  WorkMesh& work_;
  Vec3 p_;
  std::vector<std::int32_t> tets_;
  std::priority_queue<Seen> faces_;  // also those that a tet of the cavity lies beyond by now
  std::int32_t count_ = 0;
};

/// Takes the tet beyond the face that p sees worst into the cavity, again and again, and returns
/// the cavity that p saw best.
std::vector<std::int32_t> grown_cavity(WorkMesh& work, std::int32_t t, const Vec3& p,
                                       std::size_t most_tets) {
  GrowingCavity cavity(work, t, p);
  std::size_t best_size = 1;
  double best_worst = -HUGE_VAL;
  while (true) {
    const auto [quality, number, beyond] = cavity.worst();
    const double worst = std::min(quality, 1.0);
    if (worst > best_worst) {
      best_worst = worst;
      best_size = cavity.tets().size();
    }
    if (beyond < 0 || cavity.tets().size() == most_tets) break;
    cavity.add(beyond);
  }
  std::vector<std::int32_t> tets = cavity.tets();
  tets.resize(best_size);
  return tets;
}

/// From a flat tet to places beside it: on both sides of its plane, and where its nodes are nearly
/// on a line on four sides of that.
std::vector<Vec3> steps_off(const WorkMesh& work, const Tet& tet) {
  constexpr double slim = 0.05;
  Vec3 normal;
  Vec3 longest;
  for (const auto& local : tet_face_nodes) {
    const Vec3& a = work.point(tet[at(local[0])]);
    const Vec3 ab = work.point(tet[at(local[1])]) - a;
    const Vec3 here = cross(ab, work.point(tet[at(local[2])]) - a);
    if (norm2(here) > norm2(normal)) normal = here;
    if (norm2(ab) > norm2(longest)) longest = ab;
  }
  const double length = std::sqrt(norm2(longest));
  const double width = std::sqrt(norm2(normal)) / length;
  if (!(width > 0)) return {};
  const bool is_slim = width < slim * length;
  std::vector<Vec3> sides = {normalized(normal)};
  if (is_slim) sides.push_back(normalized(cross(longest, normal)));
  std::vector<Vec3> steps;
  for (const double share : {1.0, 0.3, 0.1}) {
    const double step = share * (is_slim ? length : width);
    for (const Vec3& side : sides) {
      steps.push_back(step * side);
      steps.push_back(-step * side);
    }
  }
  return steps;
}

}  // namespace

std::optional<Replacement> find_split(WorkMesh& work, std::int32_t t, const SplitOptions& options) {
  std::optional<Replacement> best;
  const auto try_cavity = [&](const std::vector<std::int32_t>& cavity, const Vec3& start) {
    auto found = fill_with_star(work, cavity, start, best ? best->new_worst : 0, options);
    if (found) best = std::move(found);
  };
  const Tet tet = work.tet(t);
  Vec3 centre;
  for (const std::int32_t v : tet) centre += 0.25 * work.point(v);
  const std::size_t most_tets = options.is_flat ? most_cavity_of_flat : most_cavity;
  try_cavity(grown_cavity(work, t, centre, most_tets), centre);
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const Vec3 middle = 0.5 * (work.point(tet[at(i)]) + work.point(tet[at(j)]));
      const auto ring = ring_of_edge(work, t, i, j, most_ring);
      if (ring) try_cavity(ring->tets, middle);
    }
  }
  if (!options.is_flat) return best;
  for (const Vec3& step : steps_off(work, tet)) {
    try_cavity(grown_cavity(work, t, centre + step, most_tets), centre + step);
  }
  return best;
}

}  // namespace tetfarm::cosmetics
