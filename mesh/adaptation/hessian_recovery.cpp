#include "mesh/adaptation/hessian_recovery.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::size_t fewest_neighbours = 8;
constexpr int most_rings = 5;
constexpr Eigen::Index unknowns = 5;

/// The nodes joined to each node by an edge, one list behind the other.
struct Adjacency {
  std::vector<std::int32_t> starts;
  std::vector<std::int32_t> nodes;
};

Adjacency adjacency_of(const TriangleComplex& complex) {
  Adjacency adjacency;
  adjacency.starts.assign(complex.points.size() + 1, 0);
  const std::vector<std::array<std::int32_t, 2>> edges = edges_of(complex);
  for (const auto& [a, b] : edges) {
    ++adjacency.starts[at(a) + 1];
    ++adjacency.starts[at(b) + 1];
  }
  for (std::size_t i = 1; i < adjacency.starts.size(); ++i) {
    adjacency.starts[i] += adjacency.starts[i - 1];
  }
  adjacency.nodes.resize(at(adjacency.starts.back()));
  std::vector<std::int32_t> fill(adjacency.starts.begin(), adjacency.starts.end() - 1);
  for (const auto& [a, b] : edges) {
    adjacency.nodes[at(fill[at(a)]++)] = b;
    adjacency.nodes[at(fill[at(b)]++)] = a;
  }
  return adjacency;
}

/// The nodes of two rings round one, or of more where these are too few.
class Rings {
 public:
  explicit Rings(const Adjacency& adjacency)
      : adjacency_(adjacency), stamps_(adjacency.starts.size(), -1) {}

  const std::vector<std::int32_t>& round(std::int32_t node, std::size_t fewest) {
    nodes_.clear();
    stamps_[at(node)] = node;
    add_neighbours(node, node);
    std::size_t begin = 0;
    for (int ring = 1; ring < most_rings && (ring < 2 || nodes_.size() < fewest); ++ring) {
      const std::size_t end = nodes_.size();
      for (; begin < end; ++begin) add_neighbours(nodes_[begin], node);
    }
    return nodes_;
  }

 private:
  void add_neighbours(std::int32_t of, std::int32_t stamp) {
    for (std::int32_t k = adjacency_.starts[at(of)]; k < adjacency_.starts[at(of) + 1]; ++k) {
      const std::int32_t neighbour = adjacency_.nodes[at(k)];
      if (stamps_[at(neighbour)] == stamp) continue;
      stamps_[at(neighbour)] = stamp;
      nodes_.push_back(neighbour);
    }
  }

  const Adjacency& adjacency_;
  std::vector<std::int32_t> stamps_;
  std::vector<std::int32_t> nodes_;
};

/// Offsets in the frame in which their mean square is 1 in every direction, so that a stretched
/// mesh is fitted as well as an even one: offset = frame * whitened.
Eigen::Matrix2d whitening_frame(const std::vector<Eigen::Vector2d>& offsets) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& offset : offsets) sum += offset * offset.transpose();
  sum /= static_cast<double>(offsets.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(sum);
  const Eigen::Vector2d sizes =
      solver.eigenvalues().cwiseMax(1e-24 * solver.eigenvalues()(1)).cwiseSqrt();
  return solver.eigenvectors() * sizes.asDiagonal();
}

