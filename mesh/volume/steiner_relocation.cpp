#include "mesh/volume/steiner_relocation.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "mesh/volume/kernel_point.h"

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// A part of the star that constrained faces part from the rest, and the whole triangles on it as
/// seen from within: their corners turn anticlockwise.
struct Side {
  std::vector<std::int32_t> tets;
  std::vector<Triangle> whole;
  bool is_inside = false;
};

/// The number in `originals` of the triangle of which pyz (p: the split node) is a part, and
/// whether it turns alike; -1 when there is none.
std::pair<int, bool> original_of(const SteinerSplit& split, std::int32_t y, std::int32_t z) {
  for (std::size_t i = 0; i < split.originals.size(); ++i) {
    const Triangle& t = split.originals[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == y && t[(k + 1) % 3] == z) return {static_cast<int>(i), true};
      if (t[k] == z && t[(k + 1) % 3] == y) return {static_cast<int>(i), false};
    }
  }
  return {-1, false};
}

/// The triangle of the split that the face of a tet is a part of, as for original_of.
std::pair<int, bool> original_of_face(const LocalRemeshing& mesh, const SteinerSplit& split,
                                      FaceHandle face) {
  const Tet& n = mesh.complex().nodes[at(tet_of(face))];
  const auto& f = tet_face_nodes[at(face_of(face))];
  for (std::size_t k = 0; k < 3; ++k) {
    if (n[at(f[k])] != split.node) continue;
    return original_of(split, n[at(f[(k + 1) % 3])], n[at(f[(k + 2) % 3])]);
  }
  return {-1, false};
}

/// False when the faces at the node are not those of the split.
bool add_whole_triangle(const LocalRemeshing& mesh, const SteinerSplit& split, FaceHandle face,
                        Side& side) {
  const auto [number, turns_alike] = original_of_face(mesh, split, face);
  if (number < 0 || (!side.whole.empty() && turns_alike != side.is_inside)) return false;
  side.is_inside = turns_alike;
  const auto& [a, b, c] = split.originals[at(number)];
  // A boundary triangle turns anticlockwise as seen from outside.
  const Triangle seen = turns_alike ? Triangle{a, c, b} : Triangle{a, b, c};
  if (std::find(side.whole.begin(), side.whole.end(), seen) == side.whole.end()) {
    side.whole.push_back(seen);
  }
  return true;
}

/// The sides of the boundary at the node, those inside first; none when something is not as it has
/// to be.
std::vector<Side> sides_of(const LocalRemeshing& mesh, const SteinerSplit& split,
                           const std::vector<std::int32_t>& star) {
  std::vector<Side> sides;
  std::vector<std::uint8_t> is_taken(star.size(), 0);
  const auto place = [&star](std::int32_t t) {
    return static_cast<std::size_t>(std::find(star.begin(), star.end(), t) - star.begin());
  };
  std::size_t wholes = 0;
  for (std::size_t first = 0; first < star.size(); ++first) {
    if (is_taken[first] != 0) continue;
    Side side;
    side.tets.push_back(star[first]);
    is_taken[first] = 1;
    for (std::size_t head = 0; head < side.tets.size(); ++head) {
      const std::int32_t t = side.tets[head];
      for (int f = 0; f < 4; ++f) {
        if (mesh.complex().nodes[at(t)][at(f)] == split.node) continue;
        if (mesh.is_constrained(face_handle(t, f))) {
          if (!add_whole_triangle(mesh, split, face_handle(t, f), side)) return {};
          continue;
        }
        const std::size_t beyond = place(tet_of(mesh.complex().neighbours[at(t)][at(f)]));
        if (is_taken[beyond] != 0) continue;
        is_taken[beyond] = 1;
        side.tets.push_back(star[beyond]);
      }
    }
    wholes += side.whole.size();
    sides.push_back(std::move(side));
  }
  if (wholes != 2 * split.originals.size()) return {};
  std::stable_partition(sides.begin(), sides.end(),
                        [](const Side& side) { return side.is_inside; });
  return sides;
}

/// A tet whose face opposite the node is one of the whole triangles goes with it: rounding has put
/// the node on the far side of a triangle that is there already.
void drop_what_is_there(const LocalRemeshing& mesh, std::int32_t node, Side& side) {
  std::erase_if(side.tets, [&](std::int32_t t) {
    const auto holds_all = [&](const Triangle& w) {
      return std::all_of(w.begin(), w.end(), [&](std::int32_t v) {
        return v != node && mesh.complex().local_node(t, v) >= 0;
      });
    };
    return std::erase_if(side.whole, holds_all) > 0;
  });
}

/// Faces that a point on this side must see, from within: the link, and the whole triangles.
std::vector<VisibleFace> faces_to_see(const LocalRemeshing& mesh, const Side& side,
                                      std::int32_t node) {
  std::vector<VisibleFace> faces;
  const auto p = [&mesh](std::int32_t v) { return mesh.fine_point(v); };
  for (const std::int32_t t : side.tets) {
    const auto& f = tet_face_nodes[at(mesh.complex().local_node(t, node))];
    const Tet& n = mesh.complex().nodes[at(t)];
    faces.push_back({p(n[at(f[0])]), p(n[at(f[2])]), p(n[at(f[1])])});
  }
  for (const auto& [a, b, c] : side.whole) faces.push_back({p(a), p(b), p(c)});
  return faces;
}

}  // namespace

bool relocate_steiner_point(LocalRemeshing& mesh, const SteinerSplit& split) {
  const auto star = mesh.star(split.node);
  std::vector<Side> sides = sides_of(mesh, split, star);
  if (sides.empty()) return false;
  const FinePoint here = mesh.fine_point(split.node);
  std::vector<FinePoint> places;
  for (Side& side : sides) {
    drop_what_is_there(mesh, split.node, side);
    const auto faces = faces_to_see(mesh, side, split.node);
    const auto place = faces.empty() ? here : kernel_point(faces, here);
    if (!place && side.is_inside) return false;
    places.push_back(place.value_or(here));
  }
  std::vector<Tet> tets;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::int32_t node = split.node;
    if (i == 0) {
      mesh.move_point(node, places[0]);
    } else {
      node = mesh.add_point(places[i]);
    }
    for (const std::int32_t t : sides[i].tets) {
      Tet n = mesh.complex().nodes[at(t)];
      std::replace(n.begin(), n.end(), split.node, node);
      tets.push_back(n);
    }
    for (const auto& [a, b, c] : sides[i].whole) tets.push_back({a, b, c, node});
  }
  mesh.replace(star, tets);
  mesh.forget_journal();
  for (const auto& [a, b, c] : split.originals) mesh.constrain(mesh.find_face(a, b, c), true);
  return true;
}

}  // namespace tetfarm
