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

/// Those of the tet's faces that no marked tet lies beyond.
std::vector<CavityFace> outer_faces(const WorkMesh& work, std::int32_t t) {
  std::vector<CavityFace> faces;
  const Tet& tet = work.tet(t);
  for (int face = 0; face < 4; ++face) {
    const FaceHandle across = work.across(t, face);
    const std::int32_t beyond = across == no_face ? -1 : tet_of(across);
    if (beyond >= 0 && work.is_marked(beyond)) continue;
    const auto& local = tet_face_nodes[at(face)];
    faces.push_back({{tet[at(local[2])], tet[at(local[1])], tet[at(local[0])]}, beyond});
  }
  return faces;
}

std::vector<CavityFace> faces_of_cavity(WorkMesh& work, const std::vector<std::int32_t>& cavity) {
  work.clear_marks();
  for (const std::int32_t t : cavity) work.set_mark(t);
  std::vector<CavityFace> faces;
  for (const std::int32_t t : cavity) {
    const std::vector<CavityFace> outer = outer_faces(work, t);
    faces.insert(faces.end(), outer.begin(), outer.end());
  }
  return faces;
}

double goodness_over(const WorkMesh& work, const CavityFace& face, const Vec3& p) {
  return goodness(work.point(face.nodes[0]), work.point(face.nodes[1]), work.point(face.nodes[2]),
                  p);
}

/// The angle between the faces is shared by the two tets of a star over them; the goodness of the
/// worse one when they have a half each.
double most_goodness_between(const Vec3& normal, const Vec3& other) {
  const double lengths = std::sqrt(norm2(normal) * norm2(other));
  return lengths > 0 ? 0.5 * (1 + dot(normal, other) / lengths) : 1;
}

bool are_neighbours(const CavityFace& face, const CavityFace& other) {
  int common = 0;
  for (const std::int32_t v : face.nodes) {
    common += static_cast<int>(std::count(other.nodes.begin(), other.nodes.end(), v));
  }
  return common == 2;
}

/// Whether the angles between the cavity's faces leave a star with a goodness above this possible.
bool has_room_for(const Star& star, const std::vector<CavityFace>& faces, double least) {
  std::vector<Vec3> normals;
  for (const auto& [a, b, c] : star) normals.push_back(cross(b - a, c - a));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (most_goodness_between(normals[i], normals[j]) > least) continue;
      if (are_neighbours(faces[i], faces[j])) return false;
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
    work_.clear_marks();
    add(t);
  }
  const std::vector<std::int32_t>& tets() const { return tets_; }
  struct Seen {
    CavityFace face;
    double goodness;
  };
  /// The first of those that p sees worst.
  const Seen& worst() const { return *std::ranges::min_element(faces_, {}, &Seen::goodness); }

  void add(std::int32_t t) {
    tets_.push_back(t);
    work_.set_mark(t);
    std::erase_if(faces_, [t](const Seen& seen) { return seen.face.beyond == t; });
    for (const CavityFace& face : outer_faces(work_, t)) {
      faces_.push_back({face, goodness_over(work_, face, p_)});
    }
  }

 private:
  WorkMesh& work_;
  Vec3 p_;
  std::vector<std::int32_t> tets_;
  std::vector<Seen> faces_;
};

/// Takes the tet beyond the face that p sees worst into the cavity, again and again, and returns
/// the cavity that p saw best.
std::vector<std::int32_t> grown_cavity(WorkMesh& work, std::int32_t t, const Vec3& p) {
  GrowingCavity cavity(work, t, p);
  std::size_t best_size = 1;
  double best_worst = -HUGE_VAL;
  while (true) {
    const auto [face, goodness] = cavity.worst();
    const double worst = std::min(goodness, 1.0);
    if (worst > best_worst) {
      best_worst = worst;
      best_size = cavity.tets().size();
    }
    if (face.beyond < 0 || cavity.tets().size() == most_cavity) break;
    cavity.add(face.beyond);
  }
  std::vector<std::int32_t> tets = cavity.tets();
  tets.resize(best_size);
  return tets;
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
  try_cavity(grown_cavity(work, t, centre), centre);
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const Vec3 middle = 0.5 * (work.point(tet[at(i)]) + work.point(tet[at(j)]));
      const auto ring = ring_of_edge(work, t, i, j, most_ring);
      if (ring) try_cavity(ring->tets, middle);
    }
  }
  return best;
}

}  // namespace tetfarm::cosmetics
