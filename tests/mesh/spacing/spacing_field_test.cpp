#include "mesh/spacing/spacing_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// A counter-based sequence in [0, 1).
class Dice {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 9007199254740992.0;
  }
  Vec3 in(const Box3& box) {
    const Vec3 size = box.size();
    return {box.low.x + size.x * next(), box.low.y + size.y * next(), box.low.z + size.z * next()};
  }

 private:
  std::uint64_t state_ = 20041101;
};

Box3 box_of(const Vec3& low, const Vec3& high) {
  Box3 box;
  box.add(low);
  box.add(high);
  return box;
}

Source point_source(const Vec3& at, double spacing, double inner, double outer) {
  return {{{at, spacing, inner, outer}}};
}

const Box3 unit_box = box_of({0, 0, 0}, {1, 1, 1});

SpacingField graded_field() {
  SpacingOptions options;
  options.background = 0.3;
  options.sources = {point_source({0.3, 0.4, 0.5}, 0.02, 0.1, 0.3)};
  return make_spacing_field(shapes::unit_cube(), options);
}

using Key = std::tuple<double, double, double>;
Key key(const Vec3& p) { return {p.x, p.y, p.z}; }

TEST(SpacingField, constant_is_exact_everywhere) {
  const SpacingField field(0.1);
  EXPECT_EQ(field.at({0, 0, 0}), 0.1);
  EXPECT_EQ(field.at({-1e9, 3, 1e12}), 0.1);
}

TEST(SpacingField, its_smallest_is_nowhere_undercut_and_nearly_reached) {
  EXPECT_EQ(SpacingField(0.1).smallest(), 0.1);
  const SpacingField field = graded_field();
  Dice dice;
  for (int i = 0; i < 1000; ++i) EXPECT_LE(field.smallest(), field.at(dice.in(unit_box)));
  EXPECT_GT(field.smallest(), 0.95 * field.at({0.3, 0.4, 0.5}));
}

TEST(SpacingField, is_the_background_where_nobody_asks) {
  SpacingOptions options;
  options.background = 0.25;
  options.inherit_surface = false;
  const SpacingField field = make_spacing_field(shapes::unit_cube(), options);
  Dice dice;
  for (int i = 0; i < 100; ++i)
    EXPECT_FLOAT_EQ(static_cast<float>(field.at(dice.in(unit_box))), 0.25F);
}

TEST(SpacingField, is_finite_without_any_demand) {
  SpacingOptions options;
  options.inherit_surface = false;
  const SpacingField field = make_spacing_field(shapes::unit_cube(), options);
  EXPECT_FLOAT_EQ(static_cast<float>(field.at({0.5, 0.5, 0.5})), 1.0F);
}

TEST(SpacingField, equals_the_source_inside_its_inner_radius) {
  const SpacingField field = graded_field();
  const Vec3 centre{0.3, 0.4, 0.5};
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = dice.in(unit_box);
    // A cell across the radius interpolates: stay one spacing inside.
    if (distance(p, centre) > 0.1 - 0.03) continue;
    EXPECT_NEAR(field.at(p), 0.02, 1e-6);
  }
}

TEST(SpacingField, follows_the_decay_of_a_source) {
  SpacingOptions options;
  options.background = 0.2;
  options.inherit_surface = false;
  options.growth = 10;
  options.sources = {point_source({0.5, 0.5, 0.5}, 0.05, 0.1, 0.4)};
  const SpacingField field = make_spacing_field(shapes::unit_cube(), options);
  for (const double r : {0.15, 0.2, 0.25, 0.3, 0.35}) {
    const double expected = 0.05 * std::pow(4.0, (r - 0.1) / 0.3);
    EXPECT_NEAR(field.at({0.5 + r, 0.5, 0.5}) / expected, 1, 0.15) << r;
  }
  EXPECT_NEAR(field.at({0.01, 0.01, 0.01}), 0.2, 0.01);
}

TEST(SpacingField, takes_the_smallest_of_overlapping_sources) {
  SpacingOptions options;
  options.background = 0.3;
  options.sources = {point_source({0.5, 0.5, 0.5}, 0.05, 0.3, 0.4),
                     point_source({0.5, 0.5, 0.5}, 0.02, 0.1, 0.2)};
  const SpacingField field = make_spacing_field(shapes::unit_cube(), options);
  EXPECT_NEAR(field.at({0.5, 0.5, 0.5}), 0.02, 1e-6);
  EXPECT_NEAR(field.at({0.5, 0.5, 0.75}), 0.05, 1e-3);
}

