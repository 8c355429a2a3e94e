// Boundary recovery of generated surfaces, a line each: recovery_trial GENERATOR SIZE FIRST_SEED
// END_SEED [FOLDER: writes the valid surfaces there as .off]. CPU seconds.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>

#include "mesh/core/validate.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/io/write_surface.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/support/generated_surfaces.h"

namespace {

using namespace tetfarm;

double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run(const shapes::SurfaceGenerator& generator, std::uint64_t seed, int size,
         const std::string& folder) {
  const CheckedSurface checked =
      check_surface(shapes::moved_by_chance(generator.make(seed, size), seed));
  const char* outcome = "invalid";
  VolumeMeshReport report;
  std::string words;
  const double start = seconds_now();
  if (checked.report.defects.empty()) {
    if (!folder.empty()) {
      write_surface(checked.surface, folder + "/" + generator.name + "_" + std::to_string(size) +
                                         "_" + std::to_string(seed) + ".off");
    }
    const Subdomain domain = root_subdomain(checked.surface);
    VolumeMeshOptions options;
    options.fill = false;
    const double spacing = 0.2 * norm(bounding_box(domain.vertices).size());
    try {
      const TetMesh mesh = mesh_volume(domain, SpacingField(spacing), options, &report);
      const auto wrong = validate(mesh, domain.triangles);
      outcome = wrong.empty() ? "meshed" : "wrong";
      if (!wrong.empty()) words = wrong.front();
    } catch (const std::exception& error) {
      outcome = "refused";
      words = error.what();
    }
  }
  std::printf(
      "%s %d %llu %s triangles=%zu missing=%lld,%lld steiner=%lld,%lld s=%.3f %s\n", generator.name,
      size, static_cast<unsigned long long>(seed), outcome, checked.surface.triangles.size(),
      static_cast<long long>(report.missing_edges), static_cast<long long>(report.missing_faces),
      static_cast<long long>(report.boundary_steiner_points),
      static_cast<long long>(report.interior_steiner_points), seconds_now() - start, words.c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  for (const auto& generator : tetfarm::shapes::surface_generators()) {
    if (std::string(argv[1]) != generator.name) continue;
    for (std::uint64_t seed = std::strtoull(argv[3], nullptr, 10);
         seed < std::strtoull(argv[4], nullptr, 10); ++seed) {
      run(generator, seed, std::atoi(argv[2]), argc > 5 ? argv[5] : "");
    }
  }
}
