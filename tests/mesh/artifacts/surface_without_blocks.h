/// A surface as programs wrote it before its files had blocks (store/formats.md, version 2).
#pragma once

#include <string>

#include "mesh/artifacts/checked_bytes.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

inline std::string surface_without_blocks(const SurfaceMesh& surface) {
  ByteWriter writer = begin_checked("TFSURF\r\n", 2);
  for (const std::size_t count :
       {surface.vertices.size(), surface.triangles.size(), surface.patch_of_triangle.size(),
        surface.patch_names.size(), surface.sides.size(), surface.region_names.size()}) {
    writer.number<std::uint64_t>(count);
  }
  const auto add_names = [&writer](const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      writer.number(static_cast<std::uint32_t>(name.size()));
      writer.text(name);
    }
  };
  writer.array(surface.vertices);
  writer.array(surface.triangles);
  writer.array(surface.patch_of_triangle);
  add_names(surface.patch_names);
  writer.array(surface.sides);
  add_names(surface.region_names);
  return finish_checked(std::move(writer));
}

}  // namespace tetfarm
