// What the outline of a mesh says, number for number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <tuple>

#include "base/error.h"
#include "tests/mesh/formats/every_kind_mesh.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

TEST(MeshOutline, has_the_counts_of_every_part_and_what_comes_before_it) {
  const EveryKindMesh mesh;
  const MeshOutline outline = outline_of(mesh);
  ASSERT_EQ(outline.parts.size(), 3U);
  const auto& [hexes, pyramids, tets] =
      std::tie(outline.parts[0], outline.parts[1], outline.parts[2]);
  EXPECT_EQ(outline.nodes, 24);
  EXPECT_EQ(hexes.nodes, 14);
  EXPECT_EQ(hexes.owned_nodes, 14);
  EXPECT_EQ(pyramids.nodes, 11);
  EXPECT_EQ(pyramids.owned_nodes, 3);
  EXPECT_EQ(tets.nodes, 8);
  EXPECT_EQ(tets.owned_nodes, 7);
  EXPECT_EQ(outline.tets, 3);
  EXPECT_THAT(outline.tets_of_region, ElementsAre(1, 1, 1));
  EXPECT_THAT(hexes.tets_of_region, ElementsAre(0, 0, 0));
  EXPECT_THAT(pyramids.tets_of_region, ElementsAre(0, 1, 0));
  EXPECT_THAT(tets.tets_of_region, ElementsAre(1, 0, 1));
  EXPECT_EQ(pyramids.first_tet, 0);
  EXPECT_EQ(tets.first_tet, 1);
  EXPECT_EQ(pyramids.first_cell, 3);
  EXPECT_EQ(tets.first_cell, 6);
  EXPECT_EQ(outline.cells(), 8);
  EXPECT_EQ(outline.boundary_triangles, 20);
  EXPECT_EQ(hexes.faces, 2);
  EXPECT_EQ(pyramids.faces, 10);
  EXPECT_EQ(tets.faces, 8);
  EXPECT_EQ(pyramids.first_face, 2);
  EXPECT_EQ(tets.first_face, 12);
  EXPECT_THAT(outline.faces_of_patch, ElementsAre(5, 14, 1, 0));
  EXPECT_THAT(tets.faces_of_patch, ElementsAre(3, 4, 1, 0));
  EXPECT_THAT(pyramids.first_face_of_patch, ElementsAre(2, 0, 0, 0));
  EXPECT_THAT(tets.first_face_of_patch, ElementsAre(2, 10, 0, 0));
  EXPECT_FALSE(outline.has_tets_alone());
  EXPECT_EQ(hexes.box.low.z, -1);
  EXPECT_EQ(hexes.box.high.z, 2);
  EXPECT_EQ(tets.box.high.x, 6);
}

TEST(MeshOutline, has_the_counts_of_blocks_by_type) {
  const MeshOutline outline = outline_of(EveryKindMesh());
  const BlockOutline& pyramids = outline.parts[1].blocks[ElementType::pyramid];
  EXPECT_EQ(pyramids.count, 2);
  EXPECT_EQ(pyramids.first, 0);
  EXPECT_THAT(pyramids.of_group, ElementsAre(0, 1, 1));
  EXPECT_EQ(outline.parts[2].blocks[ElementType::pyramid].first, 2);
  EXPECT_THAT(outline.parts[2].blocks[ElementType::pyramid].first_of_group, ElementsAre(0, 1, 1));
  EXPECT_EQ(outline.blocks[ElementType::hex].count, 2);
  EXPECT_THAT(outline.blocks[ElementType::hex].of_group, ElementsAre(2, 0, 0));
  EXPECT_EQ(outline.blocks[ElementType::prism].count, 1);
  const BlockOutline& quads = outline.blocks[ElementType::quad];
  const std::int64_t floor = 1;
  EXPECT_THAT(quads.of_group, ElementsAre(quads.count - floor, 0, floor, 0));
  EXPECT_EQ(quads.count, 13);
  EXPECT_EQ(outline.parts[1].blocks[ElementType::quad].first, 11);
  EXPECT_EQ(outline.parts[1].blocks[ElementType::quad].count, 2);
  EXPECT_EQ(outline.boundary_faces(), 33);
  EXPECT_EQ(outline.boundary_faces_of(0), 17);
  EXPECT_EQ(outline.boundary_faces_of(1), 14);
  EXPECT_EQ(outline.boundary_faces_of(2), 2);
  EXPECT_EQ(outline.boundary_faces_of(3), 0);
  EXPECT_EQ(outline.parts[1].elements()[ElementType::pyramid], 2);
  EXPECT_EQ(outline.parts[1].elements()[ElementType::triangle], 10);
  EXPECT_EQ(outline.elements()[ElementType::tet], 3);
}

