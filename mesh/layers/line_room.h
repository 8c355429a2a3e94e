/// How far each line may go: the free way before it, and the height at which the cells round it
/// would fold.
///
/// Source: the free way as Netgen's boundary layers have it, 0.4 of the distance along the line to
/// the first face of the boundary; the fold height follows from the Jacobian of a prism whose three
/// edges are straight lines, a polynomial of degree two. Neither is a proof: layer_proof.h is.
/// Heights are normal to the wall (LayerLine::along).
#pragma once

#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/wall_graph.h"
#include "mesh/layers/wall_planes.h"

namespace tetfarm {

/// Of the free way to what is opposite, so much is a line's.
inline constexpr double share_of_free_way = 0.4;
/// A cell keeps so much of its Jacobian at the wall.
inline constexpr double least_jacobian = 0.3;

/// The free way's share of each line, or `wanted` where that is less. Planes that a line stays in
/// are not in its way. The lines of a triangle that another comes down on have no more than that
/// one: their layers are there, too, where none of them looks.
/// @pre `along` and `wanted` have one for each line; a zero vector does not move.
/// Cost: the boxes round each line.
std::vector<double> free_ways(const SurfaceMesh& surface, const WallGraph& graph,
                              const WallPlanes& planes, std::span<const Vec3> along,
                              std::span<const double> wanted);

/// The height at which a cell at the line keeps least_jacobian, or `wanted` where that is less.
/// Cost: O(n).
std::vector<double> fold_heights(const SurfaceMesh& surface, const WallGraph& graph,
                                 std::span<const Vec3> along, std::span<const double> wanted);

}  // namespace tetfarm
