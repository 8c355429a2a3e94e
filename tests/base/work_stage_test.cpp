#include "base/work_stage.h"

#include <gtest/gtest.h>

#include <set>

namespace tetfarm {
namespace {

TEST(WorkStage, every_stage_has_a_name_of_its_own_that_leads_back_to_it) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < work_stages; ++i) {
    const auto stage = static_cast<WorkStage>(i);
    EXPECT_EQ(work_stage_of(name_of(stage)), stage);
    names.insert(name_of(stage));
  }
  EXPECT_EQ(names.size(), work_stages);
}

TEST(WorkStage, another_name_is_no_stage) {
  for (const char* name : {"", "Edges", "edges ", "polish"}) {
    EXPECT_FALSE(work_stage_of(name).has_value()) << name;
  }
}

TEST(WorkText, says_what_is_counted_and_how_many_of_them) {
  EXPECT_EQ(work_text({WorkStage::edges, 3, 312, 1204}), "recovery pass 3: 312 of 1,204 edges");
  EXPECT_EQ(work_text({WorkStage::cosmetics, 2, 5310, 0}), "cosmetics pass 2: 5,310 tries");
  EXPECT_EQ(work_text({WorkStage::points, 0, 1'204'000, 3'450'000}), "points: 1.20 M of 3.45 M");
  EXPECT_EQ(work_text({WorkStage::assemble, 0, 0, 16}), "assembling: 0 of 16 sub-domains");
}

TEST(WorkText, leaves_out_counts_that_are_not_known) {
  EXPECT_EQ(work_text({WorkStage::spacing, 0, 0, 0}), "building the spacing");
  EXPECT_EQ(work_text({WorkStage::cosmetics, 4, 0, 0}), "cosmetics pass 4");
}

TEST(GroupedCount, has_all_digits_below_a_million) {
  EXPECT_EQ(grouped_count(0), "0");
  EXPECT_EQ(grouped_count(999), "999");
  EXPECT_EQ(grouped_count(1000), "1,000");
  EXPECT_EQ(grouped_count(999'999), "999,999");
  EXPECT_EQ(grouped_count(1'000'000), "1.00 M");
  EXPECT_EQ(grouped_count(2'500'000'000), "2.50 G");
}

TEST(WorkText, has_its_words_for_each_stage) {
  std::string all;
  for (std::size_t i = 0; i < work_stages; ++i) {
    const auto stage = static_cast<WorkStage>(i);
    all += std::string(name_of(stage)) + " | " + work_text({stage, 0, 1, 2}) + "\n";
  }
  EXPECT_EQ(all,
            "read | reading: 1 of 2\n"
            "check | checking the surface: 1 of 2\n"
            "spacing | building the spacing: 1 of 2\n"
            "cut | cutting: 1 of 2 planes\n"
            "graph | graph of sub-domains: 1 of 2 sub-domains\n"
            "join | joining: 1 of 2 groups\n"
            "boundary | boundary: 1 of 2 nodes\n"
            "edges | recovery: 1 of 2 edges\n"
            "faces | recovery: 1 of 2 faces\n"
            "splits | recovery: 1 of 2 splits\n"
            "added_points | recovery: 1 of 2 added points\n"
            "points | points: 1 of 2\n"
            "cosmetics | cosmetics: 1 of 2 tries\n"
            "validate | validating: 1 of 2\n"
            "order | ordering: 1 of 2 sub-domains\n"
            "extract | extracting: 1 of 2\n"
            "number | numbering: 1 of 2\n"
            "write | writing: 1 of 2\n"
            "layers | growing layers: 1 of 2\n"
            "solve | running the solver: 1 of 2\n"
            "adapt | adapting: 1 of 2\n"
            "transfer | bringing the solution along: 1 of 2\n"
            "cycles | collecting: 1 of 2 cycles\n"
            "remeshing | remeshing the surface: 1 of 2\n"
            "assemble | assembling: 1 of 2 sub-domains\n");
}

TEST(GroupedCount, has_two_decimals_from_a_million_on) {
  EXPECT_EQ(grouped_count(100), "100");
  EXPECT_EQ(grouped_count(10'001), "10,001");
  EXPECT_EQ(grouped_count(999'994'999), "999.99 M");
  EXPECT_EQ(grouped_count(1'000'000'000), "1.00 G");
}

}  // namespace
}  // namespace tetfarm
