#include "mesh/remeshing/triangle_ring.h"

#include <gmock/gmock.h>

#include <random>

namespace tetfarm {
namespace {

using ::testing::ElementsAreArray;

TEST(TriangleRing, holds_what_a_list_holds_however_many_come_and_go) {
  TriangleRing ring;
  std::vector<std::int32_t> list;
  std::mt19937_64 random(1);
  for (std::int32_t step = 0; step < 5000; ++step) {
    // Few for a while, then many.
    const std::size_t most = step / 500 % 2 == 0 ? 9 : 30;
    if (list.size() < most && random() % 2 == 0) {
      ring.add(step);
      list.push_back(step);
    } else if (!list.empty()) {
      const std::int32_t gone = list[random() % list.size()];
      ring.remove(gone);
      std::erase(list, gone);
    }
    ASSERT_THAT(ring.triangles(), ElementsAreArray(list)) << step;
  }
}

TEST(TriangleRing, is_copied_whole) {
  TriangleRing ring;
  for (std::int32_t t = 0; t < 20; ++t) ring.add(t);
  const TriangleRing copy = ring;
  ring.remove(3);
  EXPECT_EQ(copy.triangles().size(), 20U);
  EXPECT_EQ(copy.triangles()[3], 3);
}

}  // namespace
}  // namespace tetfarm
