#include "mesh/formats/su2/write_su2.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
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
  const std::vector<std::string> names = plain_names(outline.patch_names, 200);
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

}  // namespace tetfarm
