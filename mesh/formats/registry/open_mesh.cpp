#include "mesh/formats/registry/open_mesh.h"

#include <array>

#include "base/error.h"
#include "mesh/formats/cgns/cgns_source.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/medit/meshb_source.h"
#include "mesh/formats/msh/msh_source.h"
#include "mesh/formats/openfoam/openfoam_source.h"
#include "mesh/formats/pvtu/pvtu_source.h"
#include "mesh/formats/su2/su2_source.h"
#include "mesh/formats/tetgen/tetgen_source.h"
#include "mesh/formats/ugrid/ugrid_source.h"
#include "mesh/formats/vtkhdf/read_vtkhdf.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using Source = std::unique_ptr<MeshSource>;

class VtkhdfSource : public MeshSource {
 public:
  explicit VtkhdfSource(const std::filesystem::path& path) : parts_(path) {
    if (parts_.size() != 1 && !parts_.has_node_numbers()) {
      parts_.fail("has several partitions, but no GlobalNodeId to join them by");
    }
  }
  std::size_t size() const override { return parts_.size(); }
  NumberedPart part(std::size_t i) const override { return parts_.part(i); }
  CountedPart counted_part(std::size_t i) const override { return parts_.count(i); }
  bool takes_threads() const override { return hdf5_takes_threads(); }
  std::vector<std::string> patch_names() const override { return parts_.patch_names(); }
  std::vector<std::string> region_names() const override { return parts_.region_names(); }

 private:
  VtkhdfParts parts_;
};

Source open_vtkhdf(const fs::path& path, const fs::path&) {
  return std::make_unique<VtkhdfSource>(path);
}

template <bool big_endian, bool wide>
Source open_ugrid_as(const fs::path& path, const fs::path&) {
  return open_ugrid(path, {big_endian, wide});
}

/// A binary format, which needs no scratch folder.
template <Source (*open)(const fs::path& path)>
Source open_in_place(const fs::path& path, const fs::path&) {
  return open(path);
}

struct ReadableFormat {
  std::string_view ending;
  Source (*open)(const fs::path& path, const fs::path& scratch_folder);
};

/// The longest endings come before those that they end with.
constexpr std::array formats = {
    ReadableFormat{".vtkhdf", open_vtkhdf},
    ReadableFormat{".hdf", open_vtkhdf},
    ReadableFormat{".lb8l.ugrid", open_ugrid_as<false, true>},
    ReadableFormat{".b8l.ugrid", open_ugrid_as<true, true>},
    ReadableFormat{".lb8.ugrid", open_ugrid_as<false, false>},
    ReadableFormat{".b8.ugrid", open_ugrid_as<true, false>},
    ReadableFormat{".su2", open_su2},
    ReadableFormat{".meshb", open_in_place<open_meshb>},
    ReadableFormat{".cgns", open_in_place<open_cgns>},
    ReadableFormat{".msh", open_msh},
    ReadableFormat{".pvtu", open_in_place<open_pvtu>},
    ReadableFormat{".vtu", open_in_place<open_pvtu>},
    ReadableFormat{".node", open_tetgen},
    ReadableFormat{".ele", open_tetgen},
};

}  // namespace

std::string readable_meshes() {
  std::string endings;
  for (const ReadableFormat& format : formats) {
    endings += (endings.empty() ? "" : ", ") + std::string(format.ending);
  }
  return endings;
}

Source open_mesh(const fs::path& path, const fs::path& scratch_folder) {
  if (is_openfoam_case(path)) return open_openfoam(path, scratch_folder);
  return open_mesh_as(path, path.filename().string(), scratch_folder);
}

Source open_mesh_as(const fs::path& path, std::string_view name, const fs::path& scratch_folder) {
  for (const ReadableFormat& format : formats) {
    if (name.ends_with(format.ending)) return format.open(path, scratch_folder);
  }
  throw InvalidInput(
      "unsupported mesh file type; " + readable_meshes() + " and OpenFOAM cases are read",
      path.string());
}

}  // namespace tetfarm
