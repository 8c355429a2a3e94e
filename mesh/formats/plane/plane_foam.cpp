#include "mesh/formats/plane/plane_foam.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/array_index.h"
#include "base/file_system.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/openfoam/foam_files.h"
#include "mesh/formats/plain_names.h"
#include "mesh/formats/plane/plane_sides.h"

namespace tetfarm {
namespace {

constexpr double layer_height = 1;
constexpr std::size_t most_side_corners = 4;
constexpr const char* front_and_back = "frontAndBack";

using PrismFace = FaceNodes<std::int64_t>;

/// The nodes that triangles use, numbered in their order; the layer above has the same behind them.
struct LayerNodes {
  std::vector<std::int64_t> numbers;  ///< of each point; -1: unused
  std::int64_t count = 0;
};

LayerNodes number_nodes(const PlaneMesh& mesh) {
  LayerNodes nodes{std::vector<std::int64_t>(mesh.points.size(), -1), 0};
  for (const auto& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) nodes.numbers[at(v)] = 0;
  }
  for (std::int64_t& number : nodes.numbers) {
    if (number == 0) number = nodes.count++;
  }
  return nodes;
}

/// The quad that stands on a side, its normal to the right of the way from a to b.
PrismFace standing_face(const LayerNodes& nodes, std::int32_t a, std::int32_t b) {
  const std::int64_t p = nodes.numbers[at(a)];
  const std::int64_t q = nodes.numbers[at(b)];
  const std::array<std::int64_t, 4> corners = {p, q, q + nodes.count, p + nodes.count};
  return PrismFace(std::span<const std::int64_t>(corners));
}

/// The triangle at the foot or the top of its prism, its normal out of it.
PrismFace lying_face(const LayerNodes& nodes, const std::array<std::int32_t, 3>& triangle,
                     bool is_top) {
  std::array<std::int64_t, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = nodes.numbers[at(triangle[i])] + (is_top ? nodes.count : 0);
  }
  const PrismFace face{std::span<const std::int64_t>(corners)};
  return is_top ? face : face.turned();
}

void write_layer_points(const std::filesystem::path& folder, const PlaneMesh& mesh,
                        const LayerNodes& nodes, const NumberText& style) {
  FoamList list(folder, {"points", "vectorField", foam_point_bytes(style), ""}, 2 * nodes.count);
  for (const double z : {0.0, layer_height}) {
    NumberText text = style;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      if (nodes.numbers[i] < 0) continue;
      put_foam_point(text, {mesh.points[i].x, mesh.points[i].y, z});
    }
    list.append(text.bytes());
  }
  list.finish();
}

void write_labels(const std::filesystem::path& folder, const char* object, const std::string& note,
                  const NumberText& style, const std::vector<std::int64_t>& labels) {
  FoamList list(folder, {object, "labelList", foam_label_bytes(style), note}, std::ssize(labels));
  NumberText text = style;
  for (const std::int64_t label : labels) put_foam_label(text, label);
  list.append(text.bytes());
  list.finish();
}

/// Faces inside, those that stand on the border, those of the foot, those of the top.
void write_prism_faces(const std::filesystem::path& folder, const PlaneMesh& mesh,
                       const PlaneSides& sides, const LayerNodes& nodes, const NumberText& style) {
  const std::int64_t inner = std::ssize(sides.inner);
  const std::int64_t cells = std::ssize(mesh.triangles);
  const std::int64_t faces = inner + std::ssize(sides.border) + 2 * cells;
  NumberText text = style;
  std::vector<std::int64_t> owners;
  std::vector<std::int64_t> neighbours;
  owners.reserve(at(faces));
  neighbours.reserve(at(inner));
  const auto put = [&](const PrismFace& face, std::int64_t owner) {
    put_foam_face(text, face, most_side_corners);
    owners.push_back(owner);
  };
  for (const InnerSide& side : sides.inner) {
    put(standing_face(nodes, side.a, side.b), side.triangle);
    neighbours.push_back(side.neighbour);
  }
  for (const OuterSide& side : sides.border) {
    put(standing_face(nodes, side.a, side.b), side.triangle);
  }
  for (const bool is_top : {false, true}) {
    for (std::int64_t t = 0; t < cells; ++t) {
      put(lying_face(nodes, mesh.triangles[at(t)], is_top), t);
    }
  }
  FoamList list(folder, {"faces", "faceList", foam_face_bytes(style, most_side_corners), ""},
                faces);
  list.append(text.bytes());
  list.finish();
  const std::string note =
      "nPoints: " + std::to_string(2 * nodes.count) + " nCells: " + std::to_string(cells) +
      " nFaces: " + std::to_string(faces) + " nInternalFaces: " + std::to_string(inner);
  write_labels(folder, "owner", note, style, owners);
  write_labels(folder, "neighbour", note, style, neighbours);
}

