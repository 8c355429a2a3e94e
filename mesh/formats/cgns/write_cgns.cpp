#include "mesh/formats/cgns/write_cgns.h"

#include <array>

#include "base/check.h"
#include "mesh/assemble/node_blocks.h"
#include "mesh/core/elements.h"
#include "mesh/formats/cgns/cgns_tree.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/plain_names.h"

namespace tetfarm {
namespace {

constexpr std::int32_t tri_3 = code_of(ElementCodes::cgns, ElementType::triangle);
constexpr std::int32_t tetra_4 = code_of(ElementCodes::cgns, ElementType::tet);
constexpr std::int64_t large_bytes = 8;
constexpr std::int64_t small_bytes = 4;
constexpr const char* base = "Base";
constexpr const char* zone = "Base/Zone1";

/// Where the arrays of the file begin.
struct Places {
  std::array<std::int64_t, 3> coordinates{};
  std::int64_t tets = 0;
  std::int64_t regions = 0;
  std::int64_t subdomains = 0;
  std::vector<std::int64_t> triangles;  ///< of each patch
};

/// Elements `first` … `last`; returns where their nodes go.
std::int64_t add_section(CgnsTree& tree, const std::string& name, std::int32_t type,
                         std::int64_t first, std::int64_t last) {
  TF_CHECK(type == tri_3 || type == tetra_4);
  const std::string section = std::string(zone) + "/" + name;
  const int nodes = type == tri_3 ? 3 : 4;
  tree.small_node(zone, name, "Elements_t", {type, 0});
  tree.large_node(section, "ElementRange", "IndexRange_t", {first, last});
  return tree.room_for_large(section, "ElementConnectivity", (last - first + 1) * nodes);
}

void add_patch(CgnsTree& tree, const std::string& name, std::int64_t first, std::int64_t last) {
  const std::string conditions = std::string(zone) + "/ZoneBC";
  tree.node(base, name, "Family_t");
  tree.text_node(conditions, name, "BC_t", "FamilySpecified");
  tree.large_node(conditions + "/" + name, "PointRange", "IndexRange_t", {first, last}, 1);
  tree.text_node(conditions + "/" + name, "GridLocation", "GridLocation_t", "FaceCenter");
  tree.text_node(conditions + "/" + name, "FamilyName", "FamilyName_t", name);
}

Places write_frame(const std::filesystem::path& path, const MeshOutline& outline) {
  CgnsTree tree(path);
  Places places;
  tree.version_node(3.4F);
  tree.small_node("", base, "CGNSBase_t", {3, 3});
  tree.large_node(base, "Zone1", "Zone_t", {outline.nodes, outline.tets, 0}, 1);
  tree.text_node(zone, "ZoneType", "ZoneType_t", "Unstructured");
  tree.node(zone, "GridCoordinates", "GridCoordinates_t");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array names = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    places.coordinates[i] =
        tree.room_for_doubles(std::string(zone) + "/GridCoordinates", names[i], outline.nodes);
  }
  places.tets = add_section(tree, "GridElements", tetra_4, 1, outline.tets);
  const std::vector<std::string> names =
      plain_names(outline.patch_names, 32,
                  {"Zone1", "ZoneType", "GridCoordinates", "GridElements", "ZoneBC", "CellData"});
  std::int64_t last = outline.tets;
  tree.node(zone, "ZoneBC", "ZoneBC_t");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::int64_t first = last + 1;
    last += outline.faces_of_patch[i];
    places.triangles.push_back(0);
    if (last < first) continue;
    places.triangles.back() = add_section(tree, names[i], tri_3, first, last);
    add_patch(tree, names[i], first, last);
  }
  const std::string cell_data = std::string(zone) + "/CellData";
  tree.node(zone, "CellData", "FlowSolution_t");
  tree.text_node(cell_data, "GridLocation", "GridLocation_t", "CellCenter");
  places.regions = tree.room_for_small(cell_data, "Region", outline.tets);
  places.subdomains = tree.room_for_small(cell_data, "Subdomain", outline.tets);
  TF_CHECK(places.triangles.size() == outline.faces_of_patch.size());
  tree.close();
  return places;
}

void write_coordinates(OutputFile& file, const Places& places, const NumberedPart& part) {
  std::vector<double> values;
  for_each_node_run(part, [&](std::int64_t first, const std::vector<Vec3>& nodes) {
    for (int axis = 0; axis < 3; ++axis) {
      values.clear();
      for (const Vec3& p : nodes) values.push_back(p[axis]);
      file.write(places.coordinates[static_cast<std::size_t>(axis)] + first * 8, values);
    }
  });
}

}  // namespace

void write_cgns(const MeshSource& source, const MeshOutline& outline,
                const std::filesystem::path& path) {
  TF_CHECK(outline.parts.size() == source.size());
  const Places places = write_frame(path, outline);
  OutputFile file(path, OutputFile::Start::as_it_is);
  const NumberText raw = NumberText::raw();
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const PartOutline& here = outline.parts[i];
    write_coordinates(file, places, part);
    std::int64_t place = places.tets + here.first_tet * 4 * large_bytes;
    for_each_block_of_nodes<std::int64_t>(part, 1, [&](const std::vector<std::int64_t>& nodes) {
      file.write(place, nodes);
      place += std::ssize(nodes) * large_bytes;
    });
    std::vector<std::int32_t> regions = regions_of_cells(part);
    regions.resize(part.tets.size());
    file.write(places.regions + here.first_tet * small_bytes, regions);
    file.write(places.subdomains + here.first_tet * small_bytes,
               std::vector<std::int32_t>(part.tets.size(), part.number));
    const auto faces = faces_by_patch(part, outline.patch_names.size());
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      NumberText triangles = raw;
      for (const std::size_t face : faces[patch]) {
        for (const std::int32_t v : part.faces[face]) {
          triangles.integer(global_node(part, v) + 1);
        }
      }
      file.write(places.triangles[patch] + here.first_face_of_patch[patch] * 3 * large_bytes,
                 triangles.bytes());
    }
  }
  file.finish();
}

}  // namespace tetfarm
