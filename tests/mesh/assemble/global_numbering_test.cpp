#include "mesh/assemble/global_numbering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

constexpr const char* table =
    "leaf 7 70 700\ncut 1 10\nleaf 4 40 400\ncut 2 20\nleaf 5 50 500\ncut 3 30\nleaf 6 60 600\n";

TEST(GlobalNumbering, tree_order_is_depth_first_with_a_node_before_its_children) {
  std::vector<TreePath> paths = {{7}, {11}, {1}, {5}, {3}, {10}, {4}, {2}, {6}};
  std::sort(paths.begin(), paths.end(), comes_before);
  EXPECT_THAT(paths, ElementsAre(TreePath{1}, TreePath{2}, TreePath{4}, TreePath{5}, TreePath{10},
                                 TreePath{11}, TreePath{3}, TreePath{6}, TreePath{7}));
}

TEST(GlobalNumbering, surface_then_cuts_then_leaves_in_tree_order) {
  const Numbering numbering = number_globally(shapes::unit_cube(), table);
  EXPECT_EQ(numbering.surface_nodes, 8);
  ASSERT_EQ(numbering.cuts.size(), 3u);
  EXPECT_EQ(numbering.cuts[0].nodes.first_node, 8);
  EXPECT_EQ(numbering.cuts[1].nodes.first_node, 18);
  EXPECT_EQ(numbering.cuts[2].nodes.first_node, 38);
  EXPECT_EQ(numbering.leaves[0].nodes.first_node, 68);
  ASSERT_EQ(numbering.leaves.size(), 4u);
  EXPECT_EQ(numbering.leaves[1].path, TreePath{5});
  EXPECT_EQ(numbering.leaves[1].nodes.first_node, 108);
  EXPECT_EQ(numbering.leaves[3].first_tet, 1500);
  EXPECT_EQ(numbering.nodes, 288);
  EXPECT_EQ(numbering.tets, 2200);
}

TEST(GlobalNumbering, unused_vertices_of_the_surface_are_passed_over) {
  SurfaceMesh surface = shapes::tetrahedron();
  surface.vertices.insert(surface.vertices.begin() + 2, Vec3{5, 5, 5});
  for (Triangle& triangle : surface.triangles) {
    for (std::int32_t& v : triangle) v += v >= 2 ? 1 : 0;
  }
  surface.vertices.push_back({6, 6, 6});
  const Numbering numbering = number_globally(surface, "leaf 1 0 1\n");
  EXPECT_EQ(numbering.surface_nodes, 4);
  EXPECT_EQ(global_number(numbering, {0, 1}), 1);
  EXPECT_EQ(global_number(numbering, {0, 3}), 2);
  EXPECT_EQ(global_number(numbering, {0, 4}), 3);
  EXPECT_THROW(global_number(numbering, {0, 2}), Error);
  EXPECT_THROW(global_number(numbering, {0, 5}), Error);
}

TEST(GlobalNumbering, nodes_of_cuts_are_found_by_origin) {
  const Numbering numbering = number_globally(shapes::unit_cube(), table);
  EXPECT_EQ(global_number(numbering, {1, 9}), 17);
  EXPECT_EQ(global_number(numbering, {3, 0}), 38);
  EXPECT_THROW(global_number(numbering, {3, 30}), Error);
  EXPECT_THROW(global_number(numbering, {8, 0}), Error);
}

TEST(GlobalNumbering, interior_nodes_are_found_by_their_leaf) {
  const Numbering numbering = number_globally(shapes::unit_cube(), table);
  EXPECT_EQ(global_number(numbering, {4, 0}), 68);
  EXPECT_EQ(global_number(numbering, {7, 69}), 287);
  EXPECT_THROW(global_number(numbering, {7, 70}), Error);
}

TEST(GlobalNumbering, dropped_nodes_have_no_number_and_leave_no_gap) {
  const std::string with_dropped =
      std::string(table) + "dropped 1 3 2\ndropped 1 9 1\ndropped 5 0 4\n";
  const Numbering numbering = number_globally(shapes::unit_cube(), with_dropped);
  EXPECT_EQ(numbering.nodes, 288 - 7);
  EXPECT_EQ(global_number(numbering, {1, 2}), 10);
  EXPECT_THROW(global_number(numbering, {1, 3}), Error);
  EXPECT_THROW(global_number(numbering, {1, 4}), Error);
  EXPECT_EQ(global_number(numbering, {1, 5}), 11);
  EXPECT_EQ(global_number(numbering, {1, 8}), 14);
  EXPECT_THROW(global_number(numbering, {1, 9}), Error);
  EXPECT_EQ(global_number(numbering, {2, 0}), 15);
  EXPECT_THROW(global_number(numbering, {5, 3}), Error);
  EXPECT_EQ(global_number(numbering, {5, 4}), 105);
  const std::string text = numbering_to_text(numbering);
  EXPECT_EQ(numbering_to_text(numbering_from_text(text, "n")), text);
}

