/// The input surface as that which the remeshed one must stay on: nearest points of its faces and
/// curves, and which faces are plane.
///
/// Points are only ever compared with the face or curve that they belong to, so that the two sides
/// of a thin plate, or two curves near each other, are never taken for each other. Units: lengths
/// in the unit of the input.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/remeshing/box_forest.h"
#include "mesh/remeshing/feature_curves.h"
#include "mesh/remeshing/normal_cones.h"
#include "mesh/remeshing/surface_features.h"

namespace tetfarm {

struct InputFoot {
  Vec3 at;
  std::int32_t item = -1;  ///< the triangle or feature edge of the input
  double distance2 = 0;
};

class InputShape {
 public:
  /// @param shares of the tolerance, of each triangle (shares_of_tolerance). @pre surface and
  /// features outlive this. Cost: O(n log n), some 240 bytes a triangle.
  InputShape(const SurfaceMesh& surface, const SurfaceFeatures& features,
             std::vector<double> shares);

  /// The nearest point of the face's triangles whose normals do not turn away from `normal`, when
  /// it is nearer than `limit`. `guess`: a triangle likely to be near, or -1.
  std::optional<InputFoot> on_face(std::int32_t face, const Vec3& p, const Vec3& normal,
                                   double limit, std::int32_t guess) const;
  /// A triangle of the face that is nearer to p than its share of `limit` and whose normal, unless
  /// it has no sure direction, has at least this cosine with `normal`; -1: none.
  /// `guesses`: triangles likely to be near, or -1; they are looked at first.
  std::int32_t near_on_face(std::int32_t face, const Vec3& p, const Vec3& normal,
                            double least_cosine, double limit,
                            std::span<const std::int32_t> guesses) const;
  /// The nearest point of the curve, when it is nearer than `limit`.
  std::optional<InputFoot> on_curve(std::int32_t curve, const Vec3& p, double limit,
                                    std::int32_t guess) const;
  /// The curve nearest to p and the point of it, when it is nearer than `limit`.
  std::optional<InputFoot> on_any_curve(const Vec3& p, double limit) const;
  std::int32_t curve_of(std::int32_t edge) const {
    return curves_.curve_of_edge[static_cast<std::size_t>(edge)];
  }
  std::int32_t curve_of_vertex(std::int32_t v) const {
    return curves_.curve_of_vertex[static_cast<std::size_t>(v)];
  }

  /// How much of the tolerance there is at a triangle, and at a feature edge, where that of the
  /// triangle counts that has most.
  double share_at(std::int32_t triangle) const {
    return shares_[static_cast<std::size_t>(triangle)];
  }
  double share_at_edge(std::int32_t edge) const {
    return edge_shares_[static_cast<std::size_t>(edge)];
  }

  /// Of unit length; zero where it has no sure direction, as the triangle is a needle.
  const Vec3& normal(std::int32_t triangle) const {
    return normals_[static_cast<std::size_t>(triangle)];
  }
  /// Whether all of the input in the box, of whatever face, looks much the same way as `way`, of
  /// unit length: a cosine above `least_cosine`. Never where sheets lie between regions, as they
  /// may look either way.
  bool looks_one_way(const Box3& box, const Vec3& way, double least_cosine) const {
    return surface_.sides.empty() && cones_.all_look(surface_, normals_, box, way, least_cosine);
  }
  /// The normal of a face all of whose vertices lie in one plane, to rounding of the coordinates.
  const std::optional<Vec3>& plane(std::int32_t face) const {
    return planes_[static_cast<std::size_t>(face)];
  }

 private:
  /// The nearest point of the feature edges of a group of the forest.
  std::optional<InputFoot> on_edges(const BoxForest& forest, std::int32_t group, const Vec3& p,
                                    double limit, std::int32_t guess) const;

  const SurfaceMesh& surface_;
  const SurfaceFeatures& features_;
  FeatureCurves curves_;
  std::vector<Vec3> normals_;
  std::vector<double> shares_;
  std::vector<double> edge_shares_;
  std::vector<std::optional<Vec3>> planes_;
  NormalCones cones_;
  BoxForest triangles_;  ///< grouped by face
  BoxForest edges_;      ///< grouped by curve
  BoxForest all_edges_;
};

}  // namespace tetfarm
