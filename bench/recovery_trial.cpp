// Boundary recovery of generated surfaces, a line each: recovery_trial GENERATOR SIZE FIRST_SEED
// END_SEED [FOLDER: writes the valid surfaces there as .off]. The generators of
// generated_surfaces.h and of cad_surfaces.h. CPU seconds.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>

#include "mesh/core/validate.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/support/cad_surfaces.h"

namespace {

using namespace tetfarm;

double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

using Move = SurfaceMesh (*)(SurfaceMesh, std::uint64_t seed);

struct Settings {
  int size = 1;
  std::string folder;  // "-": none
  bool fill = false;
};

void run(const shapes::SurfaceGenerator& generator, Move move, std::uint64_t seed,
         const Settings& settings) {
  const auto& [size, folder, fill] = settings;
  const CheckedSurface checked = check_surface(move(generator.make(seed, size), seed));
  const char* outcome = "invalid";
  VolumeMeshReport report;
  std::string words;
  double seconds = 0;
  if (checked.report.defects.empty()) {
    if (folder != "-") {
      write_surface(checked.surface, folder + "/" + generator.name + "_" + std::to_string(size) +
                                         "_" + std::to_string(seed) + ".off");
    }
    const Subdomain domain = root_subdomain(checked.surface);
    VolumeMeshOptions options;
    options.fill = fill;
    const double spacing = 0.2 * norm(bounding_box(domain.vertices).size());
    const double start = seconds_now();
    const VolumeOutcome made = mesh_volume(domain, SpacingField(spacing), options, &report);
    seconds = seconds_now() - start;
    if (made.mesh) {
      const auto wrong = validate(*made.mesh, domain.triangles);
      outcome = wrong.empty() ? "meshed" : "wrong";
      if (!wrong.empty()) words = wrong.front();
    } else {
      outcome = "refused";
      words = made.failure.message;
    }
  }
  std::printf("%s %d %llu %s triangles=%zu missing=%lld,%lld steiner=%lld,%lld s=%.3f %s\n",
              generator.name, size, static_cast<unsigned long long>(seed), outcome,
              checked.surface.triangles.size(), static_cast<long long>(report.missing_edges),
              static_cast<long long>(report.missing_faces),
              static_cast<long long>(report.boundary_steiner_points),
              static_cast<long long>(report.interior_steiner_points), seconds, words.c_str());
  std::fflush(stdout);
}

void run_all(std::span<const shapes::SurfaceGenerator> generators, Move move, char** argv,
             const Settings& settings) {
  for (const auto& generator : generators) {
    if (std::string(argv[1]) != generator.name) continue;
    for (std::uint64_t seed = std::strtoull(argv[3], nullptr, 10);
         seed < std::strtoull(argv[4], nullptr, 10); ++seed) {
      run(generator, move, seed, settings);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  const Settings settings = {std::atoi(argv[2]), argc > 5 ? argv[5] : "-",
                             argc > 6 && argv[6] == std::string("fill")};
  run_all(shapes::surface_generators(), shapes::moved_by_chance, argv, settings);
  run_all(shapes::cad_surface_generators(), shapes::moved_exactly, argv, settings);
}
