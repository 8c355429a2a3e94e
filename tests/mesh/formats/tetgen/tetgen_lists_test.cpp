#include "mesh/formats/tetgen/tetgen_lists.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/mesh/formats/refusal_table.h"

namespace tetfarm {
namespace {

std::string walked(const std::string& bytes) {
  const std::string name = "a.node";
  InputScanner in(bytes, name, tetgen_comment);
  std::string text;
  const std::int64_t first = walk_tetgen_nodes(in, [&](const Vec3& p) {
    for (const double x : {p.x, p.y, p.z}) text += std::to_string(static_cast<int>(x)) + " ";
  });
  return text + "from " + std::to_string(first) + ", left: " + std::string(in.word());
}

TEST(TetgenLists, of_nodes_count_from_0_or_1_and_may_say_more_in_a_line) {
  EXPECT_EQ(walked("# nodes\n2 3 1 1\n0 1 2 3 0.5 1\n1 4 5 6 0.5 2\nnext"),
            "1 2 3 4 5 6 from 0, left: next");
  EXPECT_EQ(walked("2\n1 1 2 3\n2 4 5 6 # last\n"), "1 2 3 4 5 6 from 1, left: ");
  EXPECT_EQ(walked("0 2\nnext"), "from 0, left: next");
}

/// One tet in files of TetGen; `what` of one of them, told by its ending, is replaced by `with`.
std::string refusal_of_files(const std::string& ending, const std::string& what,
                             const std::string& with) {
  const TempFolder folder;
  std::map<std::string, std::string> files = {
      {".node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"},
      {".face", "2 1\n1 1 3 2 1\n2 1 2 4 2\n"},
      {".ele", "1 4 1\n1 1 2 3 4 1\n"}};
  if (!ending.empty()) {
    EXPECT_NE(files[ending].find(what), std::string::npos);
    files[ending] = changed(files[ending], what, with);
  }
  for (const auto& [end, text] : files) write_unsynced(folder.path() / ("a" + end), text);
  try {
    open_mesh(folder.path() / "a.ele", folder.path());
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    return message.substr(message.find("/a.") + 1);
  }
  return "";
}

struct WrongFile {
  std::string ending;
  std::string what;
  std::string with;
  std::string message;
};

TEST(TetgenLists, of_a_mesh_name_file_and_line_of_what_is_wrong) {
  EXPECT_EQ(refusal_of_files("", "", ""), "");
  for (const auto& [ending, what, with, message] : std::vector<WrongFile>{
           {".node", "4 3 0 0", "x 3 0 0", "a.node:1: expected the number of nodes, found \"x\""},
           {".node", "4 3 0 0", "99 3 0 0",
            "a.node:1: a count of 99, but only 39 bytes left in the file"},
           {".node", "4 3 0 0", "4 2 0 0", "a.node:1: the nodes are not three-dimensional"},
           {".node", "1 0 0 0", "2 0 0 0",
            "a.node:2: nodes are not numbered consecutively from 0 or 1"},
           {".node", "3 0 1 0", "4 0 1 0",
            "a.node:4: nodes are not numbered consecutively from 0 or 1"},
           {".node", "3 0 1 0", "3 0 1", "a.node:4: expected a coordinate, found nothing"},
           {".face", "2 1\n", "x 1\n", "a.face:1: expected a count, found \"x\""},
           {".face", "2 1\n", "2\n", "a.face:1: expected a number, found nothing"},
           {".face", "2 1 2 4 2", "3 1 2 4 2", "a.face:3: expected record 2"},
           {".face", "2 1 2 4 2", "2 1 2 4", "a.face:3: expected a number, found nothing"},
           {".face", "2 1 2 4 2", "2 1 2 5 2", "a.ele: boundary triangle 1 has node 4 of 4"},
           {".face", "2 1 2 4 2", "2 1 2 4 -1", "a.ele: boundary triangle 1 has the patch -1"},
           {".ele", "1 4 1", "1 10 1", "a.ele:1: only tets of four nodes are supported"},
           {".ele", "1 4 1", "1 4", "a.ele:1: expected a number, found nothing"},
           {".ele", "1 1 2 3 4 1", "0 1 2 3 4 1", "a.ele:2: expected record 1"},
           {".ele", "1 1 2 3 4 1", "1 1 2 3 4", "a.ele:2: expected a number, found nothing"},
           {".ele", "1 1 2 3 4 1", "1 1 2 3 0 1", "a.ele: tet 0 has node -1 of 4"},
           {".ele", "1 1 2 3 4 1", "1 1 2 3 4 0", "a.ele: a tet has the region 0"}}) {
    EXPECT_EQ(refusal_of_files(ending, what, with), message) << what << " -> " << with;
  }
}

TEST(TetgenLists, without_regions_and_marks_are_of_the_first_region_and_patch) {
  EXPECT_EQ(refusal_of_files(".ele", "1 4 1\n1 1 2 3 4 1", "1 4 0\n1 1 2 3 4"), "");
  EXPECT_EQ(refusal_of_files(".face", "2 1\n1 1 3 2 1\n2 1 2 4 2", "2 0\n1 1 3 2\n2 1 2 4"), "");
}

TEST(TetgenLists, of_a_surface_name_the_line_of_what_is_wrong) {
  const std::string poly =
      "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n2 1\n1 0 8\n3 1 3 2\n1 0 9\n3 1 2 4\n";
  expect_refusals(
      "a.poly", poly,
      {{"4 3\n1", "0 3\n1", "a.poly:1: the nodes are in a separate file; they must be in this one"},
       {"2 1\n1 0 8", "x 1\n1 0 8", "a.poly:6: expected the number of facets, found \"x\""},
       {"2 1\n1 0 8", "2 y\n1 0 8", "a.poly:6: expected a number, found \"y\""},
       {"1 0 8", "x 0 8", "a.poly:7: expected the number of polygons, found \"x\""},
       {"1 0 8", "2 0 8",
        "a.poly:7: a facet of 2 polygons and 0 holes: only one polygon without holes is supported"},
       {"1 0 9", "1 1 9",
        "a.poly:9: a facet of 1 polygons and 1 holes: only one polygon without holes is supported"},
       {"3 1 2 4", "2 1 2", "a.poly:10: a polygon with 2 corners"},
       {"3 1 2 4", "9 1 2 4", "a.poly:10: a count of 9, but only 7 bytes left in the file"},
       {"3 1 2 4", "3 1 2 5", "a.poly:10: vertex 5 of 4 (counted from 1)"},
       {"3 1 2 4", "3 1 2 0", "a.poly:10: vertex 0 of 4 (counted from 1)"}},
      surface_refusal_of);
}

}  // namespace
}  // namespace tetfarm
