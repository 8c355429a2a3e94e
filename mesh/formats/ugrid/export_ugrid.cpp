#include "mesh/formats/ugrid/export_ugrid.h"

#include "base/file_system.h"
#include "mesh/formats/ugrid/write_ugrid.h"

namespace tetfarm {

namespace fs = std::filesystem;

template <bool big_endian, bool wide>
void export_ugrid(const MeshSource& source, const MeshOutline& outline, const fs::path& file) {
  const UgridCounts counts{outline.nodes, outline.boundary_triangles, outline.tets};
  const std::unique_ptr<UgridWriter> writer = write_ugrid(file, counts, {big_endian, wide});
  for (std::size_t i = 0; i < source.size(); ++i) {
    const PartOutline& here = outline.parts[i];
    writer->add_behind({0, here.first_face, here.first_tet}, source.part(i));
  }
  writer->finish();
}

template void export_ugrid<false, false>(const MeshSource&, const MeshOutline&, const fs::path&);
template void export_ugrid<false, true>(const MeshSource&, const MeshOutline&, const fs::path&);
template void export_ugrid<true, false>(const MeshSource&, const MeshOutline&, const fs::path&);
template void export_ugrid<true, true>(const MeshSource&, const MeshOutline&, const fs::path&);

void write_beside_ugrid(const MeshOutline& outline, const fs::path& file) {
  const fs::path stem = fs::path(file).replace_extension().replace_extension();
  write_file_atomically(stem.string() + ".mapbc", mapbc_text(outline.patch_names));
  if (outline.region_names.size() < 2) return;
  std::string text;
  std::int64_t first = 1;
  std::int64_t last = 0;
  const std::vector<RegionRun> runs = region_runs(outline);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    last += runs[i].tets;
    const bool goes_on = i + 1 < runs.size() && runs[i + 1].region == runs[i].region;
    if (goes_on || last < first) continue;
    text += std::to_string(runs[i].region) + ' ' + std::to_string(first) + ' ' +
            std::to_string(last) + ' ' +
            outline.region_names[static_cast<std::size_t>(runs[i].region - 1)] + '\n';
    first = last + 1;
  }
  write_file_atomically(stem.string() + ".regions", text);
}

}  // namespace tetfarm
