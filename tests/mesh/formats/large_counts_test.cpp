#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/openfoam/seam_faces.h"
#include "mesh/formats/pvtu/write_pvtu.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/vtkhdf/read_vtkhdf.h"
#include "mesh/formats/vtkhdf/write_vtkhdf.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/last_of_large_mesh.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::int64_t most = 2147483647;
/// The last numbers of 32 bits with and without sign lie between those before and those of the
/// part.
constexpr std::int64_t below_2_31 = most - 2;
constexpr std::int64_t below_2_32 = 4294967295 - 2;

std::filesystem::path written(const LastOfLargeMesh& mesh, const TempFolder& folder,
                              const std::string& format, const std::string& name) {
  const std::filesystem::path file = folder.path() / name;
  find_mesh_format(format, file).write_mesh(mesh, mesh.outline(), file);
  return file;
}

/// Integers as the text formats have them, in columns.
std::string columns(std::int64_t width, const std::vector<std::int64_t>& numbers) {
  std::string line;
  for (const std::int64_t number : numbers) {
    const std::string digits = std::to_string(number);
    line += std::string(static_cast<std::size_t>(width) - digits.size(), ' ') + digits;
  }
  return line;
}

std::int64_t width_of(std::int64_t largest) { return std::ssize(std::to_string(largest)) + 1; }

/// Where what follows the text begins.
std::int64_t place_behind(const SparseFile& file, const std::string& text) {
  const std::int64_t place = file.place_of(text);
  return place < 0 ? -1 : place + std::ssize(text);
}

constexpr std::int64_t point_bytes = 3 * 25;

class LargeCounts : public testing::TestWithParam<std::int64_t> {
 protected:
  const std::int64_t before = GetParam();
  const LastOfLargeMesh mesh{before};
  const TempFolder folder;
};
INSTANTIATE_TEST_SUITE_P(Before, LargeCounts, testing::Values(below_2_31, below_2_32),
                         [](const auto& limit) {
                           return limit.param == below_2_31 ? "2_31" : "2_32";
                         });

TEST_P(LargeCounts, ugrid_of_64_bits_has_everything_at_its_place) {
  for (const bool big : {false, true}) {
    const SparseFile file(written(mesh, folder, big ? "b8l.ugrid" : "lb8l.ugrid", "a"));
    const auto numbers = [&](std::int64_t place, std::size_t count) {
      return big ? file.big_endian<std::int64_t>(place, count)
                 : file.numbers<std::int64_t>(place, count);
    };
    EXPECT_THAT(numbers(0, 7), ElementsAre(before + 4, 2 * before + 4, 0, before + 1, 0, 0, 0));
    const std::int64_t triangles = 56 + (before + 4) * 24;
    const std::int64_t patches = triangles + (2 * before + 4) * 24;
    const std::int64_t tets = patches + (2 * before + 4) * 8;
    EXPECT_EQ(file.size(), tets + (before + 1) * 32);
    EXPECT_EQ((big ? file.big_endian<double>(triangles - 96, 2)
                   : file.numbers<double>(triangles - 96, 2)),
              (std::vector<double>{0.5, 0}));
    EXPECT_THAT(numbers(triangles + 2 * before * 24, 3),
                ElementsAre(before + 1, before + 2, before + 3));
    EXPECT_THAT(numbers(patches + 2 * before * 8, 4), ElementsAre(1, 1, 2, 2));
    EXPECT_THAT(numbers(tets + before * 32, 4),
                ElementsAre(before + 1, before + 2, before + 3, before + 4));
  }
}

TEST_P(LargeCounts, cgns_has_everything_at_its_place) {
  const Hdf5Input file(written(mesh, folder, "cgns", "a.cgns").string());
  const std::string zone = "Base/Zone1/";
  const auto last = [&](const std::string& node, std::int64_t first, std::int64_t count) {
    return file.slice<std::int64_t>(zone + node + "/ data", first, count);
  };
  EXPECT_THAT(last("GridElements/ElementRange", 0, 2), ElementsAre(1, before + 1));
  EXPECT_THAT(last("outer/ElementRange", 0, 2), ElementsAre(2 * before + 4, 3 * before + 5));
  EXPECT_THAT(last("GridElements/ElementConnectivity", 4 * before, 4),
              ElementsAre(before + 1, before + 2, before + 3, before + 4));
  EXPECT_THAT(last("outer/ElementConnectivity", 3 * before, 6),
              ElementsAre(before + 1, before + 4, before + 3, before + 2, before + 3, before + 4));
  EXPECT_THAT(file.slice<double>(zone + "GridCoordinates/CoordinateX/ data", before, 4),
              ElementsAre(0.5, 1, 0, 0));
  EXPECT_THAT(file.slice<std::int32_t>(zone + "CellData/Region/ data", before, 1), ElementsAre(1));
}

