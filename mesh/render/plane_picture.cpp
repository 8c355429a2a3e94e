#include "mesh/render/plane_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "mesh/render/metric_ellipses.h"
#include "mesh/render/palette.h"

namespace tetfarm {
namespace {

/// An edge of triangles, with the smallest height of a triangle over it in pixels.
struct PlaneEdge {
  std::int32_t a = 0;
  std::int32_t b = 0;
  double height = 0;
  bool is_border = true;
};

const Vec2& point(const PlaneMesh& mesh, std::int32_t v) {
  return mesh.points[static_cast<std::size_t>(v)];
}

template <class Value>
const Value& at_node(std::span<const Value> values, std::int32_t v) {
  return values[static_cast<std::size_t>(v)];
}

double height_over(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u{b.x - a.x, b.y - a.y};
  const double length = std::sqrt(u.x * u.x + u.y * u.y);
  return length > 0 ? std::fabs(u.x * (c.y - a.y) - u.y * (c.x - a.x)) / length : 0;
}

/// Each once, sorted by their nodes.
std::vector<PlaneEdge> edges_of_triangles(const PlaneMesh& mesh, double pixels_per_unit) {
  std::vector<PlaneEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = triangle[i];
      const std::int32_t b = triangle[(i + 1) % 3];
      const double height =
          height_over(point(mesh, a), point(mesh, b), point(mesh, triangle[(i + 2) % 3]));
      edges.push_back({std::min(a, b), std::max(a, b), height * pixels_per_unit, true});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const PlaneEdge& s, const PlaneEdge& t) {
    return std::tie(s.a, s.b, s.height) < std::tie(t.a, t.b, t.height);
  });
  std::vector<PlaneEdge> once;
  for (const PlaneEdge& edge : edges) {
    const bool is_again = !once.empty() && once.back().a == edge.a && once.back().b == edge.b;
    if (is_again) {
      once.back().is_border = false;
    } else {
      once.push_back(edge);
    }
  }
  return once;
}

/// The place of each number among those that there are.
std::map<std::int32_t, std::int32_t> ranks_of(const std::vector<std::int32_t>& numbers) {
  std::map<std::int32_t, std::int32_t> ranks;
  for (const std::int32_t number : numbers) ranks.emplace(number, 0);
  std::int32_t next = 0;
  for (auto& [number, rank] : ranks) rank = next++;
  return ranks;
}

Colour region_fill(std::int32_t rank) {
  constexpr float white = 0.55F;
  return mixed(palette_colour(rank), {1, 1, 1}, white);
}

