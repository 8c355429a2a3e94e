#include "mesh/render/plane_canvas.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace tetfarm {
namespace {

/// The whole number below, within bounds; whatever the number.
int floor_within(double value, int low, int high) {
  if (!(value > low)) return low;
  return value < high ? static_cast<int>(std::floor(value)) : high;
}

bool is_before(const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// On which side of an edge points lie. The two triangles of an edge, which see it from either
/// end, have the same numbers with opposite signs: it is worked out from the same end.
class Side {
 public:
  Side(const Vec2& from, const Vec2& to) : is_turned_(is_before(to, from)) {
    start_ = is_turned_ ? to : from;
    const Vec2& end = is_turned_ ? from : to;
    way_ = {end.x - start_.x, end.y - start_.y};
  }
  double at(double x, double y) const {
    const double value = way_.x * (y - start_.y) - way_.y * (x - start_.x);
    return is_turned_ ? -value : value;
  }
  /// Of points on the edge itself, one of the two triangles has them.
  bool has(double value) const { return value > 0 || (value == 0 && !is_turned_); }

 private:
  bool is_turned_;
  Vec2 start_;
  Vec2 way_;
};

struct Span {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Between which x a triangle lies at y.
Span span_at(const std::array<Vec2, 3>& corners, double y) {
  Span span;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& p = corners[i];
    const Vec2& q = corners[(i + 1) % 3];
    if ((p.y < y && q.y < y) || (p.y > y && q.y > y)) continue;
    if (p.y == q.y) {
      span.add(p.x);
      span.add(q.x);
    } else {
      span.add(p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)));
    }
  }
  return span;
}

std::uint8_t byte_of_level(float level) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(level, 0.0F, 1.0F)));
}

/// A stroke seen from its own direction.
struct StrokeAxes {
  double length = 0;
  Vec2 along{1, 0};

  explicit StrokeAxes(const Stroke& stroke) {
    const Vec2 way{stroke.to.x - stroke.from.x, stroke.to.y - stroke.from.y};
    length = std::sqrt(way.x * way.x + way.y * way.y);
    if (length > 0) along = {way.x / length, way.y / length};
  }
};

}  // namespace

PlaneCanvas::PlaneCanvas(int width, int height, int samples)
    : width_(width), height_(height), samples_(samples) {
  TF_CHECK(width > 0 && height > 0 && samples > 0);
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  pixels_.resize(count);
  cover_.resize(count, 0);
  clip_to_all();
}

void PlaneCanvas::clip_to(const PixelBox& box) {
  clip_ = {std::clamp(box.left, 0, width_), std::clamp(box.top, 0, height_),
           std::clamp(box.right, 0, width_), std::clamp(box.bottom, 0, height_)};
}

void PlaneCanvas::fill(const std::array<Vec2, 3>& corners, const Shade& shade) {
  std::array<Vec2, 3> p = corners;
  if (Side(p[0], p[1]).at(p[2].x, p[2].y) < 0) std::swap(p[1], p[2]);
  const bool is_turned = p[1] == corners[2];
  const std::array<Side, 3> sides = {Side(p[1], p[2]), Side(p[2], p[0]), Side(p[0], p[1])};
  const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
  const double per_pixel = samples_;
  const auto share = 1 / static_cast<float>(samples_ * samples_);
  const int last_row =
      floor_within(high * per_pixel, clip_.top * samples_ - 1, clip_.bottom * samples_ - 1);
  for (int row = floor_within(low * per_pixel - 1, clip_.top * samples_, clip_.bottom * samples_);
       row <= last_row; ++row) {
    const double y = (row + 0.5) / per_pixel;
    const Span span = span_at(p, y);
    const int last = floor_within(span.high * per_pixel + 1, clip_.left * samples_ - 1,
                                  clip_.right * samples_ - 1);
    for (int column =
             floor_within(span.low * per_pixel - 2, clip_.left * samples_, clip_.right * samples_);
         column <= last; ++column) {
      const double x = (column + 0.5) / per_pixel;
      std::array<double, 3> value = {sides[0].at(x, y), sides[1].at(x, y), sides[2].at(x, y)};
      if (!sides[0].has(value[0]) || !sides[1].has(value[1]) || !sides[2].has(value[2])) continue;
      const double sum = value[0] + value[1] + value[2];
      if (!(sum > 0)) continue;
      for (double& one : value) one /= sum;
      if (is_turned) std::swap(value[1], value[2]);
      const Colour colour = shade(value);
      Pixel& pixel = pixels_[index(column / samples_, row / samples_)];
      pixel.sum = {pixel.sum.red + share * colour.red, pixel.sum.green + share * colour.green,
                   pixel.sum.blue + share * colour.blue};
      pixel.weight += share;
    }
  }
}

