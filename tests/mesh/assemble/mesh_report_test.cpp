/// What other tests believe must itself be able to complain.
#include "tests/support/mesh_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats/registry/read_global_mesh.h"
#include "mesh/formats/vtkhdf/write_vtkhdf.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/assemble/cut_grid.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using testing::Not;

GlobalMesh grid_in_memory() {
  const CutGrid grid = cut_grid(3);
  const TempFolder folder;
  const auto writer =
      write_vtkhdf(folder.path() / "grid.vtkhdf", grid.counts(), {grid.surface.patch_names});
  for (const LeafNumbers& leaf : grid.numbering().leaves) writer->add(grid.reader()(leaf).part);
  writer->finish();
  return read_global_mesh(folder.path() / "grid.vtkhdf");
}

TEST(MeshReport, complains_of_a_tet_that_is_inside_out) {
  GlobalMesh mesh = grid_in_memory();
  std::swap(mesh.mesh.tets[5][0], mesh.mesh.tets[5][1]);
  EXPECT_THAT(report_on(mesh).complaints, Not(IsEmpty()));
}

TEST(MeshReport, complains_of_a_hole) {
  GlobalMesh mesh = grid_in_memory();
  mesh.mesh.tets.erase(mesh.mesh.tets.begin() + 7);
  EXPECT_THAT(report_on(mesh).complaints, Not(IsEmpty()));
}

TEST(MeshReport, complains_of_a_missing_boundary_triangle) {
  GlobalMesh mesh = grid_in_memory();
  mesh.boundary.pop_back();
  mesh.patch_of_triangle.pop_back();
  EXPECT_THAT(report_on(mesh).complaints, Not(IsEmpty()));
}

TEST(MeshReport, complains_of_nodes_that_do_not_exist) {
  GlobalMesh mesh = grid_in_memory();
  mesh.mesh.tets[0][2] = 1000000;
  EXPECT_THAT(report_on(mesh).complaints, Not(IsEmpty()));
}

}  // namespace
}  // namespace tetfarm
