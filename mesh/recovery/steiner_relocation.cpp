#include "mesh/recovery/steiner_relocation.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/recovery/kernel_point.h"
#include "mesh/recovery/surface_fans.h"

namespace tetfarm {
namespace {

/// A part of the star that constrained faces part from the rest, and the triangles that will close
/// it, as seen from within: their corners turn anticlockwise.
struct Side {
  std::vector<std::int32_t> tets;
  std::vector<std::size_t> fans;
  std::vector<Triangle> whole;
  bool is_inside = false;
};

/// The fan that the triangle of the node, y and z is of, and whether it turns alike.
std::optional<std::pair<std::size_t, bool>> fan_of(const std::vector<SurfaceFan>& fans,
                                                   std::int32_t y, std::int32_t z) {
  for (std::size_t i = 0; i < fans.size(); ++i) {
    for (const auto& [from, to] : fans[i].edges) {
      if (from == y && to == z) return std::pair{i, true};
      if (from == z && to == y) return std::pair{i, false};
    }
  }
  return std::nullopt;
}

/// The same for the face of a tet.
std::optional<std::pair<std::size_t, bool>> fan_of_face(const LocalRemeshing& mesh,
                                                        const std::vector<SurfaceFan>& fans,
                                                        FaceHandle face, std::int32_t node) {
  const Tet& n = mesh.complex().nodes[at(tet_of(face))];
  const auto& f = tet_face_nodes[at(face_of(face))];
  for (std::size_t k = 0; k < 3; ++k) {
    if (n[at(f[k])] != node) continue;
    return fan_of(fans, n[at(f[(k + 1) % 3])], n[at(f[(k + 2) % 3])]);
  }
  return std::nullopt;
}

/// False when the constrained face is not one of the surface's.
bool close_side(const LocalRemeshing& mesh, const std::vector<SurfaceFan>& fans, FaceHandle face,
                std::int32_t node, Side& side) {
  const auto found = fan_of_face(mesh, fans, face, node);
  if (!found) return false;
  const auto [number, turns_alike] = *found;
  if (!side.fans.empty() && turns_alike != side.is_inside) return false;
  side.is_inside = turns_alike;
  if (std::find(side.fans.begin(), side.fans.end(), number) != side.fans.end()) return true;
  side.fans.push_back(number);
  for (const auto& [a, b, c] : fans[number].without) {
    // A boundary triangle turns anticlockwise as seen from outside.
    side.whole.push_back(turns_alike ? Triangle{a, c, b} : Triangle{a, b, c});
  }
  return true;
}

/// The sides of the boundary at the node, those inside first; none when something is not as it has
/// to be.
std::vector<Side> sides_of(const LocalRemeshing& mesh, const std::vector<SurfaceFan>& fans,
                           const std::vector<std::int32_t>& star, std::int32_t node) {
  std::vector<Side> sides;
  std::vector<std::uint8_t> is_taken(star.size(), 0);
  const auto place = [&star](std::int32_t t) {
    return static_cast<std::size_t>(std::find(star.begin(), star.end(), t) - star.begin());
  };
  std::size_t closed = 0;
  for (std::size_t first = 0; first < star.size(); ++first) {
    if (is_taken[first] != 0) continue;
    Side side;
    side.tets.push_back(star[first]);
    is_taken[first] = 1;
    for (std::size_t head = 0; head < side.tets.size(); ++head) {
      const std::int32_t t = side.tets[head];
      for (int f = 0; f < 4; ++f) {
        if (mesh.complex().nodes[at(t)][at(f)] == node) continue;
        if (mesh.is_constrained(face_handle(t, f))) {
          if (!close_side(mesh, fans, face_handle(t, f), node, side)) return {};
          continue;
        }
        const std::size_t beyond = place(tet_of(mesh.complex().neighbours[at(t)][at(f)]));
        TF_CHECK(beyond < star.size());
        if (is_taken[beyond] != 0) continue;
        is_taken[beyond] = 1;
        side.tets.push_back(star[beyond]);
      }
    }
    closed += side.fans.size();
    sides.push_back(std::move(side));
  }
  if (closed != 2 * fans.size()) return {};
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

bool relocate_steiner_point(LocalRemeshing& mesh, SplitSurface& surface,
                            const std::vector<Triangle>& triangles, std::int32_t node) {
  const auto fans = surface_fans(mesh, surface, triangles, node);
  if (!fans) return false;
  const auto star = mesh.star(node);
  std::vector<Side> sides = sides_of(mesh, *fans, star, node);
  if (sides.empty()) return false;
  const FinePoint here = mesh.fine_point(node);
  std::vector<FinePoint> places;
  for (Side& side : sides) {
    drop_what_is_there(mesh, node, side);
    const auto faces = faces_to_see(mesh, side, node);
    const auto place = faces.empty() ? here : kernel_point(faces, here);
    if (!place && side.is_inside) return false;
    places.push_back(place.value_or(here));
  }
  std::vector<Tet> tets;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::int32_t part = node;
    if (i == 0) {
      mesh.move_point(node, places[0]);
    } else {
      part = mesh.add_point(places[i]);
    }
    for (const std::int32_t t : sides[i].tets) {
      Tet n = mesh.complex().nodes[at(t)];
      std::replace(n.begin(), n.end(), node, part);
      tets.push_back(n);
    }
    for (const auto& [a, b, c] : sides[i].whole) tets.push_back({a, b, c, part});
  }
  mesh.replace(star, tets);
  mesh.forget_journal();
  std::vector<SurfacePart> parts;
  for (const SurfaceFan& fan : *fans) {
    for (const Triangle& t : fan.without) {
      parts.push_back({t, fan.source});
      mesh.constrain(mesh.find_face(t[0], t[1], t[2]), true);
    }
  }
  replace_fan(surface, node, parts);
  return true;
}

}  // namespace tetfarm
