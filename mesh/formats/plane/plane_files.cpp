#include "mesh/formats/plane/plane_files.h"

#include <array>
#include <string_view>

#include "base/error.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/plane/plane_cgns.h"
#include "mesh/formats/plane/plane_foam.h"
#include "mesh/formats/plane/plane_meshb.h"
#include "mesh/formats/plane/plane_msh.h"
#include "mesh/formats/plane/plane_su2.h"
#include "mesh/formats/plane/plane_vtu.h"

namespace tetfarm {
namespace {

using PlaneReader = PlaneMesh (*)(std::string_view bytes, const std::string& name);
using PlaneWriter = void (*)(const PlaneMesh& mesh, const std::filesystem::path& path);

struct PlaneFormat {
  std::string_view ending;
  std::string_view what;
  PlaneReader read = nullptr;   ///< null: it is not read
  PlaneWriter write = nullptr;  ///< null: it is not written
};

void write_mesh_as_vtu(const PlaneMesh& mesh, const std::filesystem::path& path) {
  write_plane_vtu(mesh, {}, path);
}

/// A case is named by its folder, which has no ending.
constexpr std::string_view folder_ending = "/";

constexpr std::array plane_formats = {
    PlaneFormat{".mesh", "Medit, text", read_plane_medit, write_plane_medit},
    PlaneFormat{".meshb", "Medit, binary", read_plane_meshb, write_plane_meshb},
    PlaneFormat{".su2", "SU2", read_plane_su2, write_plane_su2},
    PlaneFormat{".msh", "Gmsh", read_plane_msh, write_plane_msh},
    PlaneFormat{".cgns", "CGNS", nullptr, write_plane_cgns},
    PlaneFormat{".vtu", "VTK XML", nullptr, write_mesh_as_vtu},
    PlaneFormat{folder_ending, "a folder: OpenFOAM case", nullptr, write_plane_foam}};

std::string without_gz(const std::filesystem::path& path) {
  const bool is_packed = path.extension() == ".gz";
  return is_packed ? path.stem().string() : path.string();
}

/// In lower case.
std::string ending_of(const std::string& name) {
  if (name.ends_with('/')) return std::string(folder_ending);
  const std::size_t dot = name.find_last_of("./");
  if (dot == name.npos || name[dot] != '.') return "";
  std::string ending = name.substr(dot);
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

template <class IsWanted>
const PlaneFormat& format_of(std::string_view ending, const std::string& file,
                             const std::string& done, const IsWanted& is_wanted) {
  std::string list;
  for (const PlaneFormat& format : plane_formats) {
    if (!is_wanted(format)) continue;
    if (format.ending == ending) return format;
    list += (list.empty() ? "" : ", ") + std::string(format.ending) + " (" +
            std::string(format.what) + ")";
  }
  throw UsageError("meshes of the plane are " + done + " " + list, file);
}

const PlaneFormat& input_format(const std::filesystem::path& path) {
  const std::string name = without_gz(path);
  return format_of(ending_of(name), path.string(), "read from",
                   [](const PlaneFormat& format) { return format.read != nullptr; });
}

const PlaneFormat& output_format(const std::filesystem::path& path) {
  const bool is_folder = std::filesystem::is_directory(path);
  const std::string name = path.string();
  return format_of(is_folder ? std::string(folder_ending) : ending_of(name), name, "written to",
                   [](const PlaneFormat& format) { return format.write != nullptr; });
}

}  // namespace

void require_plane_input_name(const std::filesystem::path& path) { input_format(path); }

void require_plane_output_name(const std::filesystem::path& path) { output_format(path); }

PlaneMesh read_plane_mesh(std::string_view bytes, const std::string& name) {
  const PlaneFormat& format = input_format(name);
  PlaneMesh mesh =
      is_gzip(bytes) ? format.read(unpack_gzip(bytes, name), name) : format.read(bytes, name);
  mesh.name = name;
  return mesh;
}

PlaneMesh read_plane_mesh(const std::filesystem::path& path) {
  input_format(path);
  return read_plane_mesh(read_whole_file(path.string()), path.string());
}

void write_plane_mesh(const PlaneMesh& mesh, const std::filesystem::path& path) {
  output_format(path).write(mesh, path);
}

}  // namespace tetfarm
