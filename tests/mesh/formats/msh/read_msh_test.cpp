#include "mesh/formats/msh/read_msh.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/formats/msh/msh_elements.h"
#include "tests/mesh/formats/surface_texts.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

SurfaceMesh cube_of_two_patches() {
  SurfaceMesh cube = shapes::unit_cube();
  cube.patch_names = {"wall", "far field"};
  for (std::size_t i = 6; i < 12; ++i) cube.patch_of_triangle[i] = 1;
  return cube;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

class ReadMsh : public testing::TestWithParam<std::pair<int, bool>> {
 protected:
  std::string file() const { return texts::msh(cube_, GetParam().first, GetParam().second); }
  bool is_binary() const { return GetParam().second; }

  const SurfaceMesh cube_ = cube_of_two_patches();
};

INSTANTIATE_TEST_SUITE_P(Versions, ReadMsh,
                         testing::Values(std::pair{2, false}, std::pair{2, true},
                                         std::pair{4, false}, std::pair{4, true}));

TEST_P(ReadMsh, reads_sparse_nodes_triangles_and_physical_names_and_passes_over_tets) {
  const SurfaceMesh read = read_msh(file(), "a.msh");
  EXPECT_EQ(read.vertices, cube_.vertices);
  EXPECT_EQ(read.triangles, cube_.triangles);
  EXPECT_EQ(read.patch_names, cube_.patch_names);
  EXPECT_EQ(read.patch_of_triangle, cube_.patch_of_triangle);
}

TEST_P(ReadMsh, drops_the_nodes_that_no_triangle_uses) {
  SurfaceMesh mesh = cube_;
  mesh.vertices.insert(mesh.vertices.begin(), {0.5, 0.5, 0.5});
  for (Triangle& triangle : mesh.triangles) {
    for (std::int32_t& v : triangle) ++v;
  }
  const SurfaceMesh read = read_msh(texts::msh(mesh, GetParam().first, GetParam().second), "a.msh");
  EXPECT_EQ(read.vertices, cube_.vertices);
  EXPECT_EQ(read.triangles, cube_.triangles);
}

TEST_P(ReadMsh, every_cut_is_an_error) {
  const std::string bytes = file();
  for (std::size_t size = 0; size + 1 < bytes.size(); size += is_binary() ? 1 : 3) {
    EXPECT_THROW(read_msh(bytes.substr(0, size), "a.msh"), InvalidInput) << size;
  }
}

TEST_P(ReadMsh, a_node_that_is_not_finite_is_refused) {
  SurfaceMesh mesh = cube_;
  mesh.vertices[5].y = HUGE_VAL;
  EXPECT_THAT([&] { read_msh(texts::msh(mesh, GetParam().first, GetParam().second), "a.msh"); },
              ThrowsMessage<InvalidInput>(HasSubstr(is_binary() ? "a.msh: byte " : "a.msh:")));
}

const std::string format_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string nodes_2 =
    format_2 + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n";

TEST(ReadMshText, triangles_without_physical_name_are_named_by_number_or_surface) {
  const SurfaceMesh read = read_msh(
      nodes_2 + "3\n1 2 2 5 1 1 2 3\n2 2 2 0 1 1 2 4\n3 2 0 2 3 4\n$EndElements\n", "a.msh");
  EXPECT_THAT(read.patch_names, ElementsAre("physical 5", "surface"));
  EXPECT_THAT(read.patch_of_triangle, ElementsAre(0, 1, 1));
}

TEST(ReadMshText, reads_parametric_nodes_of_version_4) {
  const SurfaceMesh read = read_msh(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 3 5 9\n0 1 1 1\n5\n0 0 0\n2 1 1 2\n9\n7\n"
      "1 0 0 0.1 0.2\n0 1 0 0.3 0.4\n$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 5 9 7\n"
      "$EndElements\n",
      "a.msh");
  EXPECT_THAT(read.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ReadMshText, takes_the_first_physical_group_of_a_surface_whatever_its_sign) {
  const SurfaceMesh read = read_msh(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 8 \"wing\"\n3 8 \"air\"\n"
      "$EndPhysicalNames\n$Entities\n0 0 1 1\n4 0 0 0 1 1 1 2 -8 9 0\n4 0 0 0 1 1 1 1 7 1 4\n"
      "$EndEntities\n$Nodes\n1 3 1 3\n2 4 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
      "$Elements\n1 1 1 1\n2 4 2 1\n1 1 2 3\n$EndElements\n",
      "a.msh");
  EXPECT_THAT(read.patch_names, ElementsAre("wing"));
}

TEST(ReadMshText, names_the_line_of_what_it_cannot_use) {
  const auto reading = [](const std::string& text) { return [=] { read_msh(text, "a.msh"); }; };
  const auto throws = [](const std::string& text) {
    return ThrowsMessage<InvalidInput>(HasSubstr(text));
  };
  EXPECT_THAT(
      reading(nodes_2 + "1\n1 10 0 1 2 3 4 1 2 3 4 1\n$EndElements\n"),
      throws("a.msh:13: a 9-node quadrangle: only triangles of 3 nodes and quadrangles of 4"));
  EXPECT_THAT(reading(nodes_2 + "1\n1 9 0 1 2 3 4 1 2\n$EndElements\n"),
              throws("a.msh:13: a 6-node triangle"));
  EXPECT_THAT(reading(nodes_2 + "1\n1 77 0 1 2 3\n$EndElements\n"), throws("element type 77"));
  EXPECT_THAT(reading(nodes_2 + "1\n1 2 0 1 2 5\n$EndElements\n"), throws("there is no node 5"));
  EXPECT_THAT(reading(nodes_2 + "1\n1 2 0 1 2 99999999999\n$EndElements\n"),
              throws("no node 9999"));
  EXPECT_THAT(reading(nodes_2 + "1\n1 2 -3 1 2 3\n$EndElements\n"), throws("negative"));
  EXPECT_THAT(reading(nodes_2 + "2\n1 2 0 1 2 3\n$EndElements\n"), throws("an element number"));
  EXPECT_THAT(reading(format_2), throws("no section $Elements"));
  EXPECT_THAT(reading(format_2 + "$Nodes\n4000000000\n1 0 0 0\n"), throws("a count of 4000000000"));
  EXPECT_THAT(reading(with(nodes_2, "\n4 0 0 1", "\n3 0 0 1")), throws("have the tag 3"));
  EXPECT_THAT(reading(with(nodes_2, "2.2", "4.0")), throws("save it as 4.1 or 2.2"));
  EXPECT_THAT(reading(with(nodes_2, "2.2 0 8", "2.2 0 4")), throws("8 bytes"));
  EXPECT_THAT(reading("$NOD\n3\n"), throws("a.msh:1: Gmsh format 1 is not supported; save"));
  EXPECT_THAT(
      reading("(1 \"Fluent\")\n"),
      throws("a.msh:1: is not a mesh of Gmsh: expected $MeshFormat, found \"(1\"; Fluent and "
             "GiD give their files the ending .msh too"));
  EXPECT_THAT(reading(format_2 + "$Other\n1 2 3\n"), throws("has no end"));
}

TEST(ReadMshText, tells_a_big_endian_file) {
  EXPECT_THAT([] { read_msh(std::string("$MeshFormat\n2.2 1 8\n\0\0\0\1\n", 25), "a.msh"); },
              ThrowsMessage<InvalidInput>(HasSubstr("big-endian")));
}

TEST(MshNodeTags, finds_dense_sparse_and_unsorted_tags) {
  MshNodeTags tags;
  for (const std::int64_t tag : {7, 8, 9, 20, 3, 1000000000}) tags.add(tag);
  EXPECT_FALSE(tags.sort());
  EXPECT_EQ(tags.find(7), 0);
  EXPECT_EQ(tags.find(20), 3);
  EXPECT_EQ(tags.find(3), 4);
  EXPECT_EQ(tags.find(1000000000), 5);
  for (const std::int64_t tag : {-1, 0, 4, 10, 1000000001}) EXPECT_EQ(tags.find(tag), -1);
  tags.add(9);
  EXPECT_EQ(tags.sort(), 9);
}

}  // namespace
}  // namespace tetfarm
