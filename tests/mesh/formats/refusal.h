/// What the readers of meshes say of a file that is wrong.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/registry/open_mesh.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {

/// A file that need not outlive its test.
inline void write_unsynced(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The message of the InvalidInput that opening a file with these bytes throws; "" when it is read.
inline std::string refusal_of(const std::string& name, std::string_view bytes) {
  const TempFolder folder;
  write_unsynced(folder.path() / name, bytes);
  try {
    open_mesh(folder.path() / name, folder.path());
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

/// `text` with the first `what` replaced.
inline std::string changed(std::string text, std::string_view what, std::string_view with) {
  return text.replace(text.find(what), what.size(), with);
}

}  // namespace tetfarm