TEST(GlobalNumbering, refuses_dropped_nodes_that_are_not_there_or_not_in_order) {
  for (const char* wrong : {"dropped 1 9 2\n", "dropped 8 0 1\n", "dropped 1 3 0\n",
                            "dropped 1 5 1\ndropped 1 3 1\n", "dropped 1 3 2\ndropped 1 4 1\n"}) {
    EXPECT_THROW(number_globally(shapes::unit_cube(), std::string(table) + wrong), Error) << wrong;
  }
}

TEST(GlobalNumbering, numbers_beyond_32_bits_are_kept) {
  const Numbering numbering =
      number_globally(shapes::unit_cube(), "cut 1 5\nleaf 2 6000000000 30000000000\nleaf 3 1 1\n");
  EXPECT_EQ(numbering.leaves[1].nodes.first_node, 6000000013);
  EXPECT_EQ(numbering.leaves[1].first_tet, 30000000000);
}

TEST(GlobalNumbering, triangles_are_counted_on_as_far_as_all_leaves_before_are_counted) {
  const SurfaceMesh cube = shapes::unit_cube();
  const Numbering all = number_globally(cube, "cut 1 5\nleaf 2 6 30 7\nleaf 3 1 1 5\n");
  EXPECT_EQ(all.leaves[0].first_face, 0);
  EXPECT_EQ(all.leaves[1].first_face, 7);
  EXPECT_EQ(all.leaves[1].faces, 5);
  EXPECT_EQ(numbering_from_text(numbering_to_text(all), "text").leaves[1].first_face, 7);
  const Numbering some =
      number_globally(cube, "cut 1 5\ncut 2 0\nleaf 4 6 30\nleaf 5 1 1\nleaf 3 1 1 5\n");
  EXPECT_EQ(some.leaves[1].first_face, std::nullopt);
  EXPECT_EQ(some.leaves[2].first_face, std::nullopt);
}

TEST(GlobalNumbering, the_only_leaf_without_a_count_of_triangles_has_the_rest) {
  const SurfaceMesh cube = shapes::unit_cube();
  EXPECT_EQ(number_globally(cube, "leaf 1 1 1\n").leaves[0].faces, 12);
  const Numbering rest = number_globally(cube, "cut 1 5\nleaf 2 6 30\nleaf 3 1 1 5\n");
  EXPECT_EQ(rest.leaves[0].faces, 7);
  EXPECT_EQ(rest.leaves[1].first_face, 7);
  const Numbering too_many = number_globally(cube, "cut 1 5\nleaf 2 6 30\nleaf 3 1 1 13\n");
  EXPECT_EQ(too_many.leaves[0].faces, std::nullopt);
}

constexpr const char* with_layers =
    "cut 1 90\ncut 2 5\nleaf 4 6 30\nleaf 5 1 40\ncut 3 0\nleaf 6 70 1 8 2 300\n"
    "leaf 7 80 0 4 10 400\n";

TEST(GlobalNumbering, counts_the_cells_of_layers_type_by_type) {
  const Numbering numbering = number_globally(shapes::unit_cube(), with_layers);
  EXPECT_EQ(numbering.tets, 71);
  EXPECT_EQ(numbering.others[ElementType::pyramid], 12);
  EXPECT_EQ(numbering.others[ElementType::prism], 700);
  EXPECT_EQ(numbering.leaves[2].first_tet, 70);
  EXPECT_EQ(numbering.leaves[2].first_other, ElementCounts{});
  EXPECT_EQ(numbering.leaves[3].first_other[ElementType::pyramid], 2);
  EXPECT_EQ(numbering.leaves[3].first_other[ElementType::prism], 300);
  EXPECT_EQ(numbering.leaves[3].others[ElementType::prism], 400);
  EXPECT_EQ(numbering_to_text(numbering_from_text(numbering_to_text(numbering), "text")),
            numbering_to_text(numbering));
  EXPECT_THAT(numbering_to_text(numbering), testing::HasSubstr("\nleaf 6 70 1 8 2 300\n"));
  EXPECT_THROW(number_globally(shapes::unit_cube(), "leaf 1 1 1 12 3\n"), Error);
}

TEST(GlobalNumbering, counts_quads_of_the_boundary_where_a_leaf_has_some) {
  const Numbering numbering =
      number_globally(shapes::unit_cube(),
                      "cut 1 9\nleaf 2 6 30\ncut 3 0\nleaf 6 70 1 8 2 3 4\nleaf 7 80 0 4 5 6\n");
  EXPECT_EQ(numbering.others[ElementType::quad], 4);
  EXPECT_EQ(numbering.leaves[2].first_other[ElementType::quad], 4);
  const std::string text = numbering_to_text(numbering);
  EXPECT_THAT(text, testing::HasSubstr("\nleaf 6 70 1 8 2 3 4\nleaf 7 80 0 4 5 6\n"));
  EXPECT_EQ(numbering_to_text(numbering_from_text(text, "text")), text);
  EXPECT_THROW(number_globally(shapes::unit_cube(), "leaf 1 1 1 12 3 4 5 6\n"), Error);
}

