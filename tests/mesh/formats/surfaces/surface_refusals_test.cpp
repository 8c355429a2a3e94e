// What the readers of surfaces say of files that are wrong: the whole message, with the place.
#include <gtest/gtest.h>

#include "tests/mesh/formats/refusal_table.h"
#include "tests/mesh/formats/surface_texts.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(SurfaceRefusals, of_stl) {
  const std::string text =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n";
  expect_refusals(
      "a.stl", text,
      {{"solid a\nfacet", "solid a\nface", "a.stl:2: expected facet or endsolid, found \"face\""},
       {"normal", "norm", "a.stl:2: expected normal, found \"norm\""},
       {"outer", "inner", "a.stl:3: expected outer, found \"inner\""},
       {"loop", "lap", "a.stl:3: expected loop, found \"lap\""},
       {"vertex 1", "point 1", "a.stl:5: expected vertex, found \"point\""},
       {"vertex 0 1 0", "vertex 0 1", "a.stl:7: expected a coordinate, found \"endloop\""},
       {"endloop", "vertex", "a.stl:7: expected endloop, found \"vertex\""},
       {"endfacet", "end", "a.stl:8: expected endfacet, found \"end\""},
       {"endsolid a\n", "", "a.stl:9: expected facet or endsolid, found nothing"},
       {"endsolid a\n", "endsolid a\nshape", "a.stl:10: expected solid, found \"shape\""},
       {"solid", "shape",
        "a.stl: byte 80: is not STL: it is not text that begins with \"solid\", and a binary file "
        "with the 1886351212 triangles that its header gives has 94317560684 bytes, this one 105"}},
      surface_refusal_of);
  EXPECT_EQ(surface_refusal_of("a.stl", "shape"),
            "a.stl: is not STL: it does not begin with \"solid\", and its 5 bytes are fewer than a "
            "binary header has");
  EXPECT_EQ(surface_refusal_of("a.stl", ""), "a.stl: the file is empty");
  EXPECT_EQ(surface_refusal_of("a.stl", "solid a\nendsolid a\n"),
            "a.stl: the file has no triangles");
}

TEST(SurfaceRefusals, of_binary_stl) {
  std::string bytes = texts::stl_binary(shapes::tetrahedron());
  EXPECT_EQ(surface_refusal_of("a.stl", bytes), "");
  const float endless = std::numeric_limits<float>::infinity();
  // The second corner of the third triangle.
  std::memcpy(bytes.data() + 84 + 2 * 50 + 12 + 12 + 8, &endless, 4);
  EXPECT_EQ(surface_refusal_of("a.stl", bytes),
            "a.stl: byte 208: triangle 2 has a coordinate that is not finite");
}

TEST(SurfaceRefusals, of_obj) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n# here\ng wall\nf 1 2/7 -1\n";
  expect_refusals("a.obj", text,
                  {{"v 1 0 0", "v 1 0", "a.obj:2: expected a coordinate, found nothing"},
                   {"v 1 0 0", "w 1 0 0", "a.obj:2: unknown OBJ statement \"w\""},
                   {"f 1 2/7 -1", "f 1 2", "a.obj:6: a face with 2 vertices"},
                   {"f 1 2/7 -1", "f 0 2 3", "a.obj:6: vertex 0 of the 3 so far"},
                   {"f 1 2/7 -1", "f 1 2 4", "a.obj:6: vertex 4 of the 3 so far"},
                   {"f 1 2/7 -1", "f 1 2 -4", "a.obj:6: vertex -4 of the 3 so far"},
                   {"f 1 2/7 -1", "f 1 /2 3", "a.obj:6: expected a vertex number, found nothing"}},
                  surface_refusal_of);
}

