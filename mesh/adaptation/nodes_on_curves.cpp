#include "mesh/adaptation/nodes_on_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/curve_tracing.h"

namespace tetfarm {
namespace {

constexpr double farthest_move = 1e-3;      ///< in edges there
constexpr double as_good_as_there = 1e-14;  ///< in lengths of the curve
constexpr int most_projections = 200;

double distance_of(const Vec2& a, const Vec2& b) { return std::hypot(b.x - a.x, b.y - a.y); }

std::string number_text(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

std::string node_text(const PlaneMesh& mesh, std::int32_t node) {
  return in_file(mesh.name,
                 "node " + std::to_string(node + 1) + " at " + place_text(mesh.points[at(node)]));
}

std::string patch_list(const std::set<std::int32_t>& patches) {
  constexpr std::size_t most = 20;
  std::string text;
  std::size_t told = 0;
  for (const std::int32_t patch : patches) {
    if (told == most) return text + " and " + std::to_string(patches.size() - most) + " more";
    text += (told == 0 ? "" : ", ") + std::to_string(patch);
    ++told;
  }
  return text;
}

/// A node where several curves end, and where each of them would have it.
using CurvesAtNode = std::map<std::int32_t, std::vector<const TrueCurve*>>;

class CurvePlacing {
 public:
  CurvePlacing(const PlaneMesh& mesh, const TriangleComplex& complex,
               std::span<const PatchCurve> curves)
      : given_(mesh), mesh_(mesh), curves_(curves) {
    TriangleComplex held_in = complex;
    held_ = hold_edges(mesh, held_in);
    limits_.assign(mesh.points.size(), 0);
    for (const HeldEdge& edge : held_) {
      if (curve_of_patch(curves, edge.patch) == nullptr) continue;
      const auto [a, b] = edge.nodes;
      const double length = distance_of(mesh.points[at(a)], mesh.points[at(b)]);
      for (const std::int32_t v : edge.nodes) {
        limits_[at(v)] = std::max(limits_[at(v)], farthest_move * length);
      }
    }
  }

  NodesOnCurves place(double corner_angle_deg) {
    for (const PatchCurve& curve : curves_) take_corners_of(curve);
    const TracedBoundary traced = trace_boundary(mesh_, held_, corner_angle_deg);
    place_corners(traced);
    for (const BoundaryPiece& piece : traced.pieces) {
      const PatchCurve* curve = curve_of_patch(curves_, piece.patch);
      if (curve != nullptr) place_nodes(piece, *curve);
    }
    check_triangles();
    std::vector<MovedNodes> moved;
    for (const PatchCurve& curve : curves_) moved.push_back(moves_on(curve));
    return {std::move(mesh_), std::move(moved)};
  }

 private:
  std::vector<Vec2> points_of(const BoundaryPiece& piece) const {
    std::vector<Vec2> points;
    for (const std::int32_t v : piece.nodes) points.push_back(mesh_.points[at(v)]);
    return points;
  }

  /// The nodes at the ends of its parts go there, and are corners.
  void take_corners_of(const PatchCurve& curve) {
    for (const auto& part : curve.parts) {
      if (part->is_closed()) continue;
      for (const double end : {0.0, part->length()}) take_corner(curve, part->at(end));
    }
  }

  void take_corner(const PatchCurve& curve, const Vec2& place) {
    std::int32_t nearest = -1;
    for (const HeldEdge& edge : held_) {
      if (curve_of_patch(curves_, edge.patch) != &curve) continue;
      for (const std::int32_t v : edge.nodes) {
        const double distance = distance_of(mesh_.points[at(v)], place);
        if (distance > limits_[at(v)]) continue;
        if (nearest < 0 || distance < distance_of(mesh_.points[at(nearest)], place)) nearest = v;
      }
    }
    if (nearest < 0) return;
    mesh_.points[at(nearest)] = place;
    if (std::find(mesh_.corners.begin(), mesh_.corners.end(), nearest) == mesh_.corners.end()) {
      mesh_.corners.push_back(nearest);
    }
  }

  [[noreturn]] void refuse_distance(std::int32_t node, double distance,
                                    const std::string& name) const {
    throw InvalidInput("lies " + number_text(distance) +
                           " away from the curve; moved are nodes up to a thousandth of the edges "
                           "there, " +
                           number_text(limits_[at(node)]),
                       name + ": " + node_text(given_, node));
  }

  /// Corners go to the nearest place that is on all curves that end there.
  void place_corners(const TracedBoundary& traced) {
    CurvesAtNode ending;
    std::map<std::int32_t, std::string> names;
    // They hold the curves that `ending` names.
    std::vector<PieceOnCurve> on_curves;
    for (const BoundaryPiece& piece : traced.pieces) {
      const PatchCurve* curve = curve_of_patch(curves_, piece.patch);
      if (curve == nullptr || piece.is_closed || curve->parts.empty()) continue;
      on_curves.push_back(piece_on_curve(*curve, points_of(piece), false));
      for (const std::int32_t v : {piece.nodes.front(), piece.nodes.back()}) {
        ending[v].push_back(on_curves.back().part.curve.get());
        names[v] = curve->name;
      }
    }
    for (const auto& [node, there] : ending) place_corner(node, there, names[node]);
  }

  void place_corner(std::int32_t node, const std::vector<const TrueCurve*>& curves,
                    const std::string& name) {
    Vec2 place = mesh_.points[at(node)];
    double off = 0;
    for (int i = 0; i < most_projections; ++i) {
      off = 0;
      for (const TrueCurve* curve : curves) {
        const Vec2 foot = curve->at(curve->nearest(place));
        const double distance = distance_of(place, foot);
        if (distance <= as_good_as_there * curve->length()) continue;
        off = std::max(off, distance);
        place = foot;
      }
      if (off == 0) break;
    }
    const double moved = distance_of(given_.points[at(node)], place);
    if (moved > limits_[at(node)]) refuse_distance(node, moved, name);
    if (off > 0) {
      throw InvalidInput("the curves of the patches that meet here do not",
                         name + ": " + node_text(given_, node));
    }
    mesh_.points[at(node)] = place;
  }

  void place_nodes(const BoundaryPiece& piece, const PatchCurve& curve) {
    const std::vector<Vec2> points = points_of(piece);
    if (curve.parts.empty() && (piece.is_closed || piece.nodes.front() == piece.nodes.back())) {
      throw InvalidInput("patch " + std::to_string(piece.patch) +
                             " comes back here, with no corner between: that is no line",
                         curve.name + ": " + node_text(given_, piece.nodes.front()));
    }
    const PieceOnCurve on = piece_on_curve(curve, points, piece.is_closed);
    const TrueCurve& shape = *on.part.curve;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!piece.is_closed && (i == 0 || i + 1 == points.size())) continue;  // a corner
      const std::int32_t v = piece.nodes[i];
      const Vec2 foot = shape.at(shape.nearest(points[i]));
      const double distance = distance_of(points[i], foot);
      if (distance > limits_[at(v)]) refuse_distance(v, distance, curve.name);
      if (distance > as_good_as_there * shape.length()) mesh_.points[at(v)] = foot;
    }
    if (!on.fold.has_value()) return;
    throw InvalidInput("does not follow the node before it on the curve of patch " +
                           std::to_string(piece.patch) +
                           "; at every corner of the curve there has to be a node",
                       curve.name + ": " + node_text(given_, piece.nodes[*on.fold]));
  }

