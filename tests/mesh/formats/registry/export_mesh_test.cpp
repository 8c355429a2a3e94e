#include "mesh/formats/registry/export_mesh.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/error_text.h"

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

TEST(ExportMesh, puts_no_file_in_the_place_of_a_folder) {
  const TempFolder folder;
  const std::string there = (folder.path() / "there").string();
  std::filesystem::create_directory(there);
  const auto refusal = [](std::string_view format, const std::string& output) {
    return error_text_of<UsageError>(
        [&] { export_mesh(GridSource(cut_grid(2)), find_mesh_format(format, ""), output); });
  };
  EXPECT_EQ(refusal("su2", there), there + ": this is a folder; su2 needs the name of a file");
  EXPECT_EQ(refusal("pvtu", there), there + ": this is a folder; pvtu needs the name of a file");
  EXPECT_EQ(refusal("openfoam", there), "");
  const std::string bare = (folder.path() / "mesh").string();
  EXPECT_EQ(refusal("pvtu", bare),
            bare + ": give the file an ending: the pieces go into a folder of its name without it");
  EXPECT_FALSE(std::filesystem::exists(bare));
  EXPECT_EQ(refusal("su2", bare), "");
}

}  // namespace
}  // namespace tetfarm
