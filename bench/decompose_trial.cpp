// Cuts a surface into N leaves, as the decompose tasks would, and prints what came of it:
//   decompose_trial surface N [--box] [--growth g] [--verbose]
// --box puts the body into a box ten times its size.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "mesh/decompose/planar_cut.h"
#include "mesh/io/read_surface.h"
#include "tests/support/shapes.h"

namespace {

using namespace tetfarm;

struct Arguments {
  std::string surface;
  int parts = 16;
  bool in_box = false;
  bool is_verbose = false;
  double growth = 0.3;
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
};

/// Of this process only, so that a busy machine does not count.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Arguments parse(int count, char** words) {
  Arguments a;
  a.surface = words[1];
  a.parts = std::stoi(words[2]);
  for (int i = 3; i < count; ++i) {
    if (!std::strcmp(words[i], "--box")) a.in_box = true;
    if (!std::strcmp(words[i], "--verbose")) a.is_verbose = true;
    if (!std::strcmp(words[i], "--growth")) a.growth = std::stod(words[i + 1]);
  }
  return a;
}

SurfaceMesh in_outer_box(const SurfaceMesh& body) {
  const Box3 box = bounding_box(body.vertices);
  const Vec3 size = box.size();
  const double half = 5 * std::max({size.x, size.y, size.z});
  const Vec3 reach{half, half, half};
  return shapes::between(shapes::box(box.centre() - reach, box.centre() + reach, 12), body);
}

void cut_recursively(const Subdomain& subdomain, const SpacingField& spacing, int parts,
                     const Arguments& arguments, Totals& totals) {
  if (parts > 1) {
    CutOptions options;
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

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::puts("decompose_trial surface N [--box] [--growth g] [--verbose]");
    return 2;
  }
  const Arguments arguments = parse(count, words);
  SurfaceMesh surface = read_surface(arguments.surface);
  if (arguments.in_box) surface = in_outer_box(surface);
  SpacingOptions options;
  options.growth = arguments.growth;
  const double start = cpu_seconds();
  const SpacingField spacing = make_spacing_field(surface, options);
  std::printf("spacing %.2f s\n", cpu_seconds() - start);
  Totals totals;
  cut_recursively(root_subdomain(surface), spacing, arguments.parts, arguments, totals);
  print(arguments, surface, totals);
  return 0;
}
