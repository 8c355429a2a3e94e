// The steps of a cut, known by their digests (tests/golden/decompose.txt): of several that differ,
// the first of a case tells in which step.
#include <gtest/gtest.h>

#include "mesh/core/subdomain_regions.h"
#include "mesh/decompose/cut_candidate.h"
#include "mesh/decompose/cut_lifting.h"
#include "mesh/decompose/decomposition_plan.h"
#include "mesh/decompose/inertia_matrix.h"
#include "mesh/decompose/intersection_repair.h"
#include "mesh/decompose/invalid_zones.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/decompose/planar_placement.h"
#include "mesh/decompose/region_split.h"
#include "mesh/decompose/split_subdomain.h"
#include "tests/mesh/decompose/cuts_by_chance.h"
#include "tests/mesh/decompose/flat_cut.h"
#include "tests/support/chance.h"
#include "tests/support/generated_skins.h"
#include "tests/support/subdomain_digest.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void expect_known(const std::string& name, const ResultDigest& result) {
  test::expect_known("decompose", name, result);
}

struct Shape {
  std::string name;
  SurfaceMesh surface;
  double spacing;
};

/// A ball whose vertices are pushed about: nothing about it is even.
SurfaceMesh rough_ball(int levels, std::uint64_t seed) {
  SurfaceMesh mesh = shapes::sphere({0, 0, 0}, 1, levels);
  shapes::Chance chance(seed);
  for (Vec3& p : mesh.vertices) p *= chance.between(0.85, 1.15);
  return mesh;
}

/// A step of three boxes, evenly triangulated: concave edges, flat faces.
SurfaceMesh stairs() {
  SurfaceMesh mesh = shapes::box({0, 0, 0}, {3, 1, 1}, 6);
  for (Vec3& p : mesh.vertices) {
    if (p.z > 0.6) p.z += p.x < 1.2 ? 0 : p.x < 2.2 ? 0.4 : 1;
  }
  return mesh;
}

std::vector<Shape> shapes_to_cut() {
  return {{"ball", shapes::sphere({0, 0, 0}, 1, 2), 0.3},
          {"rough_ball", rough_ball(2, 5), 0.3},
          {"bar", shapes::box({0, 0, 0}, {3, 1, 0.7}, 5), 0.25},
          {"stairs", stairs(), 0.25},
          {"hollow", shapes::nested_spheres(2), 0.25},
          {"plate_inside",
           shapes::between(shapes::box({0, 0, 0}, {1, 1, 1}, 6),
                           shapes::box({0.3, 0.3, 0.47}, {0.7, 0.7, 0.58}, 2)),
           0.15},
          {"tetrahedron", shapes::tetrahedron(), 0.5},
          {"blocks", shapes::voxels(3, 2), 0.5}};
}

void add_plane(ResultDigest& result, const CutPlane& plane) {
  result.add(plane.normal, plane.u, plane.v, plane.offset);
}

void add_candidates(ResultDigest& result, const std::vector<PlaneCandidate>& candidates) {
  result.add(candidates.size());
  for (const PlaneCandidate& c : candidates) {
    add_plane(result, c.plane);
    result.add(c.left_share, c.penalty, c.lattice.has_value());
    if (c.lattice) result.add(c.lattice->axis, c.lattice->sign, c.lattice->sum);
  }
}

TEST(DecomposeResults, of_planes_and_of_the_work_that_places_them_are_known) {
  for (const auto& [name, surface, h] : shapes_to_cut()) {
    const Subdomain root = root_subdomain(surface);
    const SpacingField spacing(h);
    const SurfaceTopology topology = make_surface_topology(root);
    ResultDigest result;
    result.add(topology.twin, topology.centroid, topology.normal, topology.size,
               topology.vertex2half_edge, topology.triangle2shell);
    for (const std::size_t most : {100UL, 4000UL}) {
      const WorkSamples work = sample_work(root, spacing, most);
      result.add(work.total, work.samples.size());
      for (const WorkSample& s : work.samples) result.add(s.at, s.work, s.spacing, s.width);
      const InertiaMatrix inertia = inertia_matrix(work);
      result.add(inertia.rows, principal_axes(inertia));
    }
    const WorkSamples work = sample_work(root, spacing);
    const std::vector<double> offsets = {-0.5, 0, 0.3, 0.5, 0.97};
    result.add(area_in_invalid_zones(root, topology, {0, 0, 1}, offsets));
    result.add(area_in_invalid_zones(root, topology, normalized(Vec3{1, 2, 3}), offsets));
    for (const CutPlanes planes :
         {CutPlanes::automatic, CutPlanes::lattice, CutPlanes::axis, CutPlanes::inertia}) {
      PlacementOptions options;
      options.planes = planes;
      add_candidates(result, place_planes(root, topology, work, spacing, options));
      options.left_share = 0.3;
      options.most = 11;
      add_candidates(result, place_planes(root, topology, work, spacing, options));
    }
    expect_known(name + "_planes", result);
  }
}

