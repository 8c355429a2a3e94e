// What is said of tables and texts of a numbering that are wrong: the whole message.
#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/assemble/global_numbering.h"
#include "mesh/assemble/leaf_numbering.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

const std::string tree = "cut 1 10\nleaf 2 5 30\nleaf 3 6 40\n";

std::string said_of_table(const std::string& table) {
  return error_text_of([&] { number_globally(shapes::unit_cube(), table); });
}

TEST(NumberingRefusals, name_the_line_of_a_table_that_is_none) {
  for (const char* line :
       {"knot 1 1", "cut 1", "cut 1 2 3", "cut 0 1", "cut 9223372036854775808 1", "leaf 1 2",
        "leaf 1 2 3 4 5", "leaf 0 1 1", "leaf 2 1152921504606846977 1", "joined 2", "joined 2 0",
        "joined 0 2", "dropped 1 2", "dropped 1 2 3 4", "leaf 2 1 -1", "leaf  2 1 1",
        "leaf 2 1 1 "}) {
    EXPECT_EQ(said_of_table(tree + line + "\n"),
              "the table of the tree has the line \"" + std::string(line) + "\"");
  }
  EXPECT_EQ(said_of_table("cut 1 10\nleaf 2 1152921504606846976 1\nleaf 3 6 40\n"), "");
}

TEST(NumberingRefusals, tell_a_tree_that_is_not_whole_from_nodes_that_do_not_exist) {
  const std::string whole = "the table of the tree does not have every cut and leaf exactly once";
  const std::string nodes = "the table of the tree drops nodes that do not exist";
  EXPECT_EQ(said_of_table(tree), "");
  EXPECT_EQ(said_of_table("cut 1 10\nleaf 2 5 30\n"), whole);
  EXPECT_EQ(said_of_table(tree + "leaf 3 6 40\n"), whole);
  EXPECT_EQ(said_of_table(tree + "leaf 6 6 40\n"), whole);
  EXPECT_EQ(said_of_table("cut 1 10\nleaf 2 5 30\njoined 3 2\n"), "");
  EXPECT_EQ(said_of_table("cut 1 10\nleaf 2 5 30\njoined 3 1\n"), whole) << "into a cut";
  EXPECT_EQ(said_of_table("cut 1 10\nleaf 2 5 30\njoined 3 3\n"), whole) << "into itself";
  for (const char* dropped : {"dropped 1 9 2", "dropped 1 10 1", "dropped 1 3 0", "dropped 4 0 1",
                              "dropped 0 0 1", "dropped 1 4 1\ndropped 1 4 1"}) {
    EXPECT_EQ(said_of_table(tree + dropped + "\n"), nodes) << dropped;
  }
  EXPECT_EQ(said_of_table(tree + "dropped 1 0 9\ndropped 1 9 1\n"), "");
}

TEST(NumberingRefusals, name_the_node_or_leaf_that_is_not_there) {
  const Numbering numbering = number_globally(shapes::unit_cube(), tree + "dropped 1 3 2\n");
  const auto node = [&](std::uint64_t owner, std::uint32_t index) {
    return error_text_of([&] { global_number(numbering, {owner, index}); });
  };
  EXPECT_EQ(node(0, 7), "");
  EXPECT_EQ(node(0, 8), "no node 8 of the surface in the numbering");
  EXPECT_EQ(node(1, 2), "");
  EXPECT_EQ(node(1, 3), "no node 3 of cut or leaf root in the numbering");
  EXPECT_EQ(node(1, 5), "");
  EXPECT_EQ(node(1, 10), "no node 10 of cut or leaf root in the numbering");
  EXPECT_EQ(node(4, 0), "no node 0 of cut or leaf LL in the numbering");
  EXPECT_EQ(error_text_of([&] {
              leaf_numbering(numbering, {{4}, 1, {}});
            }),
            "sub-domain LL is not a leaf of the numbering");
}

TEST(NumberingRefusals, of_a_text_name_the_file_and_the_line) {
  const std::string text =
      "tetfarm-numbering 1\nsurface 8\nunused 3\ncut 1 10\nleaf 2 5 30 7\nleaf 3 6 40\nend\n";
  const auto said_of_text = [](const std::string& wrong) {
    return error_text_of([&] { numbering_from_text(wrong, "n"); });
  };
  const auto changed = [&text](const std::string& what, const std::string& with) {
    return std::string(text).replace(text.find(what), what.size(), with);
  };
  EXPECT_EQ(said_of_text(text), "");
  EXPECT_EQ(numbering_to_text(numbering_from_text(text, "n")), text);
  EXPECT_EQ(said_of_text(""), "n: not a numbering");
  EXPECT_EQ(said_of_text("tetfarm-numbering 1\nend\n"), "n: not a numbering");
  EXPECT_EQ(said_of_text(changed("ing 1", "ing 2")), "n: not a numbering");
  EXPECT_EQ(said_of_text(changed("end\n", "")), "n: the end is missing");
  EXPECT_EQ(said_of_text(changed("surface 8\n", "")), "n: line 2 is wrong");
  EXPECT_EQ(said_of_text(changed("surface 8", "surface 2147483648")), "n: line 2 is wrong");
  EXPECT_EQ(said_of_text(changed("unused 3", "surface 3")), "n: line 3 is wrong");
  EXPECT_EQ(said_of_text(changed("unused 3", "unused 3 4")), "n: line 3 is wrong");
  EXPECT_EQ(said_of_text(changed("unused 3", "unused 2147483648")), "n: line 3 is wrong");
  EXPECT_EQ(said_of_text(changed("cut 1 10", "cut 1 x")), "n: line 4 is wrong");
  EXPECT_EQ(said_of_text(changed("unused 3", "unused 3\nunused 2")),
            "n: unused vertices are not in order");
  EXPECT_EQ(said_of_text(changed("leaf 3 6 40\n", "")),
            "n: does not have every cut and leaf exactly once");
  EXPECT_EQ(said_of_text(changed("end", "dropped 1 9 2\nend")), "n: drops nodes that do not exist");
}

}  // namespace
}  // namespace tetfarm
