// Cuts a surface into N leaves, as the decompose tasks would, and prints what came of it:
//   decompose_trial surface N [--box] [--growth g] [--planes auto|lattice|axis|inertia]
//                   [--verbose] [--mesh]
// --box puts the body into a box ten times its size; --mesh meshes the leaves and tells how good
// the elements within three layers of the cuts are beside the others.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "mesh/core/tet_quality.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/volume/volume_mesh.h"

namespace {

using namespace tetfarm;

struct Arguments {
  std::string surface;
  int parts = 16;
  bool in_box = false;
  bool is_verbose = false;
  bool is_meshed = false;
  double growth = 0.3;
  CutPlanes planes = CutPlanes::automatic;
};

/// Of the elements of one region: smallest dihedral angles, and smallest heights over the spacing.
struct Shapes {
  std::vector<float> dihedrals;
  std::vector<float> heights;
};

struct Totals {
  std::vector<double> leaf_work;
  std::vector<double> angles;
  int stuck = 0;
  int tried = 0;
  int first = 0;
  int cuts = 0;
  std::size_t interdomain = 0;
  double volume = 0;
  double cut_seconds = 0;
  double mesh_seconds = 0;
  std::vector<double> leaf_tets;
  int leaves_not_meshed = 0;
  double worst_estimate = 0;  // relative error
  double estimated_tets = 0;
  Shapes near_cuts;
  Shapes elsewhere;
};

/// Of this process only, so that a busy machine does not count.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

CutPlanes planes_called(const std::string& name) {
  if (name == "lattice") return CutPlanes::lattice;
  if (name == "axis") return CutPlanes::axis;
  return name == "inertia" ? CutPlanes::inertia : CutPlanes::automatic;
}

Arguments parse(int count, char** words) {
  Arguments a;
  a.surface = words[1];
  a.parts = std::stoi(words[2]);
  for (int i = 3; i < count; ++i) {
    if (!std::strcmp(words[i], "--box")) a.in_box = true;
    if (!std::strcmp(words[i], "--mesh")) a.is_meshed = true;
    if (!std::strcmp(words[i], "--verbose")) a.is_verbose = true;
    if (!std::strcmp(words[i], "--planes")) a.planes = planes_called(words[i + 1]);
    if (!std::strcmp(words[i], "--growth")) a.growth = std::stod(words[i + 1]);
  }
  return a;
}

/// How many edges each node is away from the cuts, 3 for all that are farther.
std::vector<int> layers_from_cuts(const Subdomain& leaf, const TetMesh& mesh) {
  std::vector<int> layer(mesh.nodes.size(), 3);
  for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
    if (leaf.triangle_origin[t].owner == 0) continue;
    for (const std::int32_t v : leaf.triangles[t]) layer[static_cast<std::size_t>(v)] = 0;
  }
  for (int round = 1; round < 3; ++round) {
    for (const Tet& tet : mesh.tets) {
      bool is_next = false;
      for (const std::int32_t v : tet) is_next |= layer[static_cast<std::size_t>(v)] == round - 1;
      if (!is_next) continue;
      for (const std::int32_t v : tet) {
        int& of_node = layer[static_cast<std::size_t>(v)];
        of_node = std::min(of_node, round);
      }
    }
  }
  return layer;
}

double smallest_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double largest_face = std::max({norm(cross(b - a, c - a)), norm(cross(b - a, d - a)),
                                        norm(cross(c - a, d - a)), norm(cross(c - b, d - b))});
  return 6 * tet_volume(a, b, c, d) / largest_face;
}

void add_shapes(const Subdomain& leaf, const TetMesh& mesh, const SpacingField& spacing,
                Totals& totals) {
  const std::vector<int> layer = layers_from_cuts(leaf, mesh);
  for (const Tet& tet : mesh.tets) {
    const auto at = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(tet[k])]; };
    int least = 3;
    for (const std::int32_t v : tet) least = std::min(least, layer[static_cast<std::size_t>(v)]);
    Shapes& shapes = least < 3 ? totals.near_cuts : totals.elsewhere;
    const double h = spacing.at(0.25 * (at(0) + at(1) + at(2) + at(3)));
    const double height = std::abs(smallest_height(at(0), at(1), at(2), at(3)));
    shapes.dihedrals.push_back(
        static_cast<float>(dihedral_range(at(0), at(1), at(2), at(3)).min_deg));
    shapes.heights.push_back(static_cast<float>(height / h));
  }
}

