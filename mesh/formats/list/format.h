/// What is known of a file format: its name and endings, what the file can hold, and the functions
/// that read and write it.
///
/// A folder of mesh/formats describes its formats in FOLDER/FOLDER_format.h, as a constexpr array
/// FOLDER_formats; the line add_format(FOLDER) in CMakeLists.txt puts them in the list of all
/// (mesh/formats/list/all_formats.h, which CMake writes). What reads, writes or names formats is
/// made from that list.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace tetfarm {

class MeshSource;
struct MeshOutline;
struct SurfaceMesh;

/// What lies on disk once a mesh is written.
enum class FormatLayout {
  one_file,
  several_files,  ///< beside one another, named after the one that is asked for
  folder
};

/// Which cells the files of a format have a place for, whether or not they are written here.
enum class FormatCells {
  tets,
  all  ///< pyramids, prisms and hexahedra too
};

struct FormatFacts {
  std::string_view name;  ///< as --format takes it
  /// Those that tell the format, in lower case; the first is what a mesh is written with. Where one
  /// ends another, as .ugrid does .b8.ugrid, the longer one counts.
  std::array<std::string_view, 2> endings = {};
  std::string_view what;  ///< for people
  /// What a written mesh ends with where the ending does not tell the format.
  std::string_view other_ending = {};
  std::string_view folders = {};  ///< what the folders are called that are read; empty without any
  FormatLayout layout = FormatLayout::one_file;
  FormatCells cells = FormatCells::all;
  int integer_bits = 64;     ///< of its counts and numbers, or of those in the programs it is for
  bool holds_parts = false;  ///< the file tells of each tet which part it is in
  bool is_of_tasks = false;  ///< the tasks of a job write it themselves
  bool has_regions = true;
  bool has_patch_names = true;

  /// What the file that is written ends with; empty for a folder.
  constexpr std::string_view written_ending() const {
    return endings[0].empty() ? other_ending : endings[0];
  }
};

/// Null where the format cannot be read or written in that way.
struct FormatFunctions {
  /// `bytes` are not packed, and not empty; `name` is for messages. @throws InvalidInput.
  SurfaceMesh (*read_surface)(std::string_view bytes, const std::string& name) = nullptr;
  /// The whole file.
  std::string (*write_surface)(const SurfaceMesh& surface) = nullptr;
  /// Text formats are kept in `scratch_folder` meanwhile. @throws IoError, InvalidInput.
  std::unique_ptr<MeshSource> (*open_mesh)(const std::filesystem::path& path,
                                           const std::filesystem::path& scratch_folder) = nullptr;
  /// Whether a folder holds such a mesh; null for formats of files.
  bool (*is_mesh_folder)(const std::filesystem::path& folder) = nullptr;
  /// One file is written under another name first: `file` is where to write to.
  void (*write_mesh)(const MeshSource& source, const MeshOutline& outline,
                     const std::filesystem::path& file) = nullptr;
  /// Writes what goes beside `file`, where there is something.
  void (*write_beside)(const MeshSource& source, const MeshOutline& outline,
                       const std::filesystem::path& file) = nullptr;
};

struct Format : FormatFacts, FormatFunctions {};

}  // namespace tetfarm
