#include "mesh/formats/msh/write_msh22.h"

#include "base/check.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/msh/msh41_sections.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

constexpr int triangle_numbers = 8;
constexpr int tet_numbers = 11;

struct Places {
  std::int64_t node = 0;
  std::int64_t triangle = 0;
  std::int64_t tet = 0;
};

Places write_frame(OutputFile& file, const MeshOutline& outline, const NumberText& style) {
  Places places;
  std::string head = msh_head(outline, style);
  TF_CHECK(head.find("4.1") != std::string::npos);
  head.replace(head.find("4.1"), 3, "2.2");
  head += "$Nodes\n" + std::to_string(outline.nodes) + "\n";
  file.write(0, head);
  places.node = std::ssize(head);
  const std::int64_t after_nodes = places.node + outline.nodes * style.record_bytes(1, 3);
  const std::string between =
      "$EndNodes\n$Elements\n" + std::to_string(outline.boundary_triangles + outline.tets) + "\n";
  file.write(after_nodes, between);
  places.triangle = after_nodes + std::ssize(between);
  places.tet =
      places.triangle + outline.boundary_triangles * style.record_bytes(triangle_numbers, 0);
  file.write(places.tet + outline.tets * style.record_bytes(tet_numbers, 0),
             std::string_view("$EndElements\n"));
  return places;
}

template <class Element>
void put_element(NumberText& lines, const NumberedPart& part, const Element& element) {
  for (const std::int32_t v : element) lines.integer(global_node(part, v) + 1);
  lines.end_record();
}

}  // namespace

void write_msh22(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& path) {
  const std::string larger = "use msh41, which counts with 64 bits";
  require_32_bits(outline.nodes, "nodes", "Gmsh's format 2.2", larger);
  require_32_bits(outline.tets + outline.boundary_triangles, "elements", "Gmsh's format 2.2",
                  larger);
  TF_CHECK(outline.parts.size() == source.size());
  OutputFile file(path);
  const NumberText style = msh_style(outline, true);
  const Places places = write_frame(file, outline, style);
  std::int32_t entity = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    write_node_records(file, places.node, style.record_bytes(1, 3), part, style,
                       [](NumberText& lines, std::int64_t node, const Vec3& p) {
                         lines.integer(node + 1);
                         for (const double x : {p.x, p.y, p.z}) lines.real(x);
                         lines.end_record();
                       });
    const PartOutline& here = outline.parts[i];
    NumberText triangles = style;
    std::int64_t number = here.first_face + 1;
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      triangles.integer(number++);
      const std::int32_t patch = part.patch_of_face[f] + 1;
      for (const std::int32_t tag : {msh_triangle_type, 2, patch, patch}) triangles.integer(tag);
      put_element(triangles, part, part.faces[f]);
    }
    file.write(places.triangle + here.first_face * style.record_bytes(triangle_numbers, 0),
               triangles.bytes());
    NumberText tets = style;
    const auto partition = static_cast<std::int32_t>(i + 1);
    std::int64_t tet_number = outline.boundary_triangles + here.first_tet + 1;
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      const std::int32_t region = part.region_of(t);
      if (t == 0 || region != part.region_of(t - 1)) ++entity;
      tets.integer(tet_number++);
      for (const std::int32_t tag : {msh_tet_type, 4, region, entity, 1, partition}) {
        tets.integer(tag);
      }
      put_element(tets, part, part.tets[t]);
    }
    file.write(places.tet + here.first_tet * style.record_bytes(tet_numbers, 0), tets.bytes());
  }
  file.finish();
}

}  // namespace tetfarm