TEST_P(LargeCounts, meshb_has_everything_at_its_place) {
  const SparseFile file(written(mesh, folder, "meshb", "a.meshb"));
  constexpr std::int64_t first_node = 24 + 20;
  const std::int64_t triangle_head = first_node + (before + 4) * 32;
  const std::int64_t tet_head = triangle_head + 20 + (2 * before + 4) * 32;
  const std::int64_t end = tet_head + 20 + (before + 1) * 40;
  EXPECT_THAT(file.numbers<std::int64_t>(28, 2), ElementsAre(triangle_head, before + 4));
  EXPECT_THAT(file.numbers<std::int64_t>(triangle_head + 4, 2),
              ElementsAre(tet_head, 2 * before + 4));
  EXPECT_THAT(file.numbers<std::int64_t>(tet_head + 4, 2), ElementsAre(end, before + 1));
  EXPECT_THAT(file.numbers<std::int32_t>(end, 1), ElementsAre(54));
  EXPECT_THAT(file.numbers<double>(first_node + before * 32, 3), ElementsAre(0.5, 0, 0));
  EXPECT_THAT(file.numbers<std::int64_t>(triangle_head + 20 + 2 * before * 32, 4),
              ElementsAre(before + 1, before + 3, before + 2, 1));
  EXPECT_THAT(file.numbers<std::int64_t>(tet_head + 20 + before * 40, 5),
              ElementsAre(before + 1, before + 2, before + 3, before + 4, 1));
}

TEST_P(LargeCounts, su2_has_everything_at_its_place) {
  const SparseFile file(written(mesh, folder, "su2", "a.su2"));
  const std::int64_t width = width_of(before + 4);
  const std::int64_t tets = place_behind(file, "NELEM= " + std::to_string(before + 1) + "\n");
  EXPECT_EQ(file.place_of(columns(width, {10, before, before + 1, before + 2, before + 3, before})),
            tets + before * (6 * width + 1));
  const std::int64_t nodes = place_behind(file, "NPOIN= " + std::to_string(before + 4) + "\n");
  EXPECT_EQ(nodes - tets, (before + 1) * (6 * width + 1) + 7 + width);
  EXPECT_EQ(file.place_of(columns(width, {before + 3}) + "\nNMARK"),
            nodes + (before + 4) * (width + point_bytes + 1) - width - 1);
  const std::int64_t outer =
      place_behind(file, "MARKER_TAG= outer\nMARKER_ELEMS= " + std::to_string(before + 2) + "\n");
  EXPECT_EQ(file.place_of(columns(width, {5, before + 1, before + 2, before + 3})),
            outer + (before + 1) * (4 * width + 1));
}

TEST_P(LargeCounts, msh41_has_everything_at_its_place) {
  const SparseFile file(written(mesh, folder, "msh41", "a.msh"));
  const std::int64_t elements = 3 * before + 5;
  const std::int64_t counts = place_behind(file, "$Nodes\n");
  EXPECT_THAT(file.numbers<std::int64_t>(counts, 4), ElementsAre(1, before + 4, 1, before + 4));
  const std::int64_t tags = counts + 32 + 20;
  EXPECT_THAT(file.numbers<std::int64_t>(tags + before * 8, 1), ElementsAre(before + 1));
  const std::int64_t places = tags + (before + 4) * 8;
  EXPECT_THAT(file.numbers<double>(places + before * 24, 3), ElementsAre(0.5, 0, 0));
  const std::int64_t lists = place_behind(file, "\n$EndNodes\n$Elements\n");
  EXPECT_EQ(lists, places + (before + 4) * 24 + 21);
  EXPECT_THAT(file.numbers<std::int64_t>(lists, 4), ElementsAre(3, elements, 1, elements));
  const std::int64_t inner = lists + 32 + 20;
  const std::int64_t outer = inner + (before + 2) * 32 + 20;
  EXPECT_THAT(file.numbers<std::int64_t>(outer + before * 32, 4),
              ElementsAre(2 * before + 3, before + 1, before + 4, before + 3));
  EXPECT_THAT(file.numbers<std::int64_t>(outer + (before + 2) * 32 + 20, 5),
              ElementsAre(elements, before + 1, before + 2, before + 3, before + 4));
}

