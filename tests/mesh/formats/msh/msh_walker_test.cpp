#include "mesh/formats/msh/msh_walker.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/mesh/formats/refusal_table.h"

namespace tetfarm {
namespace {

const std::string text_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 1\n1 0 0 0 1 1 1 1 2 0\n"
    "1 0 0 0 1 1 1 1 3 0\n$EndEntities\n$Nodes\n2 4 1 4\n2 1 0 3\n4\n1\n2\n0 0 1\n0 0 0\n1 0 0\n"
    "3 1 0 1\n3\n0 1 0\n$EndNodes\n$Elements\n2 2 1 2\n2 1 2 1\n1 1 3 2\n3 1 4 1\n2 1 2 3 4\n"
    "$EndElements\n";
const std::string text_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 5 \"wing\"\n$EndPhysicalNames\n"
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
    "$EndNodes\n$Elements\n3\n1 15 2 0 1 1\n2 2 2 5 1 1 3 2\n3 4 4 3 1 1 7 1 2 3 4\n"
    "$EndElements\n";

/// All that is handed on, a line each.
class Lines : public MshContent {
 public:
  void add_name(int dimension, std::int64_t group, std::string_view name) override {
    text += "name " + std::to_string(dimension) + " " + std::to_string(group) + " " +
            std::string(name) + "\n";
  }
  void add_node(std::int64_t tag, const Vec3& p) override {
    text += "node " + std::to_string(tag) + " " + std::to_string(static_cast<int>(p.x)) + " " +
            std::to_string(static_cast<int>(p.y)) + " " + std::to_string(static_cast<int>(p.z)) +
            "\n";
  }
  void end_nodes() override { text += "end of nodes\n"; }
  bool wants(const MshElementType& type, std::int64_t number) override {
    text += "wants " + std::string(type.name) + " " + std::to_string(number) + "\n";
    return type.dimension >= 2;
  }
  void add_element(const MshElement& element) override {
    text += "element " + std::to_string(element.type) + " group " + std::to_string(element.group) +
            " entity " + std::to_string(element.entity) + " partition " +
            std::to_string(element.partition) + (element.is_ghost ? " ghost" : "") + ":";
    for (const std::int64_t node : element.nodes) text += " " + std::to_string(node);
    text += "\n";
  }
  std::string text;
};

std::string walked(const std::string& bytes, bool head_first = false) {
  const std::string name = "a.msh";
  InputScanner in(bytes, name);
  MshWalker walker(in);
  Lines lines;
  if (head_first) {
    walker.walk_head(lines);
    lines.text += walker.is_partitioned() ? "partitioned\n" : "whole\n";
    lines.text += walker.has_ghosts() ? "ghosts\n" : "no ghosts\n";
    lines.text += walker.is_version_4() ? "version 4\n" : "version 2\n";
  }
  walker.walk(lines);
  return lines.text;
}

TEST(MshWalker, hands_on_all_of_version_4_in_the_order_of_the_file) {
  EXPECT_EQ(walked(text_4, true),
            "whole\nno ghosts\nversion 4\nnode 4 0 0 1\nnode 1 0 0 0\nnode 2 1 0 0\nnode 3 0 1 0\n"
            "end of nodes\nwants triangle 2\nelement 2 group 2 entity 1 partition 0: 1 3 2\n"
            "wants tetrahedron 4\nelement 4 group 3 entity 1 partition 0: 1 2 3 4\n");
}

TEST(MshWalker, hands_on_all_of_version_2_in_the_order_of_the_file) {
  const std::string elements =
      "node 1 0 0 0\nnode 2 1 0 0\nnode 3 0 1 0\nnode 4 0 0 1\nend of nodes\nwants point 15\n"
      "wants triangle 2\nelement 2 group 5 entity 0 partition 0: 1 3 2\nwants tetrahedron 4\n"
      "element 4 group 3 entity 0 partition 7: 1 2 3 4\n";
  EXPECT_EQ(walked(text_2), "name 2 5 wing\n" + elements);
  EXPECT_EQ(walked(text_2, true), "name 2 5 wing\nwhole\nno ghosts\nversion 2\n" + elements);
}

TEST(MshWalker, takes_versions_2_and_2_1_for_2_2_and_no_quotes_round_a_name) {
  for (const char* version : {"2 0", "2.1 0"}) {
    EXPECT_EQ(walked(changed(text_2, "2.2 0", version)), walked(text_2));
  }
  EXPECT_EQ(walked(changed(text_2, "\"wing\"", "wing")), walked(text_2));
  EXPECT_EQ(walked(changed(text_2, "\"wing\"", "\"")).substr(0, 11), "name 2 5 \"\n");
  EXPECT_EQ(walked(changed(text_2, "2 5 \"wing\"", "4 5 wing")).substr(0, 5), "node ")
      << "there is no dimension 4";
}

TEST(MshWalker, takes_the_first_partition_of_an_element_that_has_any) {
  const auto last = [](const std::string& tags) {
    const std::string text = walked(changed(text_2, "4 4 3 1 1 7 ", "4 " + tags));
    return text.substr(text.rfind("element"));
  };
  EXPECT_EQ(last("5 3 1 2 7 -8 "), "element 4 group 3 entity 0 partition 7: 1 2 3 4\n");
  EXPECT_EQ(last("4 3 1 0 7 "), "element 4 group 3 entity 0 partition 0: 1 2 3 4\n");
  EXPECT_EQ(last("0 "), "element 4 group 0 entity 0 partition 0: 1 2 3 4\n");
}

TEST(MshWalker, knows_partitions_and_the_elements_of_others_as_ghosts) {
  const std::string partitioned =
      changed(changed(text_4, "$Nodes",
                      "$PartitionedEntities\n2\n1\n9 1\n0 0 1 1\n3 2 1 1 1 0 0 0 1 1 1 1 -6 0\n"
                      "4 3 1 1 1 0 0 0 1 1 1 2 8 7 1 5\n$EndPartitionedEntities\n$Nodes"),
              "2 2 1 2\n2 1 2 1\n1 1 3 2\n3 1 4 1\n2 1 2 3 4\n",
              "3 3 1 3\n2 3 2 1\n1 1 3 2\n3 4 4 1\n2 1 2 3 4\n3 9 4 1\n3 1 2 3 4\n");
  const std::string text = walked(partitioned, true);
  EXPECT_EQ(text.substr(0, 29), "partitioned\nghosts\nversion 4\n");
  EXPECT_EQ(text.substr(text.find("wants")),
            "wants triangle 2\nelement 2 group 6 entity 3 partition 0: 1 3 2\n"
            "wants tetrahedron 4\nelement 4 group 8 entity 4 partition 0: 1 2 3 4\n"
            "wants tetrahedron 4\nelement 4 group 0 entity 9 partition 0 ghost: 1 2 3 4\n");
}

TEST(MshWalker, says_what_is_wrong_with_version_4_and_where) {
  const std::string only =
      ": only triangles, quads, tets, pyramids, prisms and hexes are supported";
  expect_refusals(
      "a.msh", text_4,
      {{"$MeshFormat", "$NOD", "a.msh:1: Gmsh format 1 is not supported; save it as 4.1 or 2.2"},
       {"4.1 0 8", "4 0 8", "a.msh:2: Gmsh format \"4\" is not supported; save it as 4.1 or 2.2"},
       {"4.1 0 8", "4.1 2 8", "a.msh:2: the file type is not 0 or 1"},
       {"4.1 0 8", "4.1 x 8", "a.msh:2: expected the file type, found \"x\""},
       {"4.1 0 8", "4.1 0 4", "a.msh:2: numbers do not have 8 bytes"},
       {"$EndMeshFormat", "$End", "a.msh:3: expected $EndMeshFormat, found \"$End\""},
       {"1 0 0 0 1 1 1 1 2 0", "x 0 0 0 1 1 1 1 2 0",
        "a.msh:6: expected an entity tag, found \"x\""},
       {"1 0 0 0 1 1 1 1 2 0", "1 0 0 0 1 1 1 1 x 0",
        "a.msh:6: expected a physical tag, found \"x\""},
       {"1 0 0 0 1 1 1 1 2 0", "1 0 0 0 1 1 1 1 2 1 x",
        "a.msh:6: expected a bounding entity, found \"x\""},
       {"$EndEntities", "$EndEntity", "a.msh:8: expected $EndEntities, found \"$EndEntity\""},
       {"1 1 1 1 2 0", "1 1 1 1 2000000 0", "a.msh:25: the physical tag 2000000 is out of range"},
       {"$Nodes", "Nodes", "a.msh:9: expected a section like $Nodes, found \"Nodes\""},
       {"$Nodes", "$Other", "a.msh:9: the section \"$Other\" has no end"},
       {"2 1 0 3\n", "2 1 0 -3\n", "a.msh:11: a count of -3, but only 116 bytes left in the file"},
       {"2 1 0 3\n", "2 1 x 3\n", "a.msh:11: expected 0 or 1 for parametric, found \"x\""},
       {"4\n1\n2\n", "x\n1\n2\n", "a.msh:12: expected a node number, found \"x\""},
       {"4\n1\n2\n", "0\n1\n2\n", "a.msh:15: node tags are not 1 to N: 0"},
       {"4\n1\n2\n", "400\n1\n2\n", "a.msh:15: node tags are not 1 to N: 400"},
       {"4\n1\n2\n", "4\n4\n2\n", "a.msh:16: two nodes have the tag 4"},
       {"4\n1\n2\n", "5\n1\n2\n",
        "a.msh: node tags are not 1 to N: 4 nodes, but the largest tag is 5"},
       {"0 0 1\n", "0 x 1\n", "a.msh:15: expected a coordinate, found \"x\""},
       {"0 0 1\n", "0 inf 1\n", "a.msh:15: a coordinate is inf"},
       {"$EndNodes", "$EndNode", "a.msh:21: expected $EndNodes, found \"$EndNode\""},
       {"2 1 2 1\n", "2 1 99 1\n", "a.msh:24: unknown element type 99"},
       {"2 1 2 1\n", "2 1 0 1\n", "a.msh:24: unknown element type 0"},
       {"2 1 2 1\n", "3 1 2 1\n", "a.msh:24: element type 2 in an entity of dimension 3"},
       {"2 1 2 1\n", "2 1 9 1\n", "a.msh:24: a 6-node triangle" + only},
       {"1 1 3 2\n", "1 1 3 9\n", "a.msh: boundary triangle 0 has node 8 of 4"},
       {"2 1 2 3 4\n", "2 1 2 3 5\n", "a.msh: tet 0 has node 4 of 4"},
       {"2 1 2 3 4\n", "2 0 2 3 4\n", "a.msh: tet 0 has node -1 of 4"},
       {"$EndElements\n", "", "a.msh:28: expected $EndElements, found nothing"}},
      mesh_refusal_of);
  EXPECT_EQ(mesh_refusal_of("a.msh", text_4.substr(0, text_4.find("$Elements"))),
            "a.msh:22: the file has no section $Elements");
}

TEST(MshWalker, says_what_is_wrong_with_version_2_and_where) {
  expect_refusals(
      "a.msh", text_2,
      {{"1\n2 5", "x\n2 5", "a.msh:5: expected the number of physical names, found \"x\""},
       {"2 5 \"wing\"", "x 5 \"wing\"", "a.msh:6: expected a dimension, found \"x\""},
       {"2 5 \"wing\"", "2 0 \"wing\"", "a.msh:6: the physical tag 0 is out of range"},
       {"$EndPhysicalNames", "$EndNames",
        "a.msh:7: expected $EndPhysicalNames, found \"$EndNames\""},
       {"4\n1 0", "40\n1 0", "a.msh:9: a count of 40, but only 119 bytes left in the file"},
       {"2 1 0 0", "2 1 0 nan", "a.msh:11: a coordinate is nan"},
       {"3\n1 15", "100\n1 15", "a.msh:16: a count of 100, but only 65 bytes left in the file"},
       {"1 15 2", "x 15 2", "a.msh:17: expected an element number, found \"x\""},
       {"1 15 2", "1 x 2", "a.msh:17: expected an element type, found \"x\""},
       {"2 2 2 5", "2 32 2 5", "a.msh:18: unknown element type 32"},
       {"2 2 2 5", "2 2 -2 5", "a.msh:18: a negative number of tags"},
       {"2 2 2 5", "2 2 x 5", "a.msh:18: expected the number of tags, found \"x\""},
       {"3 1 1 7 1", "-3 1 1 7 1", "a.msh:19: the physical tag -3 is out of range"},
       {"3 1 1 7 1", "3 1 1 2000000 1", "a.msh:19: the physical tag 2000000 is out of range"},
       {"7 1 2 3 4", "7 1 2 3 x", "a.msh:19: expected a node number, found \"x\""},
       {"$EndElements", "$EndElement", "a.msh:20: expected $EndElements, found \"$EndElement\""}},
      mesh_refusal_of);
}

TEST(MshWalker, says_of_a_surface_what_is_wrong_and_where) {
  expect_refusals("a.msh", text_2,
                  {{"3 4 4 3 1 1 7", "3 9 4 3 1 1 7",
                    "a.msh:19: a 6-node triangle: only triangles of 3 nodes and quadrangles of 4 "
                    "are supported"},
                   {"5 1 1 3 2", "5 1 1 3 5", "a.msh:18: there is no node 5"},
                   {"4 0 0 1", "3 0 0 1", "a.msh:14: two nodes have the tag 3"}},
                  surface_refusal_of);
}

template <class... Numbers>
std::string raw(Numbers... numbers) {
  std::string bytes;
  const auto add = [&bytes](const auto& number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  (add(numbers), ...);
  return bytes;
}

TEST(MshWalker, refuses_more_binary_elements_in_a_block_than_are_left) {
  const auto file = [](std::int32_t here) {
    return "$MeshFormat\n2.2 1 8\n" + raw(1) + "\n$EndMeshFormat\n$Elements\n2\n" +
           raw(15, here, 0, 7, 1, 8, 2) + "\n$EndElements\n";
  };
  EXPECT_EQ(walked(file(2)), "wants point 15\n");
  for (const std::int32_t here : {0, 3, -1}) {
    const std::string text = surface_refusal_of("a.msh", file(here));
    EXPECT_EQ(text, "a.msh: byte 60: a block of " +
                        std::to_string(static_cast<std::uint32_t>(here)) +
                        " elements, but only 2 are left");
  }
}

}  // namespace
}  // namespace tetfarm
