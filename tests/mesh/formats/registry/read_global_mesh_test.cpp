#include "mesh/formats/registry/read_global_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/ugrid/write_ugrid.h"
#include "mesh/formats/vtkhdf/write_vtkhdf.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/assemble/cut_grid.h"
#include "tests/support/mesh_report.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// A grid as files of both formats in a folder of its own.
struct Files {
  explicit Files(const CutGrid& grid) {
    const Numbering numbering = grid.numbering();
    const auto first = write_vtkhdf(vtkhdf, grid.counts(), {grid.surface.patch_names});
    const auto second = write_ugrid(ugrid, numbering, std::ssize(grid.surface.triangles));
    const std::array<GlobalMeshWriter*, 2> writers = {first.get(), second.get()};
    summary = assemble_global_mesh(grid.surface, numbering, grid.reader(), writers);
  }

  TempFolder folder;
  std::filesystem::path vtkhdf = folder.path() / "grid.vtkhdf";
  std::filesystem::path ugrid = folder.path() / "grid.lb8.ugrid";
  GlobalMeshSummary summary;
};

TEST(MeshFiles, both_formats_give_back_the_mesh_that_was_written) {
  const Files files(cut_grid(4));
  const GlobalMesh from_vtkhdf = read_global_mesh(files.vtkhdf);
  const GlobalMesh from_ugrid = read_global_mesh(files.ugrid);
  EXPECT_EQ(from_vtkhdf.subdomains, 3);
  EXPECT_EQ(from_vtkhdf.mesh.nodes, from_ugrid.mesh.nodes);
  EXPECT_EQ(from_vtkhdf.mesh.tets, from_ugrid.mesh.tets);
  EXPECT_EQ(from_vtkhdf.patch_of_triangle, from_ugrid.patch_of_triangle);
  EXPECT_THAT(from_vtkhdf.patch_names, testing::ElementsAre("low x", "elsewhere"));
  for (const GlobalMesh* mesh : {&from_vtkhdf, &from_ugrid}) {
    const MeshReport report = report_on(*mesh);
    EXPECT_THAT(report.complaints, IsEmpty());
    EXPECT_EQ(report.tets, files.summary.tets);
    EXPECT_EQ(report.nodes, files.summary.nodes);
    EXPECT_EQ(report.boundary_triangles, files.summary.boundary_triangles);
    EXPECT_EQ(report.shapes.all.min_dihedral_deg, files.summary.shapes.all.min_dihedral_deg);
    EXPECT_EQ(report.digest, report_on(from_vtkhdf).digest);
  }
}

TEST(MeshFiles, a_vtkhdf_file_may_end_in_hdf) {
  const Files files(cut_grid(2));
  const std::filesystem::path renamed = files.folder.path() / "grid.hdf";
  std::filesystem::copy_file(files.vtkhdf, renamed);
  EXPECT_EQ(read_global_mesh(renamed).mesh.tets, read_global_mesh(files.vtkhdf).mesh.tets);
}

TEST(MeshFiles, digest_of_the_vtkhdf_file_is_that_of_the_assembled_mesh) {
  const Files files(cut_grid(4));
  EXPECT_EQ(report_on(read_global_mesh(files.vtkhdf)).digest, files.summary.digest);
}

TEST(MeshFiles, say_of_the_tets_near_the_cuts_what_assembly_says) {
  const Files files(cut_grid(12));
  const MeshShapes& assembled = files.summary.shapes;
  const MeshShapes read = report_on(read_global_mesh(files.vtkhdf)).shapes;
  EXPECT_GT(assembled.near_cuts.tets, 1000);
  EXPECT_GT(assembled.away_from_cuts.tets, 1000);
  EXPECT_EQ(read.near_cuts.tets, assembled.near_cuts.tets);
  EXPECT_EQ(read.near_cuts.dihedral_histogram, assembled.near_cuts.dihedral_histogram);
  EXPECT_EQ(read.near_cuts.smallest_height, assembled.near_cuts.smallest_height);
  EXPECT_EQ(read.away_from_cuts.tets, assembled.away_from_cuts.tets);
  EXPECT_EQ(report_on(read_global_mesh(files.ugrid)).shapes.near_cuts.tets, 0);
}

std::vector<NumberedPart> parts_of(const CutGrid& grid) {
  std::vector<NumberedPart> parts;
  for (const LeafNumbers& leaf : grid.numbering().leaves) {
    parts.push_back(grid.reader()(leaf).part);
  }
  return parts;
}

TEST(MeshFiles, a_vtkhdf_file_that_was_not_finished_is_refused) {
  const CutGrid grid = cut_grid(3);
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "grid.vtkhdf";
  {
    const auto writer = write_vtkhdf(path, grid.counts(), {grid.surface.patch_names});
    for (const NumberedPart& part : parts_of(grid)) writer->add(part);
  }
  EXPECT_THROW(read_global_mesh(path), InvalidInput);
}