  MovedNodes moves_on(const PatchCurve& curve) const {
    std::set<std::int32_t> nodes;
    for (const HeldEdge& edge : held_) {
      if (curve_of_patch(curves_, edge.patch) != &curve) continue;
      nodes.insert(edge.nodes.begin(), edge.nodes.end());
    }
    MovedNodes moves;
    for (const std::int32_t v : nodes) {
      ++moves.nodes;
      const double distance = distance_of(given_.points[at(v)], mesh_.points[at(v)]);
      if (distance > 0) ++moves.moved;
      if (distance <= moves.farthest) continue;
      moves.farthest = distance;
      moves.node = v;
    }
    return moves;
  }

  void check_triangles() const {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto turn = [&](const PlaneMesh& mesh) {
        const auto& [a, b, c] = mesh.triangles[t];
        return orient2d(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
      };
      const double now = turn(mesh_);
      if (now != 0 && (now > 0) == (turn(given_) > 0)) continue;
      throw InvalidInput(
          "would turn over with its nodes on the curve",
          in_file(mesh_.name, "triangle " + std::to_string(t + 1) + " at " +
                                  place_text(mesh_.points[at(mesh_.triangles[t][0])])));
    }
  }

  const PlaneMesh& given_;
  PlaneMesh mesh_;
  std::span<const PatchCurve> curves_;
  std::vector<HeldEdge> held_;
  std::vector<double> limits_;  ///< how far each node may go
};

}  // namespace

std::vector<std::int32_t> nodes_of_patches(const PlaneMesh& mesh, const TriangleComplex& complex,
                                           const std::vector<std::int32_t>& patches,
                                           const std::string& name) {
  TriangleComplex held_in = complex;
  std::set<std::int32_t> there;
  std::set<std::int32_t> nodes;
  for (const HeldEdge& edge : hold_edges(mesh, held_in)) {
    there.insert(edge.patch);
    if (std::find(patches.begin(), patches.end(), edge.patch) == patches.end()) continue;
    nodes.insert(edge.nodes.begin(), edge.nodes.end());
  }
  for (const std::int32_t patch : patches) {
    if (there.contains(patch)) continue;
    throw InvalidInput("there is no patch " + std::to_string(patch) + "; " +
                           (mesh.name.empty() ? "the mesh" : mesh.name) + " has " +
                           patch_list(there),
                       name);
  }
  return {nodes.begin(), nodes.end()};
}

NodesOnCurves put_on_curves(const PlaneMesh& mesh, const TriangleComplex& complex,
                            std::span<const PatchCurve> curves, double corner_angle_deg) {
  return CurvePlacing(mesh, complex, curves).place(corner_angle_deg);
}

}  // namespace tetfarm