TEST(MeshOutline, has_runs_of_cells_of_one_region) {
  std::string text;
  EveryKindMesh mesh;
  NumberedPart& empty = mesh.parts.emplace_back();
  empty.number = 3;
  for (const RegionRun& run : region_runs(outline_of(mesh))) {
    text += std::to_string(run.part) + " region " + std::to_string(run.region) + ": " +
            std::to_string(run.tets) + " tets from " + std::to_string(run.first_tet);
    for (const ElementType type : cell_block_types) {
      text += ", " + text_of_count(run.others[type], type) + " from " +
              std::to_string(run.first_in_block[type]);
    }
    text += "; " + std::to_string(run.cells()) + "\n";
  }
  EXPECT_EQ(text,
            "0 region 1: 0 tets from 0, 0 pyramids from 0, 1 prism from 0, 2 hexes from 0; 3\n"
            "1 region 2: 1 tets from 0, 1 pyramid from 0, 0 prisms from 1, 0 hexes from 2; 2\n"
            "1 region 3: 0 tets from 1, 1 pyramid from 1, 0 prisms from 1, 0 hexes from 2; 1\n"
            "2 region 1: 1 tets from 1, 0 pyramids from 2, 0 prisms from 1, 0 hexes from 2; 1\n"
            "2 region 3: 1 tets from 2, 0 pyramids from 2, 0 prisms from 1, 0 hexes from 2; 1\n"
            "3 region 1: 0 tets from 3, 0 pyramids from 0, 0 prisms from 0, 0 hexes from 0; 0\n");
}

/// The mesh after a change, and with other names.
class Changed : public EveryKindMesh {
 public:
  explicit Changed(std::vector<std::string> patches = {}, std::vector<std::string> regions = {})
      : patches_(std::move(patches)), regions_(std::move(regions)) {}
  std::vector<std::string> patch_names() const override { return patches_; }
  std::vector<std::string> region_names() const override { return regions_; }

 private:
  std::vector<std::string> patches_;
  std::vector<std::string> regions_;
};

TEST(MeshOutline, names_what_has_no_name) {
  const MeshOutline outline = outline_of(Changed({"body"}, {"inside"}));
  EXPECT_THAT(outline.patch_names, ElementsAre("body", "patch 2", "patch 3"));
  EXPECT_THAT(outline.region_names, ElementsAre("inside", "region 2", "region 3"));
  Changed one;
  for (NumberedPart& part : one.parts) {
    part.region = 1;
    part.region_of_tet.clear();
    for_each_block(part.blocks, [](ElementType, ElementBlock& block) {
      std::fill(block.regions.begin(), block.regions.end(), 1);
    });
  }
  EXPECT_THAT(outline_of(one).region_names, ElementsAre("domain"));
  EXPECT_THAT(outline_of(Changed()).region_names, ElementsAre("region 1", "region 2", "region 3"));
}

std::string refusal(const std::function<void(std::vector<NumberedPart>&)>& change) {
  EveryKindMesh mesh;
  change(mesh.parts);
  try {
    outline_of(mesh);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(MeshOutline, refuses_numbers_that_are_out_of_range_or_order) {
  using Parts = std::vector<NumberedPart>;
  const std::string region = "sub-domain 2: a region number is out of range";
  const std::string patch = "sub-domain 2: a patch number is out of range";
  const std::string node = "sub-domain 2: a node number is out of range";
  EXPECT_EQ(refusal([](Parts& p) { p[2].region_of_tet = {0, 3}; }), region);
  EXPECT_EQ(refusal([](Parts& p) { p[2].region_of_tet = {1, 1'000'001}; }), region);
  EXPECT_EQ(refusal([](Parts& p) {
              p[2].region_of_tet = {3, 1};
            }),
            "sub-domain 2: regions are not in order");
  EXPECT_EQ(refusal([](Parts& p) { p[2].region_of_tet.clear(), p[2].region = 0; }), region);
  EXPECT_EQ(refusal([](Parts& p) { p[2].patch_of_face[0] = -1; }), patch);
  EXPECT_EQ(refusal([](Parts& p) { p[2].patch_of_face[0] = 1'000'000; }), patch);
  EXPECT_EQ(refusal([](Parts& p) { p[2].local2global[0] = -1; }), node);
  EXPECT_EQ(refusal([](Parts& p) { p[2].local2global[0] = std::int64_t{1} << 40U; }), node);
  EXPECT_EQ(refusal([](Parts& p) {
              p[1].blocks[ElementType::pyramid].regions = {0, 3};
            }),
            "sub-domain 1: a region number is out of range");
  EXPECT_EQ(refusal([](Parts& p) {
              p[1].blocks[ElementType::pyramid].regions = {3, 2};
            }),
            "sub-domain 1: regions are not in order");
  EXPECT_EQ(refusal([](Parts& p) { p[0].blocks[ElementType::quad].patches[0] = -1; }),
            "sub-domain 0: a patch number is out of range");
  EXPECT_EQ(refusal([](Parts& p) { p[0].blocks[ElementType::quad].patches[0] = 1'000'000; }),
            "sub-domain 0: a patch number is out of range");
  EXPECT_EQ(refusal([](Parts& p) { p[2].local2global[0] = 30; }),
            "node numbers have gaps: the largest is 30 of 24 nodes");
}

TEST(MeshOutline, of_a_mesh_with_other_cells_than_tets_is_refused_by_formats_of_tets) {
  try {
    require_tets_alone(outline_of(EveryKindMesh()), "TetGen files hold");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "TetGen files hold tetrahedra only; this mesh has 2 pyramids, 1 prism, 2 hexes, 13 "
        "quads: choose a format that holds them, vtkhdf for instance");
  }
  require_tets_alone(outline_of(TetsMesh()), "TetGen files hold");
}

TEST(MeshOutline, names_regions_that_only_other_cells_than_tets_have) {
  HybridMesh mesh(2);
  mesh.parts[0].blocks[ElementType::hex].regions = {1, 5};
  EXPECT_THAT(outline_of(mesh).region_names,
              ElementsAre("inside", "outside", testing::_, testing::_, testing::_));
}

}  // namespace
}  // namespace tetfarm
