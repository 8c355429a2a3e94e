#include "mesh/quality/face_check.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <random>

#include "mesh/assemble/part_cells.h"
#include "mesh/formats/node_records.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t all = 100'000;
constexpr std::size_t much_memory = std::size_t{64} << 20U;

std::vector<FaceCorners> wrong_faces(const std::vector<NumberedPart>& parts,
                                     std::size_t memory = much_memory, std::size_t most = all) {
  const TempFolder folder;
  FaceCheck check(folder.path(), memory);
  for (const NumberedPart& part : parts) check.add(part);
  return check.finish(most);
}

TEST(FaceUse, is_right_with_two_tets_or_a_boundary_triangle_for_each) {
  const auto is_right = [](FaceUse use) { return use.is_right(); };
  EXPECT_TRUE(is_right({{1, 1}, {0, 0}}));
  EXPECT_TRUE(is_right({{1, 0}, {1, 0}}));
  EXPECT_TRUE(is_right({{0, 1}, {0, 1}}));
  EXPECT_TRUE(is_right({{1, 1}, {1, 1}}));  // between regions
  EXPECT_FALSE(is_right({{1, 0}, {0, 0}}));
  EXPECT_FALSE(is_right({{0, 0}, {1, 0}}));
  EXPECT_FALSE(is_right({{2, 0}, {0, 0}}));
  EXPECT_FALSE(is_right({{2, 1}, {0, 0}}));
  EXPECT_FALSE(is_right({{1, 0}, {0, 1}}));
  EXPECT_FALSE(is_right({{1, 1}, {1, 0}}));
  EXPECT_FALSE(is_right({{2, 0}, {2, 0}}));
  EXPECT_FALSE(is_right({{0, 0}, {0, 0}}));
}

TEST(FaceUse, counts_end_at_255) {
  FaceUse use{{200, 255}, {255, 0}};
  use.add({{100, 1}, {0, 3}});
  EXPECT_THAT(use.tets, ElementsAre(255, 255));
  EXPECT_THAT(use.boundary, ElementsAre(255, 3));
}

/// A face, and whether it is seen turned: by its smallest node, then the smaller of those beside
/// it.
std::pair<FaceCorners, bool> face_and_side(const NumberedPart& part,
                                           const FaceNodes<std::int32_t>& local) {
  auto face = local.renumbered([&](std::int32_t v) { return global_node(part, v); });
  face = face.smallest_first();
  const bool is_turned = face[face.size() - 1] < face[1];
  if (is_turned) face = face.turned();
  FaceCorners corners = {face[0], face[1], face[2], face.size() == 4 ? face[3] : -1};
  return {corners, is_turned};
}

/// Every face of all parts, counted in one table.
std::vector<FaceCorners> wrong_in_one_table(const std::vector<NumberedPart>& parts) {
  std::map<FaceCorners, FaceUse> uses;
  for (const NumberedPart& part : parts) {
    for_each_face_of_cells(part, [&](std::int32_t, const FaceNodes<std::int32_t>& local) {
      const auto [face, is_turned] = face_and_side(part, local);
      ++uses[face].tets[is_turned ? 1 : 0];
    });
    for_each_boundary_face(part,
                           [&](std::int32_t, const FaceNodes<std::int32_t>& local, std::int32_t) {
                             const auto [face, is_turned] = face_and_side(part, local);
                             ++uses[face].boundary[is_turned ? 1 : 0];
                           });
  }
  std::vector<FaceCorners> wrong;
  for (const auto& [face, use] : uses) {
    if (!use.is_right()) wrong.push_back(face);
  }
  return wrong;
}

/// Tets and faces taken away, doubled and turned.
void damage(NumberedPart& part, std::mt19937& random) {
  const auto any_of = [&random](const auto& list) {
    return static_cast<std::ptrdiff_t>(random() % list.size());
  };
  for (int i = 0; i < 3; ++i) {
    part.tets.erase(part.tets.begin() + any_of(part.tets));
    part.tets.push_back(part.tets[static_cast<std::size_t>(any_of(part.tets))]);
    Tet& tet = part.tets[static_cast<std::size_t>(any_of(part.tets))];
    std::swap(tet[0], tet[3]);
    const std::ptrdiff_t face = any_of(part.faces);
    part.faces.erase(part.faces.begin() + face);
    part.patch_of_face.erase(part.patch_of_face.begin() + face);
    Triangle& turned = part.faces[static_cast<std::size_t>(any_of(part.faces))];
    std::swap(turned[0], turned[1]);
  }
}

