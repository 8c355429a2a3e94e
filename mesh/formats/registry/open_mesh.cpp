#include "mesh/formats/registry/open_mesh.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/formats/list/all_formats.h"
#include "mesh/formats/list/format_by_ending.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using Source = std::unique_ptr<MeshSource>;

bool is_read(const Format& format) { return format.open_mesh != nullptr; }

/// Null when no format has such folders.
const Format* format_of_folder(const fs::path& folder) {
  const auto found = std::ranges::find_if(all_formats, [&](const Format& format) {
    return format.is_mesh_folder != nullptr && format.is_mesh_folder(folder);
  });
  return found == all_formats.end() ? nullptr : &*found;
}

}  // namespace

std::string readable_meshes() {
  std::string list;
  const auto add = [&](std::string_view word) {
    if (!word.empty()) list += (list.empty() ? "" : ", ") + std::string(word);
  };
  for (const Format& format : all_formats) {
    if (!is_read(format)) continue;
    for (const std::string_view ending : format.endings) add(ending);
  }
  for (const Format& format : all_formats) add(format.folders);
  return list;
}

bool is_mesh_folder(const fs::path& folder) { return format_of_folder(folder) != nullptr; }

Source open_mesh(const fs::path& path, const fs::path& scratch_folder) {
  if (const Format* format = format_of_folder(path)) return format->open_mesh(path, scratch_folder);
  return open_mesh_as(path, path.filename().string(), scratch_folder);
}

Source open_mesh_as(const fs::path& path, std::string_view name, const fs::path& scratch_folder) {
  if (const Format* format = format_by_ending(all_formats, name, is_read)) {
    return format->open_mesh(path, scratch_folder);
  }
  throw InvalidInput("unsupported mesh file type; Tetfarm reads " + readable_meshes(),
                     path.string());
}

}  // namespace tetfarm
