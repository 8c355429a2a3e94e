#include "mesh/io/read_surface.h"

#include "base/error.h"
#include "mesh/io/gzip.h"
#include "mesh/io/patch_names.h"
#include "mesh/io/read_fro.h"
#include "mesh/io/read_medit.h"
#include "mesh/io/read_msh.h"
#include "mesh/io/read_obj.h"
#include "mesh/io/read_off.h"
#include "mesh/io/read_ply.h"
#include "mesh/io/read_stl.h"
#include "mesh/io/read_su2.h"
#include "mesh/io/read_tetgen.h"
#include "mesh/io/read_ugrid_surface.h"

namespace tetfarm {
namespace {

using Reader = SurfaceMesh (*)(std::string_view bytes, const std::string& name);

Reader reader_of(const std::string& name) {
  std::string lower = name;
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (lower.ends_with(".gz")) lower.resize(lower.size() - 3);
  if (lower.ends_with(".stl")) return read_stl;
  if (lower.ends_with(".obj")) return read_obj;
  if (lower.ends_with(".off")) return read_off;
  if (lower.ends_with(".msh")) return read_msh;
  if (lower.ends_with(".ply")) return read_ply;
  if (lower.ends_with(".ugrid")) return read_ugrid_surface;
  if (lower.ends_with(".su2")) return read_su2;
  if (lower.ends_with(".mesh") || lower.ends_with(".meshb")) return read_medit;
  if (lower.ends_with(".poly") || lower.ends_with(".smesh")) return read_tetgen;
  if (lower.ends_with(".fro")) return read_fro;
  throw InvalidInput(
      "is no surface by its ending; Tetfarm reads .stl .obj .off .msh .ply .ugrid .su2 .mesh "
      ".meshb "
      ".poly .smesh .fro, each also .gz",
      name);
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
