// What `init` writes of real surfaces, called as main calls it.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/job_input.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"
#include "tests/cli/settings_of_template.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Init : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// A box of two patches.
  std::string box() const {
    SurfaceMesh surface = shapes::box({0, 0, 0}, {3, 2, 1}, 3);
    surface.patch_names = {"lid", "walls"};
    surface.patch_of_triangle.clear();
    for (const Triangle& corners : surface.triangles) {
      const bool is_lid = std::all_of(corners.begin(), corners.end(), [&](std::int32_t v) {
        return surface.vertices[static_cast<std::size_t>(v)].z == 1;
      });
      surface.patch_of_triangle.push_back(is_lid ? 0 : 1);
    }
    write_surface(surface, path("box.stl"));
    return path("box.stl");
  }
  Said init(const std::string& surface, const std::string& output, bool force = false) const {
    InitCommand command;
    command.surface = surface;
    command.output = output;
    command.force = force;
    return said_by([&] { return init_command(command); });
  }
  std::string written(const std::string& surface) const {
    EXPECT_EQ(init(surface, path("job.toml")).error, "");
    return read_file(path("job.toml"));
  }
  static JobInput job_of(const std::string& input) {
    RunOptions options;
    options.input = input;
    return read_job(options);
  }

  const TempFolder folder_;
};

TEST_F(Init, writes_the_job_that_the_surface_is_by_itself) {
  const std::string surface = box();
  const Said said = init(surface, path("job.toml"));
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_EQ(said.out, path("job.toml") + "\n");
  EXPECT_EQ(key_of(job_of(path("job.toml"))), key_of(job_of(surface)));
}

TEST_F(Init, tells_patches_and_sizes_of_the_surface) {
  const std::string text = written(box());
  EXPECT_THAT(text, HasSubstr("The surface has 108 triangles in 1 shell.\n#   box 3 x 2 x 1, from "
                              "0, 0, 0 to 3, 2, 1\n"));
  EXPECT_THAT(text, HasSubstr("        18            1  \"lid\"\n"));
  EXPECT_THAT(text, HasSubstr("        90 "));
  EXPECT_THAT(text, HasSubstr("#patches = [\""));
}

/// A plan does all that a job begins with: reads, checks, remeshes, puts layers and boxes.
TEST_F(Init, writes_settings_any_of_which_can_be_planned) {
  const std::vector<SettingInForce> all = settings_in_force(written(box()));
  ASSERT_GE(all.size(), 20U);
  for (const SettingInForce& in_force : all) {
    write_file_atomically(path("job.toml"), in_force.text);
    PlanCommand command;
    command.job.input = path("job.toml");
    command.job.output = path("out");
    const Said said = said_by([&] { return plan_command(command); });
    EXPECT_EQ(said.error, "") << in_force.setting;
    EXPECT_THAT(said.out, HasSubstr("most likely")) << in_force.setting;
  }
}

TEST_F(Init, writes_a_job_in_metres_of_a_surface_in_another_unit) {
  InitCommand command;
  command.surface = box();
  command.output = path("job.toml");
  command.unit = "mm";
  EXPECT_EQ(said_by([&] { return init_command(command); }).error, "");
  const std::string text = read_file(path("job.toml"));
  EXPECT_THAT(text, HasSubstr("box 0.003 x 0.002 x 0.001"));
  EXPECT_EQ(job_of(path("job.toml")).job.unit, "mm");
  command.unit.clear();
  command.scale = 2;
  command.force = true;
  EXPECT_EQ(said_by([&] { return init_command(command); }).error, "");
  EXPECT_THAT(read_file(path("job.toml")), HasSubstr("\nscale = 2\n"));
  EXPECT_EQ(job_of(path("job.toml")).job.scale, 2);
}

TEST_F(Init, names_the_surface_from_the_folder_of_the_job_file) {
  box();
  make_folders(path("jobs"));
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  const Said said = init("./box.stl", "jobs/a.toml");
  const Said beside = init("box.stl", "");
  const Said printed = init("box.stl", "-");
  const std::string key = key_of(job_of("jobs/a.toml"));
  std::filesystem::current_path(here);
  EXPECT_EQ(said.error, "");
  EXPECT_THAT(read_file(path("jobs/a.toml")), HasSubstr("\nsurface = \"../box.stl\"\n"));
  EXPECT_EQ(key, key_of(job_of(path("box.stl"))));
  EXPECT_EQ(beside.out, "box.toml\n");
  const std::string text = read_file(path("box.toml"));
  EXPECT_THAT(text, HasSubstr("\nsurface = \"box.stl\"\n"));
  EXPECT_EQ(printed.out.substr(printed.out.find("\nversion")), text.substr(text.find("\nversion")));
}

TEST_F(Init, replaces_a_file_only_when_told_to) {
  const std::string surface = box();
  write_file_atomically(path("job.toml"), "mine");
  const Said refused = init(surface, path("job.toml"));
  EXPECT_EQ(refused.code, ExitCode::usage);
  EXPECT_EQ(refused.error, path("job.toml") + " exists already");
  EXPECT_THAT(refused.help, HasSubstr("--force"));
  EXPECT_EQ(read_file(path("job.toml")), "mine");
  EXPECT_EQ(init(surface, path("job.toml"), true).error, "");
  EXPECT_THAT(read_file(path("job.toml")), HasSubstr("[geometry]"));
}

TEST_F(Init, refuses_what_is_no_surface_or_would_be_no_job_file) {
  EXPECT_THAT(init(box(), path("job.txt")).error, HasSubstr("ends in .toml"));
  written(box());
  EXPECT_EQ(init(path("job.toml"), path("b.toml")).error,
            path("job.toml") + ": is a job file already; give a surface");
  EXPECT_EQ(init(path("none.stl"), path("b.toml")).code, ExitCode::not_found);
  EXPECT_FALSE(std::filesystem::exists(path("b.toml")));
}

TEST_F(Init, writes_nothing_for_a_surface_that_cannot_be_meshed) {
  write_file_atomically(path("open.off"),
                        "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n");
  const Said said = init(path("open.off"), path("job.toml"));
  EXPECT_EQ(said.code, ExitCode::bad_geometry);
  EXPECT_THAT(said.error, HasSubstr("open.off: "));
  EXPECT_THAT(said.out, IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(path("job.toml")));
}

}  // namespace
}  // namespace tetfarm
