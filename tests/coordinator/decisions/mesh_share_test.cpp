#include "coordinator/decisions/mesh_share.h"

#include <gtest/gtest.h>

#include <array>

namespace tetfarm {
namespace {

constexpr std::array<WorkStage, 8> stages_of_meshing = {
    WorkStage::boundary,     WorkStage::edges,  WorkStage::faces,     WorkStage::splits,
    WorkStage::added_points, WorkStage::points, WorkStage::cosmetics, WorkStage::validate};

TEST(MeshShare, rises_from_stage_to_stage_and_within_each) {
  for (const double needles : {0.0, 50.0, 20'000.0}) {
    double last = 0;
    for (const WorkStage stage : stages_of_meshing) {
      for (const std::uint64_t done : {0U, 3U, 10U}) {
        const double share = mesh_share({stage, 0, done, 10}, 1e6, needles);
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1 + 1e-12);
        last = share;
      }
    }
    EXPECT_NEAR(last, 1, 1e-12);
  }
}

TEST(MeshShare, of_recovery_is_larger_where_the_surface_has_needles) {
  const WorkCount recovered{WorkStage::added_points, 0, 1, 1};
  EXPECT_LT(mesh_share(recovered, 1e6, 0), 0.2);
  EXPECT_GT(mesh_share(recovered, 1e4, 2000), 0.45);
}

TEST(MeshShare, of_a_stage_without_a_total_goes_by_its_passes) {
  EXPECT_EQ(mesh_share({WorkStage::points, 0, 77, 0}, 1e5, 0),
            mesh_share({WorkStage::points, 0, 0, 10}, 1e5, 0));
  double last = mesh_share({WorkStage::points, 0, 1, 1}, 1e5, 0);
  for (const std::uint64_t pass : {2U, 5U, 9U, 1000U}) {
    const double share = mesh_share({WorkStage::cosmetics, pass, 500, 0}, 1e5, 0);
    EXPECT_GT(share, last);
    last = share;
  }
  EXPECT_LE(last, mesh_share({WorkStage::validate, 0, 0, 0}, 1e5, 0));
}

TEST(MeshShare, is_none_for_stages_that_meshing_does_not_have) {
  EXPECT_EQ(mesh_share({WorkStage::assemble, 0, 1, 2}, 1e5, 0), 0);
  EXPECT_EQ(mesh_share({WorkStage::cut, 0, 1, 2}, 1e5, 0), 0);
}

TEST(MeshShare, can_be_reckoned_without_knowing_the_leaf) {
  const double share = mesh_share({WorkStage::points, 0, 1, 2}, 0, 0);
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1);
}

}  // namespace
}  // namespace tetfarm
