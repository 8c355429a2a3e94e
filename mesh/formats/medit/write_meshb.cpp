#include "mesh/formats/medit/write_meshb.h"

#include "base/check.h"
#include "mesh/formats/medit/medit_file.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

constexpr std::int32_t byte_order_mark = 1;
constexpr std::int32_t version = 4;

/// Writes the head of a list, and returns where its records begin; `place` moves behind them.
std::int64_t begin_list(OutputFile& file, std::int64_t& place, medit::Keyword keyword,
                        std::int64_t count, std::int64_t bytes_each) {
  TF_CHECK(count >= 0 && bytes_each > 0);
  constexpr std::int64_t head_bytes = 4 + 8 + 8;
  NumberText head = NumberText::raw();
  const std::int64_t first = place + head_bytes;
  head.small(keyword);
  head.integer(first + count * bytes_each);
  head.integer(count);
  file.write(place, head.bytes());
  place = first + count * bytes_each;
  return first;
}

}  // namespace

void write_meshb(const MeshSource& source, const MeshOutline& outline,
                 const std::filesystem::path& path) {
  TF_CHECK(outline.parts.size() == source.size());
  OutputFile file(path);
  const NumberText raw = NumberText::raw();
  NumberText head = raw;
  head.small(byte_order_mark);
  head.small(version);
  head.small(medit::dimension);
  head.integer(head.size() + 8 + 4);
  head.small(3);
  file.write(0, head.bytes());
  std::int64_t place = head.size();
  const std::int64_t node_bytes = raw.record_bytes(1, 3);
  const std::int64_t first_node =
      begin_list(file, place, medit::vertices, outline.nodes, node_bytes);
  const std::int64_t triangle_bytes = raw.record_bytes(4, 0);
  const std::int64_t first_triangle =
      begin_list(file, place, medit::triangles, outline.boundary_triangles, triangle_bytes);
  const std::int64_t tet_bytes = raw.record_bytes(5, 0);
  const std::int64_t first_tet =
      begin_list(file, place, medit::tetrahedra, outline.tets, tet_bytes);
  ByType<std::int64_t> first_of;
  for_each_block(outline.blocks, [&](ElementType type, const BlockOutline& block) {
    if (block.count == 0) return;
    first_of[type] =
        begin_list(file, place, static_cast<medit::Keyword>(code_of(ElementCodes::medit, type)),
                   block.count, raw.record_bytes(static_cast<int>(nodes_of(type) + 1), 0));
  });
  NumberText tail = raw;
  tail.small(medit::end);
  tail.integer(0);
  file.write(place, tail.bytes());

  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    write_node_records(file, first_node, node_bytes, part, raw,
                       [](NumberText& numbers, std::int64_t, const Vec3& p) {
                         numbers.real(p.x);
                         numbers.real(p.y);
                         numbers.real(p.z);
                         numbers.integer(0);
                       });
    NumberText faces = raw;
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      for (const std::int32_t v : part.faces[f]) faces.integer(global_node(part, v) + 1);
      faces.integer(part.patch_of_face[f] + 1);
    }
    file.write(first_triangle + outline.parts[i].first_face * triangle_bytes, faces.bytes());
    NumberText tets = raw;
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      for (const std::int32_t v : part.tets[t]) tets.integer(global_node(part, v) + 1);
      tets.integer(part.region_of(t));
    }
    file.write(first_tet + outline.parts[i].first_tet * tet_bytes, tets.bytes());
    for_each_block(part.blocks, [&](ElementType type, const ElementBlock& block) {
      NumberText records = raw;
      for (std::size_t e = 0; e < block.size(); ++e) {
        for_each_global_node(ElementCodes::medit, type, part, e,
                             [&](std::int64_t node) { records.integer(node + 1); });
        records.integer(is_cell(type) ? block.regions[e] : block.patches[e] + 1);
      }
      const std::int64_t bytes = raw.record_bytes(static_cast<int>(nodes_of(type) + 1), 0);
      if (!block.empty()) {
        file.write(first_of[type] + outline.parts[i].blocks[type].first * bytes, records.bytes());
      }
    });
  }
  file.finish();
}

}  // namespace tetfarm
