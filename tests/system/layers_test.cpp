// Boundary layers through the whole program.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <initializer_list>
#include <thread>

#include "base/file_system.h"
#include "tests/mesh/layers/boxes_with_planes.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

class RunWithLayers : public ::testing::Test {
 protected:
  RunWithLayers() {
    test::write_contents(folder_.path() / "ball.off",
                         test::off_of(shapes::sphere({0.5, 0.25, 0}, 1, 3)));
    write_job("[spacing]\ndefault = 0.15\n");
  }

  /// Six layers inside the ball.
  void write_job(const std::string& more) {
    test::write_contents(folder_.path() / "job.toml",
                         "[geometry]\nsurface = \"ball.off\"\n[[layers]]\npatches = [\"*\"]\n"
                         "first_height = 0.01\ncount = 6\n" +
                             more);
  }

  nlohmann::json run(const std::string& output, int workers, int subdomains) {
    const Ended ended =
        run_program(test::run_words("job.toml", output, workers, subdomains), folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.code == 0 ? test::result_of(ended) : nlohmann::json();
  }

  /// Runs that are killed with all their processes after so many milliseconds, one after the other.
  void kill_runs(const std::string& output, int subdomains, std::initializer_list<int> after_ms) {
    for (const int ms : after_ms) {
      test::Program run(test::run_words("job.toml", output, 2, subdomains), folder_.path());
      std::this_thread::sleep_for(std::chrono::milliseconds(ms));
      for (const pid_t process : test::descendants(run.process())) ::kill(process, SIGKILL);
      run.signal(SIGKILL);
      run.wait();
    }
  }

  /// What `quality` says of a sound mesh.
  nlohmann::json sound(const std::string& output) {
    const Ended quality = run_program({"quality", output, "--json"}, folder_.path());
    EXPECT_EQ(quality.code, 0) << quality.err;
    return quality.code == 0 ? test::result_of(quality) : nlohmann::json();
  }

  TemporaryFolder folder_;
};

TEST_F(RunWithLayers, makes_one_sound_mesh_of_prisms_and_tets) {
  const nlohmann::json result = run("out", 2, 1);
  const nlohmann::json& layers = result["layers"];
  EXPECT_EQ(layers["wall_triangles"], 1280);
  EXPECT_EQ(layers["full"], 1280);
  EXPECT_EQ(layers["partial"], 0);
  EXPECT_EQ(layers["none"], 0);
  EXPECT_EQ(result["prisms"], 6 * 1280);
  EXPECT_EQ(result["pyramids"], 0);
  EXPECT_GT(result["tets"], 1000);
  EXPECT_EQ(result["elements"].get<std::int64_t>(),
            result["tets"].get<std::int64_t>() + result["prisms"].get<std::int64_t>());
  EXPECT_EQ(result["boundary_triangles"], 1280);
  const nlohmann::json quality = sound("out");
  EXPECT_EQ(quality["digest"], result["digest"]);
  EXPECT_EQ(quality["nodes"], result["nodes"]);
}

TEST_F(RunWithLayers, is_the_same_for_any_number_of_workers) {
  for (const int subdomains : {1, 5}) {
    const std::string name = std::to_string(subdomains);
    const nlohmann::json one = run("one" + name, 1, subdomains);
    const nlohmann::json three = run("three" + name, 3, subdomains);
    EXPECT_EQ(one["digest"], three["digest"]) << subdomains;
    EXPECT_EQ(test::contents(folder_.path() / ("one" + name) / "job.vtkhdf"),
              test::contents(folder_.path() / ("three" + name) / "job.vtkhdf"))
        << subdomains;
    EXPECT_EQ(one["prisms"], 6 * 1280);
    EXPECT_EQ(sound("one" + name)["digest"], one["digest"]);
  }
}

TEST_F(RunWithLayers, is_assimilated_and_written_in_every_format_that_tasks_write) {
  write_job(
      "[spacing]\ndefault = 0.15\n[decompose.assimilate]\ngroups = 2\n"
      "[output]\nformats = [\"vtkhdf\", \"lb8.ugrid\"]\n");
  const nlohmann::json result = run("out", 2, 8);
  EXPECT_EQ(sound("out/job.vtkhdf")["digest"], result["digest"]);
  EXPECT_EQ(sound("out/job.lb8.ugrid")["digest"], result["digest"]);
}

TEST_F(RunWithLayers, goes_on_after_it_was_killed) {
  const std::string expected = run("whole", 2, 5)["digest"];
  kill_runs("out", 5, {300, 700, 1200});
  EXPECT_EQ(run("out", 2, 5)["digest"], expected);
}

TEST_F(RunWithLayers, plan_counts_their_cells) {
  const Ended plan = run_program({"plan", "job.toml", "--json"}, folder_.path());
  ASSERT_EQ(plan.code, 0) << plan.err;
  const nlohmann::json with = test::result_of(plan);
  EXPECT_EQ(with["tasks"]["grow"]["count"], 1);
  test::write_contents(folder_.path() / "bare.toml",
                       "[geometry]\nsurface = \"ball.off\"\n[spacing]\ndefault = 0.15\n");
  const nlohmann::json without =
      test::result_of(run_program({"plan", "bare.toml", "--json"}, folder_.path()));
  EXPECT_FALSE(without["tasks"].contains("grow"));
  EXPECT_GT(with["estimated_elements"], 6 * 1280);
}

TEST_F(RunWithLayers, grows_absorbing_layers_outside_of_a_box_beside_those_of_the_body) {
  write_job(
      "growth = 1\n[domain]\nouter = \"box\"\nfactor = 2\nspacing = 0.5\n"
      "[[pml]]\npatches = [\"outer\"]\nlayers = 4\nheight = 0.25\n");
  const nlohmann::json result = run("out", 2, 3);
  ASSERT_FALSE(result.is_null());
  EXPECT_EQ(result["layers"]["full"], 1280);
  const nlohmann::json& pml = result["pml"];
  const auto outside = pml["outer_triangles"].get<std::int64_t>();
  EXPECT_EQ(pml["layers"], 4);
  EXPECT_EQ(pml["thickness"], 1);
  EXPECT_EQ(pml["tets"], 12 * outside);
  EXPECT_EQ(pml["prisms"], 0);
  EXPECT_EQ(pml["cells"], pml["tets"]);
  EXPECT_EQ(result["prisms"], 6 * 1280) << "of the body alone";
  EXPECT_EQ(result["boundary_triangles"], 1280 + outside);
  const SurfaceMesh ball = shapes::sphere({0.5, 0.25, 0}, 1, 3);
  EXPECT_NEAR(result["volume"].get<double>(),
              6 * 6 * 6 - enclosed_volume(ball.vertices, ball.triangles), 1e-9);
  const nlohmann::json quality = sound("out");
  EXPECT_EQ(quality["digest"], result["digest"]);
  const std::string mesh = read_file(folder_.path() / "out" / "job.vtkhdf");
  EXPECT_NE(mesh.find("pml_axes"), std::string::npos);
  EXPECT_EQ(run("again", 1, 3)["digest"], result["digest"]);
  const nlohmann::json plan =
      test::result_of(run_program({"plan", "job.toml", "--json"}, folder_.path()));
  EXPECT_EQ(plan["pml"]["cells"], pml["cells"]);
}

TEST_F(RunWithLayers, grows_absorbing_layers_within_a_box_beside_those_of_the_body) {
  write_job(
      "growth = 1\n[domain]\nouter = \"box\"\nfactor = 2\nspacing = 0.5\n"
      "[[pml]]\npatches = [\"outer\"]\nlayers = 2\nheight = 0.25\nside = \"inside\"\n");
  const nlohmann::json result = run("out", 2, 3);
  ASSERT_FALSE(result.is_null());
  EXPECT_EQ(result["layers"]["full"], 1280);
  EXPECT_EQ(result["pml"]["tets"], 6 * result["pml"]["outer_triangles"].get<std::int64_t>());
  const SurfaceMesh ball = shapes::sphere({0.5, 0.25, 0}, 1, 3);
  EXPECT_NEAR(result["volume"].get<double>(),
              4 * 4 * 4 - enclosed_volume(ball.vertices, ball.triangles), 1e-9);
  EXPECT_EQ(sound("out")["digest"], result["digest"]);
}

TEST_F(RunWithLayers, grows_absorbing_layers_in_blocks_beside_those_of_the_body) {
  write_job(
      "growth = 1\n[domain]\nouter = \"box\"\nfactor = 2\nspacing = 0.5\n"
      "[[pml]]\npatches = [\"outer\"]\nlayers = 4\nheight = 0.25\ncorners = \"block\"\n");
  const nlohmann::json result = run("out", 2, 3);
  ASSERT_FALSE(result.is_null());
  EXPECT_EQ(result["layers"]["full"], 1280);
  const nlohmann::json& pml = result["pml"];
  EXPECT_EQ(pml["thickness"], 1);
  // 8 edges along each of the 12 of the box.
  EXPECT_EQ(pml["tets"], 3 * 4 * (6 * 8 * 8 * 2) + 6 * 4 * 4 * (12 * 8) + 6 * 4 * 4 * 4 * 8);
  EXPECT_EQ(pml["outer_triangles"], 6 * 16 * 16 * 2) << "as on a box of squares that are as large";
  EXPECT_EQ(result["boundary_triangles"], 1280 + 6 * 16 * 16 * 2);
  const SurfaceMesh ball = shapes::sphere({0.5, 0.25, 0}, 1, 3);
  EXPECT_NEAR(result["volume"].get<double>(),
              6 * 6 * 6 - enclosed_volume(ball.vertices, ball.triangles), 1e-9);
  EXPECT_EQ(sound("out")["digest"], result["digest"]);
  EXPECT_EQ(run("again", 1, 3)["digest"], result["digest"]);
}

/// Its five sides absorb, and the plane ends the layers of both kinds.
TEST_F(RunWithLayers, carries_on_a_plane_of_symmetry_along_absorbing_blocks) {
  SurfaceMesh half = shapes::box({-1, 0, -1}, {1, 1, 1}, 6);
  std::erase_if(half.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::int32_t v) { return half.vertices[at(v)].y == 0; });
  });
  test::write_contents(folder_.path() / "ball.off", test::off_of(half));
  write_job(
      "[spacing]\ndefault = 0.5\n[domain]\nouter = \"box\"\nfactor = 2\nspacing = 0.5\n"
      "symmetry = \"y=0\"\n"
      "[[pml]]\npatches = [\"outer\"]\nlayers = 3\nheight = 0.25\ncorners = \"block\"\n");
  const nlohmann::json result = run("out", 2, 2);
  ASSERT_FALSE(result.is_null());
  const nlohmann::json quality = sound("out");
  EXPECT_EQ(quality["digest"], result["digest"]);
  EXPECT_NEAR(result["volume"].get<double>(), 5.5 * 5.5 * 2.75 - 2 * 1 * 2, 1e-9);
}

