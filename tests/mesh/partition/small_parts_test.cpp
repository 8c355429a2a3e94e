// Small meshes put together anew and numbered anew: all that they are then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "mesh/partition/part_pieces.h"
#include "mesh/partition/partitioned_mesh.h"
#include "mesh/partition/renumbered_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/every_kind_mesh.h"
#include "tests/mesh/formats/mesh_listing.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

TEST(SmallParts, have_cells_by_region_and_their_boundary_with_them) {
  const TempFolder folder;
  const EveryKindMesh mesh;
  PartPieces pieces(3, folder.path());
  // Cells are counted tets, pyramids, prisms, hexes.
  pieces.add(mesh.parts[1], {0, 2, 0});
  pieces.add(mesh.parts[2], {0, 0});
  EXPECT_EQ(part_listing(pieces.part(0)),
            "part 0 region 1\n node 0 at 0 0 0\n node 1 at 1 0 0\n node 2 at 1 1 0\n"
            " node 3 at 0 1 0\n node 4 at 0 0 1\n node 7 at 0 1 1\n node 8 at 2 0.5 0.5\n"
            " node 9 at 1.5 0.5 -1\n node 16 at -1 0.5 0.5\n node 17 at 3 0.5 0.5\n"
            " node 18 at 2 1.5 0.5\n node 19 at 2 0.5 1.5\n node 20 at 5 0 0\n node 21 at 6 0 0\n"
            " node 22 at 5 1 0\n node 23 at 5 0 1e-07\n"
            " tet 6 9 10 11 region 1\n tet 1 2 6 7 region 2\n tet 12 13 14 15 region 3\n"
            " pyramid 0 4 5 3 8 region 3\n"
            " triangle 0 4 8 patch 1 region 3\n triangle 4 5 8 patch 1 region 3\n"
            " triangle 5 3 8 patch 1 region 3\n triangle 3 0 8 patch 1 region 3\n"
            " triangle 2 6 7 patch 1 region 2\n triangle 1 7 6 patch 1 region 2\n"
            " triangle 1 2 7 patch 1 region 2\n triangle 9 10 11 patch 1 region 1\n"
            " triangle 6 11 10 patch 1 region 1\n triangle 6 9 11 patch 1 region 1\n"
            " triangle 6 10 9 patch 1 region 1\n triangle 13 14 15 patch 0 region 3\n"
            " triangle 12 15 14 patch 0 region 3\n triangle 12 13 15 patch 0 region 3\n"
            " triangle 12 14 13 patch 2 region 3\n quad 0 3 5 4 patch 0 region 3\n"
            " lists of regions: 1 2 3; 3 3 3 3 2 2 2 1 1 1 1 3 3 3 3\n");
  EXPECT_EQ(part_listing(pieces.part(1)), "part 1 region 1\n lists of regions:;\n");
  EXPECT_EQ(part_listing(pieces.part(2)),
            "part 2 region 2\n node 1 at 1 0 0\n node 2 at 1 1 0\n node 5 at 1 0 1\n"
            " node 6 at 1 1 1\n node 8 at 2 0.5 0.5\n pyramid 0 1 3 2 4 region 2\n"
            " triangle 1 3 4 patch 1 region 2\n triangle 3 2 4 patch 1 region 2\n"
            " triangle 2 0 4 patch 1 region 2\n quad 0 2 3 1 patch 0 region 2\n"
            " lists of regions:;\n");
}

TEST(SmallParts, refuse_a_boundary_face_that_no_cell_has) {
  const TempFolder folder;
  NumberedPart part = TetsMesh().parts[1];
  std::swap(part.faces[0][0], part.faces[0][1]);
  PartPieces pieces(1, folder.path());
  try {
    pieces.add(part, {0});
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "sub-domain 1: a boundary face is not an outer face of a cell");
  }
}

TEST(SmallParts, are_no_more_than_the_mesh_has_cells) {
  const TempFolder folder;
  const PartitionedMesh mesh(TetsMesh(), {3}, folder.path());
  EXPECT_THAT(mesh.figures().cells, ElementsAre(1, 1, 1));
  EXPECT_EQ(mesh.figures().cut_faces, 2);
  EXPECT_EQ(mesh.figures().largest_over_mean(), 1);
  EXPECT_THAT(mesh.patch_names(), ElementsAre("low", "high"));
  EXPECT_THAT(mesh.region_names(), ElementsAre("water", "air"));
  try {
    PartitionedMesh(TetsMesh(), {4}, folder.path());
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--partitions 4: the mesh has only 3 elements");
  }
}

TEST(SmallParts, are_told_by_the_largest_over_the_mean) {
  EXPECT_EQ(PartitionFigures().largest_over_mean(), 1);
  EXPECT_EQ((PartitionFigures{{0, 0}, 0}).largest_over_mean(), 1);
  EXPECT_EQ((PartitionFigures{{1, 5, 3, 3}, 0}).largest_over_mean(), 5.0 * 4 / 12);
}

std::string listing_of(const NodeNumbering numbering) {
  return mesh_listing(RenumberedMesh(std::make_unique<TetsMesh>(), numbering));
}

