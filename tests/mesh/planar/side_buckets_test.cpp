#include "mesh/planar/side_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tetfarm {
namespace {

TEST(SideBuckets, hold_each_side_once_in_the_bucket_of_its_node) {
  std::mt19937_64 random(3);
  for (const std::size_t nodes : {3, 10, 200}) {
    std::vector<TriangleComplex::Nodes> triangles(2 * nodes);
    for (TriangleComplex::Nodes& n : triangles) {
      for (std::int32_t& v : n) v = static_cast<std::int32_t>(random() % nodes);
    }
    const SideBuckets buckets(nodes, triangles,
                              [](std::int32_t a, std::int32_t b) { return std::min(a, b); });
    ASSERT_EQ(buckets.nodes(), nodes);
    std::vector<EdgeHandle> all;
    for (std::size_t node = 0; node < nodes; ++node) {
      for (const EdgeHandle side : buckets.of(node)) {
        const TriangleComplex::Nodes& n = triangles[static_cast<std::size_t>(triangle_of(side))];
        const std::int32_t a = n[static_cast<std::size_t>(next(edge_of(side)))];
        const std::int32_t b = n[static_cast<std::size_t>(previous(edge_of(side)))];
        EXPECT_EQ(static_cast<std::size_t>(std::min(a, b)), node);
        all.push_back(side);
      }
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all.size(), 3 * triangles.size());
    EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
  }
}

TEST(SideBuckets, of_no_triangles_are_empty) {
  const SideBuckets buckets(2, {}, [](std::int32_t a, std::int32_t /*b*/) { return a; });
  EXPECT_EQ(buckets.nodes(), 2U);
  EXPECT_TRUE(buckets.of(0).empty());
  EXPECT_TRUE(buckets.of(1).empty());
}

}  // namespace
}  // namespace tetfarm