void add_mesh(ResultDigest& result, const InterdomainMesh& mesh) {
  result.add(mesh.rim.size(), mesh.rim_nodes, mesh.rim_vertices, mesh.lattice.size(),
             mesh.rim2triangle, mesh.heights, mesh.spacing);
  for (const RimEdge& edge : mesh.rim) {
    result.add(edge.from, edge.to, edge.left_triangle, edge.right_triangle);
  }
  for (const LatticeNodeOfCut& node : mesh.lattice) result.add(node.at, node.is_held);
  result.add(mesh.planar.triangles, mesh.planar.points.size());
  for (const Vec2& p : mesh.planar.points) result.add(p.x, p.y);
}

void add_contacts(ResultDigest& result, const std::vector<SurfaceContact>& contacts) {
  result.add(contacts.size(), judge_contacts(contacts));
  for (const SurfaceContact& c : contacts) {
    result.add(c.cut_triangle, c.surface_triangle, c.meets, c.is_at_rim, c.distance, c.unit,
               is_too_near(c));
  }
}

/// One plane after the other through a shape, from its colours to the checks.
void take_cut_through(const std::string& name, const SurfaceMesh& surface, double h,
                      const Vec3& direction, double offset) {
  const Subdomain root = root_subdomain(surface);
  const SpacingField spacing(h);
  const SurfaceTopology topology = make_surface_topology(root);
  const CutPlane plane = make_cut_plane(normalized(direction), offset);
  ResultDigest path;
  add_plane(path, plane);
  FaceColours colours = colour_by_centroid(topology, plane);
  path.add(colours);
  relax_path(colours, root, topology, plane);
  path.add(colours);
  tidy_path(colours, topology, root.triangles);
  path.add(colours);
  const EdgeLoops loops = find_edge_loops(colours, topology, root.triangles);
  path.add(loops.pinched_nodes, loops.loops.size());
  for (const auto& loop : loops.loops) {
    for (const RimEdge& e : loop) path.add(e.from, e.to, e.left_triangle, e.right_triangle);
  }
  expect_known(name + "_path", path);

  ResultDigest flat;
  InterdomainResult made = mesh_interdomain(root, topology, loops, plane, spacing);
  flat.add(made.problem);
  add_mesh(flat, made.mesh);
  std::vector<RimCorner> corners;
  for (const RimEdge& edge : made.mesh.rim) {
    corners.push_back(rim_corner(root, topology, edge));
    const RimCorner& c = corners.back();
    flat.add(c.along, c.into_left, c.into_right, c.left_inward, c.right_inward, c.is_convex,
             bisector(c), cosine_at_bisector(c));
  }
  expect_known(name + "_flat", flat);

  ResultDigest lifted;
  const auto contacts = lift_and_push(made.mesh, root, topology, colours, corners);
  add_mesh(lifted, made.mesh);
  add_contacts(lifted, contacts);
  lifted.add(cosines_at_rim(made.mesh, root, corners));
  if (!made.mesh.planar.triangles.empty()) {
    lifted.add(cosine_of_smallest_triangle_angle(made.mesh, root));
  }
  lifted.add(shells_are_on_their_sides(made.mesh, root, colours, topology.triangle2shell));
  test::add_subdomain(lifted, half_of(root, colours, made.mesh, Side::left));
  test::add_subdomain(lifted, half_of(root, colours, made.mesh, Side::right));
  expect_known(name + "_lifted", lifted);
}

TEST(DecomposeResults, of_every_step_from_the_path_to_the_lifted_cut_are_known) {
  take_cut_through("cap", shapes::sphere({0, 0, 0}, 1, 2), 0.3, {1, 2, 3}, 0.6);
  take_cut_through("rough", rough_ball(3, 7), 0.25, {2, -1, 1}, 0.1);
  take_cut_through("step", stairs(), 0.3, {1, 0, 0.1}, 1.3);
  take_cut_through("step_level", stairs(), 0.3, {0, 0, 1}, 0.93);
  take_cut_through("ring", shapes::nested_spheres(2), 0.25, {0, 0.2, 1}, 0.05);
  const SurfaceMesh room = shapes::box({0, 0, 0}, {1, 1, 1}, 8);
  take_cut_through("plate_above",
                   shapes::between(room, shapes::box({0.3, 0.3, 0.51}, {0.7, 0.7, 0.58}, 3)), 0.13,
                   {0, 0, 1}, 0.5);
  take_cut_through("plate_through",
                   shapes::between(room, shapes::box({0.3, 0.3, 0.46}, {0.7, 0.7, 0.53}, 3)), 0.13,
                   {0, 0, 1}, 0.5);
}

void add_cut(ResultDigest& result, const CutOutcome& outcome) {
  result.add(outcome.reason, outcome.cut.has_value());
  if (!outcome.cut) return;
  const Cut& cut = *outcome.cut;
  test::add_subdomain(result, cut.left);
  test::add_subdomain(result, cut.right);
  result.add(cut.interdomain_triangles, cut.left_work, cut.right_work, cut.candidates_tried,
             cut.refused);
}

