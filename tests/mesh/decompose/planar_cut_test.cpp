#include "mesh/decompose/planar_cut.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

double volume(const Subdomain& s) { return enclosed_volume(s.vertices, s.triangles); }

/// The new triangles of a half, by number, as origins of their nodes.
std::map<std::uint32_t, std::array<Origin, 3>> new_triangles(const Subdomain& half,
                                                             std::uint64_t owner) {
  std::map<std::uint32_t, std::array<Origin, 3>> found;
  for (std::size_t t = 0; t < half.triangles.size(); ++t) {
    if (half.triangle_origin[t].owner != owner) continue;
    const auto origin = [&](int k) {
      return half
          .node_origin[static_cast<std::size_t>(half.triangles[t][static_cast<std::size_t>(k)])];
    };
    found[half.triangle_origin[t].index] = {origin(0), origin(1), origin(2)};
  }
  return found;
}

void expect_sound(const Subdomain& parent, const Cut& cut) {
  EXPECT_THAT(validate(cut.left), IsEmpty());
  EXPECT_THAT(validate(cut.right), IsEmpty());
  EXPECT_NEAR(volume(cut.left) + volume(cut.right), volume(parent), 1e-12 * volume(parent));
  EXPECT_GT(volume(cut.left), 0);
  EXPECT_GT(volume(cut.right), 0);
  EXPECT_EQ(cut.left.path, parent.path.left());
  EXPECT_EQ(cut.right.path, parent.path.right());
  const auto left = new_triangles(cut.left, parent.path.heap);
  const auto right = new_triangles(cut.right, parent.path.heap);
  EXPECT_EQ(left.size(), static_cast<std::size_t>(cut.interdomain_triangles));
  ASSERT_EQ(left.size(), right.size());
  for (const auto& [index, nodes] : left) {
    const auto& [a, b, c] = right.at(index);
    EXPECT_EQ(nodes, (std::array<Origin, 3>{a, c, b}));
  }
}

std::vector<Subdomain> cut_into(const Subdomain& subdomain, const SpacingField& spacing,
                                int parts) {
  if (parts == 1) return {subdomain};
  const CutOutcome outcome = planar_cut(subdomain, spacing);
  if (!outcome.cut) {
    ADD_FAILURE() << subdomain.path.text() << ": " << outcome.reason;
    return {subdomain};
  }
  expect_sound(subdomain, *outcome.cut);
  auto leaves = cut_into(outcome.cut->left, spacing, parts / 2);
  const auto others = cut_into(outcome.cut->right, spacing, parts - parts / 2);
  leaves.insert(leaves.end(), others.begin(), others.end());
  return leaves;
}

void expect_sound_leaves(const SurfaceMesh& surface, double h, int parts) {
  const Subdomain root = root_subdomain(surface);
  const auto leaves = cut_into(root, SpacingField(h), parts);
  EXPECT_EQ(leaves.size(), static_cast<std::size_t>(parts));
  double sum = 0;
  for (const Subdomain& leaf : leaves) {
    sum += volume(leaf);
    EXPECT_LT(volume(leaf), 1.5 * volume(root) / parts);
  }
  EXPECT_NEAR(sum, volume(root), 1e-12 * sum);
}

TEST(PlanarCut, cuts_a_structured_box_along_its_rows_of_nodes) {
  const Subdomain box = root_subdomain(shapes::box({0, 0, 0}, {2, 1, 1}, 8));
  const CutOutcome outcome = planar_cut(box, SpacingField(0.15));
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  expect_sound(box, *outcome.cut);
  EXPECT_NEAR(volume(outcome.cut->left), 1, 0.02);
  EXPECT_GT(outcome.cut->smallest_angle_deg, 85);
  EXPECT_EQ(outcome.cut->candidates_tried, 1);
}

TEST(PlanarCut, cuts_a_box_into_eight) {
  expect_sound_leaves(shapes::box({0, 0, 0}, {1, 1, 1}, 8), 0.15, 8);
}
TEST(PlanarCut, cuts_a_sphere_into_eight) {
  expect_sound_leaves(shapes::sphere({0, 0, 0}, 1, 3), 0.15, 8);
}
TEST(PlanarCut, cuts_a_hollow_sphere_into_eight) {
  expect_sound_leaves(shapes::nested_spheres(3), 0.14, 8);
}
TEST(PlanarCut, cuts_a_torus_into_eight) {
  expect_sound_leaves(shapes::torus(0.4, 48, 20), 0.13, 8);
}
TEST(PlanarCut, cuts_a_box_round_a_coarse_body_into_four) {
  expect_sound_leaves(shapes::between(shapes::box({-1, -1, -1}, {1, 1, 1}, 10),
                                      shapes::sphere({0.1, 0, 0}, 0.3, 2)),
                      0.18, 4);
}

TEST(PlanarCut, along_a_lattice_plane_takes_the_nodes_of_the_lattice) {
  const SpacingField spacing(0.1);
  const Subdomain root = root_subdomain(shapes::sphere({0, 0, 0}, 1, 4));
  CutOptions options;
  options.planes = CutPlanes::lattice;
  const CutOutcome outcome = planar_cut(root, spacing, options);
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  expect_sound(root, *outcome.cut);
  const auto lattice = spacing.lattice_nodes({{-1, -1, -1}, {1, 1, 1}});
  const Subdomain& left = outcome.cut->left;
  int inner = 0;
  int of_lattice = 0;
  for (std::size_t v = 0; v < left.vertices.size(); ++v) {
    if (left.node_origin[v].owner == 0) continue;
    ++inner;
    of_lattice += std::any_of(lattice.begin(), lattice.end(),
                              [&](const LatticeNode& node) { return node.at == left.vertices[v]; });
  }
  EXPECT_GT(of_lattice, inner / 2);
}

