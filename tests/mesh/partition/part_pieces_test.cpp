#include "mesh/partition/part_pieces.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "base/error.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/formats/node_records.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"

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

using GlobalFace = FaceNodes<std::int64_t>;

GlobalFace global_face(const NumberedPart& part, const FaceNodes<std::int32_t>& face) {
  return face.renumbered([&](std::int32_t v) { return global_node(part, v); });
}

/// Cells by type, nodes in the whole mesh and region, sorted.
using Cells = std::vector<std::tuple<ElementType, std::vector<std::int64_t>, std::int32_t>>;

void add_cells(const NumberedPart& part, Cells& cells) {
  const std::vector<std::int32_t> regions = regions_of_cells(part);
  for_each_cell(part,
                [&](std::int32_t cell, ElementType type, std::span<const std::int32_t> nodes) {
                  std::vector<std::int64_t> global;
                  for (const std::int32_t v : nodes) global.push_back(global_node(part, v));
                  cells.emplace_back(type, global, regions[at(cell)]);
                });
}

/// Boundary faces by nodes in the whole mesh, patch and region.
using Boundary = std::multiset<std::tuple<GlobalFace, std::int32_t, std::int32_t>>;

void add_boundary(const NumberedPart& part, Boundary& boundary) {
  const std::vector<std::int32_t> regions = regions_of_boundary(part);
  for_each_boundary_face(
      part, [&](std::int32_t number, const FaceNodes<std::int32_t>& face, std::int32_t patch) {
        boundary.emplace(global_face(part, face), patch, regions[at(number)]);
      });
}

/// All types of cells in three sub-domains, whose cells go to parts by chance.
class PartPiecesOfGrid : public testing::Test {
 protected:
  static constexpr std::int32_t part_count = 4;

  PartPiecesOfGrid() {
    std::mt19937 random(11);
    for (const NumberedPart& subdomain : grid_.parts) {
      std::vector<std::int32_t>& part_of_cell = part_of_cell_.emplace_back();
      for (std::int64_t i = 0; i < cells_of(subdomain); ++i) {
        part_of_cell.push_back(static_cast<std::int32_t>(random() % part_count));
      }
      pieces_.add(subdomain, part_of_cell);
    }
    for (std::size_t i = 0; i < part_count; ++i) parts_.push_back(pieces_.part(i));
  }

  TempFolder folder_;
  HybridGrid grid_{4, 3, true};
  std::vector<std::vector<std::int32_t>> part_of_cell_;
  PartPieces pieces_{part_count, folder_.path()};
  std::vector<NumberedPart> parts_;
};

TEST_F(PartPiecesOfGrid, have_the_cells_that_were_given_to_their_part_and_no_others) {
  std::vector<Cells> expected(part_count);
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    Cells cells;
    add_cells(grid_.parts[i], cells);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      expected[at(part_of_cell_[i][k])].push_back(cells[k]);
    }
  }
  ASSERT_EQ(pieces_.size(), expected.size());
  for (std::size_t i = 0; i < part_count; ++i) {
    Cells cells;
    add_cells(parts_[i], cells);
    std::sort(cells.begin(), cells.end());
    std::sort(expected[i].begin(), expected[i].end());
    EXPECT_EQ(cells, expected[i]);
    EXPECT_EQ(parts_[i].number, static_cast<std::int32_t>(i));
  }
}

TEST_F(PartPiecesOfGrid, keep_the_boundary_beside_the_cells_that_have_it) {
  Boundary before;
  Boundary after;
  for (const NumberedPart& subdomain : grid_.parts) add_boundary(subdomain, before);
  for (const NumberedPart& part : parts_) {
    add_boundary(part, after);
    std::set<FaceNodes<std::int32_t>> of_cells;
    for_each_face_of_cells(part, [&](std::int32_t, const FaceNodes<std::int32_t>& face) {
      of_cells.insert(face.smallest_first());
    });
    for_each_boundary_face(part,
                           [&](std::int32_t, const FaceNodes<std::int32_t>& face, std::int32_t) {
                             EXPECT_TRUE(of_cells.contains(face.smallest_first()));
                           });
  }
  EXPECT_EQ(after, before);
}