TEST(SurfaceRefusals, of_off) {
  const std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0 255\n0 1 0\n3 0 1 2 7\n";
  expect_refusals(
      "a.off", text,
      {{"OFF", "STOFF", "a.off:1: expected OFF, found \"STOFF\""},
       {"3 1 0", "x 1 0", "a.off:2: expected the number of vertices, found \"x\""},
       {"3 1 0", "3 x 0", "a.off:2: expected the number of faces, found \"x\""},
       {"3 1 0", "7 1 0", "a.off:2: a count of 7, but only 35 bytes left in the file"},
       {"3 1 0", "3 7 0", "a.off:2: a count of 7, but only 35 bytes left in the file"},
       {"0 1 0\n", "0 1\n", "a.off:5: expected a coordinate, found nothing"},
       {"3 0 1 2", "2 0 1", "a.off:6: a face with 2 vertices"},
       {"3 0 1 2", "x 0 1 2", "a.off:6: expected the number of vertices of a face, found \"x\""},
       {"3 0 1 2", "3 0 1 3", "a.off:6: vertex 3 of 3 (counted from 0)"},
       {"3 0 1 2", "3 0 1 -1", "a.off:6: vertex -1 of 3 (counted from 0)"},
       {"3 0 1 2", "3 0 1 x", "a.off:6: expected a vertex number, found \"x\""},
       {" 7\n", "\n8\n", "a.off:7: more text after the last face: \"8\""}},
      surface_refusal_of);
}

TEST(SurfaceRefusals, of_ply) {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment here\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n"
      "1 0 0\n0 1 0\n3 0 1 2\n";
  expect_refusals(
      "a.ply", text,
      {{"ply", "pli", "a.ply:1: expected ply, found \"pli\""},
       {"ascii", "text", "a.ply:2: unknown format \"text\""},
       {"comment", "remark", "a.ply:3: expected a line of the header, found \"remark\""},
       {"element vertex 3", "element vertex x",
        "a.ply:4: expected a number of elements, found \"x\""},
       {"element vertex 3", "element vertex -3", "a.ply:4: a negative number of elements"},
       {"element vertex 3\n", "", "a.ply:4: a property before the first element"},
       {"element vertex 3", "element vertex 99",
        "a.ply:10: a count of 99, but only 26 bytes left in the file"},
       {"float y", "real y", "a.ply:6: expected a type of number, found \"real\""},
       {"list uchar", "list float", "a.ply:9: the length of a list is not an integer"},
       {"list uchar int", "list uchar real", "a.ply:9: expected a type of number, found \"real\""},
       {"3 0 1 2", "2 0 1", "a.ply:14: a face with 2 vertices"},
       {"3 0 1 2", "9 0 1 2", "a.ply:14: a count of 9, but only 7 bytes left in the file"},
       {"3 0 1 2", "3 0 1 3", "a.ply:14: vertex 3 of 3 (counted from 0)"},
       {"3 0 1 2", "x 0 1 2", "a.ply:14: expected an integer, found \"x\""},
       {"1 0 0", "1 x 0", "a.ply:12: expected a coordinate, found \"x\""}},
      surface_refusal_of);
}

TEST(SurfaceRefusals, of_fro) {
  const std::string text = "1 3 0 0\n1 0 0 0\n2 1D0 0 0\n3 0 1 0\n1 1 2 3 7\n";
  expect_refusals(
      "a.fro", text,
      {{"1 3 0 0", "x 3 0 0", "a.fro:1: expected the number of triangles, found \"x\""},
       {"1 3 0 0", "1 x 0 0", "a.fro:1: expected the number of nodes, found \"x\""},
       {"1 3 0 0", "1 9 0 0", "a.fro:1: a count of 9, but only 36 bytes left in the file"},
       {"1 3 0 0", "9 3 0 0", "a.fro:1: a count of 9, but only 36 bytes left in the file"},
       {"2 1D0 0 0", "3 1D0 0 0", "a.fro:3: expected number 2, found 3"},
       {"2 1D0 0 0", "x 1D0 0 0", "a.fro:3: expected a node's number, found \"x\""},
       {"2 1D0 0 0", "2 1F0 0 0", "a.fro:3: expected a coordinate, found \"1F0\""},
       {"1 1 2 3 7", "0 1 2 3 7", "a.fro:5: expected number 1, found 0"},
       {"1 1 2 3 7", "1 1 2 4 7", "a.fro:5: vertex 4 of 3 (counted from 1)"},
       {"1 1 2 3 7", "1 1 2 0 7", "a.fro:5: vertex 0 of 3 (counted from 1)"},
       {"1 1 2 3 7", "1 1 2 3 x", "a.fro:5: expected a surface number, found \"x\""}},
      surface_refusal_of);
}

