#include <stdlib.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/formats/plane/plane_meshb.h"
#include "mesh/formats/plane/plane_sides.h"
#include "mesh/formats/plane/read_loops.h"
#include "tests/fuzz/fuzz_targets.h"

namespace tetfarm::fuzz {
namespace {

/// Files are told by their endings; `.sol` and `.xy` are fields and loops.
constexpr std::array plane_names = {"a.mesh", "a.su2",   "a.msh", "a.sol",
                                    "a.xy",   "a.meshb", "a.solb"};

/// In memory where there is such a place.
const std::filesystem::path& plane_folder() {
  static const std::filesystem::path made = [] {
    std::string folder = std::filesystem::is_directory("/dev/shm")
                             ? "/dev/shm"
                             : std::filesystem::temp_directory_path().string();
    folder += "/tetfarm-fuzz-plane-XXXXXX";
    TF_CHECK(::mkdtemp(folder.data()) != nullptr);
    return std::filesystem::path(folder);
  }();
  return made;
}

/// Loops are three points or more.
void read_plane_loops(std::string_view bytes) {
  static const std::filesystem::path folder = plane_folder();
  static const int at_end = std::atexit([] { std::filesystem::remove_all(plane_folder()); });
  TF_CHECK(at_end == 0);
  std::ofstream(folder / "a.xy", std::ios::binary) << bytes;
  for (const PlaneLoop& loop : read_loops(folder / "a.xy")) TF_CHECK(loop.points.size() >= 3);
}

}  // namespace

void plane(std::string_view input) {
  if (input.empty()) return;
  const std::string name = plane_names[static_cast<unsigned char>(input[0]) % plane_names.size()];
  const std::string_view bytes = input.substr(1);
  try {
    if (name == "a.xy") {
      read_plane_loops(bytes);
    } else if (name == "a.sol" || name == "a.solb") {
      name == "a.sol" ? read_plane_sol(bytes, name) : read_plane_solb(bytes, name);
    } else {
      const PlaneMesh mesh = read_plane_mesh(bytes, name);
      TF_CHECK(mesh.patches.size() == mesh.edges.size());
      TF_CHECK(mesh.regions.size() == mesh.triangles.size());
      const TriangleComplex complex = checked_complex(mesh);
      TF_CHECK(complex.triangles.size() == mesh.triangles.size());
      border_patches(mesh, sides_of(mesh));
    }
  } catch (const Error&) {
  }
}

}  // namespace tetfarm::fuzz
