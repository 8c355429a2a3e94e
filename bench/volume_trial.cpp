// How long a sub-domain takes without cosmetics, stage by stage: volume_trial SURFACE_FILE
// [constant spacing; 0: by the surface] [1: with cosmetics]. CPU seconds.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "base/error.h"
#include "mesh/io/read_surface.h"
#include "mesh/volume/volume_mesh.h"

namespace {

using namespace tetfarm;

double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run(const std::string& path, double constant, bool with_cosmetics) {
  const SurfaceMesh surface = read_surface(path);
  const SpacingField field =
      constant > 0 ? SpacingField(constant) : make_spacing_field(surface, SpacingOptions{});
  VolumeMeshOptions options;
  options.cosmetics = with_cosmetics;
  const double start = seconds_now();
  options.progress = [start](const char* stage, std::int64_t tets) {
    std::printf("%8.3f s  %s, %lld tets\n", seconds_now() - start, stage,
                static_cast<long long>(tets));
  };
  VolumeMeshReport report;
  const TetMesh mesh = mesh_volume(root_subdomain(surface), field, options, &report);
  const double seconds = seconds_now() - start;
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