TEST(SurfaceRefusals, of_medit_text) {
  const std::string text =
      "MeshVersionFormatted 2\nDimension\n3\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n# here\n"
      "Corners\n1\n1\nTriangles\n1\n1 2 3 7\nEnd\n";
  expect_refusals(
      "a.mesh", text,
      {{"Formatted 2", "Formatted x", "a.mesh:1: expected the version, found \"x\""},
       {"Dimension", "Size", "a.mesh:2: expected Dimension, found \"Size\""},
       {"Dimension\n3", "Dimension\n2",
        "a.mesh:3: the mesh is not three-dimensional; `tetfarm adapt` takes meshes of the plane"},
       {"Vertices\n3", "Vertices\nx", "a.mesh:5: expected the length of a list, found \"x\""},
       {"Vertices\n3", "Vertices\n99",
        "a.mesh:5: a count of 99, but only 68 bytes left in the file"},
       {"1 0 0 0", "1 0 0 x", "a.mesh:7: expected a reference, found \"x\""},
       {"1 2 3 7", "1 2 4 7", "a.mesh:15: vertex 4 of 3 (counted from 1)"},
       {"1 2 3 7", "1 2 x 7", "a.mesh:15: expected a vertex number, found \"x\""},
       {"1 2 3 7", "1 2 3 x", "a.mesh:15: expected a reference, found \"x\""},
       {"Corners\n1", "Quadrilaterals\n1",
        "a.mesh:13: expected a vertex number, found \"Triangles\""}},
      surface_refusal_of);
  EXPECT_EQ(surface_refusal_of("a.mesh", changed(text, "Corners\n1\n1\n", "Quadrilaterals\n0\n")),
            "");
  EXPECT_EQ(surface_refusal_of("a.mesh", text + "Triangles\nx\n"), "") << "behind the end";
}

TEST(SurfaceRefusals, of_ugrid_text) {
  const std::string text = "3 1 0 0 0 0 0\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n7\n";
  expect_refusals(
      "a.ugrid", text,
      {{"3 1 0", "x 1 0", "a.ugrid:1: expected a count, found \"x\""},
       {"3 1 0", "3 -1 0", "a.ugrid:1: a count is negative"},
       {"3 1 0", "3 1 1", "a.ugrid:6: vertex 7 of 3 (counted from 1)"},
       {"3 1 0", "3 1 5", "a.ugrid:1: a count of 5, but only 27 bytes left in the file"},
       {"3 1 0", "6 1 0", "a.ugrid:1: a count of 6, but only 27 bytes left in the file"},
       {"3 1 0", "3 4 0", "a.ugrid:1: a count of 4, but only 27 bytes left in the file"},
       {"1 0 0\n", "1 x 0\n", "a.ugrid:3: expected a coordinate, found \"x\""},
       {"1 2 3", "1 2 4", "a.ugrid:5: vertex 4 of 3 (counted from 1)"},
       {"1 2 3", "1 2 0", "a.ugrid:5: vertex 0 of 3 (counted from 1)"},
       {"1 2 3", "1 2 x", "a.ugrid:5: expected a node number, found \"x\""},
       {"7\n", "x\n", "a.ugrid:6: expected a patch number, found \"x\""}},
      surface_refusal_of);
}

TEST(SurfaceRefusals, of_points_alone_say_how_many_they_are) {
  EXPECT_EQ(surface_refusal_of("a.obj", "v 0 0 0\nv 1 0 0\n"),
            "a.obj: the file has 2 points, but no triangles: make a surface of them first");
  EXPECT_EQ(surface_refusal_of("a.obj", "# nothing\n"), "a.obj: the file has no triangles");
}

TEST(SurfaceRefusals, of_names_that_tell_no_format) {
  const auto refusal = [](const std::string& name) -> std::string {
    try {
      read_surface_bytes("x", name);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const std::string reads = "Tetfarm reads .";
  EXPECT_EQ(
      refusal("wing.STEP"),
      "wing.STEP: unsupported file type `.step`; mesh a CAD file first: `gmsh -2 wing.STEP -o "
      "wing.msh`");
  EXPECT_EQ(refusal("a/wing").substr(0, 70),
            "a/wing: unknown file type, as the name has no extension; Tetfarm reads");
  EXPECT_EQ(refusal("wing.txt.gz").substr(0, 61),
            "wing.txt.gz: unsupported file type `.txt`; Tetfarm reads .stl");
}

}  // namespace
}  // namespace tetfarm
