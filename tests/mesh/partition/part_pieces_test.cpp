#include "mesh/partition/part_pieces.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

/// The parts as a mesh.
class Pieces : public MeshSource {
 public:
  Pieces(const GridSource& grid, std::int32_t parts,
         const std::function<std::int32_t(std::size_t subdomain, std::size_t tet)>& part_of)
      : names_(grid.patch_names()), pieces_(parts, folder_.path()) {
    for (std::size_t i = 0; i < grid.size(); ++i) {
      std::vector<std::int32_t> part_of_cell;
      for (std::size_t t = 0; t < grid.parts[i].tets.size(); ++t) {
        part_of_cell.push_back(part_of(i, t));
      }
      pieces_.add(grid.parts[i], part_of_cell);
    }
  }
  std::size_t size() const override { return pieces_.size(); }
  NumberedPart part(std::size_t i) const override { return pieces_.part(i); }
  std::vector<std::string> patch_names() const override { return names_; }
  std::vector<std::string> region_names() const override { return {}; }

 private:
  const TempFolder folder_;
  std::vector<std::string> names_;
  PartPieces pieces_;
};

TEST(PartPieces, put_together_are_the_mesh_whatever_goes_into_which_part) {
  const GridSource grid(cut_grid(4));
  const Pieces pieces(grid, 5, [](std::size_t i, std::size_t t) {
    return static_cast<std::int32_t>((7 * i + t / 3) % 5);
  });
  EXPECT_EQ(content_of(pieces), content_of(grid));
}

TEST(PartPieces, have_the_cells_that_were_given_to_each_and_their_boundary_faces) {
  const GridSource grid(cut_grid(4));
  const Pieces pieces(grid, 2,
                      [](std::size_t i, std::size_t t) { return i == 1 && t < 5 ? 1 : 0; });
  const NumberedPart few = pieces.part(1);
  ASSERT_EQ(few.tets.size(), 5U);
  for (std::size_t t = 0; t < 5; ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(few.local2global[at(few.tets[t][k])],
                grid.parts[1].local2global[at(grid.parts[1].tets[t][k])]);
    }
  }
  for (const Triangle& face : few.faces) {
    EXPECT_TRUE(std::ranges::any_of(few.tets, [&](const Tet& tet) {
      return std::ranges::all_of(face,
                                 [&](std::int32_t v) { return std::ranges::count(tet, v) > 0; });
    }));
  }
}

TEST(PartPieces, have_each_of_their_nodes_once_ascending_and_no_others) {
  const GridSource grid(cut_grid(4));
  const Pieces pieces(grid, 3,
                      [](std::size_t, std::size_t t) { return static_cast<std::int32_t>(t % 3); });
  for (std::size_t i = 0; i < 3; ++i) {
    const NumberedPart part = pieces.part(i);
    EXPECT_EQ(part.number, static_cast<std::int32_t>(i));
    EXPECT_THAT(part.local2global, testing::WhenSorted(testing::ContainerEq(part.local2global)));
    EXPECT_EQ(std::ranges::adjacent_find(part.local2global), part.local2global.end());
    std::set<std::int32_t> used;
    for (const Tet& tet : part.tets) used.insert(tet.begin(), tet.end());
    EXPECT_EQ(used.size(), part.nodes.size());
  }
}

TEST(PartPieces, of_a_part_that_got_nothing_are_empty) {
  const GridSource grid(cut_grid(2));
  const Pieces pieces(grid, 2, [](std::size_t, std::size_t) { return 0; });
  EXPECT_TRUE(pieces.part(1).tets.empty());
  EXPECT_TRUE(pieces.part(1).nodes.empty());
}

TEST(PartPieces, of_several_regions_have_their_cells_by_region) {
  GridSource grid(cut_grid(4));
  // The first sub-domain that is added has the last region.
  for (std::size_t i = 0; i < grid.size(); ++i) {
    grid.parts[i].region = static_cast<std::int32_t>(grid.size() - i);
  }
  const Pieces pieces(grid, 2, [](std::size_t i, std::size_t t) {
    return i == 2 ? 1 : static_cast<std::int32_t>(t % 2);
  });
  const NumberedPart mixed = pieces.part(0);
  EXPECT_EQ(std::set<std::int32_t>(mixed.region_of_tet.begin(), mixed.region_of_tet.end()),
            (std::set<std::int32_t>{2, 3}));
  EXPECT_TRUE(std::ranges::is_sorted(mixed.region_of_tet));
  EXPECT_EQ(mixed.region_of_face.size(), mixed.faces.size());
  EXPECT_EQ(content_of(pieces), content_of(grid));
}

}  // namespace
}  // namespace tetfarm