/// What the volume mesher makes of a leaf.
void mesh_leaf(const Subdomain& leaf, const SpacingField& spacing, const Arguments& arguments,
               Totals& totals) {
  const double start = cpu_seconds();
  const VolumeOutcome outcome = mesh_volume(leaf, spacing);
  if (!outcome.mesh) {
    ++totals.leaves_not_meshed;
    std::printf("%-8s %7zu triangles: NOT MESHED, %s\n", leaf.path.text().c_str(),
                leaf.triangles.size(), outcome.failure.message.c_str());
    return;
  }
  totals.mesh_seconds += cpu_seconds() - start;
  const auto tets = static_cast<double>(outcome.mesh->tets.size());
  const double estimate = estimated_elements(leaf, spacing);
  totals.leaf_tets.push_back(tets);
  totals.estimated_tets += estimate;
  totals.worst_estimate = std::max(totals.worst_estimate, std::abs(estimate / tets - 1));
  if (arguments.is_verbose) {
    std::printf("%-8s %7zu triangles: %.0f tets of %.0f estimated\n", leaf.path.text().c_str(),
                leaf.triangles.size(), tets, estimate);
  }
  add_shapes(leaf, *outcome.mesh, spacing, totals);
}

void cut_recursively(const Subdomain& subdomain, const SpacingField& spacing, int parts,
                     const Arguments& arguments, Totals& totals) {
  if (parts > 1) {
    CutOptions options;
    options.planes = arguments.planes;
    options.left_share = static_cast<double>(parts / 2) / parts;
    const double start = cpu_seconds();
    const CutOutcome outcome = planar_cut(subdomain, spacing, options);
    const double seconds = cpu_seconds() - start;
    totals.cut_seconds += seconds;
    if (outcome.cut) {
      const Cut& cut = *outcome.cut;
      ++totals.cuts;
      totals.tried += cut.candidates_tried;
      totals.first += cut.candidates_tried == 1 ? 1 : 0;
      totals.angles.push_back(cut.smallest_angle_deg);
      totals.interdomain += static_cast<std::size_t>(cut.interdomain_triangles);
      if (arguments.is_verbose) {
        std::printf(
            "%-8s %7zu triangles: cut of %5d, angle %4.1f, tried %2d, share %.3f, %.3f s; %s\n",
            subdomain.path.text().c_str(), subdomain.triangles.size(), cut.interdomain_triangles,
            cut.smallest_angle_deg, cut.candidates_tried,
            cut.left_work / (cut.left_work + cut.right_work), seconds, cut.refused.c_str());
      }
      for (const Subdomain* half : {&cut.left, &cut.right}) {
        for (const std::string& line : validate(*half)) std::printf("BROKEN: %s\n", line.c_str());
      }
      cut_recursively(cut.left, spacing, parts / 2, arguments, totals);
      cut_recursively(cut.right, spacing, parts - parts / 2, arguments, totals);
      return;
    }
    ++totals.stuck;
    std::printf("%-8s %7zu triangles: stuck, %s, %.3f s\n", subdomain.path.text().c_str(),
                subdomain.triangles.size(), outcome.reason.c_str(), seconds);
  }
  if (arguments.is_meshed) mesh_leaf(subdomain, spacing, arguments, totals);
  totals.leaf_work.push_back(estimated_elements(subdomain, spacing));
  totals.volume += enclosed_volume(subdomain.vertices, subdomain.triangles);
}

