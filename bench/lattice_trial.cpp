// What filling a domain costs in looking for lattice nodes: lattice_trial SIZE CASE [FILE FACTOR]
//   SIZE: the spacing far from everything, 0: what the surface allows.
//   CASE: wing, wing-in-box, spiral, spiral-in-box, shell, bodies, or "file" with a surface and the
//   factor of a box round it (0: none).
// Prints a row of a table: triangles, tets, cells of the octree and of its blocks that were
// visited, how often it was asked whether a box is needless, nodes listed, nodes in the domain,
// visits for each of those and of the triangles, CPU seconds of the mesh and its checksum.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "base/error.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/support/thin_domains.h"

namespace {

using namespace tetfarm;

SurfaceMesh surface_of(const std::string& name, int count, char** words) {
  constexpr double box_factor = 5;
  constexpr int box_parts = 8;
  if (name == "wing") return shapes::thin_wing(0.02, 40);
  if (name == "wing-in-box") {
    return shapes::in_large_box(shapes::thin_wing(0.02, 40), box_factor, box_parts);
  }
  if (name == "spiral") return shapes::spiral(8, 12);
  if (name == "spiral-in-box") {
    return shapes::in_large_box(shapes::spiral(8, 12), box_factor, box_parts);
  }
  if (name == "shell") return shapes::thin_shell(1e-3, 5);
  if (name == "bodies")
    return shapes::in_large_box(shapes::scattered_bodies(10), box_factor, box_parts);
  if (name != "file" || count < 5) throw UsageError("no such case", name);
  const SurfaceMesh surface = check_surface(read_surface(words[3])).surface;
  OuterBoundary outer;
  outer.factor = std::atof(words[4]);
  outer.kind = outer.factor > 0 ? OuterBoundary::Kind::box : OuterBoundary::Kind::none;
  return add_outer_boundary(surface, outer, SpacingOptions{}.growth);
}

void run(const std::string& name, int count, char** words) {
  const SurfaceMesh surface = surface_of(name, count, words);
  SpacingOptions spacing;
  spacing.background = std::atof(words[1]);
  const SpacingField field = make_spacing_field(surface, spacing);
  VolumeMeshReport report;
  const auto start = std::clock();
  const TetMesh mesh = mesh_volume(root_subdomain(surface), field, {}, &report).mesh.value();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::uint64_t sum = 0;
  for (const Tet& tet : mesh.tets) {
    for (const std::int32_t v : tet) {
      sum = (sum ^ static_cast<std::uint32_t>(v)) * 0x9e3779b97f4a7c15ULL;
      sum ^= sum >> 29U;
    }
  }
  const LatticeCost& cost = report.lattice;
  const double kept =
      static_cast<double>(cost.inside) + static_cast<double>(surface.triangles.size());
  std::printf("| %zu | %zu | %lld | %lld | %lld | %lld | %.2f | %.2f | %llx |\n",
              surface.triangles.size(), mesh.tets.size(), static_cast<long long>(cost.visits.cells),
              static_cast<long long>(cost.visits.questions), static_cast<long long>(cost.listed),
              static_cast<long long>(cost.inside), static_cast<double>(cost.visits.cells) / kept,
              seconds, static_cast<unsigned long long>(sum));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw UsageError("lattice_trial SIZE CASE [FILE FACTOR]", "");
    run(argv[2], argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