PlaneBox box_of_triangles(const PlaneMesh& mesh) {
  PlaneBox box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const auto& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) {
      const Vec2& p = point(mesh, v);
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

FieldLevels levels_of(std::span<const double> field, const PlanePictureOptions& options) {
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  FieldLevels levels{*low, *high, options.levels};
  if (options.range) {
    levels.low = options.range->front();
    levels.high = options.range->back();
    if (!(levels.low < levels.high)) {
      throw UsageError("the first number must be below the second", "--range");
    }
  } else if (!(levels.high - levels.low > 1e-12 * std::max(std::fabs(*low), std::fabs(*high)))) {
    // A field of one value: a band on either side of it.
    const double half = *low == 0 ? 1 : 0.5 * std::fabs(*low);
    levels.low -= half;
    levels.high += half;
  }
  if (!std::isfinite(levels.high - levels.low)) {
    throw UsageError("the values are too far apart for even bands",
                     options.range ? "--range" : "--field");
  }
  return levels;
}

/// One picture in the making.
class PlaneDrawing {
 public:
  PlaneDrawing(const PlaneMesh& mesh, const PlaneContents& contents,
               const PlanePictureOptions& options)
      : mesh_(mesh),
        contents_(contents),
        options_(options),
        regions_(ranks_of(mesh.regions)),
        patches_(ranks_of(mesh.patches)),
        frame_(plane_frame(box_of_triangles(mesh), options.window, options.width, options.height,
                           beside())),
        canvas_(options.width, options.height, options.samples) {}

  Picture draw() {
    edges_ = edges_of_triangles(mesh_, frame_.pixels_per_unit);
    canvas_.clip_to(frame_.pixels);
    if (has_field()) {
      const FieldLevels levels = levels_of(contents_.field, options_);
      fill_field(levels);
      draw_inside();
      draw_colour_bar(canvas_, frame_, levels);
    } else {
      fill_regions();
      draw_inside();
      if (beside() == Beside::legend) draw_legend(canvas_, frame_, legend_entries());
    }
    draw_axes(canvas_, frame_);
    return canvas_.picture();
  }

 private:
  bool has_field() const { return !contents_.field.empty(); }
  bool has_metrics() const { return !contents_.metrics.empty(); }
  /// Where contents are drawn, the boundary is, like them, in ink.
  bool colours_patches() const { return !has_field() && !has_metrics(); }
  Beside beside() const {
    if (has_field()) return Beside::colour_bar;
    const bool has_several = regions_.size() > 1 || patches_.size() > 1;
    return colours_patches() && has_several ? Beside::legend : Beside::nothing;
  }

  std::array<Vec2, 3> corners(std::size_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return {frame_.to_pixel(point(mesh_, a)), frame_.to_pixel(point(mesh_, b)),
            frame_.to_pixel(point(mesh_, c))};
  }

  void fill_regions() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Colour colour = region_fill(regions_.at(mesh_.regions[t]));
      canvas_.fill(corners(t), [&colour](const auto&) { return colour; });
    }
  }

  void fill_field(const FieldLevels& levels) {
    std::vector<Colour> colours;
    for (int level = 0; level < levels.count; ++level) {
      colours.push_back(levels.colour_of_level(level));
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& triangle = mesh_.triangles[t];
      const std::array<double, 3> value = {at_node(contents_.field, triangle[0]),
                                           at_node(contents_.field, triangle[1]),
                                           at_node(contents_.field, triangle[2])};
      canvas_.fill(corners(t), [&](const std::array<double, 3>& share) {
        const double here = share[0] * value[0] + share[1] * value[1] + share[2] * value[2];
        return colours[static_cast<std::size_t>(levels.level_of(here))];
      });
    }
  }

  /// What lies within the frame, over the areas.
  void draw_inside() {
    draw_mesh_edges();
    draw_boundary();
    if (has_metrics()) draw_ellipses();
    canvas_.clip_to_all();
  }

  Stroke stroke(std::int32_t a, std::int32_t b, double width) const {
    return {frame_.to_pixel(point(mesh_, a)), frame_.to_pixel(point(mesh_, b)), width};
  }

  /// Thinner where triangles are only a few pixels high, so that dense parts become a tone and not
  /// a blot.
  void draw_mesh_edges() {
    constexpr double share_of_height = 0.16;
    const float opacity = has_metrics() ? 0.3F : has_field() ? 0.5F : 0.75F;
    std::vector<Stroke> strokes;
    for (const PlaneEdge& edge : edges_) {
      const double width = std::min(options_.edge_width, share_of_height * edge.height);
      if (width > 0) strokes.push_back(stroke(edge.a, edge.b, width));
    }
    canvas_.draw_mesh_lines(strokes, plane_ink, opacity);
  }

  double boundary_width() const { return std::max(0.2 * frame_.text_height, 1.5); }

  /// The border of the triangles, and the edges of each patch over it.
  void draw_boundary() {
    std::vector<Stroke> border;
    for (const PlaneEdge& edge : edges_) {
      if (edge.is_border) border.push_back(stroke(edge.a, edge.b, 0.6 * boundary_width()));
    }
    canvas_.draw_line(border, plane_ink);
    if (!colours_patches()) return;
    std::vector<std::vector<Stroke>> of_patch(patches_.size());
    for (std::size_t k = 0; k < mesh_.edges.size(); ++k) {
      const auto rank = static_cast<std::size_t>(patches_.at(mesh_.patches[k]));
      of_patch[rank].push_back(stroke(mesh_.edges[k][0], mesh_.edges[k][1], boundary_width()));
    }
    for (std::size_t rank = 0; rank < of_patch.size(); ++rank) {
      canvas_.draw_line(of_patch[rank], line_colour(static_cast<std::int32_t>(rank)));
    }
  }

  void draw_ellipses() {
    constexpr double distance = 3;  // pixels
    constexpr double smallest = 4;
    constexpr int points_round = 64;
    const double unit = 1 / frame_.pixels_per_unit;
    const std::vector<std::int32_t> nodes =
        spaced_ellipses(mesh_.points, contents_.metrics,
                        {frame_.low, frame_.high(), distance * unit, smallest * unit});
    const double width = std::max(0.11 * frame_.text_height, 1.0);
    std::vector<Stroke> strokes;
    for (const std::int32_t v : nodes) {
      std::vector<Vec2> round =
          ellipse_points(unit_ellipse(at_node(contents_.metrics, v)), points_round);
      for (Vec2& p : round) {
        p = frame_.to_pixel({p.x + point(mesh_, v).x, p.y + point(mesh_, v).y});
      }
      for (std::size_t i = 0; i < round.size(); ++i) {
        strokes.push_back({round[i], round[(i + 1) % round.size()], width});
      }
    }
    if (!has_field()) {
      canvas_.draw_line(strokes, line_colour(0));
      return;
    }
    // On colours of any lightness: white with a dark rim.
    std::vector<Stroke> rims = strokes;
    for (Stroke& rim : rims) rim.width += 1.5;
    canvas_.draw_line(rims, plane_ink, 0.6F);
    canvas_.draw_line(strokes, {1, 1, 1});
  }

  std::vector<LegendEntry> legend_entries() const {
    std::vector<LegendEntry> entries;
    for (const auto& [number, rank] : patches_) {
      entries.push_back({"patch " + std::to_string(number), line_colour(rank), true});
    }
    if (regions_.size() < 2) return entries;
    for (const auto& [number, rank] : regions_) {
      entries.push_back({"region " + std::to_string(number), region_fill(rank), false});
    }
    return entries;
  }

  const PlaneMesh& mesh_;
  const PlaneContents& contents_;
  const PlanePictureOptions& options_;
  std::map<std::int32_t, std::int32_t> regions_;
  std::map<std::int32_t, std::int32_t> patches_;
  PlaneFrame frame_;
  PlaneCanvas canvas_;
  std::vector<PlaneEdge> edges_;
};

}  // namespace

void require_nodes_of_mesh(const PlaneMesh& mesh) {
  const auto require = [&mesh](std::int32_t v, const char* what, std::size_t i) {
    if (v >= 0 && static_cast<std::size_t>(v) < mesh.points.size()) return;
    throw InvalidInput(std::string(what) + " " + std::to_string(i + 1) + " has node " +
                           std::to_string(std::int64_t{v} + 1) + "; there are " +
                           std::to_string(mesh.points.size()),
                       mesh.name);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) require(v, "triangle", t);
  }
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    for (const std::int32_t v : mesh.edges[k]) require(v, "edge", k);
  }
}

Picture plane_picture(const PlaneMesh& mesh, const PlaneContents& contents,
                      const PlanePictureOptions& options) {
  require_nodes_of_mesh(mesh);
  TF_CHECK(!mesh.triangles.empty());
  TF_CHECK(contents.field.empty() || contents.field.size() == mesh.points.size());
  TF_CHECK(contents.metrics.empty() || contents.metrics.size() == mesh.points.size());
  return PlaneDrawing(mesh, contents, options).draw();
}

}  // namespace tetfarm
