// What `surface` makes and says of it, called as main calls it.
#include <gmock/gmock.h>

#include <algorithm>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "mesh/inspect/surface_check.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"
#include "tests/support/remeshing_judge.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class SurfaceRemeshed : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string cube() const {
    write_surface(shapes::unit_cube(), path("cube.off"));
    return path("cube.off");
  }
  Said remeshed(SurfaceCommand command) const {
    return said_by([&] { return surface_command(command); });
  }

  const TempFolder folder_;
};

TEST_F(SurfaceRemeshed, is_written_judged_and_told) {
  SurfaceCommand command;
  command.input = cube();
  command.output = path("fine.off");
  command.size = 0.2;
  const Said said = remeshed(command);
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_THAT(said.out, HasSubstr("triangles       "));
  EXPECT_THAT(said.out, HasSubstr(", before 12\n"));
  EXPECT_THAT(said.out, HasSubstr("volume          1, before 1\n"));
  RemeshingDemands demands;
  demands.tolerance = 1e-12;
  EXPECT_THAT(
      remeshing_complaints(read_surface(command.input), read_surface(command.output), demands),
      IsEmpty());
}

TEST_F(SurfaceRemeshed, is_told_to_programs_in_one_line) {
  SurfaceCommand command;
  command.input = cube();
  command.output = path("fine.off");
  command.size = 0.25;
  command.json = true;
  const auto told = nlohmann::json::parse(remeshed(command).out);
  EXPECT_EQ(told["type"], "surface");
  EXPECT_EQ(told["file"], command.output);
  EXPECT_EQ(told["triangles_before"], 12);
  EXPECT_EQ(told["triangles"], read_surface(command.output).triangles.size());
  EXPECT_EQ(told["volume_before"], 1);
  EXPECT_LE(told["distance_from_input"].get<double>(), 1e-12);
  EXPECT_GE(told["smallest_angle_deg"].get<double>(), 30);
}

TEST_F(SurfaceRemeshed, takes_size_growth_and_sources_of_a_job_file) {
  cube();
  write_file_atomically(path("job.toml"),
                        "[geometry]\nsurface = \"cube.off\"\n[spacing]\ndefault = 0.5\n"
                        "[[source]]\nkind = \"point\"\nat = [1.0, 1.0, 1.0]\nspacing = 0.05\n"
                        "inner = 0.1\nouter = 0.4\n");
  SurfaceCommand command;
  command.input = path("job.toml");
  command.output = path("sourced.off");
  ASSERT_EQ(remeshed(command).code, ExitCode::ok);
  const SurfaceMesh surface = read_surface(command.output);
  const auto vertices_near = [&surface](const Vec3& p) {
    return std::ranges::count_if(surface.vertices,
                                 [&p](const Vec3& v) { return distance(p, v) < 0.3; });
  };
  EXPECT_GT(vertices_near({1, 1, 1}), 4 * vertices_near({0, 0, 0}));
}

TEST_F(SurfaceRemeshed, never_replaces_its_input) {
  SurfaceCommand command;
  command.input = cube();
  command.output = command.input;
  EXPECT_THAT([&] { surface_command(command); },
              ::testing::ThrowsMessage<UsageError>(HasSubstr("would overwrite the surface")));
}

TEST_F(SurfaceRemeshed, with_defects_is_refused_and_they_lie_in_a_file) {
  write_file_atomically(path("open.off"),
                        "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n");
  SurfaceCommand command;
  command.input = path("open.off");
  command.output = path("never.off");
  command.defects_file = path("bad.vtp");
  EXPECT_THAT([&] { surface_command(command); },
              ::testing::ThrowsMessage<Error>(HasSubstr("open edge")));
  EXPECT_TRUE(std::filesystem::exists(path("bad.vtp")));
  EXPECT_FALSE(std::filesystem::exists(path("never.off")));
}

TEST_F(SurfaceRemeshed, is_not_made_with_sizes_that_contradict_each_other) {
  SurfaceCommand command;
  command.input = cube();
  command.output = path("never.off");
  command.size = 0.1;
  command.min_size = 0.2;
  EXPECT_THAT([&] { surface_command(command); },
              ::testing::ThrowsMessage<UsageError>(HasSubstr("--min-size: is larger than --size")));
}

class SurfaceHealed : public SurfaceRemeshed {
 protected:
  /// A box with a triangle twice, and one missing.
  std::string broken() const {
    SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 8);
    box.triangles.push_back(box.triangles[40]);
    box.triangles.erase(box.triangles.begin() + 9);
    box.patch_of_triangle.clear();
    box.patch_names.clear();
    write_surface(box, path("broken.off"));
    return path("broken.off");
  }
};

