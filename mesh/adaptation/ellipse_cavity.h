/// Bowyer-Watson with ellipses: the cavity of a new node in a mesh with metrics, and its filling.
///
/// Source: thesis 3.2, equations 4 to 7 (approximations 1, 2 and 3) and 3.3.4 (restricted cavity).
/// Approximation 2 and 3 in the form of P.-L. George and H. Borouchaki, "Delaunay Triangulation and
/// Meshing" (1998): the sum of the ratios of distance and radius is less than their number. A
/// cavity by metrics need not be star-shaped, so validity does not rest on it: a triangle joins
/// only if the new node sees its two other edges, exactly, and if no node would be enclosed; none
/// joins across a constrained edge.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

enum class EllipseTest {
  at_new_node,    ///< approximation 1
  at_apex_too,    ///< approximation 2, the default
  at_all_corners  ///< approximation 3
};

struct CavityOptions {
  EllipseTest test = EllipseTest::at_apex_too;
  /// How many steps from the first triangles the cavity may reach; 1 is the restricted cavity.
  int rings = 1000;
};

class EllipseCavity {
 public:
  explicit EllipseCavity(CavityOptions options = {}) : options_(options) {}

  /// The cavity of a new node on the edge, which it divides. False when the node cannot be joined
  /// to the nodes round it, or is nearer to one of them than `shortest`, in metric length. At most
  /// some 200 triangles: where metrics differ wildly, ellipses hold whole meshes.
  bool find(const MetricMesh& mesh, const NodePlace& place, EdgeHandle edge, double shortest = 0);
  /// The nodes round it, without order.
  const std::vector<std::int32_t>& rim_nodes() const { return rim_nodes_; }
  /// Fills the cavity that was found with triangles to the new node `node`, which lies at the
  /// place. On a constrained edge both halves are constrained and on its curve.
  void fill(MetricMesh& mesh, std::int32_t node);

 private:
  struct RimEdge {
    std::int32_t from = 0, to = 0;
    EdgeHandle outside = no_edge;
    std::int32_t region = 0;
    bool is_constrained = false;
  };
  void add(std::int32_t triangle, int ring);
  bool open(const MetricMesh& mesh, const NodePlace& place, EdgeHandle edge);
  bool is_seen(const MetricMesh& mesh, const NodePlace& place, EdgeHandle edge) const;
  bool grow_until_seen(const MetricMesh& mesh, const NodePlace& place);
  bool mark_rim_node(std::int32_t node);

  CavityOptions options_;
  std::int32_t stamp_ = 0;
  std::vector<std::int32_t> node_stamps_;
  std::vector<std::int32_t> triangle_stamps_;
  std::vector<std::int32_t>
      starts_;  ///< of a rim node: the new triangle whose rim edge begins here
  std::vector<std::int32_t> triangles_;
  std::vector<int> rings_;  ///< of each triangle of the cavity
  std::vector<std::int32_t> rim_nodes_;
  std::vector<RimEdge> rim_;
  EdgeHandle divided_ = no_edge;
};

/// Whether `p` lies in the ellipse through the corners of a triangle, by the metrics the test
/// takes: M(p) of the new node, that of the apex, those of all corners.
bool is_in_ellipse(const MetricMesh& mesh, const TriangleComplex::Nodes& nodes, int apex,
                   const NodePlace& p, EllipseTest test);

}  // namespace tetfarm
