#include "mesh/formats/su2/su2_walker.h"

#include <gtest/gtest.h>

#include "tests/mesh/formats/refusal_table.h"

namespace tetfarm {
namespace {

const std::string a_tet =
    "% one tet\nNDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 4\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 3\n"
    "NMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 4\n5 1 2 3\n5 0 3 2\n5 0 1 3\n5 0 2 1\n";

/// All that is handed on, a line each; elements of the types 3 are not wanted.
class Lines : public Su2Content {
 public:
  void add_node(const Vec3& p) override {
    text += "node " + std::to_string(static_cast<int>(p.x)) + " " +
            std::to_string(static_cast<int>(p.y)) + " " + std::to_string(static_cast<int>(p.z)) +
            "\n";
  }
  void begin_marker(std::string_view name) override {
    text += "marker " + std::string(name) + "\n";
  }
  bool wants(Su2List, std::int64_t type, const InputScanner&) override { return type != 3; }
  void add_element(Su2List list, std::int64_t type, std::span<const std::int64_t> nodes) override {
    text += (list == Su2List::marker ? "face " : "cell ") + std::to_string(type) + ":";
    for (const std::int64_t node : nodes) text += " " + std::to_string(node);
    text += "\n";
  }
  std::string text;
};

std::string walked(const std::string& bytes) {
  const std::string name = "a.su2";
  InputScanner in(bytes, name, '%');
  Lines lines;
  walk_su2(in, lines);
  return lines.text;
}

TEST(Su2Walker, hands_on_all_in_the_order_of_the_file) {
  EXPECT_EQ(walked(a_tet),
            "cell 10: 0 1 2 3\nnode 0 0 0\nnode 1 0 0\nnode 0 1 0\nnode 0 0 1\nmarker wall\n"
            "face 5: 1 2 3\nface 5: 0 3 2\nface 5: 0 1 3\nface 5: 0 2 1\n");
}

TEST(Su2Walker, takes_keywords_with_and_without_blanks_and_passes_over_unknown_ones) {
  EXPECT_EQ(walked("AOA=4 5\nNDIME =3 x\nNELEM = 3\n3 7 8\n5 0 1 2 9\n9 3 2 1 0\nFFD_NBOX= 1\n"
                   "NPOIN=1 7\n1 2 3 0 % here\nMARKER_TAG=low z\nMARKER_ELEMS=1\n5 2 1 0\nEND="),
            "cell 5: 0 1 2\ncell 9: 3 2 1 0\nnode 1 2 3\nmarker low\nface 5: 2 1 0\n");
}

TEST(Su2Walker, says_what_is_wrong_with_a_mesh_and_where) {
  const std::string cells = "expected a tet, a hex, a prism or a pyramid, type 10, 12, 13 or 14";
  expect_refusals(
      "a.su2", a_tet,
      {{"NDIME= 3", "NDIME= 2",
        "a.su2:2: the mesh is not three-dimensional; `tetfarm adapt` takes meshes of the plane"},
       {"NDIME= 3", "NDIME= x", "a.su2:2: expected the number of dimensions, found \"x\""},
       {"NDIME= 3", "NDIME 3", "a.su2:2: expected KEYWORD=, found \"NDIME\""},
       {"NELEM= 1", "NELEM= 999", "a.su2:3: a count of 999, but only 129 bytes left in the file"},
       {"NELEM= 1", "NELEM= x", "a.su2:3: expected a count, found \"x\""},
       {"10 0 1 2 3 0", "x 0 1 2 3 0", "a.su2:4: expected the type of an element, found \"x\""},
       {"10 0 1 2 3 0", "5 0 1 2", "a.su2:4: " + cells},
       {"10 0 1 2 3 0", "11 0 1 2 3", "a.su2:4: " + cells},
       {"10 0 1 2 3 0", "10 0 1 2", "a.su2:4: expected a node number, found nothing"},
       {"NPOIN= 4", "NPOIN= -4", "a.su2:5: a count of -4, but only 107 bytes left in the file"},
       {"0 1 0 2\n", "0 1\n", "a.su2:8: expected a coordinate, found nothing"},
       {"MARKER_TAG= wall\n", "", "a.su2:11: MARKER_ELEMS before any MARKER_TAG"},
       {"5 0 3 2", "10 0 3 2 1", "a.su2:14: expected a triangle or a quad, type 5 or 9"},
       {"5 0 3 2", "7 0 3 2 1", "a.su2:14: expected a triangle or a quad, type 5 or 9"},
       {"5 0 3 2", "5 0 3 4", "a.su2: boundary triangle 1 has node 4 of 4"},
       {"5 0 3 2", "5 0 3 -1", "a.su2: boundary triangle 1 has node -1 of 4"},
       {"10 0 1 2 3 0", "10 0 1 2 4 0", "a.su2: tet 0 has node 4 of 4"}},
      mesh_refusal_of);
}

TEST(Su2Walker, says_what_is_wrong_with_a_surface_and_where) {
  expect_refusals(
      "a.su2", a_tet,
      {{"5 0 3 2", "10 0 3 2 1",
        "a.su2:14: an element of a marker has the type 10: expected a triangle (5) or a quadrangle "
        "(9)"},
       {"5 0 3 2", "9 0 3 2 4", "a.su2:16: vertex 4 of 4 (counted from 0)"},
       {"5 0 3 2", "5 0 3 4", "a.su2:16: vertex 4 of 4 (counted from 0)"},
       {"5 0 3 2", "5 0 3 -1", "a.su2:16: vertex -1 of 4 (counted from 0)"}},
      surface_refusal_of);
}

}  // namespace
}  // namespace tetfarm
