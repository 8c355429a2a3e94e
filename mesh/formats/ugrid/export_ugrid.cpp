#include "mesh/formats/ugrid/export_ugrid.h"

#include "base/file_system.h"
#include "mesh/formats/patch_boxes.h"
#include "mesh/formats/ugrid/mapbc.h"
#include "mesh/formats/ugrid/write_ugrid.h"

namespace tetfarm {

namespace fs = std::filesystem;

namespace {

/// A line for consecutive cells of one region, as the file lists them: tets, then other types.
std::string region_lines(const MeshOutline& outline) {
  std::string text;
  std::int64_t first = 1;
  std::int64_t last = 0;
  std::int32_t region = 1;
  const auto end_line = [&] {
    if (last < first) return;
    text += std::to_string(region) + ' ' + std::to_string(first) + ' ' + std::to_string(last) +
            ' ' + outline.region_names[static_cast<std::size_t>(region - 1)] + '\n';
    first = last + 1;
  };
  const std::vector<RegionRun> runs = region_runs(outline);
  const auto add = [&](const auto& count_of) {
    for (const RegionRun& run : runs) {
      const std::int64_t count = count_of(run);
      if (count == 0) continue;
      if (run.region != region) end_line();
      region = run.region;
      last += count;
    }
  };
  add([](const RegionRun& run) { return run.tets; });
  for (const ElementType type : cell_block_types) {
    add([type](const RegionRun& run) { return run.others[type]; });
  }
  end_line();
  return text;
}

}  // namespace

template <bool big_endian, bool wide>
void export_ugrid(const MeshSource& source, const MeshOutline& outline, const fs::path& file) {
  UgridCounts counts{outline.nodes, outline.boundary_triangles, outline.tets, {}};
  for_each_block(outline.blocks, [&](ElementType type, const BlockOutline& block) {
    counts.others[type] = block.count;
  });
  const std::unique_ptr<UgridWriter> writer = write_ugrid(file, counts, {big_endian, wide});
  for (std::size_t i = 0; i < source.size(); ++i) {
    const PartOutline& here = outline.parts[i];
    UgridCounts before{0, here.first_face, here.first_tet, {}};
    for_each_block(here.blocks, [&](ElementType type, const BlockOutline& block) {
      before.others[type] = block.first;
    });
    writer->add_behind(before, source.part(i));
  }
  writer->finish();
}

template void export_ugrid<false, false>(const MeshSource&, const MeshOutline&, const fs::path&);
template void export_ugrid<false, true>(const MeshSource&, const MeshOutline&, const fs::path&);
template void export_ugrid<true, false>(const MeshSource&, const MeshOutline&, const fs::path&);
template void export_ugrid<true, true>(const MeshSource&, const MeshOutline&, const fs::path&);

void write_beside_ugrid(const MeshSource& source, const MeshOutline& outline,
                        const fs::path& file) {
  const fs::path stem = fs::path(file).replace_extension().replace_extension();
  const std::vector<PatchType>& types = outline.patch_types;
  const std::vector<Box3> boxes =
      wants_boxes(types) ? patch_boxes(source, outline) : std::vector<Box3>();
  write_file_atomically(stem.string() + ".mapbc", mapbc_text(outline.patch_names, types, boxes));
  if (outline.region_names.size() < 2) return;
  write_file_atomically(stem.string() + ".regions", region_lines(outline));
}

}  // namespace tetfarm