TEST(SpacingField, matches_the_edges_of_a_well_shaped_surface) {
  const SurfaceMesh sphere = shapes::sphere({1, 2, 3}, 1, 4);
  const SpacingField field = make_spacing_field(sphere, {});
  for (const Triangle& t : sphere.triangles) {
    const auto v = [&](std::size_t k) { return sphere.vertices[static_cast<std::size_t>(t[k])]; };
    const double length = (distance(v(0), v(1)) + distance(v(1), v(2)) + distance(v(2), v(0))) / 3;
    EXPECT_NEAR(field.at((v(0) + v(1) + v(2)) / 3) / length, 1, 0.15);
  }
}

/// Along cell edges the growth is exact, between corners the interpolation may exceed it a little.
void expect_growth(const SpacingField& field, const Box3& box, double growth) {
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 a = dice.in(box);
    const Vec3 b = dice.in(box);
    EXPECT_LE(std::abs(field.at(a) - field.at(b)), 1.15 * growth * distance(a, b) + 1e-6);
  }
}

TEST(SpacingField, grows_no_faster_than_asked_from_a_source) {
  expect_growth(graded_field(), unit_box, 0.3);
}

TEST(SpacingField, grows_no_faster_than_asked_from_a_surface) {
  SpacingOptions options;
  options.growth = 0.15;
  const SurfaceMesh shell = shapes::nested_spheres(3);
  expect_growth(make_spacing_field(shell, options), bounding_box(shell.vertices), 0.15);
}

TEST(SpacingField, limits_a_line_whose_spacing_changes_too_fast) {
  SpacingOptions options;
  options.background = 1;
  options.inherit_surface = false;
  options.growth = 0.2;
  options.sources = {{{{{0.2, 0.5, 0.5}, 0.02, 0.02, 0.1}, {{0.5, 0.5, 0.5}, 0.5, 0.2, 0.3}}}};
  const SpacingField field = make_spacing_field(shapes::unit_cube(), options);
  expect_growth(field, unit_box, 0.2);
  EXPECT_NEAR(field.at({0.2, 0.5, 0.5}), 0.02, 0.004);
}

TEST(SpacingField, limits_a_line_whose_radius_changes_too_fast) {
  SpacingOptions options;
  options.background = 1;
  options.inherit_surface = false;
  options.growth = 0.2;
  options.sources = {{{{{0.35, 0.5, 0.5}, 0.03, 0.01, 0.02}, {{0.55, 0.5, 0.5}, 0.03, 0.4, 0.41}}}};
  expect_growth(make_spacing_field(shapes::unit_cube(), options), unit_box, 0.2);
}

TEST(SpacingField, changes_continuously_across_cells) {
  const SpacingField field = graded_field();
  Dice dice;
  for (int line = 0; line < 20; ++line) {
    const Vec3 a = dice.in(unit_box);
    const Vec3 b = dice.in(unit_box);
    const int steps = 5000;
    double before = field.at(a);
    for (int i = 1; i <= steps; ++i) {
      const double now = field.at(a + (static_cast<double>(i) / steps) * (b - a));
      EXPECT_LE(std::abs(now - before), 2 * 0.3 * distance(a, b) / steps + 1e-7);
      before = now;
    }
  }
}

TEST(SpacingField, outside_is_that_of_the_nearest_point_of_its_box) {
  const SpacingField field = graded_field();
  EXPECT_EQ(field.at({1e30, -1e30, 5}), field.at({1e9, -1e9, 5}));
  EXPECT_TRUE(std::isfinite(field.at({-HUGE_VAL, 0, HUGE_VAL})));
  EXPECT_GT(field.at({NAN, 0, 0}), 0);
}

TEST(SpacingField, bytes_are_the_same_each_time) {
  EXPECT_EQ(graded_field().to_bytes(), graded_field().to_bytes());
}

TEST(SpacingField, comes_back_from_bytes) {
  const SpacingField field = graded_field();
  const std::string bytes = field.to_bytes();
  const SpacingField back = SpacingField::from_bytes(bytes, "test");
  EXPECT_EQ(back.to_bytes(), bytes);
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = dice.in(box_of({-1, -1, -1}, {2, 2, 2}));
    EXPECT_EQ(back.at(p), field.at(p));
  }
  EXPECT_EQ(SpacingField::from_bytes(SpacingField(0.7).to_bytes(), "test").at({1, 2, 3}), 0.7);
}