TEST(DecomposeResults, of_whole_cuts_are_known) {
  for (const auto& [name, surface, h] : shapes_to_cut()) {
    const Subdomain root = root_subdomain(surface);
    const SpacingField spacing(h);
    for (const CutPlanes planes : {CutPlanes::automatic, CutPlanes::lattice}) {
      ResultDigest result;
      CutOptions options;
      options.planes = planes;
      options.progress = result.listener();
      add_cut(result, planar_cut(root, spacing, options));
      options.left_share = 1.0 / 3;
      options.candidates = 12;
      add_cut(result, planar_cut(root, spacing, options));
      expect_known(name + (planes == CutPlanes::lattice ? "_lattice_cut" : "_cut"), result);
    }
  }
}

/// Of the cuts by chance those that are quickly made, or have something in their way that hardly
/// ever comes up.
struct SomeCuts {
  const char* name;
  ShapeToCut kind;
  std::vector<std::uint64_t> seeds;
};

TEST(DecomposeResults, of_cuts_by_chance_are_known) {
  const std::vector<SomeCuts> cuts = {
      {"rough_balls", ShapeToCut::rough_ball, {3, 8, 9, 11, 12, 30, 34, 36, 38, 48, 51, 59}},
      {"bars", ShapeToCut::bar, {2, 4, 9, 11, 16, 19, 20, 23, 24, 54}},
      {"plates_in_boxes", ShapeToCut::plate_in_box, {3, 7, 23, 30, 31, 35, 39}},
      {"hollow_balls", ShapeToCut::hollow_ball, {26, 35}},
      {"many_stairs", ShapeToCut::stairs, {0, 2, 10, 11, 23, 28, 31, 32, 36}},
      {"wedges", ShapeToCut::wedges, {0, 4, 6, 7, 10, 11, 15, 17, 18, 19, 22, 30}}};
  for (const auto& [name, kind, seeds] : cuts) {
    ResultDigest result;
    for (const std::uint64_t seed : seeds) {
      CutByChance cut(kind, seed);
      cut.options.progress = result.listener();
      const Subdomain root = root_subdomain(cut.surface);
      add_cut(result, planar_cut(root, *cut.spacing, cut.options));
      if (root.triangles.size() > 200) continue;
      cut.options.smallest_angles_deg = {80, 65, 50, 20};
      cut.options.candidates = 20;
      add_cut(result, planar_cut(root, *cut.spacing, cut.options));
    }
    expect_known(name, result);
  }
}

TEST(DecomposeResults, of_plans_are_known) {
  const Subdomain root = root_subdomain(shapes::box({0, 0, 0}, {2, 1, 0.8}, 4));
  const SpacingField spacing(0.12);
  ResultDigest result;
  for (const std::int64_t parts : {1, 3, 8}) {
    const auto as_told = [](double, double, std::int64_t told) { return told; };
    for (const PlannedSubdomain& s : plan_decomposition(root, spacing, parts, as_told)) {
      result.add(s.path.heap, s.parts, s.elements, s.triangles);
    }
    const auto by_size = [](double elements, double triangles, std::int64_t) {
      return elements > 2000 || triangles > 400 ? std::int64_t{2} : std::int64_t{0};
    };
    for (const PlannedSubdomain& s : plan_decomposition(root, spacing, parts, by_size)) {
      result.add(s.path.heap, s.parts, s.elements, s.triangles);
    }
  }
  expect_known("plans", result);
}

TEST(DecomposeResults, of_regions_are_known) {
  SurfaceMesh surface =
      shapes::voxel_surface(
          {{3, 2, 1}, [](int x, int y, int) { return 1 + std::min(2, x) + (y > 0 && x == 1); }})
          .surface;
  if (surface.sides.empty()) {
    const auto voxels = shapes::voxel_surface(
        {{3, 2, 1}, [](int x, int y, int) { return 1 + std::min(2, x) + (y > 0 && x == 1); }});
    for (const auto& [behind, in_front] : voxels.sets) surface.sides.push_back({behind, in_front});
    for (std::size_t i = 1; i < voxels.cubes_of_set.size(); ++i) {
      surface.region_names.push_back("r" + std::to_string(i));
    }
  }
  const Subdomain root = root_subdomain(surface);
  ASSERT_EQ(root.region, 0);
  ResultDigest result;
  for (const std::int64_t parts : {3, 4, 7, 20}) {
    if (parts < std::ssize(regions_of(root))) continue;
    const RegionSplit split = split_regions(root, SpacingField(0.3), parts);
    result.add(split.left_parts, split.right_parts);
    test::add_subdomain(result, split.left);
    test::add_subdomain(result, split.right);
  }
  const auto as_told = [](double, double, std::int64_t told) { return told; };
  for (const PlannedSubdomain& s : plan_decomposition(root, SpacingField(0.2), 5, as_told)) {
    result.add(s.path.heap, s.parts, s.elements, s.triangles);
  }
  expect_known("regions", result);
}

}  // namespace
}  // namespace tetfarm
