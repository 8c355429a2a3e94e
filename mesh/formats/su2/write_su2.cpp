#include "mesh/formats/su2/write_su2.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/plain_names.h"
#include "mesh/formats/su2/su2_walker.h"

namespace tetfarm {
namespace {

constexpr ElementCodes vtk = ElementCodes::vtk;

/// Records have a type and nodes; those of cells a number behind.
int numbers_of(ElementType type) {
  return static_cast<int>(1 + nodes_of(type) + (is_cell(type) ? 1 : 0));
}

std::vector<std::string> su2_markers(const MeshOutline& outline) {
  return plain_names(outline.patch_names, 200);
}

/// What a configuration says of the markers of a type, with values behind each.
struct MarkerLine {
  PatchType type = PatchType::unspecified;
  const char* option = "";
  const char* values = "";
};

/// SU2 has no lines for the others: a comment names them, as it refuses markers that it is not told
/// of. Those that want values of the flow are comments too, with the standard atmosphere's.
constexpr std::array<MarkerLine, 11> marker_lines = {
    {{PatchType::wall, "MARKER_HEATFLUX", ", 0.0"},
     {PatchType::slip, "MARKER_EULER", ""},
     {PatchType::symmetry, "MARKER_SYM", ""},
     {PatchType::farfield, "MARKER_FAR", ""},
     {PatchType::inflow, "% set temperature, pressure and direction: MARKER_INLET",
      ", 288.15, 101325.0, 1.0, 0.0, 0.0"},
     {PatchType::outflow, "% set the pressure: MARKER_OUTLET", ", 101325.0"},
     {PatchType::coupled, "% interface: MARKER_FLUID_INTERFACE", ""},
     {PatchType::pec, "% pec, nothing in SU2", ""},
     {PatchType::pmc, "% pmc, nothing in SU2", ""},
     {PatchType::absorbing, "% absorbing, nothing in SU2", ""},
     {PatchType::unspecified, "% no type was given, SU2 wants one", ""}}};

/// Where each list begins.
struct Places {
  std::int64_t tet = 0;
  ByType<std::int64_t> cells;
  std::int64_t node = 0;
  std::vector<std::int64_t> face_of_patch;
  ByType<std::vector<std::int64_t>> others_of_patch;
};

/// Writes the lines between the lists.
Places write_frame(OutputFile& file, const MeshOutline& outline, const NumberText& style) {
  Places places;
  std::int64_t place = 0;
  const auto words = [&](const std::string& text) {
    file.write(place, text);
    place += std::ssize(text);
  };
  const auto leave = [&](ElementType type, std::int64_t count) {
    return std::exchange(place, place + count * style.record_bytes(numbers_of(type), 0));
  };
  words("NDIME= 3\nNELEM= " + std::to_string(outline.cells()) + "\n");
  places.tet = leave(ElementType::tet, outline.tets);
  for (const ElementType type : cell_block_types) {
    places.cells[type] = leave(type, outline.blocks[type].count);
  }
  words("NPOIN= " + std::to_string(outline.nodes) + "\n");
  places.node = place;
  place += outline.nodes * style.record_bytes(1, 3);
  words("NMARK= " + std::to_string(outline.patch_names.size()) + "\n");
  const std::vector<std::string> names = su2_markers(outline);
  for (std::size_t i = 0; i < names.size(); ++i) {
    words("MARKER_TAG= " + names[i] +
          "\nMARKER_ELEMS= " + std::to_string(outline.boundary_faces_of(i)) + "\n");
    places.face_of_patch.push_back(leave(ElementType::triangle, outline.faces_of_patch[i]));
    for (const ElementType type : face_block_types) {
      places.others_of_patch[type].push_back(leave(type, outline.blocks[type].of_group[i]));
    }
  }
  return places;
}

void write_tets(OutputFile& file, const Places& places, const NumberedPart& part,
                const PartOutline& here, const NumberText& style) {
  NumberText tets = style;
  std::int64_t tet_number = here.first_tet;
  for (const Tet& tet : part.tets) {
    tets.integer(code_of(vtk, ElementType::tet));
    for (const std::int32_t v : tet) tets.integer(global_node(part, v));
    tets.integer(tet_number++);
    tets.end_record();
  }
  file.write(places.tet + here.first_tet * style.record_bytes(numbers_of(ElementType::tet), 0),
             tets.bytes());
}

/// Cells in blocks are numbered behind the tets, type after type.
void write_cells(OutputFile& file, const Places& places, const NumberedPart& part,
                 const PartOutline& here, const MeshOutline& outline, const NumberText& style) {
  std::int64_t first = outline.tets;
  for (const ElementType type : cell_block_types) {
    NumberText cells = style;
    std::int64_t number = first + here.blocks[type].first;
    for (std::size_t i = 0; i < part.blocks[type].size(); ++i) {
      cells.integer(code_of(vtk, type));
      for_each_global_node(vtk, type, part, i, [&](std::int64_t node) { cells.integer(node); });
      cells.integer(number++);
      cells.end_record();
    }
    file.write(
        places.cells[type] + here.blocks[type].first * style.record_bytes(numbers_of(type), 0),
        cells.bytes());
    first += outline.blocks[type].count;
  }
}

void write_triangles(OutputFile& file, const Places& places, const NumberedPart& part,
                     const PartOutline& here, const NumberText& style) {
  const auto faces = faces_by_patch(part, places.face_of_patch.size());
  for (std::size_t patch = 0; patch < faces.size(); ++patch) {
    NumberText triangles = style;
    for (const std::size_t face : faces[patch]) {
      triangles.integer(su2_triangle);
      for (const std::int32_t v : part.faces[face]) triangles.integer(global_node(part, v));
      triangles.end_record();
    }
    file.write(
        places.face_of_patch[patch] + here.first_face_of_patch[patch] *
                                          style.record_bytes(numbers_of(ElementType::triangle), 0),
        triangles.bytes());
  }
}

void write_faces(OutputFile& file, const Places& places, const NumberedPart& part,
                 const PartOutline& here, const NumberText& style) {
  for (const ElementType type : face_block_types) {
    const auto faces = faces_by_patch(part.blocks[type], places.face_of_patch.size());
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      NumberText records = style;
      for (const std::size_t face : faces[patch]) {
        records.integer(code_of(vtk, type));
        for_each_global_node(vtk, type, part, face,
                             [&](std::int64_t node) { records.integer(node); });
        records.end_record();
      }
      file.write(places.others_of_patch[type][patch] + here.blocks[type].first_of_group[patch] *
                                                           style.record_bytes(numbers_of(type), 0),
                 records.bytes());
    }
  }
}

}  // namespace

