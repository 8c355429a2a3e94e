#include "mesh/arrangement/chain_triangle.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TriangleChain chain_of(std::vector<Vec3> vertices, const std::vector<Triangle>& triangles) {
  TriangleChain chain{std::move(vertices), {}};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    chain.triangles.push_back({triangles[t], 1, static_cast<std::int32_t>(t), false, false});
  }
  return chain;
}

const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(ChainTriangle, one_of_several_that_face_alike_stays_as_often_as_they_were_there) {
  TriangleChain chain = chain_of(square, {{0, 1, 2}, {2, 0, 1}, {0, 2, 1}, {1, 2, 0}});
  merge_equals(chain);
  ASSERT_THAT(chain.triangles, SizeIs(1));
  EXPECT_EQ(chain.triangles[0].times, 2);
  EXPECT_EQ(chain.triangles[0].nodes, (Triangle{0, 1, 2}));
}

TEST(ChainTriangle, what_is_left_faces_as_most_do_and_has_the_patch_of_the_first_of_them) {
  TriangleChain chain = chain_of(square, {{0, 2, 1}, {0, 1, 2}, {1, 2, 0}});
  merge_equals(chain);
  ASSERT_THAT(chain.triangles, SizeIs(1));
  EXPECT_EQ(chain.triangles[0].nodes, (Triangle{0, 1, 2}));
  EXPECT_EQ(chain.triangles[0].patch, 1);
}

TEST(ChainTriangle, back_to_back_leaves_nothing) {
  TriangleChain chain = chain_of(square, {{0, 1, 2}, {0, 2, 1}});
  merge_equals(chain);
  EXPECT_THAT(chain.triangles, IsEmpty());
}

TEST(ChainTriangle, vertices_at_one_place_become_one_and_flat_triangles_go) {
  TriangleChain chain =
      chain_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 3, 2}, {0, 1, 4}});
  merge_equals(chain);
  ASSERT_THAT(chain.triangles, SizeIs(1));
  EXPECT_EQ(chain.triangles[0].nodes, (Triangle{0, 1, 2}));
}

TEST(ChainTriangle, those_that_meet_are_found_once_more_only_where_one_has_changed) {
  TriangleChain chain = chain_of({{0, 0, 0},
                                  {2, 0, 0},
                                  {0, 2, 0},
                                  {0.5, 0.5, -1},
                                  {0.5, 0.5, 1},
                                  {3, 3, 0},
                                  {9, 9, 9},
                                  {9, 9, 8},
                                  {9, 8, 9}},
                                 {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  EXPECT_THAT(meeting_pairs(chain).value(), ElementsAre(TrianglePair{0, 1}));
  EXPECT_FALSE(chain.triangles[0].is_clear);
  EXPECT_TRUE(chain.triangles[2].is_clear);
  EXPECT_THAT(meeting_pairs(chain).value(), SizeIs(1));
  for (ChainTriangle& t : chain.triangles) t.is_clear = true;
  EXPECT_THAT(meeting_pairs(chain).value(), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
