#include "mesh/quality/node_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Somewhere along x, or anywhere.
struct Place {
  Place(double x) : at{x, 0, 0} {}
  Place(const Vec3& p) : at(p) {}
  Vec3 at;
};

/// Parts of nodes alone, by their numbers and places.
class NodesOnly : public MeshSource {
 public:
  using Nodes = std::vector<std::pair<std::int64_t, Place>>;
  explicit NodesOnly(std::vector<Nodes> parts) : parts_(std::move(parts)) {}
  std::size_t size() const override { return parts_.size(); }
  NumberedPart part(std::size_t i) const override {
    NumberedPart part;
    part.number = static_cast<std::int32_t>(i);
    for (const auto& [number, place] : parts_.at(i)) {
      part.local2global.push_back(number);
      part.nodes.push_back(place.at);
    }
    return part;
  }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {}; }

 private:
  std::vector<Nodes> parts_;
};

struct Checked {
  std::vector<std::int64_t> first;  ///< numbers in the order in which they were new
  std::int64_t nodes = 0;
  std::vector<std::string> lines;
};

Checked check(const NodesOnly& source, std::size_t most = 100) {
  const TempFolder folder;
  NodeCheck check(source, folder.path(), 0);
  Checked result;
  for (std::size_t i = 0; i < source.size(); ++i) {
    check.add(source.part(i),
              [&](std::int64_t number, const Vec3&) { result.first.push_back(number); });
  }
  result.nodes = check.nodes();
  result.lines = check.finish(most);
  return result;
}

TEST(NodeCheck, meets_each_node_once_whichever_parts_have_it) {
  const Checked right =
      check(NodesOnly({{{2, 0.5}, {0, 1}}, {{1, 7}, {2, 0.5}}, {{2, 0.5}, {3, 0}}}));
  EXPECT_THAT(right.first, ElementsAre(2, 0, 1, 3));
  EXPECT_EQ(right.nodes, 4);
  EXPECT_THAT(right.lines, IsEmpty());
}

TEST(NodeCheck, names_the_places_of_a_node_that_lies_elsewhere_in_another_part) {
  const NodesOnly source({{{0, 1}, {1, 2}, {2, 0.0}}, {{0, 1.5}, {1, 2}}, {{1, 2.25}, {2, -0.0}}});
  EXPECT_THAT(check(source).lines,
              ElementsAre("node 0 lies at (1, 0, 0) in sub-domain 0 and at (1.5, 0, 0) in "
                          "sub-domain 1, 0.5 apart",
                          "node 1 lies at (2, 0, 0) in sub-domain 1 and at (2.25, 0, 0) in "
                          "sub-domain 2, 0.25 apart",
                          "node 2 lies at (0, 0, 0) in sub-domain 0 and at (-0, 0, 0) in "
                          "sub-domain 2, 0 apart"));
  EXPECT_EQ(check(source, 2).lines.size(), 2U);
  EXPECT_EQ(check(source, 0).lines.size(), 0U);
}

TEST(NodeCheck, compares_places_along_each_axis) {
  const NodesOnly source({{{0, Vec3{1, 2, 3}}, {1, Vec3{1, 2, 3}}, {2, Vec3{1, 2, 3}}},
                          {{0, Vec3{0, 2, 3}}, {1, Vec3{1, 0, 3}}, {2, Vec3{1, 2, 0}}}});
  EXPECT_THAT(check(source).lines,
              ElementsAre("node 0 lies at (1, 2, 3) in sub-domain 0 and at (0, 2, 3) in "
                          "sub-domain 1, 1 apart",
                          "node 1 lies at (1, 2, 3) in sub-domain 0 and at (1, 0, 3) in "
                          "sub-domain 1, 2 apart",
                          "node 2 lies at (1, 2, 3) in sub-domain 0 and at (1, 2, 0) in "
                          "sub-domain 1, 3 apart"));
}

TEST(NodeCheck, tells_a_gap_in_the_numbers_and_the_first_that_is_missing) {
  const Checked gap = check(NodesOnly({{{0, 1}, {3, 2}}, {{1, 1}, {6, 0}}}));
  EXPECT_EQ(gap.nodes, 4);
  EXPECT_THAT(gap.lines, ElementsAre("node numbers have gaps: 4 nodes, but the largest number is 6 "
                                     "and there is no 2"));
  EXPECT_THAT(check(NodesOnly({{{1, 1}}})).lines,
              ElementsAre("node numbers have gaps: 1 nodes, but the largest number is 1 and there "
                          "is no 0"));
}

TEST(NodeCheck, refuses_numbers_that_no_mesh_with_so_many_points_could_have) {
  const auto refusal = [](std::int64_t number) -> std::string {
    try {
      check(NodesOnly({{{0, 1}}, {{number, 1}, {1, 0}}}));
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(-1), "sub-domain 1: the node number -1 is out of range");
  EXPECT_EQ(refusal(std::int64_t{2147483647} + 3),
            "sub-domain 1: the node number 2147483650 is out of range");
}

TEST(NodeCheck, of_many_shared_nodes_takes_what_memory_it_is_given) {
  NodesOnly::Nodes nodes;
  for (std::int64_t i = 0; i < 3000; ++i) nodes.emplace_back(i, static_cast<double>(i));
  NodesOnly::Nodes others = nodes;
  others[2777].second = -1;
  EXPECT_THAT(check(NodesOnly({nodes, others})).lines,
              ElementsAre("node 2777 lies at (2777, 0, 0) in sub-domain 0 and at (-1, 0, 0) in "
                          "sub-domain 1, 2778 apart"));
}

}  // namespace
}  // namespace tetfarm
