#include "mesh/remeshing/edge_split.h"

#include <optional>
#include <vector>

#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// A vertex for the middle of the edge with these triangles, and the place on the input for it.
struct MiddleVertex {
  SurfaceVertex vertex;
  Vec3 at;
};

std::optional<MiddleVertex> middle_of_feature(const RemeshingWork& work, std::int32_t a,
                                              std::int32_t b, const Vec3& middle) {
  MiddleVertex found{{VertexKind::on_curve, -1, -1, 0}, middle};
  std::optional<InputFoot> foot;
  const SurfaceVertex* const end =
      work.surface.vertex(a).kind == VertexKind::on_curve   ? &work.surface.vertex(a)
      : work.surface.vertex(b).kind == VertexKind::on_curve ? &work.surface.vertex(b)
                                                            : nullptr;
  const double limit = 2 * work.tolerance;
  if (end != nullptr) {
    found.vertex.home = end->home;
    foot = work.shape.on_curve(end->home, middle, limit, end->foot);
  } else {
    foot = work.shape.on_any_curve(middle, limit);
    if (foot) found.vertex.home = work.shape.curve_of(foot->item);
  }
  if (!foot) return std::nullopt;
  found.at = foot->at;
  found.vertex.foot = foot->item;
  return found;
}

std::optional<MiddleVertex> middle_of_face(const RemeshingWork& work, std::int32_t a,
                                           std::int32_t b, const std::vector<std::int32_t>& on,
                                           const Vec3& middle) {
  const std::int32_t face = work.surface.triangle(on.front()).face;
  MiddleVertex found{{VertexKind::smooth, face, -1, 0}, middle};
  Vec3 normal;
  for (const std::int32_t t : on) {
    normal += doubled_area(work.surface.points(work.surface.triangle(t).nodes));
  }
  std::int32_t guess = -1;
  for (const std::int32_t end : {a, b}) {
    if (work.surface.vertex(end).kind == VertexKind::smooth) guess = work.surface.vertex(end).foot;
  }
  const std::optional<InputFoot> foot =
      work.shape.on_face(face, middle, normal, 2 * work.tolerance, guess);
  if (!foot) return std::nullopt;
  found.vertex.foot = foot->item;
  // In a plane the middle is as good, and no worse for rounding.
  if (!work.shape.plane(face)) found.at = foot->at;
  return found;
}

void make_halves(RemeshingWork& work, const std::vector<std::int32_t>& on, std::int32_t a,
                 std::int32_t b, std::int32_t m) {
  work.replacement.clear();
  work.replacement.removed = on;
  for (const std::int32_t t : on) {
    const FaceTriangle& old = work.surface.triangle(t);
    const std::int32_t third = third_vertex(old.nodes, a, b);
    for (const std::int32_t gone : {a, b}) {
      // The half keeps two of the old edges, and the third is new.
      const std::int32_t kept = gone == a ? b : a;
      FaceTriangle half = old;
      half.nodes[corner_of(old.nodes, gone)] = m;
      half.features = 0;
      if (is_feature_edge(old, a, b)) mark_feature_edge(half, m, kept);
      if (is_feature_edge(old, kept, third)) mark_feature_edge(half, kept, third);
      work.replacement.made.push_back(half);
    }
  }
}

}  // namespace

bool split_edge(RemeshingWork& work, std::int32_t a, std::int32_t b) {
  ChangingSurface& surface = work.surface;
  const std::vector<std::int32_t> on = surface.triangles_on(a, b);
  if (on.empty()) return false;
  const Vec3 middle = 0.5 * (surface.at(a) + surface.at(b));
  std::optional<MiddleVertex> found = surface.is_feature(on.front(), a, b)
                                          ? middle_of_feature(work, a, b, middle)
                                          : middle_of_face(work, a, b, on, middle);
  if (!found) return false;
  found->vertex.spacing = work.spacing.at(found->at);
  const std::int32_t m = surface.add_vertex(found->at, found->vertex);
  make_halves(work, on, a, b, m);
  work.replacement.fills_hole = !surface.is_feature(on.front(), a, b);
  bool may_be = lies_on_input(work, m) && meets_nothing(work);
  if (!may_be && !(found->at == middle)) {
    surface.move_vertex(m, middle);
    may_be = meets_nothing(work);
  }
  if (may_be) {
    replace(work);
  } else {
    surface.remove_vertex(m);
  }
  return may_be;
}

}  // namespace tetfarm
