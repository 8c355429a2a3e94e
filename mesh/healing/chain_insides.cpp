#include "mesh/healing/chain_insides.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/array_index.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/inspect/shifted_ray.h"
#include "mesh/inspect/six_volumes.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/inspect/surface_sides.h"

namespace tetfarm {
namespace {

constexpr std::int32_t unknown = INT32_MIN;

double area_of(const TrianglePoints& t) { return norm(cross(t[1] - t[0], t[2] - t[0])) / 2; }

/// Sheets are joined sides: each bounds a region on its side. Those of a part, which is joined over
/// edges, are the one round it and one for each region inside it.
class Sheets {
 public:
  Sheets(const TriangleChain& chain, const SurfaceMesh& surface, SurfaceSides sides)
      : chain_(chain),
        surface_(surface),
        sides_(std::move(sides)),
        volume_(at(sides_.sheets), 0),
        border_(at(sides_.sheets), 0),
        winding_(at(sides_.sheets), unknown) {
    measure();
  }

  bool find_winding_numbers() {
    struct Step {
      std::int32_t to;
      std::int32_t change;
    };
    std::vector<std::vector<Step>> steps(at(sides_.sheets));
    for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
      const std::int32_t times = chain_.triangles[t].times;
      steps[at(front(t))].push_back({behind(t), times});
      steps[at(behind(t))].push_back({front(t), -times});
    }
    const BoxTree tree(triangle_boxes(surface_.vertices, surface_.triangles));
    const std::vector<std::int32_t> vertices = vertices_of_parts();
    for (std::int32_t part = 0; part < sides_.parts; ++part) {
      if (vertices[at(part)] < 0) return false;
      winding_[at(outer_[at(part)])] = winding_of_others(part, vertices[at(part)], tree);
      std::vector<std::int32_t> open = {outer_[at(part)]};
      while (!open.empty()) {
        const std::int32_t sheet = open.back();
        open.pop_back();
        for (const Step& step : steps[at(sheet)]) {
          const std::int32_t there = winding_[at(sheet)] + step.change;
          if (winding_[at(step.to)] == unknown) {
            winding_[at(step.to)] = there;
            open.push_back(step.to);
          }
          if (winding_[at(step.to)] != there) return false;
        }
      }
    }
    return true;
  }

  std::vector<std::array<bool, 2>> insides(double tolerance) const {
    const std::vector<char> is_inside = settled(tolerance);
    std::vector<std::array<bool, 2>> insides;
    for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
      insides.push_back({is_inside[at(behind(t))] != 0, is_inside[at(front(t))] != 0});
    }
    return insides;
  }

 private:
  std::int32_t behind(std::size_t t) const { return sides_.side2sheet[side_behind(t)]; }
  std::int32_t front(std::size_t t) const { return sides_.side2sheet[side_in_front(t)]; }