TEST_F(SurfaceHealed, is_written_with_all_else_as_it_was_and_its_changes_beside) {
  SurfaceCommand command;
  command.input = broken();
  command.output = path("sound.off");
  command.heal_only = true;
  command.largest_hole = 1;
  const Said said = remeshed(command);
  ASSERT_EQ(said.code, ExitCode::ok) << said.error;
  EXPECT_THAT(said.out, HasSubstr("healed          1 duplicate triangle removed: ("));
  EXPECT_THAT(said.out, HasSubstr("\n                1 hole filled: ("));
  EXPECT_THAT(said.out, HasSubstr("see " + path("broken.healed.vtp")));
  EXPECT_THAT(said.out, HasSubstr("triangles       768, before 768\n"));
  const SurfaceMesh sound = read_surface(command.output);
  EXPECT_TRUE(check_surface(sound).report.defects.empty());
  EXPECT_EQ(sound.triangles.size(), 768U);
  EXPECT_THAT(read_file(path("broken.healed.vtp")), HasSubstr("PolyData"));
}

TEST_F(SurfaceHealed, is_remeshed_where_that_is_not_all) {
  SurfaceCommand command;
  command.input = broken();
  command.output = path("even.off");
  command.heal = true;
  command.largest_hole = 1;
  command.size = 0.25;
  command.json = true;
  const auto told = nlohmann::json::parse(remeshed(command).out);
  EXPECT_EQ(told["healing"]["mends_all"], true);
  EXPECT_EQ(told["healing"]["acts"].size(), 2U);
  EXPECT_EQ(told["healing"]["acts"][0]["kind"], "duplicate triangle");
  EXPECT_EQ(told["healing"]["acts"][1]["count"], 1);
  EXPECT_LT(told["triangles"], 700);
  EXPECT_TRUE(check_surface(read_surface(command.output)).report.defects.empty());
}

TEST_F(SurfaceHealed, is_refused_where_not_all_could_be_mended_or_nobody_asked) {
  SurfaceCommand command;
  command.input = broken();
  command.output = path("sound.off");
  command.heal_only = true;
  command.largest_hole = 0.01;
  command.defects_file = path("left.vtp");
  const Said said = remeshed(command);
  EXPECT_EQ(said.code, ExitCode::bad_geometry);
  EXPECT_THAT(said.error, HasSubstr("open edge"));
  EXPECT_EQ(said.error.find("duplicate"), std::string::npos) << "that was mended";
  EXPECT_FALSE(std::filesystem::exists(command.output));
  command.heal_only = false;
  EXPECT_THAT(remeshed(command).error, HasSubstr("duplicate"));
}

TEST_F(SurfaceHealed, of_a_sound_one_is_told_to_be_sound) {
  SurfaceCommand command;
  command.input = cube();
  command.output = path("same.off");
  command.heal_only = true;
  EXPECT_THAT(remeshed(command).out, HasSubstr("healed          nothing: the surface is sound\n"));
  EXPECT_EQ(read_surface(command.output).triangles, shapes::unit_cube().triangles);
}

TEST_F(SurfaceRemeshed, for_a_frequency_is_the_same_as_with_that_size) {
  SurfaceCommand by_size;
  by_size.input = cube();
  by_size.output = path("by_size.off");
  by_size.size = 0.2;
  EXPECT_THAT(remeshed(by_size).out, Not(HasSubstr("wavelength")));
  SurfaceCommand by_wave;
  by_wave.input = by_size.input;
  by_wave.output = path("by_wave.off");
  by_wave.wave.frequency = "2";
  by_wave.wave.speed = 4;
  EXPECT_THAT(remeshed(by_wave).out, HasSubstr("size            0.2 (10 to a wavelength of 2)\n"));
  EXPECT_EQ(read_file(by_wave.output), read_file(by_size.output));
}

TEST_F(SurfaceRemeshed, of_a_job_file_has_the_size_of_its_frequency_unless_it_says_another) {
  cube();
  write_file_atomically(path("job.toml"),
                        "[geometry]\nsurface = \"cube.off\"\n[spacing]\nfrequency = 2\n"
                        "wave_speed = 4\n[surface]\nremesh = true\n");
  SurfaceCommand command;
  command.input = path("job.toml");
  command.output = path("fine.off");
  EXPECT_THAT(remeshed(command).out, HasSubstr("size            0.2 (10 to a wavelength of 2)\n"));
  command.wave.per_wavelength = 4;
  EXPECT_THAT(remeshed(command).out, HasSubstr("size            0.5 (4 to a wavelength of 2)\n"));
  command.wave = {};
  command.size = 0.25;
  EXPECT_THAT(remeshed(command).out, Not(HasSubstr("wavelength")));
}

}  // namespace
}  // namespace tetfarm
