#include "mesh/formats/cgns/write_cgns.h"

#include <array>
#include <numeric>
#include <set>

#include "base/check.h"
#include "mesh/assemble/node_blocks.h"
#include "mesh/core/element_block.h"
#include "mesh/formats/cgns/cgns_tree.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/plain_names.h"

namespace tetfarm {
namespace {

constexpr std::int64_t large_bytes = 8;
constexpr std::int64_t small_bytes = 4;
constexpr const char* base = "Base";
constexpr const char* zone = "Base/Zone1";

/// Where the arrays of the file begin.
struct Places {
  std::array<std::int64_t, 3> coordinates{};
  std::int64_t tets = 0;
  ByType<std::int64_t> cells;  ///< of types in blocks
  std::int64_t regions = 0;
  std::int64_t subdomains = 0;
  std::vector<std::int64_t> triangles;      ///< of each patch
  ByType<std::vector<std::int64_t>> faces;  ///< the same, of types in blocks
};

/// Elements `first` … `last`; returns where their nodes go.
std::int64_t add_section(CgnsTree& tree, const std::string& name, ElementType type,
                         std::int64_t first, std::int64_t last) {
  const std::string section = std::string(zone) + "/" + name;
  const auto nodes = static_cast<std::int64_t>(nodes_of(type));
  tree.small_node(zone, name, "Elements_t", {code_of(ElementCodes::cgns, type), 0});
  tree.large_node(section, "ElementRange", "IndexRange_t", {first, last});
  return tree.room_for_large(section, "ElementConnectivity", (last - first + 1) * nodes);
}

std::vector<std::string> names_of_patches(const MeshOutline& outline) {
  std::vector<std::string> taken = {"Zone1",        "ZoneType", "GridCoordinates",
                                    "GridElements", "ZoneBC",   "CellData"};
  for_each_block(outline.blocks, [&](ElementType type, const BlockOutline& block) {
    if (block.count > 0 && is_cell(type)) taken.push_back(cgns_section(type));
  });
  return plain_names(outline.patch_names, 32, taken);
}

/// A patch with faces of two types has a section of each: only the first can have its name.
class SectionNames {
 public:
  explicit SectionNames(const std::vector<std::string>& patch_names)
      : taken_(patch_names.begin(), patch_names.end()) {}
  std::string next(ElementType type) {
    for (std::size_t i = 1;; ++i) {
      std::string name = cgns_section(type) + "_" + std::to_string(i);
      if (taken_.insert(name).second) return name;
    }
  }

