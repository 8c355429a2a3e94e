#include "mesh/quality/cut_nodes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;

/// Parts that a test fills in.
class Parts : public MeshSource {
 public:
  std::size_t size() const override { return parts.size(); }
  NumberedPart part(std::size_t i) const override { return parts.at(i); }
  bool knows_subdomains() const override { return knows; }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {}; }

  void add(std::int32_t region, std::vector<std::int64_t> nodes, std::vector<Tet> tets = {},
           std::vector<std::int32_t> regions = {}) {
    NumberedPart& part = parts.emplace_back();
    part.number = static_cast<std::int32_t>(parts.size()) - 1;
    part.region = region;
    part.nodes.resize(nodes.size());
    part.local2global = std::move(nodes);
    part.tets = std::move(tets);
    part.region_of_tet = std::move(regions);
  }

  std::vector<NumberedPart> parts;
  bool knows = true;
};

TEST(RangesOfTets, are_those_of_consecutive_ones_of_a_region) {
  NumberedPart part;
  part.region = 4;
  EXPECT_TRUE(ranges_of(part).empty());
  part.tets.resize(5);
  std::string text;
  const auto list = [&] {
    text.clear();
    for (const TetRange& range : ranges_of(part)) {
      text += std::to_string(range.first) + "-" + std::to_string(range.last) + " of " +
              std::to_string(range.region) + "; ";
    }
    return text;
  };
  EXPECT_EQ(list(), "0-5 of 4; ");
  part.region_of_tet = {1, 1, 3, 5, 5};
  EXPECT_EQ(list(), "0-2 of 1; 2-3 of 3; 3-5 of 5; ");
}

TEST(CutNodesOfParts, are_those_that_two_parts_have_in_one_region) {
  Parts source;
  source.add(1, {0, 1, 2, 3});
  source.add(1, {3, 2, 7});
  source.add(2, {7, 0, 8});
  source.add(2, {8, 3, 2});
  const CutNodes cuts(source);
  EXPECT_THAT(cuts.of(source.parts[0], 1), ElementsAre(false, false, true, true));
  EXPECT_THAT(cuts.of(source.parts[1], 1), ElementsAre(true, true, false));
  EXPECT_THAT(cuts.of(source.parts[2], 2), ElementsAre(false, false, true));
  EXPECT_THAT(cuts.of(source.parts[3], 2), ElementsAre(true, false, false))
      << "of the other region they are no cut";
  EXPECT_THAT(cuts.of(source.parts[0], 3), ElementsAre(false, false, false, false));
}

TEST(CutNodesOfParts, of_several_regions_are_told_of_each_by_its_tets) {
  Parts source;
  source.add(1, {0, 1, 2, 3, 4, 5}, {{0, 1, 2, 3}, {1, 2, 3, 4}}, {1, 2});
  source.add(2, {4, 1, 0, 9});
  source.add(1, {3, 5, 0, 11});
  const CutNodes cuts(source);
  EXPECT_THAT(cuts.of(source.parts[0], 1), ElementsAre(true, false, false, true, false, false));
  EXPECT_THAT(cuts.of(source.parts[0], 2), ElementsAre(false, true, false, false, true, false));
}

TEST(CutNodesOfParts, are_none_where_parts_are_pieces_of_a_file) {
  Parts source;
  source.add(1, {0, 1});
  source.add(1, {1, 2});
  source.knows = false;
  EXPECT_THAT(CutNodes(source).of(source.parts[0], 1), ElementsAre(false, false));
  source.knows = true;
  EXPECT_THAT(CutNodes(source).of(source.parts[0], 1), ElementsAre(false, true));
}

}  // namespace
}  // namespace tetfarm
