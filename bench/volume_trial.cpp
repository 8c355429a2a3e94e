// How long a sub-domain takes without cosmetics, stage by stage: volume_trial SURFACE_FILE
// [constant spacing; 0: by the surface] [1: with cosmetics]. CPU seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "base/error.h"
#include "mesh/core/tet_quality.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/volume/volume_mesh.h"

namespace {

using namespace tetfarm;

double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The smallest dihedral angle, and how many tets have one below some.
void print_angles(const TetMesh& mesh) {
  constexpr double deg = 57.29577951308232;
  constexpr std::array<double, 6> limits = {0.1, 1, 3, 8, 15, 20};
  std::array<std::size_t, limits.size()> below{};
  double smallest = 180;
  for (const Tet& tet : mesh.tets) {
    const auto at = [&mesh](std::int32_t v) { return mesh.nodes[static_cast<std::size_t>(v)]; };
    const double angle =
        deg *
        std::acos(dihedral_cosines(at(tet[0]), at(tet[1]), at(tet[2]), at(tet[3])).of_smallest);
    smallest = std::min(smallest, angle);
    for (std::size_t i = 0; i < limits.size(); ++i) below[i] += angle < limits[i] ? 1 : 0;
  }
  std::printf("smallest dihedral angle %.4g deg; tets below 0.1, 1, 3, 8, 15, 20 deg:", smallest);
  for (const std::size_t n : below) std::printf(" %zu", n);
  std::printf("\n");
}

void run(const std::string& path, double constant, bool with_cosmetics) {
  const SurfaceMesh surface = read_surface(path);
  const SpacingField field =
      constant > 0 ? SpacingField(constant) : make_spacing_field(surface, SpacingOptions{});
  VolumeMeshOptions options;
  options.cosmetics = with_cosmetics;
  const double start = seconds_now();
  options.progress = WorkProgress([start](const WorkCount& count) {
    std::printf("%8.3f s  %s\n", seconds_now() - start, work_text(count).c_str());
  });
  VolumeMeshReport report;
  const TetMesh mesh = mesh_volume(root_subdomain(surface), field, options, &report).mesh.value();
  const double seconds = seconds_now() - start;
  print_angles(mesh);
  std::uint64_t sum = 0;
  for (const Tet& tet : mesh.tets) {
    for (const std::int32_t v : tet) {
      sum = (sum ^ static_cast<std::uint32_t>(v)) * 0x9e3779b97f4a7c15ULL;
      sum ^= sum >> 29U;
    }
  }
  std::printf(
      "%8.3f s, %zu tets, %.3f us a tet, %lld edges and %lld faces recovered, checksum %llx\n",
      seconds, mesh.tets.size(), 1e6 * seconds / static_cast<double>(mesh.tets.size()),
      static_cast<long long>(report.missing_edges), static_cast<long long>(report.missing_faces),
      static_cast<unsigned long long>(sum));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? argv[1] : "", argc > 2 ? std::atof(argv[2]) : 0, argc > 3);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