 private:
  std::set<std::string> taken_;
};

/// A BCType of the SIDS; "" where none says the same.
std::string condition_of(PatchType type) {
  switch (type) {
    case PatchType::wall:
      return "BCWallViscous";
    case PatchType::slip:
      return "BCWallInviscid";
    case PatchType::symmetry:
      return "BCSymmetryPlane";
    case PatchType::farfield:
      return "BCFarfield";
    case PatchType::inflow:
      return "BCInflow";
    case PatchType::outflow:
      return "BCOutflow";
    default:
      return {};
  }
}

/// Sections and boundary conditions, behind `last` elements.
void add_patches(CgnsTree& tree, const MeshOutline& outline, std::int64_t last, Places& places) {
  const std::vector<std::string> names = names_of_patches(outline);
  TF_CHECK(names.size() <= outline.faces_of_patch.size());
  SectionNames more_names(names);
  tree.node(zone, "ZoneBC", "ZoneBC_t");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::int64_t first = last + 1;
    const auto add = [&](ElementType type, std::int64_t count) -> std::int64_t {
      if (count == 0) return 0;
      const std::string name = last < first ? names[i] : more_names.next(type);
      const std::int64_t place = add_section(tree, name, type, last + 1, last + count);
      last += count;
      return place;
    };
    places.triangles.push_back(add(ElementType::triangle, outline.faces_of_patch[i]));
    for (const ElementType type : face_block_types) {
      places.faces[type].push_back(add(type, outline.blocks[type].of_group[i]));
    }
    if (last < first) continue;
    tree.boundary(names[i], first, last, "FaceCenter",
                  condition_of(type_of_patch(outline.patch_types, i)));
  }
}

Places write_frame(const std::filesystem::path& path, const MeshOutline& outline) {
  CgnsTree tree(path);
  Places places;
  tree.version_node(3.4F);
  tree.small_node("", base, "CGNSBase_t", {3, 3});
  tree.large_node(base, "Zone1", "Zone_t", {outline.nodes, outline.cells(), 0}, 1);
  tree.text_node(zone, "ZoneType", "ZoneType_t", "Unstructured");
  tree.node(zone, "GridCoordinates", "GridCoordinates_t");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array names = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    places.coordinates[i] =
        tree.room_for_doubles(std::string(zone) + "/GridCoordinates", names[i], outline.nodes);
  }
  std::int64_t last = outline.tets;
  if (outline.tets > 0 || outline.cells() == 0) {
    places.tets = add_section(tree, "GridElements", ElementType::tet, 1, last);
  }
  for (const ElementType type : cell_block_types) {
    const std::int64_t count = outline.blocks[type].count;
    if (count == 0) continue;
    places.cells[type] = add_section(tree, cgns_section(type), type, last + 1, last + count);
    last += count;
  }
  add_patches(tree, outline, last, places);
  const std::string cell_data = std::string(zone) + "/CellData";
  tree.node(zone, "CellData", "FlowSolution_t");
  tree.text_node(cell_data, "GridLocation", "GridLocation_t", "CellCenter");
  places.regions = tree.room_for_small(cell_data, "Region", outline.cells());
  places.subdomains = tree.room_for_small(cell_data, "Subdomain", outline.cells());
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

void write_triangles(OutputFile& file, const Places& places, const NumberedPart& part,
                     const PartOutline& here, const NumberText& raw) {
  const auto faces = faces_by_patch(part, places.triangles.size());
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

std::string nodes_of_block(ElementType type, const NumberedPart& part,
                           const std::vector<std::size_t>& elements) {
  NumberText nodes = NumberText::raw();
  for (const std::size_t i : elements) {
    for_each_global_node(ElementCodes::cgns, type, part, i,
                         [&](std::int64_t node) { nodes.integer(node + 1); });
  }
  return nodes.take();
}

/// The elements in blocks, and of cells their regions and sub-domains behind those of the tets.
void write_blocks(OutputFile& file, const Places& places, const NumberedPart& part,
                  const PartOutline& here, const MeshOutline& outline) {
  for (const ElementType type : face_block_types) {
    const auto faces = faces_by_patch(part.blocks[type], places.triangles.size());
    const std::int64_t bytes = static_cast<std::int64_t>(nodes_of(type)) * large_bytes;
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      if (faces[patch].empty()) continue;
      file.write(places.faces[type][patch] + here.blocks[type].first_of_group[patch] * bytes,
                 nodes_of_block(type, part, faces[patch]));
    }
  }
  std::int64_t first = outline.tets;
  for (const ElementType type : cell_block_types) {
    const ElementBlock& block = part.blocks[type];
    const std::int64_t before = here.blocks[type].first;
    if (!block.empty()) {
      std::vector<std::size_t> all(block.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      const std::int64_t bytes = static_cast<std::int64_t>(nodes_of(type)) * large_bytes;
      file.write(places.cells[type] + before * bytes, nodes_of_block(type, part, all));
      file.write(places.regions + (first + before) * small_bytes, block.regions);
      file.write(places.subdomains + (first + before) * small_bytes,
                 std::vector<std::int32_t>(block.size(), part.number));
    }
    first += outline.blocks[type].count;
  }
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
    write_triangles(file, places, part, here, raw);
    write_blocks(file, places, part, here, outline);
  }
  file.finish();
}

}  // namespace tetfarm
