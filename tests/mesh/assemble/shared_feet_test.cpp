#include "mesh/assemble/shared_feet.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

/// Two lines of two layers on the nodes 0 and 2, with tops 10 and 12 and nodes of their own
/// between.
NumberedPart chunk_of(std::int64_t foot, std::int64_t top, std::int64_t between) {
  NumberedPart chunk;
  chunk.local2global = {foot, between, top, 30};
  chunk.feet.foot = {foot, foot, foot, no_foot};
  chunk.feet.depth = {0, 1, 2, no_foot};
  return chunk;
}

SharedFeet feet_of_two_chunks() {
  SharedFeet feet(20);
  feet.add(chunk_of(2, 12, 25));
  feet.add(chunk_of(0, 10, 24));
  feet.add(chunk_of(2, 12, 25));
  feet.finish();
  return feet;
}

TEST(SharedFeet, are_told_of_the_nodes_of_the_wall_and_of_the_top) {
  const std::vector<std::int64_t> nodes = {12, 5, 0, 10, 2};
  const NodeFeet feet = feet_of_two_chunks().of(nodes);
  EXPECT_EQ(feet.foot, (std::vector<std::int64_t>{2, no_foot, 0, 0, 2}));
  EXPECT_EQ(feet.depth, (std::vector<std::int32_t>{2, no_foot, 0, 2, 0}));
}

TEST(SharedFeet, are_none_of_nodes_that_are_in_chunks_alone) {
  const std::vector<std::int64_t> nodes = {24, 25, 30};
  const NodeFeet feet = feet_of_two_chunks().of(nodes);
  EXPECT_EQ(feet.foot, (std::vector<std::int64_t>(3, no_foot)));
  EXPECT_EQ(feet.depth, (std::vector<std::int32_t>(3, no_foot)));
}

TEST(SharedFeet, of_no_chunks_are_none) {
  SharedFeet feet(20);
  feet.finish();
  const std::vector<std::int64_t> nodes = {0, 1};
  EXPECT_EQ(feet.of(nodes).foot, (std::vector<std::int64_t>(2, no_foot)));
  EXPECT_TRUE(feet.of({}).empty());
}

}  // namespace
}  // namespace tetfarm
