#include "mesh/inspect/surface_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/counted.h"
#include "mesh/core/complaints.h"
#include "mesh/inspect/defect_text.h"
#include "mesh/inspect/region_map.h"
#include "mesh/inspect/self_intersection.h"
#include "mesh/inspect/shell_nesting.h"
#include "mesh/inspect/shell_orientation.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/inspect/surface_figures.h"
#include "mesh/inspect/triangle_defects.h"
#include "mesh/inspect/vertex_fans.h"

namespace tetfarm {
namespace {

/// The volume that the shell encloses when its triangles are turned as the flood fill wants them.
/// Long sums, since its sign decides which side is out.
double signed_volume(const SurfaceMesh& surface, const std::vector<std::int32_t>& shell,
                     const std::vector<char>& turn) {
  const auto at = [&surface](std::int32_t v) {
    return surface.vertices[static_cast<std::size_t>(v)];
  };
  const Vec3 origin = at(surface.triangles[static_cast<std::size_t>(shell[0])][0]);
  long double sum = 0;
  for (const std::int32_t t : shell) {
    const Triangle& nodes = surface.triangles[static_cast<std::size_t>(t)];
    const Vec3 a = at(nodes[0]) - origin;
    const Vec3 b = at(nodes[1]) - origin;
    const Vec3 c = at(nodes[2]) - origin;
    const long double ax = a.x;
    const long double ay = a.y;
    const long double az = a.z;
    const long double det =
        ax * (static_cast<long double>(b.y) * c.z - static_cast<long double>(b.z) * c.y) +
        ay * (static_cast<long double>(b.z) * c.x - static_cast<long double>(b.x) * c.z) +
        az * (static_cast<long double>(b.x) * c.y - static_cast<long double>(b.y) * c.x);
    sum += turn[static_cast<std::size_t>(t)] != 0 ? -det : det;
  }
  return static_cast<double>(sum / 6);
}

std::string shell_text(std::size_t number, const Shell& shell) {
  return "shell " + std::to_string(number) + " (" + counted(shell.triangles.size(), "triangle") +
         ")";
}

/// Turns what has to be turned in the shell, and says so. `reverse`: all the other way than `turn`
/// says.
void orient_shell(std::size_t number, bool reverse, const std::vector<char>& turn,
                  CheckedSurface& checked) {
  Shell& shell = checked.report.shells[number];
  std::size_t turned = 0;
  for (const std::int32_t t : shell.triangles) {
    if ((turn[static_cast<std::size_t>(t)] != 0) == reverse) continue;
    Triangle& nodes = checked.surface.triangles[static_cast<std::size_t>(t)];
    std::swap(nodes[1], nodes[2]);
    ++turned;
  }
  shell.was_flipped = 2 * turned > shell.triangles.size();
  const std::string what = shell_text(number, shell);
  if (turned == shell.triangles.size()) {
    checked.report.remarks.push_back(what + " was oriented " +
                                     (shell.depth % 2 == 0 ? "inward" : "outward") +
                                     "; turned by nesting");
  } else if (turned > 0) {
    checked.report.remarks.push_back(what + ": " + counted(turned, "triangle") +
                                     " faced the other way than the rest and had to be turned");
  }
}

void remark_on_fans(const SurfaceMesh& surface, const std::vector<std::int32_t>& vertices,
                    SurfaceReport& report) {
  if (vertices.empty()) return;
  std::vector<std::string> places;
  for (std::size_t i = 0; i < std::min(vertices.size(), places_named); ++i) {
    places.push_back("vertex " + std::to_string(vertices[i]) + " " +
                     text_of(surface.vertices[static_cast<std::size_t>(vertices[i])]));
  }
  report.remarks.push_back(
      with_places("the surface touches itself at " + counted(vertices.size(), "single point"),
                  places, vertices.size()));
}

/// @pre there are no defects.
void nest_and_orient(const ShellOrientation& orientation, CheckedSurface& checked) {
  TF_CHECK(checked.report.defects.empty());
  SurfaceReport& report = checked.report;
  const std::vector<ShellPlace> places = nest_shells(checked.surface, orientation.shells);
  TF_CHECK(places.size() == report.shells.size());
  for (std::size_t s = 0; s < report.shells.size(); ++s) {
    Shell& shell = report.shells[s];
    shell.parent = places[s].parent;
    shell.depth = places[s].depth;
    const double volume = signed_volume(checked.surface, shell.triangles, orientation.turn);
    shell.volume = std::abs(volume);
    const bool is_domain_inside = shell.depth % 2 == 0;
    report.volume += is_domain_inside ? shell.volume : -shell.volume;
    // The triangles, turned as the flood fill wants, enclose a positive volume when they face
    // outward.
    const bool keep_fill = (volume > 0) == is_domain_inside;
    orient_shell(s, !keep_fill, orientation.turn, checked);
  }
}

/// @pre there are no defects.
void divide_into_regions(std::span<const EdgeUse> uses, const RegionRules& rules,
                         bool has_interfaces, CheckedSurface& checked) {
  TF_CHECK(checked.report.defects.empty());
  checked.report.shells.clear();
  // The map looks at the triangles as they were; they may be turned while it is still used.
  const SurfaceMesh given = checked.surface;
  const RegionMap map(given, join_sides(given, uses));
  auto defect = choose_regions(map, rules, has_interfaces, checked.surface, checked.report);
  if (defect) checked.report.defects.push_back(std::move(*defect));
}

bool has_crowded_edge(std::span<const EdgeUse> uses) {
  bool found = false;
  for_each_edge(uses,
                [&found](std::span<const EdgeUse> edge) { found = found || edge.size() > 2; });
  return found;
}

}  // namespace

CheckedSurface check_surface(SurfaceMesh given, const RegionRules& rules) {
  CheckedSurface checked{std::move(given), {}};
  const SurfaceMesh& surface = checked.surface;
  SurfaceReport& report = checked.report;
  TriangleCheck triangles = check_triangles(surface);
  report.defects = std::move(triangles.defects);
  std::vector<EdgeUse> uses = edge_uses(surface.triangles, triangles.sieve.for_edges);
  measure_surface(surface, uses, report);
  if (auto defect = check_edges(surface, uses)) report.defects.push_back(std::move(*defect));
  ShellOrientation orientation = orient_shells(surface, uses, triangles.sieve.for_edges);
  if (orientation.defect) report.defects.push_back(*orientation.defect);
  for (const auto& shell : orientation.shells) {
    report.shells.emplace_back().triangles = shell;
  }
  const std::vector<std::int32_t> of_several_fans = vertices_of_several_fans(surface, uses);
  const bool has_interfaces = has_crowded_edge(uses);
  const bool has_regions = has_interfaces || !rules.wishes.empty();
  if (!has_regions) uses = {};  // the next step needs most memory
  if (auto defect = check_self_intersection(surface, triangles.sieve.for_contact)) {
    report.defects.push_back(std::move(*defect));
  }
  remark_on_fans(surface, of_several_fans, report);
  if (report.unused_vertices > 0) {
    report.remarks.push_back("vertices in no triangle: " + std::to_string(report.unused_vertices));
  }
  if (!report.defects.empty()) return checked;
  if (has_regions) {
    divide_into_regions(uses, rules, has_interfaces, checked);
  } else {
    nest_and_orient(orientation, checked);
  }
  return checked;
}

}  // namespace tetfarm
