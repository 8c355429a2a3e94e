#include "cli/converted_meshes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>

#include "base/file_system.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/job_file/job_formats.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(ConvertedMeshes, are_of_all_formats_that_export_writes) {
  const auto named = job_output_formats();
  const std::vector<std::string_view> names(named.begin(), named.end());
  for (const Format& format : written_formats()) EXPECT_THAT(names, Contains(format.name));
  EXPECT_THAT(names, SizeIs(written_formats().size()));
}

TEST(ConvertedMeshes, have_a_name_each) {
  EXPECT_EQ(converted_file("out/wing.vtkhdf", "su2"), "out/wing.su2");
  EXPECT_EQ(converted_file("out/wing.vtkhdf", "msh22"), "out/wing.msh22.msh");
  EXPECT_EQ(converted_file("out/wing.vtkhdf", "openfoam"), "out/wing.openfoam");
  EXPECT_EQ(converted_file("out/wing.vtkhdf", "pvtu"), "out/wing.pvtu");
  std::vector<std::filesystem::path> files;
  for (const std::string_view format : job_output_formats()) {
    files.push_back(converted_file("out/a.b.vtkhdf", std::string(format)));
    EXPECT_EQ(files.back().parent_path(), "out");
  }
  std::sort(files.begin(), files.end());
  EXPECT_EQ(std::adjacent_find(files.begin(), files.end()), files.end());
}

/// A mesh of a run, whose job asks for others.
class ConvertedRun : public ::testing::Test {
 protected:
  ConvertedRun() {
    export_mesh(GridSource(cut_grid(2)), find_mesh_format("vtkhdf", mesh_), mesh_);
    status_.set_state("done");
    (*status_.mutable_texts())["formats_to_convert"] = "su2,pvtu";
  }
  std::vector<std::filesystem::path> convert() {
    std::vector<std::filesystem::path> files = {mesh_};
    convert_mesh(status_, ProgressStyle::none, files);
    return files;
  }

  const TempFolder folder_;
  const std::filesystem::path mesh_ = folder_.path() / "wing.vtkhdf";
  wire::JobStatus status_;
};

TEST_F(ConvertedRun, has_what_the_job_asks_for_once_it_is_done) {
  status_.set_state("failed");
  EXPECT_THAT(convert(), SizeIs(1));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "wing.su2"));
  status_.set_state("done");
  EXPECT_THAT(convert(),
              ElementsAre(mesh_, folder_.path() / "wing.su2", folder_.path() / "wing.pvtu"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "wing.su2"));
  EXPECT_TRUE(std::filesystem::is_directory(folder_.path() / "wing.pvtu"));
}

TEST_F(ConvertedRun, puts_a_new_folder_in_the_place_of_an_old_one) {
  convert();
  const std::filesystem::path left = folder_.path() / "wing.pvtu" / "left.over";
  write_file_atomically(left, "of the mesh before");
  std::filesystem::last_write_time(
      mesh_, std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  convert();
  EXPECT_FALSE(std::filesystem::exists(left));
  EXPECT_FALSE(std::filesystem::is_empty(folder_.path() / "wing.pvtu"));
}

}  // namespace
}  // namespace tetfarm
