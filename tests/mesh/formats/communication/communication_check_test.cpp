#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "mesh/formats/communication/communication_table.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Tables = std::vector<CommunicationTable>;

/// Three parts of a mesh of 5 nodes: 0 and 1 share the nodes 1 and 2, all share node 2.
Tables three_parts() {
  Tables tables(3);
  for (std::int32_t i = 0; i < 3; ++i) {
    tables[static_cast<std::size_t>(i)].part = i;
    tables[static_cast<std::size_t>(i)].parts = 3;
    tables[static_cast<std::size_t>(i)].nodes_of_mesh = 5;
  }
  tables[0].local2global = {0, 1, 2};
  tables[0].owner = {0, 0, 0};
  tables[0].neighbours = {{1, {1, 2}, {1, 0}}, {2, {2}, {1}}};
  tables[1].local2global = {2, 1, 3};
  tables[1].owner = {0, 0, 1};
  tables[1].neighbours = {{0, {1, 0}, {1, 2}}, {2, {0}, {1}}};
  tables[2].local2global = {4, 2};
  tables[2].owner = {2, 0};
  tables[2].neighbours = {{0, {1}, {2}}, {1, {1}, {0}}};
  return tables;
}

std::vector<std::string> complaints_after(const std::function<void(Tables&)>& change) {
  Tables tables = three_parts();
  change(tables);
  return communication_complaints(static_cast<std::int32_t>(tables.size()), [&](std::int32_t i) {
    return tables.at(static_cast<std::size_t>(i));
  });
}

TEST(CommunicationCheck, has_nothing_to_say_of_tables_that_are_right) {
  EXPECT_THAT(complaints_after([](Tables&) {}), IsEmpty());
}

TEST(CommunicationCheck, tells_lists_that_are_not_those_of_the_other_side) {
  EXPECT_THAT(complaints_after([](Tables& t) { t[0].neighbours[0].remote[0] = 2; }),
              ElementsAre("part 0: its list with part 1 differs from that of the other side",
                          "part 1: its list with part 0 differs from that of the other side"));
  EXPECT_THAT(complaints_after([](Tables& t) { t[1].neighbours[0].neighbour = 1; }),
              testing::Contains("part 1: a neighbour does not exist"));
  EXPECT_THAT(complaints_after([](Tables& t) { t[1].neighbours[1].neighbour = 3; }),
              testing::Contains("part 1: a neighbour does not exist"));
  EXPECT_THAT(complaints_after([](Tables& t) { t[1].neighbours[1].neighbour = -1; }),
              testing::Contains("part 1: a neighbour does not exist"));
}

TEST(CommunicationCheck, tells_a_list_with_other_nodes_or_in_another_order) {
  const auto complaints = complaints_after([](Tables& t) {
    t[0].neighbours[0].local = {2, 1};
    t[0].neighbours[0].remote = {0, 1};
    t[1].neighbours[0].local = {0, 1};
    t[1].neighbours[0].remote = {2, 1};
  });
  EXPECT_THAT(complaints,
              ElementsAre("part 0: its list with part 1 is not in the order of the whole mesh",
                          "part 1: its list with part 0 is not in the order of the whole mesh"));
  EXPECT_THAT(complaints_after([](Tables& t) { t[2].local2global[1] = 3; }),
              testing::Contains("part 0: its list with part 2 has nodes that differ"));
}

TEST(CommunicationCheck, tells_owners_that_differ_or_are_not_the_lowest) {
  EXPECT_THAT(complaints_after([](Tables& t) { t[2].owner[1] = 1; }),
              ElementsAre("part 0: its list with part 2 has a node with two owners",
                          "part 1: its list with part 2 has a node with two owners",
                          "part 2: an owner is not the lowest part with the node",
                          "part 2: its list with part 0 has a node with two owners",
                          "part 2: its list with part 1 has a node with two owners"));
  EXPECT_THAT(complaints_after([](Tables& t) { t[1].owner[2] = 2; }),
              ElementsAre("part 1: an owner is not the lowest part with the node",
                          "part 0: all parts own 4 nodes of 5"));
}

TEST(CommunicationCheck, tells_nodes_that_are_none_and_shared_ones_that_a_list_lacks) {
  EXPECT_THAT(complaints_after([](Tables& t) { t[1].local2global[2] = 5; }),
              ElementsAre("part 1: a node is out of range"));
  EXPECT_THAT(complaints_after([](Tables& t) { t[1].local2global[2] = -1; }),
              ElementsAre("part 1: a node is out of range"));
  EXPECT_THAT(complaints_after([](Tables& t) {
                t[1].neighbours.pop_back();
                t[2].neighbours.pop_back();
              }),
              ElementsAre("part 1: node 2 is shared, but not in all lists",
                          "part 2: node 2 is shared, but not in all lists"));
}

TEST(CommunicationCheck, says_no_more_than_twenty_things) {
  Tables tables(1);
  tables[0].parts = 1;
  tables[0].nodes_of_mesh = 1;
  tables[0].local2global.assign(30, 7);
  tables[0].owner.assign(30, 0);
  const auto complaints = communication_complaints(1, [&](std::int32_t) { return tables[0]; });
  EXPECT_EQ(complaints.size(), 20U);
}

}  // namespace
}  // namespace tetfarm
