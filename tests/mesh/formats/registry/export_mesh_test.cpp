#include "mesh/formats/registry/export_mesh.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

TEST(ExportMesh, leaves_nothing_of_a_file_that_could_not_be_written) {
  const TempFolder folder;
  Format format = find_mesh_format("vtkhdf", "");
  format.write_mesh = [](const MeshSource&, const MeshOutline&, const std::filesystem::path& file) {
    std::ofstream(file) << "the beginning";
    throw IoError("cannot write", file.string(), ENOSPC);
  };
  EXPECT_THROW(export_mesh(GridSource(cut_grid(3)), format, folder.path() / "a.vtkhdf"), IoError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace tetfarm
