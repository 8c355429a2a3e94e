// Apart, as it reads 48 GB of zeros: seconds, but minutes with the address sanitizer.
#include <gtest/gtest.h>

#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/ugrid/ugrid_source.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/last_of_large_mesh.h"

namespace tetfarm {
namespace {

TEST(LargeUgrid, reads_back_at_the_limit_of_32_bits) {
  const TempFolder folder;
  const LastOfLargeMesh mesh(CountsBefore{2147483647 - 4, 0, 0});
  const std::filesystem::path file = folder.path() / "a.lb8.ugrid";
  find_mesh_format("lb8.ugrid", file).write_mesh(mesh, mesh.outline(), file);
  const auto source = open_ugrid(file);
  ASSERT_EQ(source->size(), 1U);
  EXPECT_EQ(source->part(0).local2global, mesh.part(0).local2global);
  EXPECT_EQ(source->part(0).nodes, mesh.part(0).nodes);
}

}  // namespace
}  // namespace tetfarm