TEST_P(LargeCounts, msh41_as_text_has_everything_at_its_place) {
  const SparseFile file(written(mesh, folder, "msh41-text", "a.msh"));
  const std::int64_t elements = 3 * before + 5;
  const std::int64_t width = width_of(elements);
  const std::int64_t tags = place_behind(file, "$Nodes\n") + 2 * (4 * width + 1);
  const std::int64_t lists = place_behind(file, "$EndNodes\n$Elements\n");
  EXPECT_EQ(lists, tags + (before + 4) * (width + 1 + point_bytes + 1) + 20);
  const std::int64_t outer = lists + 3 * (4 * width + 1) + (before + 2) * (4 * width + 1);
  EXPECT_EQ(file.place_of(columns(width, {2 * before + 3, before + 1, before + 4, before + 3})),
            outer + before * (4 * width + 1));
  EXPECT_GT(
      file.place_of(columns(width, {elements, before + 1, before + 2, before + 3, before + 4})),
      outer);
}

TEST_P(LargeCounts, msh41_split_has_the_numbers_of_the_whole_mesh) {
  written(mesh, folder, "msh41-split", "a.msh");
  const std::string bytes = read_file(folder.path() / "a_1.msh");
  const std::vector<std::int64_t> tet = {3 * before + 5, before + 1, before + 2, before + 3,
                                         before + 4};
  EXPECT_THAT(bytes,
              HasSubstr(std::string(reinterpret_cast<const char*>(tet.data()), tet.size() * 8)));
}

TEST_P(LargeCounts, vtkhdf_goes_on_behind_them_and_is_read_there) {
  const std::filesystem::path path = folder.path() / "a.vtkhdf";
  NumberedPart part = mesh.part(0);
  part.number = 3;
  // Behind three sub-domains, the largest that a reader takes.
  const VtkhdfCounts largest = {most, most, 0};
  const std::array counts = {
      largest, largest, largest,
      VtkhdfCounts{std::ssize(part.nodes), std::ssize(part.tets), std::ssize(part.faces)}};
  const auto writer = write_vtkhdf(path, counts, {{"inner", "outer"}});
  writer->add(part);
  writer->finish();
  const VtkhdfParts parts(path);
  ASSERT_EQ(parts.size(), 4u);
  const NumberedPart read = parts.part(3);
  EXPECT_EQ(read.nodes, part.nodes);
  EXPECT_EQ(read.tets, part.tets);
  EXPECT_EQ(read.faces, part.faces);
  EXPECT_EQ(read.patch_of_face, part.patch_of_face);
  EXPECT_EQ(read.local2global, part.local2global);
}

TEST_P(LargeCounts, tables_and_seams_of_such_nodes_are_those_of_small_numbers) {
  const GridSource grid(cut_grid(4));
  MeshOutline outline = outline_of(grid);
  GridSource far = grid;
  for (NumberedPart& part : far.parts) {
    for (std::int64_t& number : part.local2global) number += before;
  }
  MeshOutline far_outline = outline;
  for (PartOutline& part : far_outline.parts) part.first_cell += before;
  std::vector<CommunicationTable> tables;
  for_each_communication_table(grid, outline, folder.path(),
                               [&](const CommunicationTable& table) { tables.push_back(table); });
  for_each_communication_table(
      far, far_outline, folder.path(), [&](const CommunicationTable& table) {
        CommunicationTable near = communication_from_bytes(communication_to_bytes(table), "here");
        for (std::int64_t& node : near.local2global) node -= before;
        for (GhostCell& ghost : near.ghosts) {
          for (std::size_t k = 0; k < nodes_of(ghost.type); ++k) ghost.nodes[k] -= before;
        }
        EXPECT_EQ(near, tables.at(static_cast<std::size_t>(near.part)));
      });
  SeamFaces seams(grid, outline, folder.path());
  SeamFaces far_seams(far, far_outline, folder.path());
  const std::vector<SeamFace> here = seams.next_part();
  const std::vector<SeamFace> there = far_seams.next_part();
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(there[i].cell, here[i].cell + before);
    EXPECT_EQ(there[i].neighbour_cell, here[i].neighbour_cell + before);
    EXPECT_EQ(there[i].nodes[2], here[i].nodes[2] + before);
  }
}

