#include "mesh/formats/plane/plane_cgns.h"

#include <string>
#include <vector>

#include "mesh/formats/cgns/cgns_tree.h"
#include "mesh/formats/plain_names.h"
#include "mesh/formats/plane/plane_sides.h"

namespace tetfarm {
namespace {

constexpr const char* base = "Base";
constexpr const char* zone = "Base/Zone1";
constexpr std::int32_t lines = 3;      // BAR_2
constexpr std::int32_t triangles = 5;  // TRI_3

/// The elements from `first` on, with `each` nodes, counted from 1.
void add_elements(CgnsTree& tree, const std::string& name, std::int32_t type, std::int64_t first,
                  const std::vector<std::int64_t>& nodes, std::int64_t each) {
  const std::string section = std::string(zone) + "/" + name;
  const std::int64_t last = first + std::ssize(nodes) / each - 1;
  tree.small_node(zone, name, "Elements_t", {type, 0});
  tree.large_node(section, "ElementRange", "IndexRange_t", {first, last});
  tree.large_node(section, "ElementConnectivity", "DataArray_t", nodes);
}

std::vector<std::string> names_of(const std::vector<PlanePatch>& patches) {
  std::vector<std::string> names;
  for (const PlanePatch& patch : patches) names.push_back(patch.name);
  return plain_names(
      names, 32, {"Zone1", "ZoneType", "GridCoordinates", "GridElements", "ZoneBC", "CellData"});
}

void add_patches(CgnsTree& tree, const PlaneMesh& mesh) {
  const PlaneSides sides = sides_of(mesh);
  const std::vector<PlanePatch> patches = border_patches(mesh, sides);
  const std::vector<std::string> names = names_of(patches);
  tree.node(zone, "ZoneBC", "ZoneBC_t");
  std::int64_t last = std::ssize(mesh.triangles);
  auto side = sides.border.begin();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    std::vector<std::int64_t> nodes;
    for (; side != sides.border.end() && side->patch == patches[i].number; ++side) {
      nodes.insert(nodes.end(), {side->a + 1, side->b + 1});
    }
    add_elements(tree, names[i], lines, last + 1, nodes, 2);
    tree.boundary(names[i], last + 1, last + std::ssize(nodes) / 2, "EdgeCenter");
    last += std::ssize(nodes) / 2;
  }
}

void add_coordinates(CgnsTree& tree, const PlaneMesh& mesh) {
  const std::string grid = std::string(zone) + "/GridCoordinates";
  std::vector<double> x;
  std::vector<double> y;
  for (const Vec2& point : mesh.points) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  tree.node(zone, "GridCoordinates", "GridCoordinates_t");
  tree.double_node(grid, "CoordinateX", "DataArray_t", x);
  tree.double_node(grid, "CoordinateY", "DataArray_t", y);
}

void add_triangles(CgnsTree& tree, const PlaneMesh& mesh) {
  std::vector<std::int64_t> nodes;
  for (const auto& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) nodes.push_back(v + std::int64_t{1});
  }
  add_elements(tree, "GridElements", triangles, 1, nodes, 3);
}

}  // namespace

void write_plane_cgns(const PlaneMesh& mesh, const std::filesystem::path& path) {
  CgnsTree tree(path);
  tree.version_node(3.4F);
  tree.small_node("", base, "CGNSBase_t", {2, 2});
  tree.large_node(base, "Zone1", "Zone_t", {std::ssize(mesh.points), std::ssize(mesh.triangles), 0},
                  1);
  tree.text_node(zone, "ZoneType", "ZoneType_t", "Unstructured");
  add_coordinates(tree, mesh);
  add_triangles(tree, mesh);
  add_patches(tree, mesh);
  const std::string cells = std::string(zone) + "/CellData";
  tree.node(zone, "CellData", "FlowSolution_t");
  tree.text_node(cells, "GridLocation", "GridLocation_t", "CellCenter");
  tree.small_node(cells, "Region", "DataArray_t", mesh.regions);
  tree.close();
}

}  // namespace tetfarm
