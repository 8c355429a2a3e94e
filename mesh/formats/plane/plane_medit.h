/// Meshes of the plane and fields at their nodes as Medit's text files (.mesh, .sol), which bamg,
/// FreeFEM, mmg2d and INRIA's programs read and write.
///
/// A symmetric tensor stands in a .sol file as xx, xy, yy. Vertices of a three-dimensional file
/// may lie in a plane z = constant, as some programs write them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/metric/metric2.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// @throws InvalidInput with the file and the line; IoError.
PlaneMesh read_plane_medit(const std::filesystem::path& path);
PlaneMesh read_plane_medit(std::string_view bytes, const std::string& name);
void write_plane_medit(const PlaneMesh& mesh, const std::filesystem::path& path);
/// What is written. @pre a patch for each edge, a region for each triangle.
std::string medit_text(const PlaneMesh& mesh);

/// The kinds of fields, by their numbers in the file.
enum class NodeFieldKind : std::uint8_t { scalar = 1, vector = 2, metric = 3 };

/// What a .sol file gives at each node: numbers, metrics and vectors. A file may hold them all.
struct NodeFields {
  std::vector<NodeFieldKind> order;  ///< of the fields in the file; each list below is in it
  std::vector<std::vector<double>> scalars;
  std::vector<std::vector<Metric2>> metrics;
  std::vector<std::vector<Vec2>> vectors;
};

/// @throws InvalidInput with the file and the line; IoError.
NodeFields read_plane_sol(const std::filesystem::path& path);
NodeFields read_plane_sol(std::string_view bytes, const std::string& name);
void write_plane_sol(std::span<const Metric2> metrics, const std::filesystem::path& path);
/// @pre `order` counts the fields, and all have a value for each node.
void write_plane_sol(const NodeFields& fields, const std::filesystem::path& path);
/// What is written. @pre as above.
std::string sol_text(const NodeFields& fields);

}  // namespace tetfarm