TEST(GlobalNumbering, the_top_of_layers_is_the_cut_of_the_root) {
  const Numbering numbering = number_globally(shapes::unit_cube(), with_layers);
  EXPECT_EQ(global_number(numbering, {top_of_layers, 0}), 8);
  EXPECT_EQ(global_number(numbering, {top_of_layers, 89}), 8 + 89);
  EXPECT_EQ(global_number(numbering, {2, 0}), 8 + 90);
  EXPECT_THROW(global_number(numbering, {top_of_layers, 90}), Error);
}

TEST(GlobalNumbering, refuses_what_is_not_one_whole_tree) {
  const SurfaceMesh cube = shapes::unit_cube();
  for (const char* wrong : {"", "cut 1 1\n", "cut 1 1\nleaf 2 1 1\n", "leaf 1 1 1\nleaf 2 1 1\n",
                            "cut 1 1\nleaf 2 1 1\nleaf 3 1 1\nleaf 3 1 1\n", "leaf 2 1 1\n",
                            "leaf 1 1\n", "leaf 1 -1 1\n", "leaf 0 1 1\n", "leaf 1 1 1 \n",
                            "knot 1 1\n", "leaf 1 99999999999999999999 1\n"}) {
    EXPECT_THROW(number_globally(cube, wrong), Error) << wrong;
  }
}

TEST(GlobalNumbering, text_gives_the_same_numbering) {
  SurfaceMesh surface = shapes::unit_cube();
  surface.vertices.push_back({9, 9, 9});
  const Numbering numbering = number_globally(surface, table);
  const std::string text = numbering_to_text(numbering);
  const Numbering again = numbering_from_text(text, "n");
  EXPECT_EQ(numbering_to_text(again), text);
  EXPECT_EQ(again.nodes, numbering.nodes);
  EXPECT_EQ(again.unused_vertices, numbering.unused_vertices);
  EXPECT_EQ(again.leaves[2].nodes.first_node, numbering.leaves[2].nodes.first_node);
}

/// The leaves 4 and 6 are joined; cut 1 loses its nodes 2, 3 and 7, cut 2 all but its first.
constexpr const char* joined_table =
    "cut 1 10\ncut 2 20\ncut 3 30\nleaf 4 40 400\nleaf 5 50 500\njoined 6 4\nleaf 7 70 700\n"
    "dropped 1 2 2\ndropped 1 7 1\ndropped 2 1 19\n";

TEST(GlobalNumbering, dropped_nodes_leave_no_gap) {
  const Numbering numbering = number_globally(shapes::unit_cube(), joined_table);
  EXPECT_EQ(numbering.cuts[0].nodes.kept(), 7);
  EXPECT_EQ(numbering.cuts[1].nodes.first_node, 8 + 7);
  EXPECT_EQ(numbering.leaves[0].nodes.first_node, 8 + 7 + 1 + 30);
  EXPECT_EQ(numbering.leaves.size(), 3U);
  std::vector<std::int64_t> kept;
  for (const std::uint32_t node : {0U, 1U, 4U, 5U, 6U, 8U, 9U}) {
    kept.push_back(global_number(numbering, {1, node}));
  }
  EXPECT_THAT(kept, ElementsAre(8, 9, 10, 11, 12, 13, 14));
  for (const std::uint32_t node : {2U, 3U, 7U, 10U}) {
    EXPECT_THROW(global_number(numbering, {1, node}), Error) << node;
  }
  EXPECT_EQ(global_number(numbering, {2, 0}), 15);
  EXPECT_THROW(global_number(numbering, {2, 19}), Error);
}

TEST(GlobalNumbering, refuses_joins_and_drops_that_make_no_sense) {
  const std::string tree = "cut 1 5\nleaf 2 1 1\n";
  for (const char* wrong :
       {"joined 3 3\n", "joined 3 4\n", "joined 3\n", "joined 3 2\njoined 3 2\n",
        "joined 3 2\ndropped 2 0 2\n", "joined 3 2\ndropped 1 0 6\n",
        "joined 3 2\ndropped 1 2 2\ndropped 1 3 1\n", "joined 3 2\ndropped 1 0 0\n"}) {
    EXPECT_THROW(number_globally(shapes::unit_cube(), tree + wrong), Error) << wrong;
  }
  EXPECT_NO_THROW(number_globally(shapes::unit_cube(), tree + "joined 3 2\ndropped 1 0 5\n"));
}

TEST(GlobalNumbering, text_keeps_what_was_joined_and_dropped) {
  const Numbering numbering = number_globally(shapes::unit_cube(), joined_table);
  const std::string text = numbering_to_text(numbering);
  const Numbering again = numbering_from_text(text, "n");
  EXPECT_EQ(numbering_to_text(again), text);
  EXPECT_EQ(again.nodes, numbering.nodes);
  EXPECT_EQ(global_number(again, {1, 9}), 14);
}

TEST(GlobalNumbering, damaged_text_is_refused) {
  const std::string text = numbering_to_text(number_globally(shapes::unit_cube(), joined_table));
  EXPECT_THROW(numbering_from_text("", "n"), CorruptFile);
  for (std::size_t length = 0; length + 1 < text.size(); ++length) {
    EXPECT_THROW(numbering_from_text(text.substr(0, length), "n"), CorruptFile) << length;
  }
}

}  // namespace
}  // namespace tetfarm