TEST(SpacingField, comes_back_from_a_file_that_may_be_removed_while_it_is_used) {
  const TempFolder folder;
  const SpacingField field = graded_field();
  const std::filesystem::path path = folder.path() / "spacing";
  write_file_atomically(path, field.to_bytes());
  const SpacingField back = SpacingField::from_file(path, "test");
  std::filesystem::remove(path);
  EXPECT_EQ(back.to_bytes(), field.to_bytes());
  EXPECT_EQ(back.smallest(), field.smallest());
  const Box3 box = box_of({-1, -1, -1}, {2, 2, 2});
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = dice.in(box);
    EXPECT_EQ(back.at(p), field.at(p));
  }
  EXPECT_EQ(back.lattice_nodes(box).size(), field.lattice_nodes(box).size());
}

TEST(SpacingField, refuses_a_damaged_file) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "spacing";
  EXPECT_THROW(SpacingField::from_file(path, "missing"), IoError);
  std::string bytes = graded_field().to_bytes();
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  write_file_atomically(path, bytes);
  EXPECT_THROW(SpacingField::from_file(path, "damaged"), CorruptFile);
  write_file_atomically(path, "");
  EXPECT_THROW(SpacingField::from_file(path, "empty"), CorruptFile);
}

TEST(SpacingField, refuses_damaged_bytes) {
  const std::string bytes = graded_field().to_bytes();
  EXPECT_THROW(SpacingField::from_bytes("", "empty"), CorruptFile);
  EXPECT_THROW(SpacingField::from_bytes(bytes.substr(0, bytes.size() - 1), "cut"), CorruptFile);
  EXPECT_THROW(SpacingField::from_bytes(bytes + "x", "long"), CorruptFile);
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 97) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    EXPECT_THROW(SpacingField::from_bytes(damaged, "damaged"), CorruptFile) << at;
  }
}

TEST(SpacingField, refuses_bad_options) {
  const SurfaceMesh cube = shapes::unit_cube();
  const auto with = [&](const Source& source) {
    SpacingOptions options;
    options.sources = {source};
    return make_spacing_field(cube, options);
  };
  EXPECT_THROW(with(point_source({}, 0, 1, 2)), InvalidInput);
  EXPECT_THROW(with(point_source({}, 1, -1, 2)), InvalidInput);
  EXPECT_THROW(with(point_source({}, 1, 2, 1)), InvalidInput);
  EXPECT_THROW(with(point_source({NAN, 0, 0}, 1, 1, 2)), InvalidInput);
  EXPECT_THROW(with({}), InvalidInput);
  SpacingOptions still;
  still.growth = 0;
  EXPECT_THROW(make_spacing_field(cube, still), InvalidInput);
  EXPECT_THROW(make_spacing_field({}, {}), InvalidInput);
}

TEST(LatticeNodes, of_a_constant_field_are_body_centred_cubic) {
  const double h = 0.1;
  const auto nodes = SpacingField(h).lattice_nodes(unit_box);
  const double cell = h / 0.92;
  EXPECT_NEAR(static_cast<double>(nodes.size()), 2 / (cell * cell * cell), 300);
  for (const LatticeNode& node : nodes) {
    EXPECT_NEAR(node.cell_edge, cell, 1e-6 * cell);
    double nearest = 1;
    for (const LatticeNode& other : nodes) {
      const double d = distance(node.at, other.at);
      if (d > 0) nearest = std::min(nearest, d);
    }
    EXPECT_NEAR(nearest, std::sqrt(0.75) * node.cell_edge, 1e-9);
  }
}

TEST(LatticeNodes, of_a_uniform_background_have_the_ideal_cell) {
  SpacingOptions options;
  options.background = 0.07;
  options.inherit_surface = false;
  const auto nodes = make_spacing_field(shapes::unit_cube(), options).lattice_nodes(unit_box);
  EXPECT_NEAR(static_cast<double>(nodes.size()), 2 * std::pow(0.92 / 0.07, 3), 600);
  for (const LatticeNode& node : nodes) EXPECT_NEAR(node.cell_edge, 0.07 / 0.92, 1e-6);
}

TEST(LatticeNodes, come_once_each) {
  for (const auto& nodes : {graded_field().lattice_nodes(box_of({-1, -1, -1}, {2, 2, 2})),
                            make_spacing_field(shapes::nested_spheres(3), {})
                                .lattice_nodes(box_of({-2, -2, -2}, {2, 2, 2}))}) {
    std::map<Key, int> seen;
    for (const LatticeNode& node : nodes) ++seen[key(node.at)];
    EXPECT_EQ(seen.size(), nodes.size());
  }
}