TEST(PlanarCut, separates_pieces_that_are_apart_without_a_triangle) {
  SurfaceMesh two = shapes::sphere({0, 0, 0}, 1, 2);
  const SurfaceMesh other = shapes::sphere({5, 0, 0}, 1, 2);
  for (const auto& [a, b, c] : other.triangles)
    two.triangles.push_back({a + 162, b + 162, c + 162});
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  const Subdomain root = root_subdomain(two);
  const CutOutcome outcome = planar_cut(root, SpacingField(0.25));
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  expect_sound(root, *outcome.cut);
  EXPECT_EQ(outcome.cut->interdomain_triangles, 0);
  EXPECT_NEAR(volume(outcome.cut->left), volume(outcome.cut->right), 1e-9);
}

TEST(PlanarCut, gives_the_left_its_share) {
  const Subdomain root = root_subdomain(shapes::sphere({0, 0, 0}, 1, 3));
  // Planes of the lattice lie where the lattice has them.
  for (const auto& [planes, tolerance] :
       {std::pair{CutPlanes::axis, 1e-9}, std::pair{CutPlanes::lattice, 0.02}}) {
    CutOptions options;
    options.planes = planes;
    options.left_share = 0.25;
    const CutOutcome outcome = planar_cut(root, SpacingField(0.12), options);
    ASSERT_TRUE(outcome.cut) << outcome.reason;
    EXPECT_NEAR(volume(outcome.cut->left) / volume(root), 0.25, 0.05);
    EXPECT_NEAR(outcome.cut->left_work / (outcome.cut->left_work + outcome.cut->right_work), 0.25,
                tolerance);
  }
}

TEST(PlanarCut, is_the_same_each_time) {
  const Subdomain root = root_subdomain(shapes::torus(0.4, 40, 16));
  const CutOutcome first = planar_cut(root, SpacingField(0.15));
  const CutOutcome second = planar_cut(root, SpacingField(0.15));
  ASSERT_TRUE(first.cut && second.cut);
  EXPECT_EQ(first.cut->left.vertices, second.cut->left.vertices);
  EXPECT_EQ(first.cut->left.triangles, second.cut->left.triangles);
  EXPECT_EQ(first.cut->right.triangles, second.cut->right.triangles);
}

TEST(PlanarCut, goes_on_when_a_cut_is_not_accepted) {
  CutOptions options;
  int calls = 0;
  options.accept = [&calls](const Subdomain& left, const Subdomain& right) {
    EXPECT_THAT(validate(left), IsEmpty());
    EXPECT_THAT(validate(right), IsEmpty());
    return ++calls == 3;
  };
  const Subdomain root = root_subdomain(shapes::sphere({0, 0, 0}, 1, 3));
  const CutOutcome outcome = planar_cut(root, SpacingField(0.15), options);
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  EXPECT_EQ(calls, 3);
  EXPECT_THAT(outcome.cut->refused, HasSubstr("not accepted 2"));
}

TEST(PlanarCut, gives_up_after_so_many_refusals) {
  CutOptions options;
  int calls = 0;
  options.most_accept_calls = 2;
  options.accept = [&calls](const Subdomain&, const Subdomain&) {
    ++calls;
    return false;
  };
  const Subdomain root = root_subdomain(shapes::sphere({0, 0, 0}, 1, 3));
  const CutOutcome outcome = planar_cut(root, SpacingField(0.15), options);
  EXPECT_FALSE(outcome.cut);
  EXPECT_EQ(outcome.reason, "no candidate accepted");
  EXPECT_EQ(calls, 2);
}

TEST(PlanarCut, tells_why_it_cannot_cut_a_tetrahedron) {
  const CutOutcome outcome = planar_cut(root_subdomain(shapes::tetrahedron()), SpacingField(1.0));
  EXPECT_FALSE(outcome.cut);
  EXPECT_THAT(outcome.reason, HasSubstr("candidates refused"));
}

TEST(PlanarCut, no_badly_balanced_cut_is_tried_before_a_well_balanced_one) {
  const Subdomain bar = root_subdomain(shapes::box({0, 0, 0}, {2, 1, 1}, 4));
  CutOptions options;
  options.left_share = 0.25;
  options.smallest_angles_deg = {20};
  options.most_accept_calls = 100;
  std::vector<double> shares;
  while (true) {
    // The next of those that pass.
    std::size_t calls = 0;
    options.accept = [&](const Subdomain&, const Subdomain&) { return ++calls > shares.size(); };
    const CutOutcome outcome = planar_cut(bar, SpacingField(0.3), options);
    if (!outcome.cut) break;
    shares.push_back(outcome.cut->left_work / (outcome.cut->left_work + outcome.cut->right_work));
  }
  const auto is_balanced = [](double share) { return std::fabs(share - 0.25) <= 0.15 * 0.25; };
  EXPECT_GT(std::count_if(shares.begin(), shares.end(), is_balanced), 5);
  EXPECT_FALSE(std::all_of(shares.begin(), shares.end(), is_balanced));
  EXPECT_TRUE(std::is_partitioned(shares.begin(), shares.end(), is_balanced));
}

}  // namespace
}  // namespace tetfarm