TEST(SmallNumbers, by_rcm_go_from_the_far_end_of_each_part) {
  // Part 0: nodes 0 and 4 have three neighbours, the others four; the search ends at 0 and begins
  // there again from 4, or the other way round. Part 1 has node 5 alone for itself.
  const std::string text = listing_of(NodeNumbering::reverse_cuthill_mckee);
  EXPECT_EQ(text,
            "sub-domains\npatch \"low\"\npatch \"high\"\nregion \"water\"\nregion \"air\"\n"
            "part 0 region 1\n node 0 at 0 0 0\n node 1 at 0 0 1\n node 2 at 0 1 0\n"
            " node 3 at 1 0 0\n node 4 at 1 1 1\n tet 0 3 2 1 region 1\n tet 3 2 1 4 region 2\n"
            " triangle 0 1 2 patch 0 region 1\n triangle 0 3 1 patch 0 region 1\n"
            " triangle 0 2 3 patch 0 region 1\n triangle 2 1 4 patch 1 region 2\n"
            " triangle 3 4 1 patch 1 region 2\n lists of regions: 1 2; 1 1 1 2 2\n"
            "part 1 region 2\n node 2 at 0 1 0\n node 3 at 1 0 0\n node 4 at 1 1 1\n"
            " node 5 at 1 1 -0.125\n tet 1 0 2 3 region 2\n triangle 0 2 3 patch 1 region 2\n"
            " triangle 1 3 2 patch 1 region 2\n triangle 1 0 3 patch 1 region 2\n"
            " lists of regions:;\n");
}

/// The mesh with boundary faces of its second part alone.
class HalfBoundary : public TetsMesh {
 public:
  HalfBoundary() {
    parts[0].faces.clear();
    parts[0].patch_of_face.clear();
    parts[0].region_of_face.clear();
    parts[1].faces.resize(1);  // nodes 2, 4 and 5
    parts[1].patch_of_face.resize(1);
  }
};

TEST(SmallNumbers, along_the_curve_begin_with_the_surface_then_borders_then_the_inside) {
  const RenumberedMesh mesh(std::make_unique<HalfBoundary>(), NodeNumbering::hilbert);
  const NumberedPart first = mesh.part(0);
  const NumberedPart second = mesh.part(1);
  const auto place_of = [](const NumberedPart& part, std::int64_t number) {
    const auto found = std::find(part.local2global.begin(), part.local2global.end(), number);
    return part.nodes.at(static_cast<std::size_t>(found - part.local2global.begin()));
  };
  const HalfBoundary before;
  std::set<std::int64_t> on_surface;
  for (const std::int32_t v : before.parts[1].faces[0]) {
    on_surface.insert(before.parts[1].local2global[static_cast<std::size_t>(v)]);
  }
  ASSERT_EQ(on_surface.size(), 3U);
  // Of the three shared nodes (1, 2 and 4) those on the surface have the first numbers, and are
  // numbered by the first part; node 5 is numbered by the second, behind them.
  EXPECT_EQ(second.local2global.size(), 4U);
  const std::int64_t shared_on_surface = static_cast<std::int64_t>(on_surface.size()) - 1;
  EXPECT_EQ(place_of(second, shared_on_surface), (Vec3{1, 1, -0.125}));
  std::int64_t border = -1;
  for (const std::int64_t node : {1, 2, 4}) {
    if (on_surface.contains(node)) continue;
    EXPECT_EQ(border, -1);
    border = node;
  }
  EXPECT_EQ(place_of(first, 3), before.parts[0].nodes[static_cast<std::size_t>(border)]);
  EXPECT_THAT(first.local2global, ElementsAre(0, 1, 3, 4, 5));
  EXPECT_THAT(second.local2global, ElementsAre(0, 1, 2, 3));
}

TEST(SmallNumbers, sort_cells_of_each_type_by_region_and_their_lowest_nodes) {
  const RenumberedMesh mesh(std::make_unique<EveryKindMesh>(), NodeNumbering::hilbert);
  EXPECT_EQ(mesh.size(), 3U);
  EXPECT_TRUE(mesh.knows_subdomains());
  EXPECT_EQ(mesh.counted_part(1).faces, 10);
  const EveryKindMesh before;
  EXPECT_EQ(mesh.patch_names(), before.patch_names());
  EXPECT_EQ(mesh.region_names(), before.region_names());
  for (std::size_t i = 0; i < 3; ++i) {
    const NumberedPart part = mesh.part(i);
    EXPECT_TRUE(std::is_sorted(part.local2global.begin(), part.local2global.end()));
    EXPECT_EQ(part.region_of_tet, before.parts[i].region_of_tet);
    EXPECT_EQ(part.region_of_face, before.parts[i].region_of_face);
    EXPECT_EQ(part.blocks[ElementType::pyramid].regions,
              before.parts[i].blocks[ElementType::pyramid].regions);
  }
  const NumberedPart first = mesh.part(0);
  const ElementBlock& hexes = first.blocks[ElementType::hex];
  const auto lowest = [&hexes](std::size_t i) {
    const auto nodes = hexes.element(ElementType::hex, i);
    return *std::min_element(nodes.begin(), nodes.end());
  };
  EXPECT_LE(lowest(0), lowest(1));
}

}  // namespace
}  // namespace tetfarm
