// What the mesh kernel makes of some surfaces, a line each: CASE STEP DIGEST. The same lines must
// come out of every build, whatever the compiler, its flags and the processor
// (tests/builds/compare_builds.py).
//
//   kernel_digests [FOLDER]   FOLDER: that of the real models; without it, generated ones only
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

#include "base/hash.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/support/generated_surfaces.h"

namespace tetfarm {
namespace {

/// A case: its surface goes through every step of a job, and each step's file is told.
class Case {
 public:
  explicit Case(std::string name) : name_(std::move(name)) {}

  void run(const SurfaceMesh& given, const SpacingOptions& options = {}) const {
    tell("read", surface_to_bytes(given));
    const CheckedSurface checked = check_surface(given);
    if (!checked.report.defects.empty()) {
      std::string messages;
      for (const SurfaceDefect& defect : checked.report.defects) messages += defect.message + "\n";
      tell("defects", messages);
      return;
    }
    run_domain(checked.surface, options);
  }

  /// In a box of twice its size.
  void run_in_box(const SurfaceMesh& body) const {
    const OuterBoundary outer{.kind = OuterBoundary::Kind::box, .factor = 2};
    run_domain(add_outer_boundary(check_surface(body).surface, outer, growth), {});
  }

 private:
  static constexpr double growth = 0.3;

  void tell(const char* step, std::string_view bytes) const {
    std::printf("%s %s %s\n", name_.c_str(), step, hash128(bytes).hex().c_str());
  }

  void run_domain(const SurfaceMesh& surface, const SpacingOptions& options) const {
    tell("surface", surface_to_bytes(surface));
    const SpacingField spacing = make_spacing_field(surface, options);
    tell("spacing", spacing.to_bytes());
    const Subdomain root = root_subdomain(surface);
    const CutOutcome outcome = planar_cut(root, spacing);
    if (!outcome.cut) {
      tell("no_cut", outcome.reason);
      run_volume("whole", root, spacing, {});
      return;
    }
    tell("left", subdomain_to_bytes(outcome.cut->left));
    tell("right", subdomain_to_bytes(outcome.cut->right));
    run_volume("left_mesh", outcome.cut->left, spacing, {});
    run_volume("right_mesh", outcome.cut->right, spacing, {});
    VolumeMeshOptions by_sweeps;
    by_sweeps.points = InteriorPoints::sweeps;
    run_volume("left_by_sweeps", outcome.cut->left, spacing, by_sweeps);
  }

  void run_volume(const char* step, const Subdomain& part, const SpacingField& spacing,
                  const VolumeMeshOptions& options) const {
    const VolumeOutcome outcome = mesh_volume(part, spacing, options);
    tell(step, outcome.mesh ? tet_mesh_to_bytes(*outcome.mesh) : outcome.failure.message);
  }

  std::string name_;
};

/// All three kinds of sources, whose decay is exponential.
SpacingOptions with_sources() {
  SpacingOptions options;
  options.growth = 0.25;
  options.background = 0.4;
  options.sources = {
      {{{.at = {1.5, 0.1, 0.2}, .spacing = 0.05, .inner_radius = 0.1, .outer_radius = 0.9}}},
      {{{.at = {-1.5, 0, 0}, .spacing = 0.06, .inner_radius = 0.05, .outer_radius = 0.6},
        {.at = {-1.2, 0.7, 1}, .spacing = 0.1, .inner_radius = 0.1, .outer_radius = 0.5}}},
      {{{.at = {0, 1.5, 0}, .spacing = 0.08, .inner_radius = 0.1, .outer_radius = 0.7},
        {.at = {0.3, 1.4, 0.5}, .spacing = 0.1, .inner_radius = 0.1, .outer_radius = 0.7},
        {.at = {0.1, 1.3, -0.6}, .spacing = 0.07, .inner_radius = 0.1, .outer_radius = 0.7}}}};
  return options;
}

void run_shapes() {
  Case("sphere_in_sphere").run(make_shape("sphere-in-sphere", {.spacing = 0.25}));
  Case("sphere_in_box").run(make_shape("sphere-in-box", {.spacing = 0.3}), with_sources());
  Case("corner_reflector").run(make_shape("corner-reflector", {.spacing = 0.2}));
  Case("duct").run(make_shape("duct", {.spacing = 0.15}));
  Case("wing").run(make_shape("wing", {.spacing = 0.15, .growth = 0.5}));
}

void run_generated() {
  constexpr std::uint64_t seeds = 2;
  for (const shapes::SurfaceGenerator& generator : shapes::surface_generators()) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Case here(std::string(generator.name) + "_" + std::to_string(seed));
      here.run(shapes::moved_by_chance(generator.make(seed, 1), seed));
    }
  }
}

void run_real(const std::string& folder) {
  for (const std::string name : {"cube_sphere", "nasa_almond_in_box", "flange", "pipe"}) {
    Case(name).run(read_surface(folder + "/" + name + "/" + name + ".msh"));
  }
  Case("onera").run(read_surface(folder + "/onera_m6_sharp_te/onera_m6_sharp_te.msh.gz"));
  Case("almond").run_in_box(
      read_surface(folder + "/nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl"));
}

}  // namespace
}  // namespace tetfarm

int main(int argc, char** argv) {
  try {
    tetfarm::run_shapes();
    tetfarm::run_generated();
    if (argc > 1) tetfarm::run_real(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