TEST(FaceCheck, finds_what_one_table_of_all_faces_finds_in_damaged_meshes) {
  const GridSource grid(cut_grid(5));
  EXPECT_THAT(wrong_faces(grid.parts), IsEmpty());
  std::mt19937 random(2);
  for (int i = 0; i < 10; ++i) {
    std::vector<NumberedPart> parts = grid.parts;
    for (NumberedPart& part : parts) damage(part, random);
    const std::vector<FaceCorners> expected = wrong_in_one_table(parts);
    ASSERT_GT(expected.size(), 20U);
    EXPECT_EQ(wrong_faces(parts), expected);
    EXPECT_EQ(wrong_faces(parts, 0), expected) << "in the least memory";
  }
}

TEST(FaceCheck, finds_damage_among_cells_of_all_types) {
  HybridGrid grid(4, 3);
  EXPECT_THAT(wrong_faces(grid.parts), IsEmpty());
  std::mt19937 random(4);
  for (const ElementType type : {ElementType::pyramid, ElementType::prism, ElementType::hex}) {
    for (NumberedPart& part : grid.parts) {
      ElementBlock& block = part.blocks[type];
      if (block.empty()) continue;
      const std::size_t i = nodes_of(type) * (random() % block.size());
      std::swap(block.nodes[i], block.nodes[i + 1]);
    }
  }
  ElementBlock& quads = grid.parts[1].blocks[ElementType::quad];
  ASSERT_FALSE(quads.empty());
  std::swap(quads.nodes[1], quads.nodes[3]);
  const std::vector<FaceCorners> expected = wrong_in_one_table(grid.parts);
  EXPECT_GT(expected.size(), 10U);
  EXPECT_EQ(wrong_faces(grid.parts), expected);
}

TEST(FaceCheck, tells_the_first_and_no_more_than_asked_for) {
  GridSource grid(cut_grid(4));
  for (NumberedPart& part : grid.parts) part.faces.clear();
  for (NumberedPart& part : grid.parts) part.patch_of_face.clear();
  std::vector<FaceCorners> expected = wrong_faces(grid.parts);
  ASSERT_EQ(expected.size(), 6U * 2 * 16);
  EXPECT_TRUE(std::is_sorted(expected.begin(), expected.end()));
  expected.resize(7);
  EXPECT_EQ(wrong_faces(grid.parts, much_memory, 7), expected);
  EXPECT_THAT(wrong_faces(grid.parts, much_memory, 0), IsEmpty());
}

/// The grid without the first boundary triangles of its first part.
GridSource grid_without(std::size_t triangles) {
  GridSource source(cut_grid(4));
  NumberedPart& part = source.parts[0];
  part.faces.erase(part.faces.begin(), part.faces.begin() + static_cast<long>(triangles));
  part.patch_of_face.erase(part.patch_of_face.begin(),
                           part.patch_of_face.begin() + static_cast<long>(triangles));
  return source;
}

std::size_t wrong_faces_without(std::size_t triangles, std::size_t most) {
  return wrong_faces(grid_without(triangles).parts, much_memory, most).size();
}

TEST(FaceCheck, names_as_many_faces_as_it_is_asked_for_and_no_more) {
  EXPECT_EQ(wrong_faces_without(0, 5), 0U);
  EXPECT_EQ(wrong_faces_without(3, 5), 3U);
  EXPECT_EQ(wrong_faces_without(5, 5), 5U);
  EXPECT_EQ(wrong_faces_without(8, 5), 5U);
}

TEST(FaceCheck, describes_a_face_by_place_use_and_elements) {
  GridSource grid(cut_grid(4));
  NumberedPart& part = grid.parts[1];
  part.tets.push_back(part.tets[3]);
  const std::vector<FaceCorners> wrong = wrong_faces(grid.parts);
  ASSERT_EQ(wrong.size(), 4U);
  const std::vector<std::string> lines = describe_faces(grid, wrong);
  ASSERT_EQ(lines.size(), 4U);
  const std::size_t first = grid.parts[0].tets.size();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_THAT(lines[i], HasSubstr("face (" + std::to_string(wrong[i][0]) + ", "));
    EXPECT_THAT(lines[i], HasSubstr("tet " + std::to_string(first + 3) + " of sub-domain 1"));
    EXPECT_THAT(lines[i], HasSubstr("tet " + std::to_string(first + part.tets.size() - 1) +
                                    " of sub-domain 1"));
  }
  EXPECT_THAT(describe_faces(grid, {}), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
