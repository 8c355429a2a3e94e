#include "mesh/formats/registry/export_mesh.h"

#include <array>
#include <system_error>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/undo_unless_done.h"
#include "mesh/formats/cgns/write_cgns.h"
#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/medit/write_meshb.h"
#include "mesh/formats/msh/write_msh22.h"
#include "mesh/formats/msh/write_msh41.h"
#include "mesh/formats/msh/write_msh41_split.h"
#include "mesh/formats/openfoam/write_openfoam.h"
#include "mesh/formats/pvtu/write_pvtu.h"
#include "mesh/formats/su2/write_su2.h"
#include "mesh/formats/tetgen/write_tetgen.h"
#include "mesh/formats/ugrid/write_ugrid.h"
#include "mesh/formats/vtkhdf/write_vtkhdf.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

void export_vtkhdf(const MeshSource& source, const MeshOutline& outline, const fs::path& file) {
  std::vector<VtkhdfCounts> counts;
  for (const PartOutline& part : outline.parts) {
    counts.push_back({part.nodes, part.tets, part.faces});
  }
  const std::unique_ptr<GlobalMeshWriter> writer =
      write_vtkhdf(file, counts, outline.patch_names, outline.region_names);
  for (std::size_t i = 0; i < source.size(); ++i) writer->add(source.part(i));
  writer->finish();
}

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

template <MshEncoding encoding>
void export_msh41(const MeshSource& source, const MeshOutline& outline, const fs::path& file) {
  write_msh41(source, outline, file, encoding);
}

template <MshGhosts with_ghosts>
void export_msh41_split(const MeshSource& source, const MeshOutline& outline,
                        const fs::path& file) {
  write_msh41_split(source, outline, file, with_ghosts);
}

template <bool is_text>
void export_communication(const MeshSource& source, const MeshOutline& outline,
                          const fs::path& folder) {
  write_communication(source, outline, folder, is_text);
}

/// NAME.b8.ugrid gets NAME.mapbc, and NAME.regions when there are several.
void write_mapbc(const MeshOutline& outline, const fs::path& file) {
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

constexpr std::array formats = {
    MeshFormat{"vtkhdf", ".vtkhdf", "VTKHDF, a partition for each sub-domain", true, export_vtkhdf,
               nullptr, true},
    MeshFormat{"lb8l.ugrid", ".lb8l.ugrid", "UGRID, 64-bit integers", true,
               export_ugrid<false, true>, write_mapbc},
    MeshFormat{"b8l.ugrid", ".b8l.ugrid", "UGRID, 64-bit integers, big endian", true,
               export_ugrid<true, true>, write_mapbc},
    MeshFormat{"lb8.ugrid", ".lb8.ugrid", "UGRID", true, export_ugrid<false, false>, write_mapbc},
    MeshFormat{"b8.ugrid", ".b8.ugrid", "UGRID, big endian", true, export_ugrid<true, false>,
               write_mapbc},
    MeshFormat{"cgns", ".cgns", "CGNS (HDF5), 64-bit", true, write_cgns, nullptr, true},
    MeshFormat{"pvtu", ".pvtu", "VTK XML, a .vtu for each sub-domain", false, write_pvtu, nullptr,
               true},
    MeshFormat{"msh41", ".msh", "Gmsh 4.1, binary", true, export_msh41<MshEncoding::binary>,
               nullptr, true},
    MeshFormat{"msh41-text", "", "Gmsh 4.1, text", true, export_msh41<MshEncoding::text>, nullptr,
               true},
    MeshFormat{"msh41-split", "", "Gmsh 4.1, a file for each sub-domain", false,
               export_msh41_split<MshGhosts::none>, nullptr, true},
    MeshFormat{"msh41-ghosts", "", "Gmsh 4.1, a file for each sub-domain, with ghost elements",
               false, export_msh41_split<MshGhosts::all>, nullptr, true},
    MeshFormat{"msh22", "", "Gmsh 2.2, text", true, write_msh22, nullptr, true},
    MeshFormat{"su2", ".su2", "SU2", true, write_su2, nullptr},
    MeshFormat{"meshb", ".meshb", "Medit (GMF 4), 64-bit", true, write_meshb, nullptr},
    MeshFormat{"tetgen", ".node", "TetGen .node, .face, .ele", false, write_tetgen, nullptr},
    MeshFormat{"openfoam", "", "OpenFOAM constant/polyMesh", false, write_openfoam, nullptr},
    MeshFormat{"openfoam-decomposed", "", "OpenFOAM, a processor for each sub-domain", false,
               write_openfoam_decomposed, nullptr, true},
    MeshFormat{"comm", "", "communication tables", false, export_communication<false>, nullptr,
               true},
    MeshFormat{"comm-text", "", "communication tables, text", false, export_communication<true>,
               nullptr, true},
};

void write_single_file(const MeshSource& source, const MeshOutline& outline,
                       const MeshFormat& format, const fs::path& output) {
  TF_CHECK(format.write != nullptr);
  const fs::path growing = output.parent_path() / (unique_temp_name(output.filename().string()) +
                                                   std::string(format.ending));
  UndoUnlessDone writing([&growing] {
    std::error_code ignored;
    fs::remove(growing, ignored);
  });
  format.write(source, outline, growing);
  publish_by_rename(growing, output);
  writing.done();
}

std::string all_names() {
  std::string names;
  for (const MeshFormat& format : formats) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

}  // namespace

std::span<const MeshFormat> mesh_formats() { return formats; }

const MeshFormat& find_mesh_format(std::string_view name, const fs::path& output) {
  const std::string file = output.filename().string();
  for (const MeshFormat& format : formats) {
    const bool is_wanted = name.empty() ? !format.ending.empty() && file.ends_with(format.ending)
                                        : format.name == name;
    if (is_wanted) return format;
  }
  throw UsageError("unknown format; the formats are " + all_names(),
                   name.empty() ? output.string() : "--format " + std::string(name));
}

ExportCounts export_mesh(const MeshSource& source, const MeshFormat& format,
                         const fs::path& output) {
  const MeshOutline outline = outline_of(source);
  if (format.is_single_file) {
    write_single_file(source, outline, format, output);
  } else {
    format.write(source, outline, output);
  }
  if (format.write_beside != nullptr) format.write_beside(outline, output);
  return {outline.nodes, outline.tets, outline.boundary_triangles, outline.parts.size()};
}

}  // namespace tetfarm