void write_su2(const MeshSource& source, const MeshOutline& outline,
               const std::filesystem::path& path) {
  OutputFile file(path);
  // Room for the two digits of a type too.
  const NumberText style = NumberText::text(
      std::max<std::int64_t>({outline.nodes, outline.cells(), code_of(vtk, ElementType::tet)}));
  const Places places = write_frame(file, outline, style);
  TF_CHECK(outline.parts.size() == source.size());
  TF_CHECK(places.face_of_patch.size() == outline.patch_names.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const PartOutline& here = outline.parts[i];
    write_node_records(file, places.node, style.record_bytes(1, 3), part, style,
                       [](NumberText& numbers, std::int64_t number, const Vec3& p) {
                         numbers.real(p.x);
                         numbers.real(p.y);
                         numbers.real(p.z);
                         numbers.integer(number);
                         numbers.end_record();
                       });
    write_tets(file, places, part, here, style);
    write_cells(file, places, part, here, outline, style);
    write_triangles(file, places, part, here, style);
    write_faces(file, places, part, here, style);
  }
  file.finish();
}

void write_beside_su2(const MeshSource&, const MeshOutline& outline,
                      const std::filesystem::path& file) {
  if (!has_types(outline.patch_types)) return;
  const std::filesystem::path beside = std::filesystem::path(file).replace_extension(".cfg");
  if (std::filesystem::exists(beside)) return;
  const std::vector<std::string> names = su2_markers(outline);
  std::string text =
      "% The mesh and its markers; the rest of the configuration is for you to write.\n"
      "MESH_FILENAME= " +
      file.filename().string() + "\nMESH_FORMAT= SU2\n";
  for (const MarkerLine& line : marker_lines) {
    std::string markers;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (type_of_patch(outline.patch_types, i) != line.type) continue;
      markers += (markers.empty() ? "" : ", ") + names[i] + line.values;
    }
    if (!markers.empty()) text += std::string(line.option) + "= ( " + markers + " )\n";
  }
  write_file_atomically(beside, text);
}

}  // namespace tetfarm
