#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/spacing/spacing_field.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

constexpr Box3 box{{-1, -1, -1}, {1, 1, 1}};

SpacingField graded_field() {
  SpacingOptions options;
  options.background = 0.4;
  options.sources = {{{{{0.1, 0.2, 0.3}, 0.05, 0.1, 2}}}};
  return make_spacing_field(shapes::box({-1, -1, -1}, {1, 1, 1}, 4), options);
}

double height_over(const LatticePlane& plane, const Vec3& p) {
  return dot(plane.normal, p) - plane.offset;
}

TEST(LatticePlanes, lie_within_the_bounds_asked_for) {
  const SpacingField field(0.1);
  for (std::size_t direction = 0; direction < 6; ++direction) {
    for (const auto& [low, high] : {std::pair(0.2, 0.5), {-0.5, -0.2}}) {
      const auto plane = field.coarsest_lattice_plane(direction, low, high);
      ASSERT_TRUE(plane.has_value());
      EXPECT_EQ(plane->normal, lattice_plane_normals()[direction]);
      EXPECT_GE(plane->offset, low - 1e-12);
      EXPECT_LE(plane->offset, high + 1e-12);
    }
  }
}

TEST(LatticePlanes, hold_the_nodes_of_the_lattice_that_lie_in_them_and_no_others) {
  const SpacingField field = graded_field();
  const auto all = field.lattice_nodes(box);
  for (std::size_t direction = 0; direction < 6; ++direction) {
    const auto plane = field.coarsest_lattice_plane(direction, -0.1, 0.1);
    ASSERT_TRUE(plane.has_value());
    const auto found = field.lattice_nodes_in_plane(box, *plane);
    EXPECT_GT(found.size(), 20U);
    for (const LatticeNode& node : found) EXPECT_NEAR(height_over(*plane, node.at), 0, 1e-12);
    const auto in_plane = std::count_if(all.begin(), all.end(), [&](const LatticeNode& node) {
      return std::fabs(height_over(*plane, node.at)) < 1e-12;
    });
    EXPECT_EQ(found.size(), static_cast<std::size_t>(in_plane));
  }
}

TEST(LatticePlanes, are_crossed_by_no_tet_of_an_even_lattice) {
  const SpacingField field(0.25);
  const auto nodes = field.lattice_nodes(box);
  std::vector<Vec3> points;
  for (const LatticeNode& node : nodes) points.push_back(node.at);
  const DelaunayTets tets = bowyer_watson(points);
  for (std::size_t direction = 0; direction < 6; ++direction) {
    const auto plane = field.coarsest_lattice_plane(direction, -0.15, 0.15);
    ASSERT_TRUE(plane.has_value());
    int touching = 0;
    int crossing = 0;
    for (const Tet& tet : tets.complex.nodes) {
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      bool is_inside = true;
      for (const std::int32_t v : tet) {
        if (v < 0 || v >= static_cast<std::int32_t>(points.size())) {
          is_inside = false;
          break;
        }
        const Vec3& p = points[static_cast<std::size_t>(v)];
        is_inside = is_inside && std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < 0.7;
        low = std::min(low, height_over(*plane, p));
        high = std::max(high, height_over(*plane, p));
      }
      if (!is_inside || low > 1e-9 || high < -1e-9) continue;
      ++touching;
      if (low < -1e-9 && high > 1e-9) ++crossing;
    }
    EXPECT_GT(touching, 50);
    EXPECT_EQ(crossing, 0);
  }
}

TEST(LatticeSample, has_one_of_each_n_nodes_and_no_more_than_asked_for) {
  const SpacingField field = graded_field();
  const auto all = field.lattice_nodes(box);
  for (const std::size_t most : {std::size_t{1}, std::size_t{100}, all.size(), 2 * all.size()}) {
    const LatticeSample sample = field.sample_lattice(box, most);
    EXPECT_LE(sample.nodes.size(), most + 2);
    EXPECT_NEAR(static_cast<double>(sample.nodes.size()) * sample.nodes_for_each,
                static_cast<double>(all.size()), sample.nodes_for_each);
    for (const LatticeNode& node : sample.nodes) {
      EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                              [&](const LatticeNode& other) { return other.at == node.at; }));
    }
  }
}

/// Blocks of even cells beside finer and coarser ones.
SpacingField nearly_even_field() {
  SpacingOptions options;
  options.background = 0.1;
  options.sources = {{{{{0.9, 0.9, 0.9}, 0.02, 0.05, 0.6}}}};
  options.inherit_surface = false;
  return make_spacing_field(shapes::box({-1, -1, -1}, {1, 1, 1}, 4), options);
}

