#include "mesh/layers/top_heights.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_sphere.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t vertex_bit = std::uint64_t{1} << 32U;

std::vector<TopHeight> heights_of(const LayerPlan& plan, const SurfaceMesh& surface) {
  return top_heights(plan, surface, unlayered_domain(plan, surface, TreePath{2}, top_of_layers));
}

class TopHeights : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& bytes) const {
    const std::filesystem::path path =
        testing::TempDir() + "/" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
};

TEST_F(TopHeights, are_those_of_the_last_layer_where_all_lines_are_alike) {
  const test::LayeredSphere sphere;
  const std::vector<TopHeight> heights = heights_of(sphere.plan, sphere.surface);
  EXPECT_EQ(heights.size(), sphere.surface.triangles.size());
  const double last = height_of_layer(sphere.plan.lines[0].law, 5);
  for (const TopHeight& top : heights) EXPECT_NEAR(top.height, last, 0.02 * last);
}

TEST_F(TopHeights, are_told_only_where_a_column_ends_in_a_prism) {
  const test::LayeredSphere sphere = test::LayeredSphere::uneven();
  std::size_t with_prism = 0;
  for (const std::int32_t t : sphere.plan.wall) {
    const auto lines = lines_of(sphere.plan, sphere.surface, t);
    const int stop = sphere.plan.lines[at(lines[0])].stop;
    const bool is_even = std::all_of(lines.begin(), lines.end(), [&](std::int32_t line) {
      return sphere.plan.lines[at(line)].stop == stop;
    });
    with_prism += is_even && stop > 0 ? 1 : 0;
  }
  EXPECT_GT(with_prism, 0U);
  EXPECT_LT(with_prism, sphere.plan.wall.size());
  EXPECT_EQ(heights_of(sphere.plan, sphere.surface).size(), with_prism);
}

/// Seven edges of three pieces and corners: fans have triangles of their own in the top.
TEST_F(TopHeights, are_told_of_fans_from_their_second_layer_on) {
  const test::LayeredBody one(test::cube_in_box(3), test::fanned(0.02, 1, 60));
  const test::LayeredBody five(test::cube_in_box(3), test::fanned(0.02, 5, 60));
  EXPECT_EQ(heights_of(one.plan, one.surface).size(), one.plan.wall.size());
  EXPECT_GT(heights_of(five.plan, five.surface).size(), five.plan.wall.size());
}

TEST_F(TopHeights, are_not_told_of_layers_that_absorb) {
  test::LayeredSphere sphere;
  for (LayerLine& line : sphere.plan.lines) line.of_pml = true;
  EXPECT_THAT(heights_of(sphere.plan, sphere.surface), testing::IsEmpty());
}

TEST_F(TopHeights, are_found_in_a_file_by_their_first_nodes) {
  const test::LayeredSphere sphere;
  const std::vector<TopHeight> heights = heights_of(sphere.plan, sphere.surface);
  const auto path = written(top_heights_to_bytes(heights));
  std::vector<std::uint64_t> firsts;
  std::vector<TopHeight> expected;
  for (std::uint64_t node = 3; node < sphere.plan.lines.size(); node += 7) firsts.push_back(node);
  for (const TopHeight& top : heights) {
    if (std::binary_search(firsts.begin(), firsts.end(), top.nodes[0])) expected.push_back(top);
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(TopHeightsFile(path, "heights").with_first(firsts), expected);
  EXPECT_THAT(TopHeightsFile(path, "heights").with_first({}), testing::IsEmpty());
  const std::vector<std::uint64_t> beyond = {vertex_bit + 5};
  EXPECT_THAT(TopHeightsFile(path, "heights").with_first(beyond), testing::IsEmpty());
}

TEST_F(TopHeights, keep_vertices_of_the_surface_and_nodes_of_the_top_apart) {
  EXPECT_EQ(top_key({top_of_layers, 7}), 7U);
  EXPECT_EQ(top_key({0, 7}), vertex_bit + 7);
}

TEST_F(TopHeights, of_a_damaged_file_are_refused) {
  const std::vector<TopHeight> heights = {{{1, 2, 3}, 0.5}, {{2, 3, 4}, 0.25}};
  const std::string good = top_heights_to_bytes(heights);
  const std::vector<std::uint64_t> firsts = {1, 2};
  const auto read = [&](const std::string& bytes) {
    return TopHeightsFile(written(bytes), "heights").with_first(firsts);
  };
  EXPECT_EQ(read(good), heights);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string broken = good;
    broken[i] = static_cast<char>(broken[i] ^ 0x40);
    EXPECT_THROW(read(broken), CorruptFile) << i;
    EXPECT_THROW(read(good.substr(0, i)), CorruptFile) << i;
  }
  EXPECT_THROW(read(top_heights_to_bytes(std::vector<TopHeight>{{{1, 2, 3}, 0}})), CorruptFile);
  EXPECT_THROW(read(top_heights_to_bytes(std::vector<TopHeight>{{{1, 3, 2}, 1}})), CorruptFile);
}

}  // namespace
}  // namespace tetfarm
