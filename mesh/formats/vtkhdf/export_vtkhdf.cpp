#include "mesh/formats/vtkhdf/export_vtkhdf.h"

#include "mesh/formats/vtkhdf/write_vtkhdf.h"

namespace tetfarm {

void export_vtkhdf(const MeshSource& source, const MeshOutline& outline,
                   const std::filesystem::path& file) {
  std::vector<VtkhdfCounts> counts;
  for (const PartOutline& part : outline.parts) {
    counts.push_back({part.nodes, part.tets, part.faces, {}});
    for_each_block(part.blocks, [&](ElementType type, const BlockOutline& block) {
      counts.back().others[type] = block.count;
    });
  }
  const std::unique_ptr<GlobalMeshWriter> writer =
      write_vtkhdf(file, counts,
                   {outline.patch_names, outline.region_names, source.cell_marks(),
                    source.has_feet(), outline.patch_types});
  for (std::size_t i = 0; i < source.size(); ++i) writer->add(source.part(i));
  writer->finish();
}

}  // namespace tetfarm