Metric2 fitted_hessian(const TriangleComplex& complex, std::span<const double> values,
                       std::int32_t node, const std::vector<std::int32_t>& round) {
  std::vector<Eigen::Vector2d> offsets;
  for (const std::int32_t v : round) {
    offsets.emplace_back(complex.point(v).x - complex.point(node).x,
                         complex.point(v).y - complex.point(node).y);
  }
  const Eigen::Matrix2d frame = whitening_frame(offsets);
  const Eigen::Matrix2d inverse = frame.inverse();
  const auto rows = static_cast<Eigen::Index>(round.size());
  Eigen::Matrix<double, Eigen::Dynamic, unknowns> system(rows, unknowns);
  Eigen::VectorXd right(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Eigen::Vector2d w = inverse * offsets[at(k)];
    const double weight = 1 / std::max(w.norm(), 1e-6);
    system.row(k) << w.x(), w.y(), w.x() * w.x() / 2, w.x() * w.y(), w.y() * w.y() / 2;
    system.row(k) *= weight;
    right(k) = weight * (values[at(round[at(k)])] - values[at(node)]);
  }
  const Eigen::Matrix<double, unknowns, 1> fit = system.colPivHouseholderQr().solve(right);
  Eigen::Matrix2d hessian;
  hessian << fit(2), fit(3), fit(3), fit(4);
  const Eigen::Matrix2d turned = inverse.transpose() * hessian * inverse;
  return {turned(0, 0), (turned(0, 1) + turned(1, 0)) / 2, turned(1, 1)};
}

std::vector<Metric2> quadratic_fits(const TriangleComplex& complex,
                                    std::span<const double> values) {
  const Adjacency adjacency = adjacency_of(complex);
  Rings rings(adjacency);
  std::vector<Metric2> hessians(complex.points.size(), Metric2{0, 0, 0});
  for (std::size_t v = 0; v < complex.points.size(); ++v) {
    if (complex.node2triangle[v] < 0) continue;
    const auto node = static_cast<std::int32_t>(v);
    const std::vector<std::int32_t>& round = rings.round(node, fewest_neighbours);
    if (round.size() >= static_cast<std::size_t>(unknowns)) {
      hessians[v] = fitted_hessian(complex, values, node, round);
    }
  }
  return hessians;
}

/// Gradients at the nodes: the means of those of the triangles round them, by area.
std::vector<Vec2> averaged_gradients(const TriangleComplex& complex,
                                     std::span<const double> values) {
  std::vector<Vec2> sums(complex.points.size());
  std::vector<double> areas(complex.points.size(), 0);
  for (const TriangleComplex::Nodes& n : complex.triangles) {
    const Vec2& a = complex.point(n[0]);
    const Vec2& b = complex.point(n[1]);
    const Vec2& c = complex.point(n[2]);
    const double doubled = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double ub = values[at(n[1])] - values[at(n[0])];
    const double uc = values[at(n[2])] - values[at(n[0])];
    // The gradient times twice the area.
    const Vec2 part{ub * (c.y - a.y) - uc * (b.y - a.y), uc * (b.x - a.x) - ub * (c.x - a.x)};
    for (const std::int32_t v : n) {
      sums[at(v)] = {sums[at(v)].x + part.x, sums[at(v)].y + part.y};
      areas[at(v)] += doubled;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (areas[v] > 0) sums[v] = {sums[v].x / areas[v], sums[v].y / areas[v]};
  }
  return sums;
}

std::vector<Metric2> double_projections(const TriangleComplex& complex,
                                        std::span<const double> values) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Vec2& gradient : averaged_gradients(complex, values)) {
    x.push_back(gradient.x);
    y.push_back(gradient.y);
  }
  const std::vector<Vec2> of_x = averaged_gradients(complex, x);
  const std::vector<Vec2> of_y = averaged_gradients(complex, y);
  std::vector<Metric2> hessians;
  for (std::size_t v = 0; v < of_x.size(); ++v) {
    hessians.push_back({of_x[v].x, (of_x[v].y + of_y[v].x) / 2, of_y[v].y});
  }
  return hessians;
}

}  // namespace

std::vector<Metric2> recover_hessians(const TriangleComplex& complex,
                                      std::span<const double> values, HessianRecovery recovery) {
  TF_CHECK(values.size() == complex.points.size());
  return recovery == HessianRecovery::quadratic_fit ? quadratic_fits(complex, values)
                                                    : double_projections(complex, values);
}

}  // namespace tetfarm
