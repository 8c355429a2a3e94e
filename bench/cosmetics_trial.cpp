/// What cosmetics does to a mesh: angles and seconds. The mesh is a ball, shell or half ball seeded
/// by a lattice, a ball of random points, one without inner points, or that of a surface file.
/// usage: cosmetics_trial [lattice|random|hollow|half|shell] [levels of the icosphere] [wanted, °]
///        cosmetics_trial SURFACE_FILE [background spacing, 0: by the surface] [wanted, °]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>

#include "base/error.h"
#include "mesh/core/tet_quality.h"
#include "mesh/cosmetics/improve_mesh.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace {

using namespace tetfarm;

/// Of this process, so that others on the machine do not count.
double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// How many tets have their smallest dihedral angle below 5, 10, 15… degrees, and the mean ratios.
void print_quality(const char* when, const TetComplex& complex, std::int32_t boundary_nodes) {
  std::array<std::int64_t, 8> below{};
  double sum = 0;
  double band_sum = 0;
  std::int64_t band = 0;
  double least = 180;
  double most = 0;
  for (const Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    const auto point = [&](std::size_t i) { return complex.points[std::size_t(tet[i])]; };
    const DihedralRange range = dihedral_range(point(0), point(1), point(2), point(3));
    for (std::size_t i = 0; i < below.size(); ++i) below[i] += range.min_deg < 5.0 * double(i + 1);
    least = std::min(least, range.min_deg);
    most = std::max(most, range.max_deg);
    const double ratio = radius_ratio(point(0), point(1), point(2), point(3));
    sum += ratio;
    if (*std::min_element(tet.begin(), tet.end()) < boundary_nodes) {
      band_sum += ratio;
      ++band;
    }
  }
  const auto tets = double(complex.live_tets());
  std::printf("%-7s %9.0f tets, angles %.2f to %.2f, mean ratio %.4f, at the boundary %.4f; below",
              when, tets, least, most, sum / tets, band_sum / double(band));
  for (std::size_t i = 0; i < below.size(); ++i) {
    std::printf(" %zu°: %lld", 5 * (i + 1), static_cast<long long>(below[i]));
  }
  std::printf("\n");
}

struct Trial {
  TetMesh mesh;
  CosmeticOptions options;
};

Trial made_trial(const std::string& kind, int levels) {
  if (kind == "lattice") return {trial::lattice_ball(levels), {}};
  if (kind == "random") return {trial::random_ball(levels, 1 << (3 * levels), 1), {}};
  if (kind == "hollow") return {trial::random_ball(levels, 0, 1), {}};
  if (kind == "half") return {trial::lattice_half_ball(levels), {}};
  if (kind == "shell") return {trial::lattice_shell(levels), {}};
  throw UsageError("no such trial", kind);
}

/// The volume mesh of a surface as it is before cosmetics, and the spacing as their guard.
Trial meshed_trial(const std::string& path, double background) {
  const SurfaceMesh surface = read_surface(path);
  SpacingOptions spacing_options;
  spacing_options.background = background;
  const auto field = std::make_shared<SpacingField>(make_spacing_field(surface, spacing_options));
  VolumeMeshOptions options;
  options.cosmetics = false;
  const double start = seconds_now();
  Trial trial{mesh_volume(root_subdomain(surface), *field, options).mesh.value(), {}};
  std::printf("meshed in %.3f s\n", seconds_now() - start);
  trial.options.spacing = [field](const Vec3& p) { return field->at(p); };
  return trial;
}

void run(const std::string& kind, double size, double wanted) {
  const bool is_file = kind.find('.') != std::string::npos;
  Trial trial = is_file ? meshed_trial(kind, size) : made_trial(kind, static_cast<int>(size));
  if (wanted > 0) trial.options.wanted_dihedral_deg = wanted;
  const TetMesh& mesh = trial.mesh;
  TetComplex complex = make_tet_complex(mesh);
  print_quality("before", complex, mesh.boundary_nodes);
  const double start = seconds_now();
  const CosmeticReport report = improve_mesh(complex, mesh.boundary_nodes, trial.options);
  const double seconds = seconds_now() - start;
  print_quality("after", complex, mesh.boundary_nodes);
  std::printf("%lld swaps, %lld moves, %lld collapses, %lld splits; %.3f s, %.3f us a tet\n",
              static_cast<long long>(report.swaps), static_cast<long long>(report.moves),
              static_cast<long long>(report.collapses), static_cast<long long>(report.splits),
              seconds, 1e6 * seconds / double(complex.live_tets()));
  for (const std::string& line : validate(complex)) std::printf("wrong: %s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? argv[1] : "lattice", argc > 2 ? std::atof(argv[2]) : 4,
        argc > 3 ? std::atof(argv[3]) : 0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