/// "wall" and all that begins or ends with it, in any case.
bool names_a_wall(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name.starts_with("wall") || name.ends_with("wall") || name.ends_with("walls");
}

std::vector<FoamPatch> prism_patches(const PlaneMesh& mesh, const PlaneSides& sides) {
  const std::vector<PlanePatch> of_border = border_patches(mesh, sides);
  const std::vector<bool> bounds_hole = bound_holes(mesh, sides, of_border);
  std::vector<std::string> names;
  for (const PlanePatch& patch : of_border) names.push_back(patch.name);
  names = plain_names(names, 200, {front_and_back});
  std::vector<FoamPatch> patches;
  std::int64_t next = std::ssize(sides.inner);
  auto side = sides.border.begin();
  for (std::size_t i = 0; i < of_border.size(); ++i) {
    FoamPatch patch{names[i], 0, next};
    patch.type = bounds_hole[i] || names_a_wall(names[i]) ? "wall" : "patch";
    for (; side != sides.border.end() && side->patch == of_border[i].number; ++side) ++patch.faces;
    next += patch.faces;
    patches.push_back(patch);
  }
  FoamPatch flat{front_and_back, 2 * std::ssize(mesh.triangles), next};
  flat.type = "empty";
  patches.push_back(flat);
  return patches;
}

/// Zones come in the order of the numbers of their regions.
void write_region_zones(const std::filesystem::path& folder, const PlaneMesh& mesh) {
  std::map<std::int32_t, std::size_t> zone_of_region;
  for (const std::int32_t region : mesh.regions) zone_of_region[region] = 0;
  if (zone_of_region.size() < 2) {
    remove_file(folder / "cellZones");  // of a mesh that was here before
    return;
  }
  std::vector<std::string> names;
  for (auto& [region, zone] : zone_of_region) {
    zone = names.size();
    const auto named = mesh.region_names.find(region);
    names.push_back(named == mesh.region_names.end() ? "region_" + std::to_string(region)
                                                     : named->second);
  }
  std::vector<FoamZoneRun> runs;
  for (std::size_t t = 0; t < mesh.regions.size(); ++t) {
    const std::size_t zone = zone_of_region[mesh.regions[t]];
    if (runs.empty() || runs.back().zone != zone) {
      runs.push_back({zone, static_cast<std::int64_t>(t), 0});
    }
    ++runs.back().count;
  }
  write_foam_zones(folder, plain_names(names, 200), runs);
}

}  // namespace

void write_plane_foam(const PlaneMesh& mesh, const std::filesystem::path& folder) {
  const PlaneSides sides = sides_of(mesh);
  const LayerNodes nodes = number_nodes(mesh);
  const std::int64_t cells = std::ssize(mesh.triangles);
  require_32_bits(std::ssize(sides.inner) + std::ssize(sides.border) + 2 * cells, "faces",
                  "OpenFOAM's labels", "make a coarser one");
  const std::filesystem::path poly_mesh = folder / "constant" / "polyMesh";
  make_folders(poly_mesh);
  const NumberText style = NumberText::text(std::max(2 * nodes.count, cells));
  write_layer_points(poly_mesh, mesh, nodes, style);
  write_prism_faces(poly_mesh, mesh, sides, nodes, style);
  write_region_zones(poly_mesh, mesh);
  write_foam_boundary(poly_mesh, prism_patches(mesh, sides));
}

}  // namespace tetfarm