TEST(LargeCountsOfVtu, pieces_of_the_largest_size_have_offsets_of_64_bits) {
  const VtuLayout layout = vtu_layout(most, 2 * most, 7 * most);
  EXPECT_EQ(layout.arrays[1].offset, 8 + 24 * most);
  EXPECT_EQ(layout.arrays[2].bytes, 8 * 7 * most);
  EXPECT_EQ(layout.arrays[3].offset, 3 * 8 + (24 + 8 + 56) * most);
  EXPECT_EQ(layout.bytes, 8 * 8 + (24 + 8 + 56 + 16 + 2 + 3 * 8) * most);
}

struct Limit {
  const char* format;
  CountsBefore before;  ///< the last that can be written
  CountsBefore more;    ///< one too many
};

void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.format; }

class LimitOf32Bits : public testing::TestWithParam<Limit> {};
INSTANTIATE_TEST_SUITE_P(
    Formats, LimitOf32Bits,
    testing::Values(Limit{"lb8.ugrid", {most - 4, most - 1, most / 2 - 2}, {most - 3, 0, 0}},
                    Limit{"b8.ugrid", {most - 4, most - 1, most / 2 - 2}, {0, most, 0}},
                    Limit{"lb8.ugrid", {0, 0, most / 2 - 2}, {0, 0, most / 2 - 1}},
                    Limit{"msh22", {most - 4, most - 5, 0}, {0, most - 4, 0}},
                    Limit{"msh22", {most - 4, 0, 0}, {most - 3, 0, 0}},
                    Limit{"tetgen", {most - 4, most - 1, most / 2 - 2}, {most - 3, 0, 0}},
                    Limit{"tetgen", {0, 0, 0}, {0, most, 0}},
                    Limit{"tetgen", {0, 0, 0}, {0, 0, most / 2 - 1}},
                    Limit{"openfoam", {most - 4, most / 2 - 2, 0}, {0, most / 2 - 1, 0}},
                    Limit{"openfoam", {0, 0, 0}, {most - 3, 0, 0}}),
    [](const auto& limit) {
      std::string name = limit.param.format + std::string("_") + std::to_string(limit.index);
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

TEST_P(LimitOf32Bits, is_written_up_to_it_and_refused_above_before_anything_is_there) {
  const TempFolder folder;
  written(LastOfLargeMesh(GetParam().before), folder, GetParam().format, "fits");
  const TempFolder empty;
  try {
    written(LastOfLargeMesh(GetParam().more), empty, GetParam().format, "too_large");
    ADD_FAILURE() << "written";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("too large"));
    EXPECT_THAT(error.what(), HasSubstr("2147483648"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(empty.path()));
}

TEST(LimitOf32BitsOf, openfoam_has_everything_at_its_place) {
  const TempFolder folder;
  const std::int64_t nodes_before = most - 4;
  const std::int64_t tets_before = most / 2 - 2;
  const LastOfLargeMesh mesh(CountsBefore{nodes_before, tets_before, 0});
  const std::filesystem::path poly =
      written(mesh, folder, "openfoam", "case") / "constant" / "polyMesh";
  const std::int64_t width = width_of(most);
  const std::int64_t faces = 2 * (tets_before + 1) + 2;
  const SparseFile owner(poly / "owner");
  const std::int64_t first_owner = place_behind(owner, "\n" + std::to_string(faces) + "\n(\n");
  EXPECT_EQ(owner.size(), first_owner + faces * (width + 1) + 2);
  EXPECT_EQ(owner.place_of(columns(width, {tets_before})), first_owner + (faces - 4) * (width + 1));
  const SparseFile points(poly / "points");
  const std::int64_t first_point = place_behind(points, std::to_string(most) + "\n(\n");
  EXPECT_EQ(points.size(), first_point + most * (point_bytes + 3) + 2);
  EXPECT_THAT(read_file(poly / "boundary"),
              HasSubstr("startFace       " + std::to_string(faces - 2)));
}

TEST(LimitOf32BitsOf, a_processor_of_openfoam_has_as_many_faces_as_labels) {
  const TempFolder folder;
  const LastOfLargeMesh mesh(CountsBefore{most, most, 0});
  MeshOutline outline = mesh.outline();
  outline.parts[0].tets = std::int64_t{1} << 30;
  const std::filesystem::path parts = folder.path() / "case";
  EXPECT_THROW(find_mesh_format("openfoam-decomposed", "case").write_mesh(mesh, outline, parts),
               Error);
  EXPECT_FALSE(std::filesystem::exists(parts));
}

}  // namespace
}  // namespace tetfarm