TEST_F(RunWithLayers, counts_the_tets_of_absorbing_layers_that_the_command_line_asks_for) {
  std::vector<std::string> words = test::run_words("ball.off", "out", 2, 2);
  words.insert(words.end(), {"--pml", "surface:layers=3,height=0.1", "--size", "0.3"});
  const Ended ended = run_program(words, folder_.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json result = test::result_of(ended);
  EXPECT_EQ(result["pml"]["tets"], 9 * 1280);
  EXPECT_FALSE(result.contains("layers")) << "there are no boundary layers";
  EXPECT_EQ(result["elements"], result["tets"]);
  EXPECT_EQ(sound("out")["elements"], result["elements"]);
  words.back() = "0.31";
  std::replace(words.begin(), words.end(), std::string("surface:layers=3,height=0.1"),
               std::string("surfac"));
  EXPECT_THAT(run_program(words, folder_.path()).err, HasSubstr("did you mean \"surface\"?"));
}

TEST_F(RunWithLayers, end_on_planes_with_quads_whatever_the_workers_and_kills) {
  test::write_contents(folder_.path() / "box.obj",
                       test::obj_of(test::box_with_patches({0, 0, 0}, {1, 1, 1}, 8)));
  test::write_contents(folder_.path() / "job.toml",
                       "[geometry]\nsurface = \"box.obj\"\n[[layers]]\npatches = [\"floor\"]\n"
                       "first_height = 0.005\ncount = 9\n[output]\n"
                       "formats = [\"vtkhdf\", \"lb8.ugrid\"]\n");
  const nlohmann::json result = run("out", 2, 4);
  ASSERT_FALSE(result.is_null());
  EXPECT_EQ(result["prisms"], 9 * 128);
  EXPECT_EQ(result["boundary_quads"], 9 * 32);
  EXPECT_EQ(result["layers"]["full"], 128);
  EXPECT_EQ(result["layers"]["planes"], 4);
  EXPECT_EQ(result["layers"]["plane_triangles_before"], 4 * 128);
  EXPECT_EQ(result["layers"]["plane_quads"], 9 * 32);
  EXPECT_NEAR(result["volume"].get<double>(), 1, 1e-12);
  const std::string digest = result["digest"];
  EXPECT_EQ(sound("out/job.vtkhdf")["digest"], digest);
  EXPECT_EQ(sound("out/job.lb8.ugrid")["digest"], digest);
  EXPECT_EQ(run("one", 1, 4)["digest"], digest);
  kill_runs("killed", 4, {200, 500, 900});
  EXPECT_EQ(run("killed", 2, 4)["digest"], digest);
}

TEST_F(RunWithLayers, of_several_regions_is_refused_in_words) {
  const auto cubes =
      shapes::voxel_surface({{4, 2, 2}, [](int x, int, int) { return x < 2 ? 1 : 2; }});
  test::write_contents(folder_.path() / "ball.off", test::off_of(cubes.surface));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "job.toml"}, test::run_words("job.toml", "out", 1)}) {
    const Ended ended = run_program(words, folder_.path());
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, AllOf(HasSubstr("[[layers]]"), HasSubstr("bounds 2")));
  }
}

}  // namespace
}  // namespace tetfarm