void print(const Arguments& arguments, const SurfaceMesh& surface, Totals totals) {
  const double volume = enclosed_volume(surface.vertices, surface.triangles);
  double work = 0;
  for (const double w : totals.leaf_work) work += w;
  std::sort(totals.angles.begin(), totals.angles.end());
  const double most = *std::max_element(totals.leaf_work.begin(), totals.leaf_work.end());
  std::printf(
      "%s: %zu triangles, %.3g elements, %zu leaves of %d, %d stuck, first candidate %d of %d (%d "
      "tried), angle "
      "%.1f min %.1f median, max/mean %.2f, interdomain/surface %.2f, volume off by %.1e, %.2f s "
      "(%.1f %% of 2 us an element)\n",
      arguments.surface.substr(arguments.surface.rfind('/') + 1).c_str(), surface.triangles.size(),
      work, totals.leaf_work.size(), arguments.parts, totals.stuck, totals.first, totals.cuts,
      totals.tried, totals.angles.empty() ? 0 : totals.angles.front(),
      totals.angles.empty() ? 0 : totals.angles[totals.angles.size() / 2],
      most * static_cast<double>(totals.leaf_work.size()) / work,
      static_cast<double>(totals.interdomain) / static_cast<double>(surface.triangles.size()),
      totals.volume / volume - 1, totals.cut_seconds, 100 * totals.cut_seconds / (2e-6 * work));
}

/// The smallest, the one at a thousandth, and (of angles) how many of 10,000 are below 10 degrees.
void print_shapes(const char* name, Shapes& shapes) {
  if (shapes.dihedrals.empty()) return;
  const auto count = shapes.dihedrals.size();
  const auto below = std::count_if(shapes.dihedrals.begin(), shapes.dihedrals.end(),
                                   [](float angle) { return angle < 10; });
  std::sort(shapes.dihedrals.begin(), shapes.dihedrals.end());
  std::sort(shapes.heights.begin(), shapes.heights.end());
  std::printf(
      "  %-9s %8zu tets: dihedral min %5.2f, 0.1 %% %5.2f, below 10: %.2f of 10^4; height/h "
      "min %.4f, 0.1 %% %.3f\n",
      name, count, shapes.dihedrals.front(), shapes.dihedrals[count / 1000],
      1e4 * static_cast<double>(below) / static_cast<double>(count), shapes.heights.front(),
      shapes.heights[count / 1000]);
}

void print_meshes(Totals& totals) {
  double tets = 0;
  double most = 0;
  for (const double n : totals.leaf_tets) {
    tets += n;
    most = std::max(most, n);
  }
  std::printf(
      "  meshed: %d leaves failed, %.0f tets, max/mean %.2f, estimate/tets %.3f (a leaf off "
      "by at most %.0f %%), %.2f s; cutting is %.1f %% of both\n",
      totals.leaves_not_meshed, tets, most * static_cast<double>(totals.leaf_tets.size()) / tets,
      totals.estimated_tets / tets, 100 * totals.worst_estimate, totals.mesh_seconds,
      100 * totals.cut_seconds / (totals.cut_seconds + totals.mesh_seconds));
  print_shapes("near cuts", totals.near_cuts);
  print_shapes("elsewhere", totals.elsewhere);
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::puts(
        "decompose_trial surface N [--box] [--growth g] [--planes auto|lattice|axis|inertia]\n"
        "               [--verbose] [--mesh]");
    return 2;
  }
  const Arguments arguments = parse(count, words);
  SurfaceMesh surface = read_surface(arguments.surface);
  if (arguments.in_box)
    surface = add_outer_boundary(surface, {OuterBoundary::Kind::box, 10, 0}, arguments.growth);
  SpacingOptions options;
  options.growth = arguments.growth;
  const double start = cpu_seconds();
  const SpacingField spacing = make_spacing_field(surface, options);
  std::printf("spacing %.2f s\n", cpu_seconds() - start);
  Totals totals;
  cut_recursively(root_subdomain(surface), spacing, arguments.parts, arguments, totals);
  print(arguments, surface, totals);
  if (arguments.is_meshed) print_meshes(totals);
  return 0;
}
