#include "cli/converted_meshes.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "mesh/formats/registry/export_mesh.h"
#include "mesh/job_file/job_formats.h"

namespace tetfarm {
namespace {

using ::testing::Contains;
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

}  // namespace
}  // namespace tetfarm
