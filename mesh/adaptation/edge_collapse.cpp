#include "mesh/adaptation/edge_collapse.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// A node on a curve goes along an edge of the curve alone.
bool may_join(const MetricMesh& mesh, std::int32_t node, std::int32_t target) {
  const std::int32_t curve = mesh.curve_of_node[at(node)];
  if (curve == MetricMesh::corner) return false;
  return curve == MetricMesh::inside || curve_of_edge(mesh, node, target) == curve;
}

/// Whether the triangle at the edge that goes leaves something to join: not where both its other
/// edges are held.
bool can_go(const MetricMesh& mesh, EdgeHandle corner, std::int32_t target) {
  const std::int32_t t = triangle_of(corner);
  const int of_target = mesh.complex.local_node(t, target);
  return !mesh.complex.is_constrained(t, edge_of(corner)) ||
         !mesh.complex.is_constrained(t, of_target);
}

/// Whether the edge from the target would be too long. One beyond the limit may come where the one
/// that goes is longer still.
bool is_too_long(const MetricMesh& mesh, std::int32_t node, std::int32_t target, std::int32_t other,
                 double longest) {
  return is_longer(mesh, target, other, longest) &&
         edge_length(mesh, target, other) > edge_length(mesh, node, other);
}

/// Whether the triangles that stay are valid, with edges and shapes within the limits.
bool may_collapse(MetricMesh& mesh, std::int32_t node, std::int32_t target,
                  const CollapseLimits& limits, const Ball& ball) {
  for (const EdgeHandle corner : ball.corners) {
    const OppositeEdge ring = opposite_edge(mesh.complex, corner);
    if (ring.before == target || ring.after == target) {
      if (!can_go(mesh, corner, target)) return false;
      continue;
    }
    if (is_too_long(mesh, node, target, ring.before, limits.longest) ||
        is_too_long(mesh, node, target, ring.after, limits.longest)) {
      return false;
    }
  }
  double worst_before = limits.worst_energy;
  for (const EdgeHandle corner : ball.corners) {
    worst_before = std::max<double>(worst_before, known_energy(mesh, triangle_of(corner)));
  }
  return std::all_of(ball.corners.begin(), ball.corners.end(), [&](EdgeHandle corner) {
    const OppositeEdge ring = opposite_edge(mesh.complex, corner);
    if (ring.before == target || ring.after == target) return true;
    return triangle_energy(mesh, {target, ring.before, ring.after}) <= worst_before &&
           orient2d(mesh.complex.point(target), mesh.complex.point(ring.before),
                    mesh.complex.point(ring.after)) > 0;
  });
}

/// The two nodes next to the node on its curve.
std::array<std::int32_t, 2> ends_on_curve(const MetricMesh& mesh, std::int32_t node,
                                          const Ball& ball) {
  const std::int32_t curve = mesh.curve_of_node[at(node)];
  std::array<std::int32_t, 2> ends{-1, -1};
  const auto note = [&](std::int32_t end) {
    if (curve_of_edge(mesh, node, end) != curve || end == ends[0]) return;
    (ends[0] < 0 ? ends[0] : ends[1]) = end;
  };
  for (const EdgeHandle corner : ball.corners) {
    note(opposite_edge(mesh.complex, corner).before);
    note(opposite_edge(mesh.complex, corner).after);
  }
  return ends;
}

/// The edges of a curve that meet at the node become one. False, with nothing changed, where there
/// is such an edge already (of a hole or of a line inside there would be nothing left), or where
/// another wall is in its way.
bool join_curve_edges(MetricMesh& mesh, std::int32_t node, std::int32_t target, const Ball& ball,
                      LazyBorder* border) {
  const std::int32_t curve = mesh.curve_of_node[at(node)];
  if (curve < 0) return true;
  const std::array<std::int32_t, 2> ends = ends_on_curve(mesh, node, ball);
  const std::int32_t other = ends[0] == target ? ends[1] : ends[0];
  if (curve_of_edge(mesh, target, other) >= 0) return false;
  if (border != nullptr && !ball.is_closed &&
      border->of(mesh).any_in_triangle(mesh, node, target, other)) {
    return false;
  }
  for (const std::int32_t end : ends) mesh.curve_of_edge.erase(edge_key(node, end));
  mesh.curve_of_edge[edge_key(target, other)] = curve;
  return true;
}

