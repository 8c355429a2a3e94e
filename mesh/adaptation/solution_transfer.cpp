#include "mesh/adaptation/solution_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/conservative_transfer.h"
#include "mesh/adaptation/mesh_location.h"
#include "mesh/adaptation/solution_interpolation.h"

namespace tetfarm {
namespace {

/// Nearer to the old mesh than this share of its size a node is in it: new nodes on a straight side
/// are off it by rounding.
constexpr double rounding_share = 1e-12;

Box3 used_box(const TriangleComplex& complex) {
  Box3 box;
  for (const TriangleComplex::Nodes& nodes : complex.triangles) {
    for (const std::int32_t v : nodes) box.add(Vec3{complex.point(v).x, complex.point(v).y, 0});
  }
  return box;
}

std::string box_text(const Box3& box) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "x from %.12g to %.12g, y from %.12g to %.12g", box.low.x,
                box.high.x, box.low.y, box.high.y);
  return text.data();
}

/// The middle of a triangle of one mesh lies in the other mesh.
bool has_middle_in(const TriangleComplex& complex, const MeshLocation& other) {
  std::int32_t hint = 0;
  for (const TriangleComplex::Nodes& n : complex.triangles) {
    const Vec2& a = complex.point(n[0]);
    const Vec2& b = complex.point(n[1]);
    const Vec2& c = complex.point(n[2]);
    if (other.find({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, hint)) return true;
  }
  return false;
}

void check_overlap(const MeshLocation& from, const TriangleComplex& to,
                   const std::string& from_name, const std::string& to_name) {
  const Box3 from_box = used_box(from.complex());
  const Box3 to_box = used_box(to);
  if (from_box.overlaps(to_box) &&
      (has_middle_in(to, from) || has_middle_in(from.complex(), MeshLocation(to)))) {
    return;
  }
  throw InvalidInput("does not overlap the mesh of the solution: it has " + box_text(to_box) +
                         "; " + (from_name.empty() ? "that one" : from_name) + " has " +
                         box_text(from_box),
                     to_name);
}

FieldFigures figures_of(const TriangleComplex& complex, const std::vector<double>& values) {
  FieldFigures figures{HUGE_VAL, -HUGE_VAL, field_integral(complex, values)};
  for (const TriangleComplex::Nodes& nodes : complex.triangles) {
    for (const std::int32_t v : nodes) {
      figures.min = std::min(figures.min, values[at(v)]);
      figures.max = std::max(figures.max, values[at(v)]);
    }
  }
  return figures;
}

std::vector<double> absolute_values(const std::vector<double>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(std::abs(value));
  return result;
}

TransferredField field_with_figures(const TriangleComplex& from, const std::vector<double>& before,
                                    const TriangleComplex& to, std::vector<double> after) {
  TransferredField field;
  field.before = figures_of(from, before);
  field.after = figures_of(to, after);
  const double size = field_integral(from, absolute_values(before));
  const double gained = field.after.integral - field.before.integral;
  field.gain = size > 0 ? gained / size : 0;
  field.values = std::move(after);
  return field;
}

/// The logarithms are interpolated, number by number.
std::vector<Metric2> interpolated_metrics(const TriangleComplex& from,
                                          const std::vector<Metric2>& metrics,
                                          std::span<const PlaneLocation> places) {
  std::array<std::vector<double>, 3> logs;
  for (const Metric2& metric : metrics) {
    const Metric2 log = log_of(metric);
    logs[0].push_back(log.xx);
    logs[1].push_back(log.xy);
    logs[2].push_back(log.yy);
  }
  for (std::vector<double>& numbers : logs) numbers = interpolated(from, numbers, places);
  std::vector<Metric2> result;
  result.reserve(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    result.push_back(exp_of({logs[0][v], logs[1][v], logs[2][v]}));
  }
  return result;
}

/// Of the nodes that triangles use.
void tell_outside(TransferredSolution& result, const TriangleComplex& from,
                  const TriangleComplex& to, std::span<const PlaneLocation> places) {
  const double rounding = rounding_share * norm(used_box(from).size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (to.node2triangle[v] < 0 || places[v].distance <= rounding) continue;
    ++result.nodes_outside;
    if (places[v].distance <= result.farthest_outside) continue;
    result.farthest_outside = places[v].distance;
    result.farthest_at = to.points[v];
  }
}

}  // namespace

TransferredSolution transfer_solution(const PlaneMesh& from_mesh,
                                      std::span<const std::vector<double>> fields,
                                      std::span<const std::vector<Metric2>> metrics,
                                      const PlaneMesh& to_mesh, TransferMethod method) {
  const TriangleComplex from = checked_complex(from_mesh);
  const TriangleComplex to = checked_complex(to_mesh);
  const MeshLocation background(from);
  check_overlap(background, to, from_mesh.name, to_mesh.name);
  const std::vector<PlaneLocation> places = locate_nodes(background, to);
  TransferredSolution result;
  tell_outside(result, from, to, places);
  std::vector<std::vector<double>> after;
  if (method == TransferMethod::conservative) {
    ConservedFields conserved = transferred_conservatively(background, fields, to, places);
    after = std::move(conserved.fields);
    const std::vector<double> ones(to.points.size(), 1);
    result.covered_percent = 100 * conserved.covered_area / field_integral(to, ones);
  } else {
    for (const std::vector<double>& values : fields) {
      after.push_back(interpolated(from, values, places));
    }
  }
  for (std::size_t f = 0; f < fields.size(); ++f) {
    result.fields.push_back(field_with_figures(from, fields[f], to, std::move(after[f])));
  }
  for (const std::vector<Metric2>& of_nodes : metrics) {
    TF_CHECK(of_nodes.size() == from.points.size());
    result.metrics.push_back(interpolated_metrics(from, of_nodes, places));
  }
  return result;
}

}  // namespace tetfarm