TEST_F(PartPiecesOfGrid, have_cells_of_each_type_by_region_whichever_sub_domain_comes_first) {
  const TempFolder folder;
  PartPieces pieces(1, folder.path());
  Cells expected;
  for (std::size_t i = grid_.size(); i-- > 0;) {
    pieces.add(grid_.parts[i],
               std::vector<std::int32_t>(static_cast<std::size_t>(cells_of(grid_.parts[i])), 0));
    add_cells(grid_.parts[i], expected);
  }
  const NumberedPart part = pieces.part(0);
  EXPECT_TRUE(std::ranges::is_sorted(part.region_of_tet));
  int with_several_regions = 0;
  for (const ElementType type : cell_block_types) {
    const std::vector<std::int32_t>& regions = part.blocks[type].regions;
    EXPECT_TRUE(std::ranges::is_sorted(regions));
    with_several_regions += !regions.empty() && regions.front() != regions.back() ? 1 : 0;
  }
  EXPECT_GT(with_several_regions, 1);
  Cells cells;
  add_cells(part, cells);
  std::sort(cells.begin(), cells.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(cells, expected);
}

/// Cells by type and nodes in the whole mesh, with their marks of all kinds.
using MarkedCells = std::map<std::pair<ElementType, std::vector<std::int64_t>>,
                             std::array<std::int32_t, all_cell_marks.size()>>;

void add_marked_cells(const NumberedPart& part, MarkedCells& marked) {
  Cells cells;
  add_cells(part, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto& marks = marked[{std::get<0>(cells[i]), std::get<1>(cells[i])}];
    for (const CellMark mark : all_cell_marks) {
      const std::vector<std::int32_t>& of_cells = part.marks[mark];
      if (!of_cells.empty()) marks.at(static_cast<std::size_t>(mark)) = of_cells.at(i);
    }
  }
}

TEST(PartPieces, keep_the_marks_of_each_cell_and_have_0_of_sub_domains_without_them) {
  const TempFolder folder;
  HybridGrid grid(4, 3, true);
  std::mt19937 random(12);
  for (const auto& [subdomain, mark] :
       {std::pair{0, CellMark::layer}, {0, CellMark::pml_axes}, {2, CellMark::layer}}) {
    NumberedPart& part = grid.parts[at(subdomain)];
    for (std::int64_t i = 0; i < cells_of(part); ++i) {
      part.marks[mark].push_back(static_cast<std::int32_t>(random() % 1000));
    }
  }
  PartPieces pieces(2, folder.path());
  MarkedCells before;
  // Regions come last first, so that cells are put in order.
  for (std::size_t i = grid.size(); i-- > 0;) {
    std::vector<std::int32_t> part_of_cell;
    for (std::int64_t k = 0; k < cells_of(grid.parts[i]); ++k) {
      part_of_cell.push_back(static_cast<std::int32_t>(random() % 2));
    }
    pieces.add(grid.parts[i], part_of_cell);
    add_marked_cells(grid.parts[i], before);
  }
  MarkedCells after;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const NumberedPart part = pieces.part(i);
    EXPECT_EQ(std::ssize(part.marks[CellMark::layer]), cells_of(part));
    EXPECT_TRUE(part.marks[CellMark::pml_depth].empty()) << "no sub-domain has it";
    add_marked_cells(part, after);
  }
  EXPECT_EQ(after, before);
}

TEST_F(PartPiecesOfGrid, of_a_mesh_without_marks_and_feet_have_none) {
  for (const NumberedPart& part : parts_) {
    EXPECT_TRUE(part.marks.empty());
    EXPECT_TRUE(part.feet.empty());
  }
}

TEST(PartPieces, keep_the_foot_of_each_node_and_have_none_of_sub_domains_without_them) {
  const TempFolder folder;
  HybridGrid grid(4, 3);
  std::map<std::int64_t, std::pair<std::int64_t, std::int32_t>> before;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const std::int64_t v : grid.parts[i].local2global) {
      before[v] = {v / 3, static_cast<std::int32_t>(v % 3)};
      if (i == 2) before[v] = {no_foot, no_foot};
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    for (const std::int64_t v : grid.parts[i].local2global) {
      grid.parts[i].feet.add(before.at(v).first, before.at(v).second);
    }
  }
  PartPieces pieces(2, folder.path());
  std::mt19937 random(13);
  for (const NumberedPart& subdomain : grid.parts) {
    std::vector<std::int32_t> part_of_cell;
    for (std::int64_t k = 0; k < cells_of(subdomain); ++k) {
      part_of_cell.push_back(static_cast<std::int32_t>(random() % 2));
    }
    pieces.add(subdomain, part_of_cell);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const NumberedPart part = pieces.part(i);
    ASSERT_EQ(part.feet.foot.size(), part.nodes.size());
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      EXPECT_EQ(std::pair(part.feet.foot[v], part.feet.depth[v]), before.at(part.local2global[v]));
    }
  }
}

/// Two tets with a face in common.
NumberedPart two_tets(std::int32_t number, std::int32_t region) {
  NumberedPart part;
  part.number = number;
  part.region = region;
  part.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  part.tets = {{0, 1, 2, 3}, {3, 1, 2, 4}};
  part.local2global = {0, 1, 2, 3, 4};
  for (std::int64_t& v : part.local2global) v += std::int64_t{10} * number;
  part.faces = {{0, 2, 1}};
  part.patch_of_face = {5};
  return part;
}

TEST(PartPieces, refuse_a_boundary_face_that_no_cell_has_or_that_is_turned) {
  const TempFolder folder;
  for (const Triangle& face : {Triangle{0, 1, 2}, Triangle{0, 4, 1}}) {
    PartPieces pieces(1, folder.path());
    NumberedPart part = two_tets(7, 1);
    part.faces = {face};
    try {
      pieces.add(part, {0, 0});
      ADD_FAILURE() << "taken";
    } catch (const InvalidInput& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr("sub-domain 7"));
    }
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
  const auto nodes_of = [](const NumberedPart& part, const Tet& tet) {
    std::array<std::int64_t, 4> nodes;
    for (std::size_t k = 0; k < 4; ++k) nodes[k] = part.local2global[at(tet[k])];
    return nodes;
  };
  std::map<std::array<std::int64_t, 4>, std::int32_t> region_of_tet;
  for (const NumberedPart& part : grid.parts) {
    for (const Tet& tet : part.tets) region_of_tet[nodes_of(part, tet)] = part.region;
  }
  for (std::size_t t = 0; t < mixed.tets.size(); ++t) {
    EXPECT_EQ(mixed.region_of(t), region_of_tet.at(nodes_of(mixed, mixed.tets[t])));
  }
  EXPECT_EQ(content_of(pieces), content_of(grid));
}

}  // namespace
}  // namespace tetfarm
