#include "mesh/render/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr Colour ink{0.10F, 0.11F, 0.14F};
// Of a place in samples: what lies on the edge of two triangles must not fall between them.
constexpr double rounding = 1e-9;
constexpr float edge_share = 0.75F;     // of ink on an edge
constexpr float outline_share = 0.55F;  // of ink on an outline

/// The distance of points from an edge's line, positive inside, in samples.
struct EdgeLine {
  double a = 0;
  double b = 0;
  double c = 0;
  double height = 0;  // of the triangle over the edge

  double at(double x, double y) const { return a * x + b * y + c; }
};

EdgeLine line_through(const Seen& p, const Seen& q, const Seen& opposite) {
  const double dx = q.x - p.x;
  const double dy = q.y - p.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return {};
  EdgeLine line{-dy / length, dx / length, (dy * p.x - dx * p.y) / length, 0};
  line.height = line.at(opposite.x, opposite.y);
  if (line.height < 0) line = {-line.a, -line.b, -line.c, -line.height};
  return line;
}

std::uint8_t byte_of(float level) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(level, 0.0F, 1.0F)));
}

}  // namespace

Canvas::Canvas(const CanvasOptions& options)
    : options_(options),
      columns_(options.width * options.samples),
      rows_(options.height * options.samples),
      samples_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
               Sample{std::numeric_limits<float>::infinity(), options.background}) {}

void Canvas::draw(const std::array<Seen, 3>& corners, const Colour& colour,
                  const std::array<bool, 3>& has_edge) {
  const double scale = options_.samples;
  std::array<Seen, 3> p = corners;
  for (Seen& corner : p) corner = {corner.x * scale, corner.y * scale, corner.depth};
  const std::array<EdgeLine, 3> lines = {line_through(p[1], p[2], p[0]),
                                         line_through(p[2], p[0], p[1]),
                                         line_through(p[0], p[1], p[2])};
  const double smallest_height = std::min({lines[0].height, lines[1].height, lines[2].height});
  if (!(smallest_height > 1e-9)) return;
  // Edges of triangles that are a few pixels large would cover all of them.
  const double pixels = smallest_height / scale;
  const auto share = edge_share * static_cast<float>(std::clamp((pixels - 2) / 8, 0.0, 1.0));
  const double half_width = 0.5 * options_.edge_width * scale;
  const Colour edge_colour = mixed(colour, ink, share);
  const auto [low_x, high_x] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [low_y, high_y] = std::minmax({p[0].y, p[1].y, p[2].y});
  const auto first = [](double low) { return static_cast<int>(std::floor(std::max(low, 0.0))); };
  const auto last = [](double high, int count) {
    return static_cast<int>(std::ceil(std::min(high, static_cast<double>(count - 1))));
  };
  for (int row = first(low_y); row <= last(high_y, rows_); ++row) {
    for (int column = first(low_x); column <= last(high_x, columns_); ++column) {
      const double x = column + 0.5;
      const double y = row + 0.5;
      const std::array<double, 3> inside = {lines[0].at(x, y), lines[1].at(x, y),
                                            lines[2].at(x, y)};
      const double nearest = std::min({inside[0], inside[1], inside[2]});
      if (nearest < -rounding) continue;
      // 1 / depth is linear in the picture.
      double inverse = 0;
      for (std::size_t i = 0; i < 3; ++i) inverse += inside[i] / lines[i].height / p[i].depth;
      Sample& sample = samples_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                static_cast<std::size_t>(column)];
      const auto depth = static_cast<float>(1 / inverse);
      if (!(depth < sample.depth)) continue;
      double to_edge = HUGE_VAL;
      for (std::size_t i = 0; i < 3; ++i) {
        if (has_edge[i]) to_edge = std::min(to_edge, std::max(inside[i], 0.0));
      }
      sample = {depth, to_edge < half_width ? edge_colour : colour};
    }
  }
}

float Canvas::depth_at(int x, int y) const {
  return samples_[static_cast<std::size_t>(std::clamp(y, 0, rows_ - 1)) *
                      static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(std::clamp(x, 0, columns_ - 1))]
      .depth;
}

/// Whether what is drawn here ends, with something farther away beside it. A slope is no step: the
/// depth must change more on the far side than on the near side.
bool Canvas::is_on_outline(int x, int y, double outline_depth) const {
  const float here = depth_at(x, y);
  const int reach = options_.samples;
  constexpr std::array<std::array<int, 2>, 4> ways = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (const auto& [dx, dy] : ways) {
    const float there = depth_at(x + reach * dx, y + reach * dy);
    const float behind = depth_at(x - reach * dx, y - reach * dy);
    const double step = static_cast<double>(there) - here;
    if (step > outline_depth && !(step < 4 * std::fabs(static_cast<double>(here) - behind))) {
      return true;
    }
  }
  return false;
}

Picture Canvas::picture(double outline_depth) const {
  TF_CHECK(options_.width > 0 && options_.height > 0 && options_.samples > 0);
  Picture picture{options_.width, options_.height, {}};
  const auto weight = 1.0F / static_cast<float>(options_.samples * options_.samples);
  for (int y = 0; y < options_.height; ++y) {
    for (int x = 0; x < options_.width; ++x) {
      Colour sum;
      for (int i = 0; i < options_.samples * options_.samples; ++i) {
        const int column = x * options_.samples + i % options_.samples;
        const int row = y * options_.samples + i / options_.samples;
        Colour colour =
            samples_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(column)]
                .colour;
        if (std::isfinite(depth_at(column, row)) && is_on_outline(column, row, outline_depth)) {
          colour = mixed(colour, ink, outline_share);
        }
        sum = {sum.red + colour.red * weight, sum.green + colour.green * weight,
               sum.blue + colour.blue * weight};
      }
      for (const float level : {sum.red, sum.green, sum.blue}) {
        picture.bytes.push_back(byte_of(level));
      }
    }
  }
  return picture;
}

}  // namespace tetfarm