TEST(LatticeNodes, of_overlapping_boxes_agree_to_the_last_bit) {
  const SpacingField field = graded_field();
  const auto all = field.lattice_nodes(box_of({-1, -1, -1}, {2, 2, 2}));
  Dice dice;
  for (int trial = 0; trial < 30; ++trial) {
    Box3 box;
    box.add(dice.in(unit_box));
    box.add(dice.in(unit_box));
    // Bounds that are nodes themselves: the box is closed.
    if (trial % 2 == 1) box.add(all[static_cast<std::size_t>(trial) * 7].at);
    std::map<Key, double> expected;
    for (const LatticeNode& node : all) {
      Box3 here;
      here.add(node.at);
      if (here.overlaps(box)) expected[key(node.at)] = node.cell_edge;
    }
    std::map<Key, double> found;
    for (const LatticeNode& node : field.lattice_nodes(box)) found[key(node.at)] = node.cell_edge;
    EXPECT_EQ(found, expected);
  }
}

/// Reconstructs the leaf cells from their centres, and asks each corner for its smallest cell.
TEST(LatticeNodes, carry_the_edge_of_their_smallest_cell) {
  const auto nodes = graded_field().lattice_nodes(box_of({-1, -1, -1}, {2, 2, 2}));
  std::map<Key, double> edge;
  for (const LatticeNode& node : nodes) edge[key(node.at)] = node.cell_edge;
  std::map<Key, double> smallest;
  std::size_t cells = 0;
  for (const LatticeNode& node : nodes) {
    // A centre has all eight corners of its own edge and is nobody's corner.
    bool is_centre = true;
    const double half = node.cell_edge / 2;
    std::vector<Key> corners;
    for (unsigned k = 0; k < 8; ++k) {
      const auto sign = [k](unsigned bit) { return (k >> bit & 1U) != 0 ? 1.0 : -1.0; };
      corners.push_back(key(node.at + Vec3{sign(0) * half, sign(1) * half, sign(2) * half}));
      const auto found = edge.find(corners.back());
      is_centre = is_centre && found != edge.end() && found->second <= node.cell_edge;
    }
    if (!is_centre) continue;
    ++cells;
    for (const Key& corner : corners) {
      const auto [at, is_new] = smallest.try_emplace(corner, node.cell_edge);
      if (!is_new) at->second = std::min(at->second, node.cell_edge);
    }
  }
  EXPECT_GT(cells, nodes.size() / 3);
  for (const auto& [corner, expected] : smallest) EXPECT_LE(edge.at(corner), expected);
}

TEST(LatticeNodes, between_two_sizes_of_cells_are_put_towards_the_larger_ones) {
  const auto nodes = graded_field().lattice_nodes(box_of({-1, -1, -1}, {2, 2, 2}));
  std::map<Key, double> edge;
  for (const LatticeNode& node : nodes) edge[key(node.at)] = node.cell_edge;
  // A centre has its eight corners; that of a larger cell lies half its edge from the node.
  const auto is_cell = [&edge](const Vec3& centre, double of_edge) {
    const auto found = edge.find(key(centre));
    return found != edge.end() && found->second == of_edge;
  };
  std::size_t shifted = 0;
  for (const LatticeNode& node : nodes) {
    const Vec3 shift = node.place() - node.at;
    EXPECT_LE(norm(shift), 0.4 * node.cell_edge);
    if (!(norm(shift) > 0)) continue;
    ++shifted;
    // A larger cell touches the node: its centre is an edge of the small cell away on each axis at
    // most, and on the side that the node goes to.
    bool larger = false;
    for (int k = 0; k < 27; ++k) {
      const Vec3 offset =
          node.cell_edge * Vec3{double(k % 3 - 1), double(k / 3 % 3 - 1), double(k / 9 - 1)};
      larger = larger || (dot(offset, shift) > 0 && is_cell(node.at + offset, 2 * node.cell_edge));
    }
    EXPECT_TRUE(larger);
  }
  EXPECT_GT(shifted, nodes.size() / 50);
  EXPECT_LT(shifted, nodes.size() / 2);
  for (const LatticeNode& node : SpacingField(0.1).lattice_nodes(unit_box)) {
    EXPECT_EQ(node.place(), node.at);
  }
}

TEST(LatticeNodes, of_an_empty_box_are_none) {
  EXPECT_TRUE(graded_field().lattice_nodes(Box3{}).empty());
  EXPECT_TRUE(graded_field().lattice_nodes(box_of({50, 50, 50}, {51, 51, 51})).empty());
}

}  // namespace
}  // namespace tetfarm
