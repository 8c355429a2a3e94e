#include "mesh/formats/su2/write_su2.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/plain_names.h"
#include "mesh/formats/su2/su2_walker.h"

namespace tetfarm {
namespace {

/// Where each list begins.
struct Places {
  std::int64_t tet = 0;
  std::int64_t node = 0;
  std::vector<std::int64_t> face_of_patch;
};

/// Writes the lines between the lists.
Places write_frame(OutputFile& file, const MeshOutline& outline, const NumberText& style) {
  Places places;
  std::int64_t place = 0;
  const auto words = [&](const std::string& text) {
    file.write(place, text);
    place += std::ssize(text);
  };
  words("NDIME= 3\nNELEM= " + std::to_string(outline.tets) + "\n");
  places.tet = place;
  place += outline.tets * style.record_bytes(6, 0);
  words("NPOIN= " + std::to_string(outline.nodes) + "\n");
  places.node = place;
  place += outline.nodes * style.record_bytes(1, 3);
  words("NMARK= " + std::to_string(outline.patch_names.size()) + "\n");
  const std::vector<std::string> names = plain_names(outline.patch_names, 200);
  for (std::size_t i = 0; i < names.size(); ++i) {
    words("MARKER_TAG= " + names[i] +
          "\nMARKER_ELEMS= " + std::to_string(outline.faces_of_patch[i]) + "\n");
    places.face_of_patch.push_back(place);
    place += outline.faces_of_patch[i] * style.record_bytes(4, 0);
  }
  return places;
}

}  // namespace

void write_su2(const MeshSource& source, const MeshOutline& outline,
               const std::filesystem::path& path) {
  OutputFile file(path);
  const NumberText style =
      NumberText::text(std::max<std::int64_t>({outline.nodes, outline.tets, su2_tetra}));
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
    NumberText tets = style;
    std::int64_t tet_number = here.first_tet;
    for (const Tet& tet : part.tets) {
      tets.integer(su2_tetra);
      for (const std::int32_t v : tet) tets.integer(global_node(part, v));
      tets.integer(tet_number++);
      tets.end_record();
    }
    file.write(places.tet + here.first_tet * style.record_bytes(6, 0), tets.bytes());
    const auto faces = faces_by_patch(part, outline.patch_names.size());
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      NumberText triangles = style;
      for (const std::size_t face : faces[patch]) {
        triangles.integer(su2_triangle);
        for (const std::int32_t v : part.faces[face]) triangles.integer(global_node(part, v));
        triangles.end_record();
      }
      file.write(
          places.face_of_patch[patch] + here.first_face_of_patch[patch] * style.record_bytes(4, 0),
          triangles.bytes());
    }
  }
  file.finish();
}

}  // namespace tetfarm
