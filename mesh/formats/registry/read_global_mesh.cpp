#include "mesh/formats/registry/read_global_mesh.h"

#include "base/error.h"
#include "mesh/formats/ugrid/read_ugrid.h"
#include "mesh/formats/vtkhdf/read_vtkhdf.h"

namespace tetfarm {

GlobalMesh read_global_mesh(const std::filesystem::path& path) {
  return read_global_mesh(path, path.filename().string());
}

GlobalMesh read_global_mesh(const std::filesystem::path& path, std::string_view name) {
  if (name.ends_with(".vtkhdf") || name.ends_with(".hdf")) return read_vtkhdf(path);
  if (name.ends_with(".lb8.ugrid")) return read_ugrid(path);
  throw InvalidInput("unsupported type of mesh file; .vtkhdf and .lb8.ugrid are read",
                     path.string());
}

}  // namespace tetfarm