  /// Volumes as seen from the region that the sheet bounds. That of the sheet round a part is less
  /// than all others of the part, in spite of rounding.
  void measure() {
    std::vector<Vec3> origin(at(sides_.parts));
    std::vector<char> has_origin(at(sides_.parts), 0);
    std::vector<std::int32_t> part_of(at(sides_.sheets), -1);
    for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
      const std::int32_t part = sides_.triangle2part[t];
      const TrianglePoints points = chain_.points_of(static_cast<std::int32_t>(t));
      if (has_origin[at(part)] == 0) origin[at(part)] = points[0];
      has_origin[at(part)] = 1;
      const long double six = six_volumes(points, origin[at(part)]);
      volume_[at(behind(t))] += six / 6;
      volume_[at(front(t))] -= six / 6;
      for (const std::int32_t sheet : {behind(t), front(t)}) {
        border_[at(sheet)] += area_of(points);
        part_of[at(sheet)] = part;
      }
    }
    outer_.assign(at(sides_.parts), -1);
    for (std::int32_t sheet = 0; sheet < sides_.sheets; ++sheet) {
      std::int32_t& outer = outer_[at(part_of[at(sheet)])];
      if (outer < 0 || volume_[at(sheet)] < volume_[at(outer)]) outer = sheet;
    }
  }

  /// One of each part that no other part has; -1: there is none.
  std::vector<std::int32_t> vertices_of_parts() const {
    std::vector<std::int32_t> part_of(surface_.vertices.size(), -1);  // -2: of several
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      const std::int32_t part = sides_.triangle2part[t];
      for (const std::int32_t v : surface_.triangles[t]) {
        part_of[at(v)] = part_of[at(v)] == -1 || part_of[at(v)] == part ? part : -2;
      }
    }
    std::vector<std::int32_t> vertices(at(sides_.parts), -1);
    for (std::size_t v = part_of.size(); v-- > 0;) {
      if (part_of[v] >= 0) vertices[at(part_of[v])] = static_cast<std::int32_t>(v);
    }
    return vertices;
  }

  std::int32_t winding_of_others(std::int32_t part, std::int32_t vertex,
                                 const BoxTree& tree) const {
    const Vec3& p = surface_.vertices[at(vertex)];
    std::int32_t winding = 0;
    tree.query({p, {HUGE_VAL, p.y, p.z}}, [&](std::int32_t t) {
      if (sides_.triangle2part[at(t)] == part) return;
      winding += ray_passes(p, chain_.points_of(t)) * chain_.triangles[at(t)].times;
    });
    return winding;
  }

  std::vector<char> settled(double tolerance) const {
    std::vector<char> is_inside(at(sides_.sheets));
    for (std::size_t sheet = 0; sheet < is_inside.size(); ++sheet) {
      is_inside[sheet] = winding_[sheet] > 0 ? 1 : 0;
    }
    std::vector<char> is_thin(at(sides_.sheets), 0);
    for (std::size_t sheet = 0; sheet < is_thin.size(); ++sheet) {
      is_thin[sheet] = std::abs(volume_[sheet]) < tolerance * border_[sheet] / 2 ? 1 : 0;
    }
    // What is round a part has no end.
    for (const std::int32_t outer : outer_) is_thin[at(outer)] = 0;
    std::vector<std::map<std::int32_t, double>> shared(at(sides_.sheets));
    for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
      const double area = area_of(chain_.points_of(static_cast<std::int32_t>(t)));
      if (is_thin[at(behind(t))] != 0) shared[at(behind(t))][front(t)] += area;
      if (is_thin[at(front(t))] != 0) shared[at(front(t))][behind(t)] += area;
    }
    std::vector<char> settled = is_inside;
    for (std::size_t sheet = 0; sheet < shared.size(); ++sheet) {
      double largest = 0;
      for (const auto& [other, area] : shared[sheet]) {
        if (is_thin[at(other)] != 0 || area <= largest) continue;
        largest = area;
        settled[sheet] = is_inside[at(other)];
      }
    }
    return settled;
  }

  const TriangleChain& chain_;
  const SurfaceMesh& surface_;
  SurfaceSides sides_;
  std::vector<long double> volume_;
  std::vector<double> border_;
  std::vector<std::int32_t> winding_;
  std::vector<std::int32_t> outer_;  // of each part
};

}  // namespace

std::optional<std::vector<std::array<bool, 2>>> insides_of(const TriangleChain& chain,
                                                           double tolerance) {
  SurfaceMesh surface{chain.vertices, {}, {}, {}, {}, {}};
  for (const ChainTriangle& t : chain.triangles) surface.triangles.push_back(t.nodes);
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  bool has_open_edge = false;
  for_each_edge(std::span<const EdgeUse>(uses), [&](std::span<const EdgeUse> edge) {
    has_open_edge = has_open_edge || edge.size() < 2;
  });
  if (has_open_edge) return std::nullopt;
  Sheets sheets(chain, surface, join_sides(surface, uses));
  if (!sheets.find_winding_numbers()) return std::nullopt;
  return sheets.insides(tolerance);
}

}  // namespace tetfarm