/// Calls cover(index, along, across) for the pixels whose middles may be near enough: how far they
/// are from the start along the stroke, and from its line.
template <class Cover>
void PlaneCanvas::cover_along(const Stroke& stroke, const Cover& cover) {
  const StrokeAxes axes(stroke);
  const double reach = stroke.width / 2 + 1;
  const auto [left, right] = std::minmax({stroke.from.x, stroke.to.x});
  const auto [top, bottom] = std::minmax({stroke.from.y, stroke.to.y});
  const int first_row = floor_within(top - reach, clip_.top, clip_.bottom);
  const int last_row = floor_within(bottom + reach, clip_.top - 1, clip_.bottom - 1);
  for (int row = first_row; row <= last_row; ++row) {
    const double y = row + 0.5 - stroke.from.y;
    double low = left - reach;
    double high = right + reach;
    if (std::fabs(axes.along.y) > 1e-3) {
      const double middle = stroke.from.x + y * (axes.along.x / axes.along.y);
      const double half = reach / std::fabs(axes.along.y);
      low = std::max(low, middle - half);
      high = std::min(high, middle + half);
    }
    const int last = floor_within(high + 1, clip_.left - 1, clip_.right - 1);
    const int first = floor_within(low - 1, clip_.left, clip_.right);
    for (int column = first; column <= last; ++column) {
      const double x = column + 0.5 - stroke.from.x;
      cover(index(column, row), x * axes.along.x + y * axes.along.y,
            x * axes.along.y - y * axes.along.x, axes.length);
    }
    if (first > last) continue;
    covered_ = {std::min(covered_.left, first), std::min(covered_.top, row),
                std::max(covered_.right, last + 1), std::max(covered_.bottom, row + 1)};
  }
}

void PlaneCanvas::draw_mesh_lines(std::span<const Stroke> strokes, const Colour& colour,
                                  float opacity) {
  covered_ = {width_, height_, 0, 0};
  for (const Stroke& stroke : strokes) {
    const double width = stroke.width;
    cover_along(stroke, [&](std::size_t i, double along, double across, double length) {
      const double side =
          std::clamp(width / 2 + 0.5 - std::fabs(across), 0.0, std::min(1.0, width));
      const double way =
          std::clamp(std::min(along, length - along) + 0.5, 0.0, std::min(1.0, length));
      cover_[i] += static_cast<float>(side * way);
    });
  }
  blend_cover(colour, opacity);
}

void PlaneCanvas::draw_line(std::span<const Stroke> strokes, const Colour& colour, float opacity) {
  covered_ = {width_, height_, 0, 0};
  for (const Stroke& stroke : strokes) {
    const double width = stroke.width;
    cover_along(stroke, [&](std::size_t i, double along, double across, double length) {
      const double beyond = along - std::clamp(along, 0.0, length);
      const double distance = std::sqrt(across * across + beyond * beyond);
      const double share = std::clamp(width / 2 + 0.5 - distance, 0.0, std::min(1.0, width));
      cover_[i] = std::max(cover_[i], static_cast<float>(share));
    });
  }
  blend_cover(colour, opacity);
}

void PlaneCanvas::blend_cover(const Colour& colour, float opacity) {
  for (int row = covered_.top; row < covered_.bottom; ++row) {
    for (int column = covered_.left; column < covered_.right; ++column) {
      float& cover = cover_[index(column, row)];
      if (cover == 0) continue;
      const float share = opacity * std::min(cover, 1.0F);
      cover = 0;
      Pixel& pixel = pixels_[index(column, row)];
      if (pixel.weight > 1) {
        const float weight = 1 / pixel.weight;
        pixel = {{pixel.sum.red * weight, pixel.sum.green * weight, pixel.sum.blue * weight}, 1};
      }
      pixel.sum = mixed(pixel.sum, colour, share);
      pixel.weight += (1 - pixel.weight) * share;
    }
  }
}

Picture PlaneCanvas::picture() const {
  Picture picture{width_, height_, {}};
  picture.bytes.reserve(3 * pixels_.size());
  for (const Pixel& pixel : pixels_) {
    const float white = std::max(0.0F, 1 - pixel.weight);
    const float scale = 1 / std::max(1.0F, pixel.weight);
    for (const float level : {pixel.sum.red, pixel.sum.green, pixel.sum.blue}) {
      picture.bytes.push_back(byte_of_level(level * scale + white));
    }
  }
  return picture;
}

}  // namespace tetfarm
