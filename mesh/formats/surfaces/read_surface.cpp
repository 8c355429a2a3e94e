#include "mesh/formats/surfaces/read_surface.h"

#include "base/error.h"
#include "mesh/formats/flite/read_fro.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/medit/read_medit.h"
#include "mesh/formats/msh/read_msh.h"
#include "mesh/formats/obj/read_obj.h"
#include "mesh/formats/off/read_off.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/ply/read_ply.h"
#include "mesh/formats/stl/read_stl.h"
#include "mesh/formats/su2/read_su2.h"
#include "mesh/formats/surfaces/surface_type.h"
#include "mesh/formats/tetgen/read_tetgen.h"
#include "mesh/formats/ugrid/read_ugrid_surface.h"

namespace tetfarm {
namespace {

using Reader = SurfaceMesh (*)(std::string_view bytes, const std::string& name);

Reader reader_of(const std::string& name) {
  const std::string_view ending = surface_ending_of(name);
  if (ending == ".stl") return read_stl;
  if (ending == ".obj") return read_obj;
  if (ending == ".off") return read_off;
  if (ending == ".msh") return read_msh;
  if (ending == ".ply") return read_ply;
  if (ending == ".ugrid") return read_ugrid_surface;
  if (ending == ".su2") return read_su2;
  if (ending == ".fro") return read_fro;
  return ending.find("mesh") == 1 ? read_medit : read_tetgen;
}

}  // namespace

SurfaceMesh read_surface(const std::string& path) {
  reader_of(path);  // a wrong ending is told before a large file is read
  return read_surface_bytes(read_maybe_gzip(path), path);
}

SurfaceMesh read_surface_bytes(std::string_view bytes, const std::string& name) {
  const Reader read = reader_of(name);
  if (bytes.empty()) throw InvalidInput("the file is empty", name);
  SurfaceMesh surface = read(bytes, name);
  if (surface.triangles.empty()) throw InvalidInput("the file has no triangles", name);
  if (surface.patch_names.empty()) {
    surface.patch_names = {std::string(unnamed_patch)};
    surface.patch_of_triangle.assign(surface.triangles.size(), 0);
  }
  return surface;
}

std::string read_maybe_gzip(const std::string& path) {
  std::string bytes = read_whole_file(path);
  return is_gzip(bytes) ? unpack_gzip(bytes, path) : bytes;
}

}  // namespace tetfarm