TEST(MeshFiles, the_same_parts_give_the_same_bytes_of_vtkhdf) {
  const CutGrid grid = cut_grid(3);
  const TempFolder folder;
  std::vector<std::string> bytes;
  for (int i = 0; i < 2; ++i) {
    const std::filesystem::path path = folder.path() / std::to_string(i);
    const auto writer = write_vtkhdf(path, grid.counts(), {grid.surface.patch_names});
    for (const NumberedPart& part : parts_of(grid)) writer->add(part);
    writer->finish();
    bytes.push_back(read_file(path));
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

TEST(MeshFiles, a_part_with_other_counts_than_announced_is_not_written) {
  const CutGrid grid = cut_grid(3);
  const TempFolder folder;
  std::vector<VtkhdfCounts> counts = grid.counts();
  ++counts[1].faces;
  const auto writer = write_vtkhdf(folder.path() / "a.vtkhdf", counts, {grid.surface.patch_names});
  EXPECT_THROW(writer->add(parts_of(grid)[1]), Error);
}

TEST(MeshFiles, same_mesh_gives_same_bytes) {
  const Files first(cut_grid(5));
  const Files second(cut_grid(5));
  EXPECT_EQ(read_file(first.vtkhdf), read_file(second.vtkhdf));
  EXPECT_EQ(read_file(first.ugrid), read_file(second.ugrid));
}

TEST(MeshFiles, ugrid_begins_with_its_counts_and_faces_point_inward) {
  const Files files(cut_grid(3));
  const std::string bytes = read_file(files.ugrid);
  std::array<std::int32_t, 7> counts;
  std::memcpy(counts.data(), bytes.data(), sizeof counts);
  EXPECT_THAT(counts, testing::ElementsAre(64, 108, 0, 162, 0, 0, 0));
  ASSERT_EQ(bytes.size(), 28u + 64 * 24 + 108 * 16 + 162 * 16);
  std::vector<Vec3> nodes(64);
  std::vector<Triangle> faces(108);
  std::memcpy(nodes.data(), bytes.data() + 28, 64 * 24);
  std::memcpy(faces.data(), bytes.data() + 28 + 64 * 24, 108 * 12);
  for (Triangle& face : faces) {
    for (std::int32_t& v : face) --v;
  }
  EXPECT_NEAR(enclosed_volume(nodes, faces), -1, 1e-12);
}

TEST(MeshFiles, ugrid_refuses_what_its_counts_cannot_hold) {
  const TempFolder folder;
  Numbering numbering;
  numbering.tets = std::int64_t{1} << 31;
  EXPECT_THROW(write_ugrid(folder.path() / "a.lb8.ugrid", numbering, 4), Error);
}

TEST(MeshFiles, cut_short_files_are_refused) {
  const Files files(cut_grid(3));
  for (const auto& path : {files.vtkhdf, files.ugrid}) {
    const std::string bytes = read_file(path);
    for (const std::size_t length : {std::size_t{0}, std::size_t{10}, bytes.size() / 2}) {
      write_file_atomically(path, std::string_view(bytes).substr(0, length));
      EXPECT_THROW(read_global_mesh(path), InvalidInput) << path << ' ' << length;
    }
  }
}

TEST(MeshFiles, vtkhdf_with_a_number_of_a_node_beyond_all_points_is_refused) {
  const Files files(cut_grid(3));
  for (const std::int64_t number : {1'000'000L, -1L}) {
    {
      const Hdf5Handle file(H5Fopen(files.vtkhdf.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
      const Hdf5Handle numbers(H5Dopen2(file.get(), "VTKHDF/PointData/GlobalNodeId", H5P_DEFAULT),
                               H5Dclose);
      const Hdf5Handle all(H5Dget_space(numbers.get()), H5Sclose);
      const std::array<hsize_t, 1> first = {0};
      ASSERT_GE(H5Sselect_elements(all.get(), H5S_SELECT_SET, 1, first.data()), 0);
      const Hdf5Handle one(H5Screate(H5S_SCALAR), H5Sclose);
      ASSERT_GE(
          H5Dwrite(numbers.get(), H5T_NATIVE_INT64, one.get(), all.get(), H5P_DEFAULT, &number), 0);
    }
    EXPECT_THROW(read_global_mesh(files.vtkhdf), InvalidInput) << number;
  }
}

TEST(MeshFiles, ugrid_with_wrong_numbers_is_refused) {
  const Files files(cut_grid(3));
  const std::string bytes = read_file(files.ugrid);
  for (const std::size_t place : {std::size_t{8}, std::size_t{28 + 64 * 24}, bytes.size() - 4}) {
    std::string wrong = bytes;
    wrong[place + 1] = 127;
    write_file_atomically(files.ugrid, wrong);
    EXPECT_THROW(read_global_mesh(files.ugrid), InvalidInput) << place;
  }
}

TEST(MeshFiles, missing_and_unknown_files_are_told_apart) {
  EXPECT_THROW(read_global_mesh("/nowhere/a.vtkhdf"), IoError);
  EXPECT_THROW(read_global_mesh("/nowhere/a.lb8.ugrid"), IoError);
  EXPECT_THROW(read_global_mesh("a.stl"), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
