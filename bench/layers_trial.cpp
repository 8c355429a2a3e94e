// What layers a surface gets, and how good their cells are: layers_trial SURFACE_FILE FIRST_HEIGHT
// [growth] [count; 0: until isotropic] [room: ratio, stop, scale] [outer box factor] [patch...].
// CPU seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/elements.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/layer_plan.h"

namespace {

using namespace tetfarm;

double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto i = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + i, values.end());
  return values[static_cast<std::size_t>(i)];
}

/// Of a prism that stands straight on the wall triangle.
double jacobian_of_wall(const TrianglePoints& t) {
  const Vec3 n = normalized(cross(t[2] - t[0], t[1] - t[0]));
  const std::array<Vec3, 6> straight = {t[0], t[2], t[1], t[0] + n, t[2] + n, t[1] + n};
  return scaled_jacobian(ElementType::prism, straight);
}

void print_plan(const LayerPlan& plan, const SurfaceMesh& surface) {
  std::map<std::string, int> reasons;
  for (const LayerLine& line : plan.lines) ++reasons[name_of(line.reason)];
  int shown = 0;
  for (const LayerLine& line : plan.lines) {
    if (line.reason == StopReason::complete || line.because_of != line.foot || shown++ > 14)
      continue;
    std::printf("%s: vertex %d (%g %g %g) stop %d, growth %g, along %g later %g\n",
                name_of(line.reason), line.foot, line.at.x, line.at.y, line.at.z, line.stop,
                line.law.growth, norm(line.along), norm(line.later));
  }
  std::printf("lines:");
  for (const auto& [name, count] : reasons) std::printf(" %s %d", name.c_str(), count);
  std::array<std::int64_t, 3> counts{};
  std::int64_t full = 0;
  std::int64_t none = 0;
  std::vector<double> relative;
  std::vector<double> first;
  std::vector<double> wanted;
  for (const std::int32_t t : plan.wall) {
    const auto lines = lines_of(plan, surface, t);
    std::array<int, 3> stops{};
    bool is_full = true;
    std::array<std::vector<Vec3>, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const LayerLine& line = plan.lines[static_cast<std::size_t>(lines[k])];
      stops[k] = line.stop;
      wanted.push_back(line.wanted);
      is_full = is_full && line.stop == line.wanted;
      points[k] = points_of(line);
    }
    full += is_full ? 1 : 0;
    none += layers_above(stops) == 0 ? 1 : 0;
    const TrianglePoints wall = {points[0][0], points[1][0], points[2][0]};
    const Vec3 normal = normalized(cross(wall[2] - wall[0], wall[1] - wall[0]));
    for (int layer = 1; layer <= layers_above(stops); ++layer) {
      const LayerCell cell = layer_cell(stops, layer);
      ++counts[static_cast<std::size_t>(cell.type) - 2];
      if (cell.type != ElementType::prism) continue;
      std::array<Vec3, 6> p;
      for (std::size_t k = 0; k < 6; ++k) {
        p[k] = points[static_cast<std::size_t>(cell.nodes[k].corner)]
                     [static_cast<std::size_t>(cell.nodes[k].level)];
      }
      relative.push_back(scaled_jacobian(ElementType::prism, p) / jacobian_of_wall(wall));
      if (layer > 1) continue;
      double height = 0;
      for (std::size_t k = 0; k < 3; ++k) height += dot(p[k + 3] - p[k], normal) / 3;
      first.push_back(height / plan.lines[static_cast<std::size_t>(lines[0])].law.first);
    }
  }
  const auto walls = static_cast<double>(plan.wall.size());
  std::printf(
      "\n%zu wall triangles, full %.3f %%, none %.3f %%; %lld tets, %lld pyramids, %lld prisms\n",
      plan.wall.size(), 100 * static_cast<double>(full) / walls,
      100 * static_cast<double>(none) / walls, static_cast<long long>(counts[0]),
      static_cast<long long>(counts[1]), static_cast<long long>(counts[2]));
  const auto within = [&first](double share) {
    const auto n = std::count_if(first.begin(), first.end(),
                                 [share](double h) { return std::abs(h - 1) <= share; });
    return 100 * static_cast<double>(n) / static_cast<double>(first.size());
  };
  std::printf("first height within 2 %% %.3f, 10 %% %.3f; wanted layers median %.0f\n",
              within(0.02), within(0.1), percentile(wanted, 0.5));
  std::printf("scaled Jacobian over the wall's: min %.3f, 1 %% %.3f, median %.4f\n",
              percentile(relative, 0), percentile(relative, 0.01), percentile(relative, 0.5));
}

void run(int argc, char** argv) {
  const auto number = [&](int i, double otherwise) {
    return argc > i ? std::atof(argv[i]) : otherwise;
  };
  SurfaceMesh surface = check_surface(read_surface(argv[1])).surface;
  LayerRequest request;
  request.law = {.first = number(2, 1e-3),
                 .growth = number(3, 1.2),
                 .acceleration = 1,
                 .cap = number(3, 1.2),
                 .equal = 1};
  request.count = static_cast<int>(number(4, 0));
  const std::string_view room = argc > 5 ? argv[5] : "ratio";
  request.room = room == "stop"    ? RoomRule::stop
                 : room == "scale" ? RoomRule::scale
                                   : RoomRule::ratio;
  const std::size_t own = surface.patch_names.size();
  if (number(6, 0) > 1) {
    OuterBoundary outer;
    outer.kind = OuterBoundary::Kind::box;
    outer.factor = number(6, 0);
    surface = add_outer_boundary(surface, outer, 0.3);
  }
  for (std::size_t p = 0; p < std::max<std::size_t>(1, own); ++p) {
    const bool is_named =
        std::any_of(argv + std::min(argc, 7), argv + argc,
                    [&, p](const char* name) { return own > 0 && surface.patch_names[p] == name; });
    if (argc <= 7 || is_named) request.patches.push_back(static_cast<std::int32_t>(p));
  }
  for (const std::string& name : surface.patch_names) std::printf("patch %s\n", name.c_str());
  const double start = seconds_now();
  const LayerPlan plan = plan_layers(surface, std::span(&request, 1));
  std::printf("planned in %.3f s\n", seconds_now() - start);
  print_plan(plan, surface);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3) return 2;
    run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
