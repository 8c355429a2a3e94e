// Spacing fields and their lattices, known by their digests (tests/golden/spacing.txt).
#include <gtest/gtest.h>

#include "mesh/spacing/corner_spacing.h"
#include "mesh/spacing/exp_fixed.h"
#include "mesh/spacing/lattice_volume.h"
#include "mesh/spacing/octree_build.h"
#include "mesh/spacing/octree_refine.h"
#include "mesh/spacing/spacing_field.h"
#include "mesh/spacing/surface_spacing.h"
#include "mesh/spacing/systematic_sample.h"
#include "tests/support/result_digest.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void expect_known(const std::string& name, const ResultDigest& result) {
  test::expect_known("spacing", name, result);
}

SpacingOptions with_sources(double background) {
  SpacingOptions options;
  options.growth = 0.25;
  options.background = background;
  options.sources = {
      {{{.at = {0.5, 0.1, 0.2}, .spacing = 0.06, .inner_radius = 0.1, .outer_radius = 0.9}}},
      {{{.at = {-0.5, 0, 0}, .spacing = 0.07, .inner_radius = 0.05, .outer_radius = 0.6},
        {.at = {-0.2, 0.7, 0.4}, .spacing = 0.1, .inner_radius = 0.1, .outer_radius = 0.5}}},
      {{{.at = {0, 0.5, 0}, .spacing = 0.08, .inner_radius = 0.1, .outer_radius = 0.7},
        {.at = {0.3, 0.4, 0.5}, .spacing = 0.1, .inner_radius = 0.1, .outer_radius = 0.7},
        {.at = {0.1, 0.3, -0.6}, .spacing = 0.07, .inner_radius = 0.1, .outer_radius = 0.7}}}};
  return options;
}

void add_nodes(ResultDigest& result, const std::vector<LatticeNode>& nodes) {
  result.add(nodes.size());
  for (const LatticeNode& n : nodes) {
    result.add(n.at, n.cell_edge, n.grid, n.cell_bits, n.shift, n.place());
  }
}

void take_field(const std::string& name, const SpacingField& field) {
  ResultDigest values;
  values.add(field.to_bytes(), field.smallest());
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{-1.5 + 0.037 * (i % 81), -1.4 + 0.041 * (i * 7 % 71), 1.3 - 0.043 * (i * 5 % 61)};
    values.add(field.at(p), field.lattice_cell_edge(p));
  }
  expect_known(name + "_values", values);
  const Box3 box{{-0.6, -0.5, -0.7}, {0.5, 0.7, 0.4}};
  ResultDigest lattice;
  add_nodes(lattice, field.lattice_nodes(box));
  LatticeVisits visits;
  const auto is_needless = [](const Box3& b) { return b.centre().x > 0.1 || b.low.y > 0.2; };
  add_nodes(lattice, field.lattice_nodes(box, is_needless, &visits));
  lattice.add(visits.cells, visits.questions);
  for (const std::size_t most : {10UL, 300UL, 1000000UL}) {
    const LatticeSample sample = field.sample_lattice(box, most);
    lattice.add(sample.nodes_for_each);
    add_nodes(lattice, sample.nodes);
  }
  for (std::size_t direction = 0; direction < 6; ++direction) {
    const auto plane = field.coarsest_lattice_plane(direction, -0.07, 0.11);
    lattice.add(plane.has_value());
    if (!plane) continue;
    lattice.add(plane->axis, plane->other_axis, plane->sign, plane->sum, plane->normal,
                plane->offset);
    add_nodes(lattice, field.lattice_nodes_in_plane(box, *plane));
  }
  expect_known(name + "_lattice", lattice);
}

TEST(SpacingResults, of_fields_and_their_lattices_are_known) {
  const SurfaceMesh ball = shapes::sphere({0.1, 0, 0}, 1, 2);
  take_field("even", SpacingField(0.13));
  take_field("surface", make_spacing_field(ball, {}));
  take_field("sources", make_spacing_field(ball, with_sources(0.4)));
  SpacingOptions without_background = with_sources(0);
  without_background.inherit_surface = false;
  without_background.growth = 0.6;
  take_field("sources_alone", make_spacing_field(ball, without_background));
  SpacingOptions background;
  background.background = 0.15;
  background.growth = 0.5;
  take_field("background", make_spacing_field(shapes::box({-1, -1, -1}, {1, 1, 1}, 6), background));
}

template <class T>
std::vector<T> items_of(const TreeArray<T>& array) {
  return {array.begin(), array.end()};
}

TEST(SpacingResults, of_counts_by_volume_are_known) {
  SpacingDemand demand{
      DemandTree(surface_spacing(shapes::sphere({0, 0, 0}, 1, 1)), 0.4), {}, 0.5, 0.4, 0.5};
  for (const Source& source : with_sources(0.5).sources) {
    demand.sources.push_back(source_demand(source, 0.4));
  }
  const Box3 domain{{-1, -1, -1}, {1, 1, 1}};
  const GridFrame frame = grid_frame(domain, 0.5);
  ResultDigest tree_found;
  RefinedTree tree = refine(demand, frame, domain);
  tree_found.add(tree.child_of, tree.lattice_level);
  balance(tree);
  tree_found.add(tree.child_of, tree.lattice_level);
  expect_known("tree", tree_found);
  const SpacingOctree octree = build_octree(demand, frame, domain);
  ResultDigest result;
  result.add(octree.frame.low, octree.frame.unit, items_of(octree.child_of),
             items_of(octree.values), items_of(octree.lattice_level),
             items_of(octree.owned_corners));
  const Box3 box{{-0.6, -0.5, -0.7}, {0.5, 0.7, 0.4}};
  result.add(cells_to_walk(octree, box), cells_to_walk(octree, domain));
  for (const std::size_t most : {7UL, 500UL}) {
    const LatticeSample sample = sample_by_volume(octree, box, most);
    result.add(sample.nodes_for_each);
    for (const LatticeNode& n : sample.nodes) result.add(n.at, n.cell_edge);
  }
  expect_known("by_volume", result);
}

TEST(SpacingResults, of_numbers_are_known) {
  ResultDigest result;
  for (int i = -60; i < 60; ++i) {
    result.add(exp_fixed(0.37 * i), exp_fixed(11.7 * i), log_fixed(exp_fixed(0.31 * i)));
  }
  for (const std::size_t count : {0UL, 1UL, 17UL, 1000UL, 4096UL}) {
    for (const std::size_t most : {1UL, 10UL, 100UL, 5000UL}) {
      const SystematicSample sample = systematic_sample(count, most);
      result.add(sample.numbers, sample.stride);
    }
  }
  for (const PointDemand& d : surface_spacing(shapes::box({0, 0, 0}, {1, 2, 3}, 3))) {
    result.add(d.at, d.spacing, d.plateau);
  }
  expect_known("numbers", result);
}

}  // namespace
}  // namespace tetfarm