TEST(LatticeNodes, every_corner_of_a_cell_is_there_once) {
  const SpacingField field = nearly_even_field();
  std::set<std::array<std::int32_t, 3>> there;
  const auto all = field.lattice_nodes(box);
  for (const LatticeNode& node : all) EXPECT_TRUE(there.insert(node.grid).second);
  std::set<std::int32_t> sizes;
  for (const LatticeNode& node : all) {
    const std::int32_t half = node.cell_size() / 2;
    if ((node.grid[0] & half) == 0) continue;  // no centre
    sizes.insert(node.cell_size());
    for (int k = 0; k < 8; ++k) {
      auto corner = node.grid;
      Vec3 at = node.at;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int sign = (k >> axis & 1) != 0 ? 1 : -1;
        corner[axis] += sign * half;
        at[static_cast<int>(axis)] += sign * 0.5 * node.cell_edge;
      }
      if (std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)}) > 0.999) continue;
      EXPECT_TRUE(there.contains(corner));
    }
  }
  EXPECT_GE(sizes.size(), 3U);
}

/// The choice of sample_lattice, made of a list of all nodes.
std::vector<LatticeNode> chosen_of(const std::vector<LatticeNode>& all, std::size_t most) {
  const auto scattered = [](std::uint64_t x) {
    x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27U) * 0x94d049bb133111ebU;
    return x ^ x >> 31U;
  };
  std::vector<LatticeNode> nodes;
  std::size_t stride = 1;
  std::size_t chosen = 0;
  for (std::size_t number = 0; number < all.size(); ++number) {
    if (number % (2 * stride) == 0 && nodes.size() >= 2 && nodes.size() + 2 > most) {
      const std::size_t kept = nodes.size() / 2;
      for (std::size_t i = 0; i < kept; ++i) {
        nodes[i] = nodes[2 * i + (scattered(stride * kept + i) & 1U)];
      }
      nodes.resize(kept);
      stride *= 2;
    }
    if (number % stride == 0) chosen = number + (scattered(number) & (stride - 1));
    if (number == chosen) nodes.push_back(all[number]);
  }
  return nodes;
}

void expect_samples_of_the_definition(const SpacingField& field, const Box3& where) {
  const auto all = field.lattice_nodes(where);
  for (const std::size_t most : {3U, 100U, 4000U}) {
    const std::vector<LatticeNode> expected = chosen_of(all, most);
    const LatticeSample sample = field.sample_lattice(where, most);
    ASSERT_EQ(sample.nodes.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(sample.nodes[i].grid, expected[i].grid);
      EXPECT_EQ(sample.nodes[i].place(), expected[i].place());
    }
  }
}

TEST(LatticeNodes, of_blocks_that_are_needless_are_left_out_and_no_others) {
  const SpacingField field = graded_field();
  std::size_t refused = 0;
  std::vector<Box3> needless;
  // Beyond a plane askew, so that blocks are asked for in parts.
  const auto nodes = field.lattice_nodes(box, [&](const Box3& b) {
    const bool is_beyond = b.low.x + b.low.y > 0.3;
    if (is_beyond) needless.push_back(b);
    if (!is_beyond) ++refused;
    return is_beyond;
  });
  const auto all = field.lattice_nodes(box);
  ASSERT_GT(needless.size(), 20U);
  ASSERT_GT(refused, 20U);
  EXPECT_LT(nodes.size(), 0.8 * static_cast<double>(all.size()));
  const auto lies_in_one = [&](const Vec3& p) {
    return std::any_of(needless.begin(), needless.end(), [&](const Box3& b) {
      return b.low.x <= p.x && p.x <= b.high.x && b.low.y <= p.y && p.y <= b.high.y &&
             b.low.z <= p.z && p.z <= b.high.z;
    });
  };
  std::size_t next = 0;
  for (const LatticeNode& node : all) {
    if (next < nodes.size() && nodes[next].at == node.at) {
      ++next;
    } else {
      EXPECT_TRUE(lies_in_one(node.at));
    }
  }
  EXPECT_EQ(next, nodes.size());
}

TEST(LatticeSample, nodes_that_are_passed_over_count_as_if_each_were_looked_at) {
  expect_samples_of_the_definition(graded_field(), box);
  expect_samples_of_the_definition(SpacingField(0.02), {{0, 0, 0}, {1, 1, 1}});
  expect_samples_of_the_definition(SpacingField(0.02), {{0.1, 0.2, 0.3}, {0.37, 1, 0.9}});
  expect_samples_of_the_definition(nearly_even_field(), box);
}

TEST(LatticeSample, is_not_always_the_same_corner_of_a_block_of_cells) {
  const SpacingField field(0.02);
  const Box3 cube{{0, 0, 0}, {1, 1, 1}};
  const double cell = field.lattice_cell_edge({0.5, 0.5, 0.5});
  const LatticeSample sample = field.sample_lattice(cube, 4000);
  ASSERT_GE(sample.nodes_for_each, 64);
  // Of four layers of cells along x, each has its share.
  std::array<int, 4> in_layer{};
  for (const LatticeNode& node : sample.nodes) {
    ++in_layer[static_cast<std::size_t>(std::floor(node.at.x / cell)) % 4];
  }
  for (const int count : in_layer) {
    EXPECT_NEAR(count, static_cast<double>(sample.nodes.size()) / 4,
                0.1 * static_cast<double>(sample.nodes.size()));
  }
}

}  // namespace
}  // namespace tetfarm