/// The triangle at `corner` goes: what lies beyond its two edges at the node and at the target
/// become neighbours.
void remove_triangle(MetricMesh& mesh, EdgeHandle corner, std::int32_t target) {
  TriangleComplex& complex = mesh.complex;
  const std::int32_t t = triangle_of(corner);
  const int of_node = edge_of(corner);
  const int of_target = complex.local_node(t, target);
  const EdgeHandle beside_target = complex.neighbour(t, of_node);  // opposite the node
  const EdgeHandle beside_node = complex.neighbour(t, of_target);
  const bool is_constrained =
      complex.is_constrained(t, of_node) || complex.is_constrained(t, of_target);
  const std::int32_t third = complex.node(t, 3 - of_node - of_target);
  drop_triangle(mesh, t);
  const EdgeHandle kept = beside_target != no_edge ? beside_target : beside_node;
  complex.glue(kept, kept == beside_target ? beside_node : no_edge);
  if (is_constrained) complex.constrain(kept, true);
  complex.node2triangle[at(third)] = triangle_of(kept);
  complex.node2triangle[at(target)] = triangle_of(kept);
}

}  // namespace

bool collapse_node(MetricMesh& mesh, std::int32_t node, std::int32_t target,
                   const CollapseLimits& limits, Ball& ball, LazyBorder* border) {
  TF_CHECK(node != target);
  if (!may_join(mesh, node, target)) return false;
  collect_ball(mesh.complex, node, ball);
  if (!may_collapse(mesh, node, target, limits, ball)) return false;
  // A border of three edges would be left with two.
  std::size_t staying = 0;
  for (const EdgeHandle corner : ball.corners) {
    const OppositeEdge ring = opposite_edge(mesh.complex, corner);
    staying += ring.before == target || ring.after == target ? 0 : 1;
  }
  if (staying == 0) return false;
  if (!join_curve_edges(mesh, node, target, ball, border)) return false;
  for (const EdgeHandle corner : ball.corners) {
    const OppositeEdge ring = opposite_edge(mesh.complex, corner);
    mesh.active[at(ring.before)] = 1;
    mesh.active[at(ring.after)] = 1;
    mesh.touched[at(ring.before)] |= TouchedBits::now;
    mesh.touched[at(ring.after)] |= TouchedBits::now;
    note_change(mesh, triangle_of(corner));
    if (ring.before == target || ring.after == target) continue;
    mesh.complex.triangles[at(triangle_of(corner))][at(edge_of(corner))] = target;
  }
  for (const EdgeHandle corner : ball.corners) {
    const std::int32_t t = triangle_of(corner);
    if (mesh.complex.node(t, edge_of(corner)) != node) {
      for (const std::int32_t v : mesh.complex.nodes(t)) mesh.complex.node2triangle[at(v)] = t;
    }
  }
  for (const EdgeHandle corner : ball.corners) {
    const std::int32_t t = triangle_of(corner);
    if (mesh.complex.node(t, edge_of(corner)) == node) remove_triangle(mesh, corner, target);
  }
  mesh.complex.node2triangle[at(node)] = -1;
  return true;
}

std::int64_t collapse_edges(MetricMesh& mesh, const CollapseLimits& limits, EdgesToVisit which) {
  std::int64_t gone = 0;
  Ball ball;
  LazyBorder border;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    for (int i = 0; i < 3 && mesh.is_used(t); ++i) {
      const std::int32_t a = mesh.complex.node(t, next(i));
      const std::int32_t b = mesh.complex.node(t, previous(i));
      if (!is_to_visit(mesh, which, a, b) || !is_shorter(mesh, a, b, limits.shortest)) continue;
      if (collapse_node(mesh, a, b, limits, ball, &border) ||
          collapse_node(mesh, b, a, limits, ball, &border)) {
        ++gone;
      }
    }
  }
  return gone;
}

}  // namespace tetfarm
