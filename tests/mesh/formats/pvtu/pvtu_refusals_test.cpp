// Pieces of VTK XML that are wrong, and pieces of other programs.
#include <gtest/gtest.h>

#include "base/file_system.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/mesh/formats/every_kind_mesh.h"
#include "tests/mesh/formats/mesh_listing.h"
#include "tests/mesh/formats/wrong_bytes.h"

namespace tetfarm {
namespace {

std::string piece_of(const MeshSource& mesh, const std::string& piece) {
  const TempFolder folder;
  export_mesh(mesh, find_mesh_format("pvtu", ""), folder.path() / "a.pvtu");
  return read_file(folder.path() / piece);
}

/// Of 5 points and 2 tets, with their 5 outer triangles.
std::string first_piece() { return piece_of(TetsMesh(), "a/a_0.vtu"); }

TEST(PvtuRefusals, name_the_line_of_what_is_wrong) {
  const std::string only = "a.vtu: only raw, little-endian data with 64-bit lengths are supported";
  expect_refusals(
      "a.vtu", first_piece(),
      {{"LittleEndian", "BigEndian", only},
       {"UInt64", "UInt32", only},
       {"UInt64\"", "UInt64\" compressor=\"zlib\"", only},
       {"\"raw\"", "\"base64\"", only},
       {"<AppendedData", "<Appended", "a.vtu: is not a .vtu file with appended data"},
       {"<Piece ", "<Peace ", "a.vtu:1: there is no piece"},
       {"Points=\"5", "Points=\"x", "a.vtu:4: expected a number, found \"x\""},
       {"Points=\"5", "Points=\"-5", "a.vtu:4: expected a number, found \"-5\""},
       {"Points=\"5", "Points=\"5 ", "a.vtu:4: expected a number, found \"5 \""},
       {"Points=\"5", "Points=\"99999999", "a.vtu:4: a count is larger than the file"},
       {"Cells=\"7", "Cells=\"99999999", "a.vtu:4: a count is larger than the file"},
       {"Name=\"connectivity", "Name=\"links", "a.vtu:1: there is no array connectivity"},
       {"Name=\"Points", "Name=\"places", "a.vtu:1: there is no array Points"},
       {"Int64\" Name=\"connectivity", "Int32\" Name=\"connectivity",
        "a.vtu:12: connectivity is not Int64, appended"},
       {"Components=\"3\" format=\"appended", "Components=\"3\" format=\"ascii",
        "a.vtu:6: Points is not Float64, appended"},
       {"Int32\" Name=\"region", "Int64\" Name=\"region",
        "a.vtu:18: region is not Int32, appended"},
       {"offset=\"0\"", "offset=\"999999999\"", "a.vtu:6: an offset is larger than the file"},
       {"offset=\"0\"", "offset=\"y\"", "a.vtu:6: expected a number, found \"y\""}},
      mesh_refusal_of);
}

TEST(PvtuRefusals, name_what_is_wrong_in_the_arrays) {
  const std::string right = first_piece();
  const std::size_t first = right.find('_', right.find("<AppendedData")) + 1;
  constexpr std::size_t ids = 8 + 5 * 24 + 8 + 5 * 8;
  constexpr std::size_t offsets = ids + 8 + (2 * 4 + 5 * 3) * 8;
  constexpr std::size_t types = offsets + 8 + 7 * 8;
  constexpr std::size_t regions = types + 8 + 7 + 8 + 7 * 4;
  expect_refusals_of_bytes(
      "a.vtu", right,
      {{first, raw_bytes(std::int64_t{96}),
        "a.vtu: byte " + std::to_string(first) + ": Points has 96 bytes"},
       {first + ids + 8, raw_bytes(std::int64_t{5}), "a.vtu: a cell has point 5 of 5"},
       {first + ids + 8, raw_bytes(std::int64_t{-1}), "a.vtu: a cell has point -1 of 5"},
       {first + types + 8, "\x01",
        "a.vtu: has a cell of type 1; only triangles (5), quads (9), tetrahedra (10), hexahedra "
        "(12), wedges (13) and pyramids (14) are read"},
       {first + types + 8, "\x0c",
        "a.vtu: byte " + std::to_string(first + ids) + ": connectivity has 184 bytes"},
       {first + regions + 8, raw_bytes(0), "a.vtu: a cell has the region 0"},
       {first + regions + 8, raw_bytes(1'000'001), "a.vtu: a cell has the region 1000001"}},
      mesh_refusal_of);
  const std::string cut = right.substr(0, first + regions + 20);
  EXPECT_EQ(mesh_refusal_of("a.vtu", cut), "a.vtu: byte " + std::to_string(first + regions) +
                                               ": region ends after the end of the file");
}

std::string read_of(const std::string& name, const std::string& bytes) {
  const TempFolder folder;
  write_unsynced(folder.path() / name, bytes);
  return mesh_listing(*open_mesh(folder.path() / name));
}

TEST(PvtuRefusals, are_of_no_piece_alone_that_says_nothing_of_numbers_regions_and_patches) {
  std::string bytes = piece_of(TetsMesh(), "a/a_1.vtu");
  for (const char* name : {"GlobalNodeId", "region", "patch"}) {
    bytes = changed(bytes, "Name=\"" + std::string(name), "Name=\"other");
  }
  EXPECT_EQ(read_of("a.vtu", bytes),
            "sub-domains\npart 0 region 1\n node 0 at 1 0 0\n node 1 at 0 1 0\n node 2 at 1 1 1\n"
            " node 3 at 1 1 -0.125\n tet 0 1 2 3 region 1\n triangle 1 2 3 patch 0 region 1\n"
            " triangle 0 3 2 patch 0 region 1\n triangle 0 1 3 patch 0 region 1\n"
            " lists of regions:;\n");
}

TEST(PvtuRefusals, are_of_several_pieces_without_numbers_of_nodes_and_of_a_cut_list) {
  const TempFolder folder;
  export_mesh(TetsMesh(), find_mesh_format("pvtu", ""), folder.path() / "a.pvtu");
  const auto said = [&folder]() -> std::string {
    try {
      open_mesh(folder.path() / "a.pvtu");
    } catch (const InvalidInput& error) {
      const std::string message = error.what();
      return message.substr(folder.path().string().size() + 1);
    }
    return "";
  };
  EXPECT_EQ(said(), "");
  const std::string piece = read_file(folder.path() / "a/a_1.vtu");
  write_unsynced(folder.path() / "a/a_1.vtu", changed(piece, "GlobalNodeId", "Number"));
  EXPECT_EQ(said(), "a/a_1.vtu: is one of several pieces, but has no GlobalNodeId to join them by");
  write_unsynced(folder.path() / "a/a_1.vtu", piece);
  const std::string list = read_file(folder.path() / "a.pvtu");
  write_unsynced(folder.path() / "a.pvtu", changed(list, "</VTKFile>", ""));
  EXPECT_EQ(said(), "a.pvtu: is not a complete .pvtu file");
  write_unsynced(folder.path() / "a.pvtu", list.substr(0, list.find("<Piece")) + "</VTKFile>");
  EXPECT_EQ(said(), "a.pvtu: is not a complete .pvtu file");
}

}  // namespace
}  // namespace tetfarm
