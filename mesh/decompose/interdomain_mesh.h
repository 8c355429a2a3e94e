/// The inter-domain mesh: the loops projected on the plane and meshed there.
///
/// Source: thesis 4.3.1.8 (mapping to two dimensions) and 4.3.1.9. It stays a graph over the plane:
/// a triangulation in u, v and a height at every node, so it can never cross itself.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/cut_plane.h"
#include "mesh/decompose/edge_loops.h"
#include "mesh/planar/planar_mesh.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// A node of the job's lattice that is a node of the cut.
struct LatticeNodeOfCut {
  Vec3 at;
  /// Far enough from the rim to stay where it is, bit by bit.
  bool is_held = false;
};

/// Planar point i < rim_vertices.size() is the sub-domain's vertex rim_vertices[i]; the
/// rest are new nodes, those of the lattice first. Triangles are anticlockwise in the plane: their
/// normals point from left to right.
struct InterdomainMesh {
  CutPlane plane;
  std::vector<RimEdge> rim;
  std::vector<std::array<std::int32_t, 2>> rim_nodes;  // the planar points of each rim edge
  std::vector<std::int32_t> rim_vertices;
  std::vector<LatticeNodeOfCut> lattice;
  PlanarMesh planar;
  std::vector<std::int32_t> rim2triangle;  // the planar triangle on each rim edge
  std::vector<double> heights;             // above the plane; of rim nodes as they are
  std::vector<double> spacing;             // at each planar point

  bool is_rim_node(std::int32_t node) const {
    return static_cast<std::size_t>(node) < rim_vertices.size();
  }
};

struct InterdomainResult {
  InterdomainMesh mesh;
  /// Why there is none; empty when there is one.
  std::string problem;
};

/// Two rim nodes, as planar points in ascending order.
using Chord = std::array<std::int32_t, 2>;

/// What is asked of the inside of the cut.
struct InnerNodes {
  /// Nodes in the plane that are to be nodes of the cut where they lie in its region and keep clear
  /// of its rim.
  std::vector<LatticeNode> lattice;
  /// Chords that are to have a new node near their middle instead.
  std::vector<Chord> unwanted_chords;
};

/// Heights of new nodes are 0. No inner edge is an edge of the surface, or an unwanted chord. Fails
/// when projected loops tangle, cross, or enclose no region. Cost: O(m log m) for m cut triangles.
InterdomainResult mesh_interdomain(const Subdomain& subdomain, const SurfaceTopology& topology,
                                   const EdgeLoops& loops, const CutPlane& plane,
                                   const SpacingField& spacing, const InnerNodes& inner = {});

/// The node of the triangle on rim edge i that is not on the edge.
std::int32_t apex_of_rim_triangle(const InterdomainMesh& mesh, std::size_t i);

/// The inner edges of a cut triangle that join rim nodes.
std::vector<Chord> chords_of_triangle(const InterdomainMesh& mesh, std::int32_t triangle);

/// The place of a node in space; rim nodes bit by bit as in the sub-domain.
Vec3 node_position(const InterdomainMesh& mesh, const Subdomain& subdomain, std::int32_t node);

}  // namespace tetfarm
