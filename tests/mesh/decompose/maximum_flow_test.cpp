#include "mesh/decompose/maximum_flow.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(MaximumFlow, cuts_the_narrowest_place) {
  // source 0 - 1 - 2 - sink 3, narrowest between 1 and 2.
  FlowNetwork network(4);
  network.add_edge(0, 1, 10, 0);
  network.add_edge(1, 2, 3, 3);
  network.add_edge(2, 3, 10, 0);
  EXPECT_EQ(network.source_side_of_minimum_cut(0, 3),
            (std::vector<bool>{true, true, false, false}));
}

TEST(MaximumFlow, takes_back_flow_that_is_in_the_way) {
  // The first shortest path goes across; the full flow of 2 must take half of it back.
  FlowNetwork network(6);
  // Of a node's edges the last is tried first.
  network.add_edge(0, 2, 1, 0);
  network.add_edge(0, 1, 1, 0);
  network.add_edge(1, 4, 1, 0);
  network.add_edge(1, 3, 1, 0);
  network.add_edge(2, 3, 1, 0);
  network.add_edge(3, 5, 1, 0);
  network.add_edge(4, 5, 1, 0);
  // Both source arcs are full: the cut nearest to the source is there.
  EXPECT_EQ(network.source_side_of_minimum_cut(0, 5),
            (std::vector<bool>{true, false, false, false, false, false}));
}

TEST(MaximumFlow, leaves_all_that_cannot_be_reached_on_the_other_side) {
  FlowNetwork network(3);
  network.add_edge(0, 1, 5, 5);
  EXPECT_EQ(network.source_side_of_minimum_cut(0, 2), (std::vector<bool>{true, true, false}));
}

}  // namespace
}  // namespace tetfarm
