#include "mesh/render/metric_ellipses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"

namespace tetfarm {
namespace {

/// How far the ellipse reaches in a direction of length 1.
double reach_in(const EllipseRadii& radii, const Vec2& direction) {
  const double a = radii.first.x * direction.x + radii.first.y * direction.y;
  const double b = radii.second.x * direction.x + radii.second.y * direction.y;
  return std::sqrt(a * a + b * b);
}

/// Half the width and height of the box round the ellipse.
Vec2 half_box(const EllipseRadii& radii) {
  return {reach_in(radii, {1, 0}), reach_in(radii, {0, 1})};
}

Vec2 image(const Metric2& m, const Vec2& v) {
  return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y};
}

/// The chosen ellipses by the cells of a grid over the window that their boxes reach.
class EllipseGrid {
 public:
  EllipseGrid(std::span<const Vec2> points, std::span<const Metric2> metrics,
              const EllipseChoice& choice)
      : points_(points), metrics_(metrics), choice_(choice) {
    const double width = choice.high.x - choice.low.x;
    const double height = choice.high.y - choice.low.y;
    TF_CHECK(width > 0 && height > 0 && choice.distance > 0);
    constexpr double cells_along = 96;
    size_ = std::max(width, height) / cells_along;
    columns_ = cell_at(width) + 1;
    rows_ = cell_at(height) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }

  /// Takes the node unless it comes too near to one that was taken.
  bool take(std::int32_t node) {
    const auto i = static_cast<std::size_t>(node);
    const Vec2 half = half_box(unit_ellipse(metrics_[i]));
    const CellRange here = cells_of(points_[i], {0, 0});
    const CellRange all = cells_of(points_[i], half);
    if (!is_clear(here, i) || !is_clear(all, i)) return false;
    for_each_cell(all, [node](std::vector<std::int32_t>& cell) {
      cell.push_back(node);
      return true;
    });
    return true;
  }

 private:
  struct CellRange {
    int left = 0;
    int right = 0;
    int bottom = 0;
    int top = 0;
  };
  int cell_at(double distance) const {
    constexpr double far = 1e6;
    return static_cast<int>(std::clamp(distance / size_, 0.0, far));
  }
  CellRange cells_of(const Vec2& p, const Vec2& half) const {
    const double room = choice_.distance;
    const auto column = [&](double x) {
      return std::min(cell_at(x - choice_.low.x), columns_ - 1);
    };
    const auto row = [&](double y) { return std::min(cell_at(y - choice_.low.y), rows_ - 1); };
    return {column(p.x - half.x - room), column(p.x + half.x + room), row(p.y - half.y - room),
            row(p.y + half.y + room)};
  }
  template <class Visit>
  bool for_each_cell(const CellRange& range, const Visit& visit) {
    for (int row = range.bottom; row <= range.top; ++row) {
      for (int column = range.left; column <= range.right; ++column) {
        const std::size_t cell =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column);
        if (!visit(cells_[cell])) return false;
      }
    }
    return true;
  }
  bool is_clear(const CellRange& range, std::size_t i) {
    return for_each_cell(range, [&](const std::vector<std::int32_t>& cell) {
      return std::all_of(cell.begin(), cell.end(), [&](std::int32_t other) {
        const auto j = static_cast<std::size_t>(other);
        return are_apart(points_[i], metrics_[i], points_[j], metrics_[j], choice_.distance);
      });
    });
  }

  std::span<const Vec2> points_;
  std::span<const Metric2> metrics_;
  EllipseChoice choice_;
  double size_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::vector<std::int32_t>> cells_;
};

bool is_in_window(const Vec2& p, const EllipseChoice& choice) {
  return p.x >= choice.low.x && p.x <= choice.high.x && p.y >= choice.low.y && p.y <= choice.high.y;
}

}  // namespace

EllipseRadii unit_ellipse(const Metric2& metric) {
  TF_CHECK(is_metric(metric));
  // Cholesky's factor of the metric takes the ellipse to the circle.
  const double along = 1 / std::sqrt(metric.xx);
  const double across = std::sqrt(metric.xx / determinant(metric));
  return {{along, 0}, {-metric.xy / metric.xx * across, across}};
}

std::vector<Vec2> ellipse_points(const EllipseRadii& radii, int count) {
  TF_CHECK(count > 0 && count % 4 == 0);
  const int quarter = count / 4;
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double t = static_cast<double>(k % quarter) / quarter;
    const Vec2 q{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
    const std::array<Vec2, 4> turned = {q, Vec2{-q.y, q.x}, Vec2{-q.x, -q.y}, Vec2{q.y, -q.x}};
    const Vec2& c = turned[static_cast<std::size_t>(k / quarter)];
    points.push_back(
        {c.x * radii.first.x + c.y * radii.second.x, c.x * radii.first.y + c.y * radii.second.y});
  }
  return points;
}

bool are_apart(const Vec2& p, const Metric2& of_p, const Vec2& q, const Metric2& of_q,
               double distance) {
  const Vec2 way{q.x - p.x, q.y - p.y};
  const EllipseRadii first = unit_ellipse(of_p);
  const EllipseRadii second = unit_ellipse(of_q);
  const Metric2 sum{of_p.xx + of_q.xx, of_p.xy + of_q.xy, of_p.yy + of_q.yy};
  // Normals of the lines that may part them: along the way, and those of the ellipses where the
  // way leaves them.
  for (const Vec2& normal : {way, image(of_p, way), image(of_q, way), image(sum, way)}) {
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    if (!(length > 0)) continue;
    const Vec2 unit{normal.x / length, normal.y / length};
    const double between = std::fabs(unit.x * way.x + unit.y * way.y);
    if (between > reach_in(first, unit) + reach_in(second, unit) + distance) return true;
  }
  return false;
}

std::vector<std::int32_t> spaced_ellipses(std::span<const Vec2> points,
                                          std::span<const Metric2> metrics,
                                          const EllipseChoice& choice) {
  TF_CHECK(points.size() == metrics.size());
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_in_window(points[i], choice)) continue;
    const Vec2 half = half_box(unit_ellipse(metrics[i]));
    if (2 * std::max(half.x, half.y) < choice.smallest) continue;
    order.push_back(static_cast<std::int32_t>(i));
  }
  std::vector<double> determinants;
  for (const Metric2& m : metrics) determinants.push_back(determinant(m));
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return determinants[static_cast<std::size_t>(a)] > determinants[static_cast<std::size_t>(b)];
  });
  EllipseGrid grid(points, metrics, choice);
  std::vector<std::int32_t> chosen;
  for (const std::int32_t node : order) {
    if (grid.take(node)) chosen.push_back(node);
  }
  return chosen;
}

}  // namespace tetfarm
