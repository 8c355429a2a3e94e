#include "mesh/decompose/cut_check.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr double least_clearance = 0.3;
constexpr double least_clearance_at_rim = 0.1;

double cosine_at(const Vec3& a, const Vec3& b, const Vec3& c) {
  return dot(normalized(b - a), normalized(c - a));
}

/// The height of the cut above its plane at p, when p lies in its region.
std::optional<double> height_of_cut(const InterdomainMesh& mesh, const Vec2& p) {
  for (const auto& [i, j, k] : mesh.planar.triangles) {
    const Vec2& a = mesh.planar.points[at(i)];
    const Vec2& b = mesh.planar.points[at(j)];
    const Vec2& c = mesh.planar.points[at(k)];
    const double at_a = (b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x);
    const double at_b = (c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x);
    const double at_c = (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
    if (at_a < 0 || at_b < 0 || at_c < 0) continue;
    const double sum = at_a + at_b + at_c;
    if (sum <= 0) continue;
    return (at_a * mesh.heights[at(i)] + at_b * mesh.heights[at(j)] + at_c * mesh.heights[at(k)]) /
           sum;
  }
  return std::nullopt;
}

/// A shell that the cut does not touch.
struct WholeShell {
  std::size_t triangle = 0;  ///< its first
  Side side = Side::left;
  double volume = 0;  ///< negative: a cavity
  Box3 box;
};

std::vector<WholeShell> shells_without_rim(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                           const FaceColours& colours,
                                           const std::vector<std::int32_t>& shell_of_triangle) {
  TF_CHECK(shell_of_triangle.size() == subdomain.triangles.size());
  const std::int32_t count =
      1 + *std::max_element(shell_of_triangle.begin(), shell_of_triangle.end());
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<bool> has_rim(at(count), false);
  for (const RimEdge& edge : mesh.rim) {
    has_rim[at(shell_of_triangle[at(edge.left_triangle)])] = true;
  }
  std::vector<std::size_t> place(at(count), none);
  std::vector<WholeShell> shells;
  for (std::size_t t = 0; t < shell_of_triangle.size(); ++t) {
    const std::size_t shell = at(shell_of_triangle[t]);
    if (has_rim[shell]) continue;
    if (place[shell] == none) {
      place[shell] = shells.size();
      shells.push_back({t, colours[t], 0, {}});
    }
    WholeShell& whole = shells[place[shell]];
    const Vec3& base = subdomain.vertices[at(subdomain.triangles[whole.triangle][0])];
    const auto& [a, b, c] = subdomain.triangles[t];
    const Vec3 &p = subdomain.vertices[at(a)], &q = subdomain.vertices[at(b)],
               &r = subdomain.vertices[at(c)];
    whole.volume += dot(p - base, cross(q - base, r - base)) / 6;
    for (const Vec3* v : {&p, &q, &r}) whole.box.add(*v);
  }
  return shells;
}

bool holds(const Box3& outer, const Box3& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
  }
  return true;
}

}  // namespace

std::vector<double> cosines_at_rim(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                   const std::vector<RimCorner>& corners) {
  TF_CHECK(corners.size() == mesh.rim.size());
  std::vector<double> cosines;
  cosines.reserve(mesh.rim.size());
  for (std::size_t i = 0; i < mesh.rim.size(); ++i) {
    const std::int32_t apex = apex_of_rim_triangle(mesh, i);
    const Vec3 into_cut = direction_into(subdomain.vertices[at(mesh.rim[i].from)],
                                         subdomain.vertices[at(mesh.rim[i].to)],
                                         node_position(mesh, subdomain, apex));
    cosines.push_back(cosine_to_sides(corners[i], into_cut));
  }
  return cosines;
}

double cosine_of_smallest_triangle_angle(const InterdomainMesh& mesh, const Subdomain& subdomain) {
  double worst = -1;
  for (const auto& [i, j, k] : mesh.planar.triangles) {
    const Vec3 a = node_position(mesh, subdomain, i);
    const Vec3 b = node_position(mesh, subdomain, j);
    const Vec3 c = node_position(mesh, subdomain, k);
    worst = std::max({worst, cosine_at(a, b, c), cosine_at(b, c, a), cosine_at(c, a, b)});
  }
  return worst;
}

bool shells_are_on_their_sides(const InterdomainMesh& mesh, const Subdomain& subdomain,
                               const FaceColours& colours,
                               const std::vector<std::int32_t>& shell_of_triangle) {
  const std::vector<WholeShell> shells =
      shells_without_rim(mesh, subdomain, colours, shell_of_triangle);
  for (const WholeShell& shell : shells) {
    const Vec3& p = subdomain.vertices[at(subdomain.triangles[shell.triangle][0])];
    const auto cut_height = height_of_cut(mesh, mesh.plane.project(p));
    if (!cut_height) continue;
    const Side side = mesh.plane.height(p) < *cut_height ? Side::left : Side::right;
    if (side != shell.side) return false;
  }
  return std::none_of(shells.begin(), shells.end(), [&](const WholeShell& cavity) {
    return cavity.volume < 0 &&
           std::any_of(shells.begin(), shells.end(), [&](const WholeShell& body) {
             return body.volume > 0 && body.side != cavity.side && holds(body.box, cavity.box);
           });
  });
}

bool is_too_near(const SurfaceContact& contact) {
  return contact.meets ||
         contact.distance < (contact.is_at_rim ? least_clearance_at_rim : least_clearance);
}

std::string judge_contacts(const std::vector<SurfaceContact>& contacts) {
  bool is_clear = true;
  for (const SurfaceContact& contact : contacts) {
    if (contact.meets) return "intersection";
    if (is_too_near(contact)) is_clear = false;
  }
  return is_clear ? "" : "clearance";
}

}  // namespace tetfarm
