#include "mesh/formats/msh/write_msh22.h"

#include <map>
#include <utility>

#include "base/check.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/msh/msh41_sections.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// A record: number, type, the number of tags, tags, nodes. Tags are the physical group and the
/// entity, and of cells the number of partitions, which is 1, and the partition.
int numbers_of(ElementType type) {
  return static_cast<int>((is_cell(type) ? 7 : 5) + nodes_of(type));
}

struct Places {
  std::int64_t node = 0;
  std::int64_t triangle = 0;
  std::int64_t tet = 0;
  ByType<std::int64_t> block;
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
      "$EndNodes\n$Elements\n" + std::to_string(outline.boundary_faces() + outline.cells()) + "\n";
  file.write(after_nodes, between);
  std::int64_t place = after_nodes + std::ssize(between);
  const auto leave = [&](ElementType type, std::int64_t count) {
    return std::exchange(place, place + count * style.record_bytes(numbers_of(type), 0));
  };
  places.triangle = leave(ElementType::triangle, outline.boundary_triangles);
  for (const ElementType type : face_block_types) {
    places.block[type] = leave(type, outline.blocks[type].count);
  }
  places.tet = leave(ElementType::tet, outline.tets);
  for (const ElementType type : cell_block_types) {
    places.block[type] = leave(type, outline.blocks[type].count);
  }
  file.write(place, std::string_view("$EndElements\n"));
  return places;
}

template <class Element>
void put_element(NumberText& lines, const NumberedPart& part, const Element& element) {
  for (const std::int32_t v : element) lines.integer(global_node(part, v) + 1);
  lines.end_record();
}

/// Of each run of a region in a part that has cells, from 1; the runs of a part follow one another.
class Entities {
 public:
  explicit Entities(const MeshOutline& outline) {
    std::int32_t entity = 0;
    for (const RegionRun& run : region_runs(outline)) {
      if (run.cells() > 0) entity_of_.emplace(std::pair(run.part, run.region), ++entity);
    }
  }
  std::int32_t of(std::size_t part, std::int32_t region) const {
    return entity_of_.at({part, region});
  }

 private:
  std::map<std::pair<std::size_t, std::int32_t>, std::int32_t> entity_of_;
};

void write_triangles(OutputFile& file, const NumberedPart& part, const PartOutline& here,
                     const Places& places, const NumberText& style) {
  NumberText triangles = style;
  std::int64_t number = here.first_face + 1;
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    triangles.integer(number++);
    const std::int32_t patch = part.patch_of_face[f] + 1;
    for (const std::int32_t tag : {msh_triangle_type, 2, patch, patch}) triangles.integer(tag);
    put_element(triangles, part, part.faces[f]);
  }
  file.write(
      places.triangle + here.first_face * style.record_bytes(numbers_of(ElementType::triangle), 0),
      triangles.bytes());
}

void write_tets(OutputFile& file, const NumberedPart& part, const PartOutline& here,
                std::int64_t first_number, const Entities& entities, const Places& places,
                const NumberText& style) {
  NumberText tets = style;
  std::int64_t number = first_number + here.first_tet;
  std::int32_t region = 0;
  std::int32_t entity = 0;
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    if (part.region_of(t) != region) {
      region = part.region_of(t);
      entity = entities.of(static_cast<std::size_t>(part.number), region);
    }
    tets.integer(number++);
    for (const std::int32_t tag : {msh_tet_type, 4, region, entity, 1, part.number + 1}) {
      tets.integer(tag);
    }
    put_element(tets, part, part.tets[t]);
  }
  file.write(places.tet + here.first_tet * style.record_bytes(numbers_of(ElementType::tet), 0),
             tets.bytes());
}

void write_block(OutputFile& file, ElementType type, const NumberedPart& part,
                 const PartOutline& here, std::int64_t first_number, const Entities& entities,
                 const Places& places, const NumberText& style) {
  const ElementBlock& block = part.blocks[type];
  if (block.empty()) return;
  NumberText lines = style;
  std::int64_t number = first_number + here.blocks[type].first;
  for (std::size_t i = 0; i < block.size(); ++i) {
    lines.integer(number++);
    lines.integer(msh_code(type));
    if (is_cell(type)) {
      const std::int32_t region = block.regions[i];
      const std::int32_t entity = entities.of(static_cast<std::size_t>(part.number), region);
      for (const std::int32_t tag : {4, region, entity, 1, part.number + 1}) lines.integer(tag);
    } else {
      const std::int32_t patch = block.patches[i] + 1;
      for (const std::int32_t tag : {2, patch, patch}) lines.integer(tag);
    }
    for_each_global_node(ElementCodes::msh, type, part, i,
                         [&](std::int64_t node) { lines.integer(node + 1); });
    lines.end_record();
  }
  file.write(places.block[type] + here.blocks[type].first * style.record_bytes(numbers_of(type), 0),
             lines.bytes());
}

}  // namespace

void write_msh22(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& path) {
  const std::string larger = "use msh41, which counts with 64 bits";
  require_32_bits(outline.nodes, "nodes", "Gmsh's format 2.2", larger);
  require_32_bits(outline.cells() + outline.boundary_faces(), "elements", "Gmsh's format 2.2",
                  larger);
  TF_CHECK(outline.parts.size() == source.size());
  OutputFile file(path);
  const NumberText style = msh_style(outline, true);
  const Places places = write_frame(file, outline, style);
  const Entities entities(outline);
  const MshNumbers first = first_msh_numbers(outline);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const PartOutline& here = outline.parts[i];
    write_node_records(file, places.node, style.record_bytes(1, 3), part, style,
                       [](NumberText& lines, std::int64_t node, const Vec3& p) {
                         lines.integer(node + 1);
                         for (const double x : {p.x, p.y, p.z}) lines.real(x);
                         lines.end_record();
                       });
    write_triangles(file, part, here, places, style);
    write_tets(file, part, here, first.tet, entities, places, style);
    for_each_block(part.blocks, [&](ElementType type, const ElementBlock&) {
      write_block(file, type, part, here, first.block[type], entities, places, style);
    });
  }
  file.finish();
}

}  // namespace tetfarm
