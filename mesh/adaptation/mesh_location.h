/// Where points lie in a triangulated domain of the plane; for one outside of it, the closest place
/// of its border.
///
/// Source: O. Devillers, S. Pion, M. Teillaud, "Walking in a triangulation" (2002): a walk from a
/// hint, of a counted number of steps. Where it does not arrive, at a border or going round, a tree
/// of boxes decides; so what is found does not depend on the hint but where triangles meet.
/// Exact: which triangle holds a point. Nodes of a border lie a little off that of another mesh of
/// the same curve, and next to a thin wall the closest place may be on its other side: for them the
/// border is searched among the edges that look the same way.
/// Cost: O(n log n) for the trees; a point O(1) with a near hint, else O(log n) and the triangles
/// whose boxes hold it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/geometry/box_tree.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// Twice the signed areas of the three triangles of a point with the edges of `home`, which becomes
/// the triangle in which the walk ends: that of the point unless a border or the number of steps
/// stops it.
std::array<double, 3> walk_to(const TriangleComplex& complex, const Vec2& point, std::int32_t& home,
                              int most_steps);

/// A place in a mesh: weights of the three nodes of a triangle, none negative, of sum 1.
struct PlaneLocation {
  std::int32_t triangle = -1;
  std::array<double, 3> weights{};
  double distance = 0;  ///< from the point to the place: 0 inside
};

/// Which way the domain lies from a node of a border, and how far off another border of the same
/// curve may be.
struct BorderSide {
  Vec2 inward;
  double reach = 0;
};

class MeshLocation {
 public:
  /// Keeps a reference to the mesh. @pre it has triangles, and they are valid.
  explicit MeshLocation(const TriangleComplex& complex);

  /// A triangle that holds the point, which `hint` becomes; none outside. `hint`: any triangle, the
  /// nearer the better.
  bool find(const Vec2& point, std::int32_t& hint) const;
  PlaneLocation locate(const Vec2& point, std::int32_t hint) const;

  /// The same of a point on the border of another mesh: outside of the nearest border edge that
  /// looks its way it takes the closest place of that edge, even where it is inside again beyond a
  /// thin wall. An edge farther away than `reach` and half its own length does not count.
  PlaneLocation locate_on_border(const Vec2& point, const BorderSide& side,
                                 std::int32_t hint) const;

  const TriangleComplex& complex() const { return complex_; }

 private:
  struct NearEdge {
    EdgeHandle edge = no_edge;
    double share = 0;        ///< of the way along it, at the closest place
    double square = 0;       ///< of the distance
    bool is_beside = false;  ///< the point is on the inner side of this edge or of an equal one
  };

  bool holds(std::int32_t triangle, const Vec2& point) const;
  /// Of edges that look along `inward` (any where it is 0).
  NearEdge nearest_edge(const Vec2& point, const Vec2& inward) const;
  NearEdge measured(EdgeHandle edge, const Vec2& point) const;
  PlaneLocation at_edge(const NearEdge& near) const;
  PlaneLocation in_triangle(std::int32_t triangle, std::array<double, 3> areas) const;

  const TriangleComplex& complex_;
  int most_steps_ = 0;
  BoxTree triangles_;
  std::vector<EdgeHandle> border_;
  BoxTree border_tree_;
  Box3 box_;
  double first_radius_ = 0;
};

/// The place of each node of `target`, those of its border by the way that the domain lies; of
/// nodes that no triangle uses too.
std::vector<PlaneLocation> locate_nodes(const MeshLocation& background,
                                        const TriangleComplex& target);

}  // namespace tetfarm
